//! What several studies may be doubted for.

use super::{speed_text, trimmed};
use crate::concern::Concern;
use crate::railway::{Ground, Railway};
use crate::soil::{Base, Profile};

/// Static deflections of tracks under one axle [m]: 0.7 mm on a slab to 4.1 mm on soft clay in `soil_cases`; room on both sides for
/// light axles and rock, heavy ones and peat.
const TRACKS_SINK: std::ops::RangeInclusive<f64> = 0.05e-3..=50e-3;

/// "by up to a factor of 2.3": how far an accuracy was missed.
pub(super) fn by_up_to(factor: f64) -> String {
    if factor.is_finite() {
        format!("by up to a factor of {factor:.1}")
    } else {
        "by an unknown factor".into()
    }
}

/// One concern for all speeds or frequencies at which a quadrature `missed` its `accuracy`, and by what factor, of `asked` (how many, of
/// what, in which unit).
pub(super) fn missed_accuracy(
    missed: &[(f64, f64)],
    accuracy: &str,
    (count, what, unit): (usize, &str, &str),
) -> Option<Concern> {
    let (worst, factor) = missed.iter().copied().max_by(|a, b| a.1.total_cmp(&b.1))?;
    let places: Vec<String> = missed.iter().map(|(at, _)| trimmed(*at)).collect();
    Some(Concern::new(
        "quadrature",
        format!(
            "the wavenumber integrals missed their accuracy ({accuracy}) at {} of {count} {what}, {} (at {} {unit}): {} {unit}",
            missed.len(),
            by_up_to(factor),
            trimmed(worst),
            places.join(", ")
        ),
        "poles lie too close to the real axis, where the work was cut short (more damping helps), or the track spreads the load too \
         little, or a layer is very thin",
    ))
}

/// [`static_deflection`] under the heaviest axle of `railway`; None where it has no track, or no finite deflection.
pub(super) fn sinks_as_no_track_does(railway: &Railway) -> Option<Concern> {
    let axle = railway.train().ok()?.heaviest_axle();
    let at_rest = railway.track().ok()?.moving(0.0, 1.0).ok()?;
    static_deflection(axle.axles()[0].load * at_rest.rail(0.0))
}

/// A concern if the rail sinks by `deflection` [m] under one axle at rest as no track does: mostly a number in the wrong unit.
pub(super) fn static_deflection(deflection: f64) -> Option<Concern> {
    let likely = if deflection < *TRACKS_SINK.start() {
        "train.axles.load in N (150e3, not 150), and stiffnesses and moduli not too large"
    } else {
        "stiffnesses of pads, ballast and foundation in N/m² (7e8, not 700), soil moduli in Pa (60e6, not 60), bending stiffness in N m², \
         and loads not too large"
    };
    (!TRACKS_SINK.contains(&deflection)).then(|| {
        Concern::new(
            "static-deflection",
            format!(
                "at rest the rail sinks by {:.3e} mm under one axle; tracks sink by 0.05 to 50 mm",
                1e3 * deflection
            ),
            format!("check the units: {likely}"),
        )
    })
}

/// A concern if a load at `speed` [m/s] outruns every shear wave of the ground: only far-reaching Mach waves are left.
pub(super) fn outruns_waves(railway: &Railway, speed: f64) -> Option<Concern> {
    let Ground { profile, .. } = railway.ground().ok()?;
    let fastest = profile.materials().map(|m| m.c_s()).fold(0.0, f64::max);
    (speed > fastest).then(|| {
        Concern::new(
            "faster-than-waves",
            format!("{} is faster than every shear wave of the ground ({fastest:.1} m/s)", speed_text(speed)),
            "check the speed and the soil; the response is then governed by material damping",
        )
    })
}

/// A concern if rock lies deeper than waves of the lowest of `frequencies` [Hz] above zero reach and come back from:
/// e^{−2 Σ h ηω/(2c_s)} below 1e-3.
pub(super) fn deep_rock(profile: &Profile, frequencies: &[f64]) -> Option<Concern> {
    let lowest = frequencies.iter().copied().filter(|f| *f > 0.0).reduce(|a: f64, b: f64| a.min(b))?;
    let decay: f64 = profile
        .layers()
        .iter()
        .map(|l| l.thickness * l.material.loss_factor() * std::f64::consts::TAU * lowest / l.material.c_s())
        .sum();
    (profile.base() == Base::Rigid && decay > 1e3f64.ln()).then(|| {
        Concern::new(
            "deep-rock",
            format!(
                "the rigid base at {:.1} m is deeper than waves reach: at {lowest} Hz they come back with {:.0e} of their \
                 amplitude",
                profile.depth(),
                (-decay).exp()
            ),
            "a half-space of the lowest layer gives the same answer with less work",
        )
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Silent;
    use crate::foundation::Springs;
    use crate::railway::Support;
    use crate::study::{CriticalSpeed, TrackResponse};
    use crate::track::{Member, Stack};
    use crate::vehicle::{Axle, Train};

    /// Codes of the concerns of a speed curve and of a track response: a beam on springs of `stiffness` [N/m²] under `load` [N].
    fn codes(stiffness: f64, load: f64) -> Vec<&'static str> {
        let springs = Springs::winkler(stiffness, 1e5, 0.0).unwrap();
        let beam = Stack::new(vec![Member::beam(1.276e7, 120.46, 0.0).unwrap()], vec![]);
        let train = Train::new(vec![Axle { position: 0.0, load }]).unwrap();
        let railway = Railway::new(Support::Springs(springs), beam, Some(train)).unwrap();
        let curve = CriticalSpeed { speeds: vec![10.0, 20.0], ..CriticalSpeed::default() }
            .run(&railway, &Silent)
            .unwrap();
        let shape = TrackResponse { speeds: vec![10.0], spacing: Some(0.5), ..TrackResponse::default() };
        let shape = shape.run(&railway, &Silent).unwrap();
        let all = curve.concerns.iter().chain(&shape.concerns).map(|c| c.code);
        all.filter(|code| *code == "static-deflection").collect()
    }

    /// Each of the last three passed without a word.
    #[test]
    fn a_track_that_sinks_as_none_does_is_told() {
        // 0.9 mm; 0.9 µm of kN given as N; 0.17 m of springs in kN/m²; 8.8 nm of moduli in mPa
        assert_eq!(codes(5e7, 150e3), [""; 0]);
        for (stiffness, load) in [(5e7, 150.0), (5e4, 150e3), (5e13, 150e3)] {
            assert_eq!(codes(stiffness, load), ["static-deflection"; 2], "{stiffness} {load}");
        }
    }

    #[test]
    fn the_likely_key_is_named() {
        let said = |deflection: f64| static_deflection(deflection).map(|c| c.remedy).unwrap_or_default();
        assert!(said(1e-6).contains("train.axles.load in N"));
        assert!(said(0.2).contains("N/m²"));
        assert_eq!((said(0.06e-3), said(49e-3)), (String::new(), String::new()));
        // not a number is no deflection of a track
        assert!(!said(f64::NAN).is_empty());
    }

    #[test]
    fn the_largest_miss_is_quoted() {
        let missed = [(10.0, 1.4), (12.0, 2.34), (14.25, 1.1)];
        let told = missed_accuracy(&missed, "1e-4", (40, "frequencies", "Hz")).unwrap().message;
        let wanted = "missed their accuracy (1e-4) at 3 of 40 frequencies, by up to a factor of 2.3 (at 12 Hz): 10, 12, 14.25 Hz";
        assert!(told.ends_with(wanted), "{told}");
        let told = missed_accuracy(&[(68.5, f64::INFINITY)], "1e-5", (1, "speeds", "m/s")).unwrap().message;
        assert!(told.ends_with("at 1 of 1 speeds, by an unknown factor (at 68.5 m/s): 68.5 m/s"), "{told}");
        assert!(missed_accuracy(&[], "1e-5", (4, "speeds", "m/s")).is_none());
    }
}
