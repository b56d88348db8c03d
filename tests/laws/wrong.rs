//! Deliberately wrong grounds: each must fail the laws it breaks, and each law must catch one of them.

use crate::ground::Law;
use crate::{SOLVERS, ask, ground, strip};
use groundwave::math::quadrature::Estimate;
use groundwave::soil::strip::Outline;
use groundwave::soil::{
    Compliance, GroundSolver, PreparedGround, Profile, SoilError, Strip, SurfaceCompliance,
};

/// What is wrong.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Fault {
    /// Damping feeds energy in: G(ω) is what G(−ω) should be.
    Damping,
    /// SH damping alone feeds energy in.
    TransverseDamping,
    /// u_xz 0.1 % too large where the receiver lies below the source.
    Reciprocity,
    /// u_zx with the sign of u_xz.
    Sign,
    /// |ω| in the damping: G(−ω) = G(ω).
    Even,
    /// Every interface adds 1e-6 of the compliance.
    Interfaces,
    /// A length of 1 m hidden in the formula.
    Unit,
    /// Depths are 1e-6 off what the surface alone says.
    Depths,
    /// Overflows for k h beyond 700, as e^{kh} does.
    Overflow,
    /// The side of β shows in the strip integral.
    Side,
    /// The strip integral forgets to conjugate.
    StripEven,
    /// The strip carries nothing at rest.
    Massless,
}

struct Wrong {
    right: Box<dyn GroundSolver>,
    fault: Fault,
}

struct WrongAt {
    right: Box<dyn PreparedGround>,
    fault: Fault,
    omega: f64,
    interfaces: usize,
}

impl GroundSolver for Wrong {
    fn prepare(
        &self,
        profile: &Profile,
        omega: f64,
        depths: &[f64],
    ) -> Result<Box<dyn PreparedGround>, SoilError> {
        let asked = match self.fault {
            Fault::Damping => -omega,
            Fault::Even => omega.abs(),
            _ => omega,
        };
        let right = self.right.prepare(profile, asked, depths)?;
        let interfaces = profile.layers().len();
        Ok(Box::new(WrongAt { right, fault: self.fault, omega, interfaces }))
    }
}

impl WrongAt {
    fn spoil(&self, k: f64, g: Compliance) -> Compliance {
        let factor = |f: f64| Compliance {
            u_zz: g.u_zz * f,
            u_xx: g.u_xx * f,
            u_xz: g.u_xz * f,
            u_zx: g.u_zx * f,
            u_yy: g.u_yy * f,
        };
        match self.fault {
            Fault::TransverseDamping => Compliance { u_yy: g.u_yy.conj(), ..g },
            Fault::Sign => Compliance { u_zx: g.u_xz, ..g },
            Fault::Interfaces => factor(1.0 + 1e-6 * self.interfaces as f64),
            Fault::Unit => factor(1.0 + 1e-6 / (1.0 + k)),
            Fault::Overflow if k > 700.0 => factor(f64::NAN),
            _ => g,
        }
    }
}

impl PreparedGround for WrongAt {
    fn surface(&self, k: f64) -> SurfaceCompliance {
        let g = self.spoil(k, self.right.surface(k).into());
        SurfaceCompliance { u_zz: g.u_zz, u_xx: g.u_xx, u_xz: g.u_xz, u_yy: g.u_yy }
    }

    fn at_depths(&self, k: f64, source: usize) -> Vec<Compliance> {
        let mut all: Vec<_> = self.right.at_depths(k, source).into_iter().map(|g| self.spoil(k, g)).collect();
        for (receiver, g) in all.iter_mut().enumerate() {
            match self.fault {
                Fault::Reciprocity if receiver > source => g.u_xz *= 1.001,
                Fault::Depths => g.u_xx *= 1.0 + 1e-6,
                _ => {}
            }
        }
        all
    }

    fn outline(&self) -> &Outline {
        self.right.outline()
    }

    fn strip(&self, beta: f64, strip: Strip, relative: f64) -> Estimate {
        let mut estimate = self.right.strip(beta, strip, relative);
        match self.fault {
            Fault::Side if beta < 0.0 => estimate.value *= 1.0 + 1e-9,
            Fault::StripEven if self.omega < 0.0 => estimate.value = estimate.value.conj(),
            Fault::Massless if self.omega == 0.0 => estimate.value = -estimate.value,
            _ => {}
        }
        estimate
    }
}

/// What each fault must be caught by; other laws may catch it too.
const CAUGHT: &[(Fault, &[&str])] = &[
    (Fault::Damping, &["passivity of the surface", "passivity in depth", "k_eq passive"]),
    (Fault::TransverseDamping, &["passivity of the surface", "passivity in depth"]),
    (Fault::Reciprocity, &["reciprocity"]),
    (Fault::Sign, &["reciprocity", "passivity in depth", "one answer"]),
    (Fault::Even, &["conjugate", "k_eq conjugate"]),
    (Fault::Interfaces, &["splitting"]),
    (Fault::Unit, &["units", "scaling"]),
    (Fault::Depths, &["one answer"]),
    (Fault::Overflow, &["finite"]),
    (Fault::Side, &["k_eq even in β"]),
    (Fault::StripEven, &["k_eq conjugate"]),
    (Fault::Massless, &["k_eq at rest"]),
];

fn wrong(fault: Fault) -> Wrong {
    Wrong { right: Box::new(SOLVERS[0]), fault }
}

/// True if one of a few draws shows the fault.
fn catches(name: &str, fault: Fault) -> bool {
    let ground = wrong(fault);
    if let Some((_, law)) = ground::LAWS.iter().find(|(n, _)| *n == name) {
        let law: Law = *law;
        return ask(300, &ground::inputs(), |input| law(&ground, input)).is_err();
    }
    let (_, law) = strip::LAWS.iter().find(|(n, _)| *n == name).expect("a law of that name");
    ask(50, &strip::inputs(), |input| law(&ground, input)).is_err()
}

#[test]
fn wrong_grounds_are_caught() {
    for (fault, laws) in CAUGHT {
        for law in *laws {
            assert!(catches(law, *fault), "{law} lets {fault:?} pass");
        }
    }
}

#[test]
fn every_law_catches_something() {
    let names = ground::LAWS.iter().map(|l| l.0).chain(strip::LAWS.iter().map(|l| l.0));
    for name in names {
        assert!(CAUGHT.iter().any(|(_, laws)| laws.contains(&name)), "no wrong ground for {name}");
    }
}

#[test]
fn an_unspoiled_wrapper_passes() {
    // the wrapper itself must not be what the laws catch: this fault shows in strip integrals only
    let ground = wrong(Fault::Side);
    for (name, law) in ground::LAWS {
        let verdict = ask(20, &ground::inputs(), |input| law(&ground, input));
        assert!(verdict.is_ok(), "{name}: {verdict:?}");
    }
}
