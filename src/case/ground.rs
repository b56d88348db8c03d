//! `[soil]` → profile and solver, with every fault at its key.

use super::error::Finding;
use super::schema::{MaterialInput, SoilInput, SolversInput};
use crate::quantity::{OutOfRange, not_negative, positive};
use crate::soil::{Base, Elastic, Layer, Material, Profile, SoilError, Solver};

/// Thinnest layer [m], and shear wave speeds [m/s], that a case may ask for: beyond them are slips of unit.
const THINNEST: f64 = 1e-3;
const SHEAR_SPEEDS: (f64, f64) = (5.0, 10_000.0);

/// The two elastic constants that are given.
fn elastic(input: &MaterialInput, path: &str) -> Result<Elastic, Finding> {
    const PAIRS: &str =
        "give young and poisson, or shear_speed and pressure_speed, or shear_speed and poisson";
    match (input.young, input.poisson, input.shear_speed, input.pressure_speed) {
        (Some(young), Some(poisson), None, None) => Ok(Elastic::YoungPoisson { young, poisson }),
        (None, None, Some(shear), Some(pressure)) => Ok(Elastic::Speeds { shear, pressure }),
        (None, Some(poisson), Some(shear), None) => Ok(Elastic::ShearPoisson { shear, poisson }),
        _ => {
            let given: Vec<&str> = [
                ("young", input.young),
                ("poisson", input.poisson),
                ("shear_speed", input.shear_speed),
                ("pressure_speed", input.pressure_speed),
            ]
            .iter()
            .filter(|(_, v)| v.is_some())
            .map(|(name, _)| *name)
            .collect();
            let found = if given.is_empty() { "none".to_owned() } else { given.join(", ") };
            Err(Finding::new(path, format!("elastic constants: found {found}")).help(PAIRS))
        }
    }
}

/// Elastic constants and damping of one material.
fn material(input: &MaterialInput, path: &str) -> Result<Material, Finding> {
    let elastic = elastic(input, path)?;
    let refused = |error: OutOfRange| {
        let fluid = error.value == 0.0 && matches!(error.key, "young" | "shear_speed");
        let finding = Finding::out_of_range(path, error);
        if fluid {
            finding.help("without shear stiffness it is a fluid: water is not modelled")
        } else {
            finding
        }
    };
    let loss = |factor: Option<f64>, ratio: Option<f64>, names: [&'static str; 2]| match (factor, ratio) {
        (Some(eta), None) => Ok(Some((eta, names[0]))),
        // η = 2ξ
        (None, Some(xi)) => Ok(Some((2.0 * not_negative(names[1], xi, "").map_err(refused)?, names[1]))),
        (None, None) => Ok(None),
        (Some(_), Some(_)) => Err(Finding::new(
            format!("{path}.{}", names[1]),
            format!("{} and {} are both given", names[0], names[1]),
        )
        .help("give one of them; loss factor = 2 × damping ratio")),
    };
    let shear = loss(input.loss_factor, input.damping_ratio, ["loss_factor", "damping_ratio"])?;
    let pressure = loss(
        input.loss_factor_pressure,
        input.damping_ratio_pressure,
        ["loss_factor_pressure", "damping_ratio_pressure"],
    )?;
    let Some((eta_s, key_s)) = shear else {
        return Err(Finding::new(path, "the damping is missing")
            .help("give loss_factor, or damping_ratio (half of it)"));
    };
    let (eta_p, key_p) = pressure.unwrap_or((eta_s, key_s));
    let material = Material::new(elastic, input.density, eta_s, eta_p).map_err(|error| match error {
        SoilError::OutOfRange(error) => refused(error),
        SoilError::PoissonRatio { .. } => Finding::new(format!("{path}.poisson"), error),
        SoilError::PressureSpeed { .. } => Finding::new(format!("{path}.pressure_speed"), error),
        _ => Finding::new(format!("{path}.{key_p}"), error),
    })?;
    let c_s = material.c_s();
    if c_s < SHEAR_SPEEDS.0 || c_s > SHEAR_SPEEDS.1 {
        let key = if input.young.is_some() { "young" } else { "shear_speed" };
        let (low, high) = SHEAR_SPEEDS;
        let message = format!(
            "the shear wave speed is {c_s:.3e} m/s: no ground, it should lie between {low} and {high} m/s"
        );
        return Err(Finding::new(format!("{path}.{key}"), message)
            .help("young is in Pa (60 MPa = 60e6), density in kg/m³, speeds in m/s"));
    }
    Ok(material)
}

/// The solver of `[soil.solver]`, and the one to verify it with; `path` is where the table stands.
pub fn solvers(input: Option<SolversInput>, path: &str) -> Result<(Solver, Option<Solver>), Finding> {
    let SolversInput { solver, verify } = input.unwrap_or_default();
    let solver = solver.unwrap_or_default();
    if verify.is_some_and(|verify| verify.name() == solver.name()) {
        let message = format!("{} cannot verify itself", solver.name());
        return Err(
            Finding::new(format!("{path}.verify"), message).help("name another solver, or remove the key")
        );
    }
    Ok((solver, verify))
}

/// The layer of the table at `path`.
fn layer(input: &MaterialInput, path: &str) -> Result<Layer, Finding> {
    let Some(thickness) = input.thickness else {
        return Err(Finding::new(path, "missing key `thickness`").help("add `thickness = …` [m]"));
    };
    positive("thickness", thickness, "m").map_err(|e| Finding::out_of_range(path, e))?;
    if thickness < THINNEST {
        return Err(Finding::new(
            format!("{path}.thickness"),
            format!("thickness is {thickness} m: layers below {THINNEST} m are not resolved"),
        )
        .help("thicknesses are in metres; merge such a layer with its neighbour"));
    }
    Ok(Layer { thickness, material: material(input, path)? })
}

/// What lies below the layers; `at` gives the path of a key of `[soil]`.
fn base(input: &SoilInput, at: impl Fn(&str) -> String) -> Result<Base, Finding> {
    match (&input.half_space, &input.base) {
        (Some(half_space), None) => {
            let path = at("half_space");
            if half_space.thickness.is_some() {
                return Err(Finding::new(format!("{path}.thickness"), "a half-space has no thickness")
                    .help("move it to a [[soil.layer]], or remove the key"));
            }
            Ok(Base::HalfSpace(material(half_space, &path)?))
        }
        (None, Some(_)) => Ok(Base::Rigid),
        (None, None) => Err(Finding::new(at(""), "the profile has no base")
            .help("add [soil.half_space], or soil.base = \"rigid\"")),
        (Some(_), Some(_)) => {
            Err(Finding::new(at("base"), "the profile has two bases: a half-space and a rigid one")
                .help("remove one of them"))
        }
    }
}

/// The profile of `[soil]`, or the fault of each layer; `path` is where the table stands (`soil`, or empty in a library file).
pub fn profile(input: &SoilInput, path: &str) -> Result<Profile, Vec<Finding>> {
    let at = |rest: &str| [path, rest].into_iter().filter(|p| !p.is_empty()).collect::<Vec<_>>().join(".");
    let (mut layers, mut faults) = (Vec::new(), Vec::new());
    for (i, input) in input.layer.iter().enumerate() {
        match layer(input, &at(&format!("layer[{i}]"))) {
            Ok(layer) => layers.push(layer),
            Err(fault) => faults.push(fault),
        }
    }
    match base(input, at) {
        Ok(base) if faults.is_empty() => {
            Profile::new(layers, base).map_err(|error| vec![Finding::new(path, error)])
        }
        Ok(_) => Err(faults),
        Err(fault) => Err(faults.into_iter().chain([fault]).collect()),
    }
}
