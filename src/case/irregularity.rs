//! `[irregularity]` → what the wheels roll over, with every fault at its key.

use super::checks::span;
use super::error::Finding;
use super::schema::{IrregularityInput, IrregularityKind};
use crate::irregularity::{
    ChinaBallastless, FraBreakWavenumber, FraCorner, German, IrregularityError, Iso8608, Order, Sncf,
    Spectrum, measured, out_of_round, sinusoidal,
};
use crate::quantity::{finite, positive};
use crate::study::{Carrier, Irregularity};
use std::f64::consts::TAU;

/// Shortest wavelength a case may ask for [m].
const SHORTEST: f64 = 0.01;
/// Most profiles a case may ask for.
const MOST_PROFILES: usize = 1000;
/// Most waves around a wheel.
const MOST_ORDERS: u32 = 500;

/// The kind as a case file says it.
fn word(kind: IrregularityKind) -> &'static str {
    match kind {
        IrregularityKind::FraBreakWavenumber => "fra-break-wavenumber",
        IrregularityKind::FraCorner => "fra-corner",
        IrregularityKind::German => "german",
        IrregularityKind::Sncf => "sncf",
        IrregularityKind::ChinaBallastless => "china-ballastless",
        IrregularityKind::Iso8608 => "iso8608",
        IrregularityKind::Measured => "measured",
        IrregularityKind::Sinusoidal => "sinusoidal",
        IrregularityKind::OutOfRound => "out-of-round",
    }
}

/// The key that says which spectrum of its family, if there are several.
fn parameter(kind: IrregularityKind) -> &'static str {
    match kind {
        IrregularityKind::FraBreakWavenumber | IrregularityKind::FraCorner => "class",
        IrregularityKind::German | IrregularityKind::Sncf => "quality",
        IrregularityKind::Iso8608 => "roughness",
        _ => "",
    }
}

/// Keys a kind may have besides itself.
fn allowed(kind: IrregularityKind) -> Vec<&'static str> {
    match kind {
        IrregularityKind::Measured => vec!["file", "abreast", "wavelengths"],
        IrregularityKind::Sinusoidal => vec!["wavelength", "amplitude", "phase"],
        IrregularityKind::OutOfRound => vec!["radius", "orders", "seed"],
        _ => ["wavelengths", "seed", "profiles", parameter(kind)]
            .into_iter()
            .filter(|k| !k.is_empty())
            .collect(),
    }
}

/// A fault of a constructor, at the key it names.
fn fault(error: IrregularityError) -> Finding {
    match error {
        IrregularityError::OutOfRange(error) => Finding::out_of_range("irregularity", error),
        error => Finding::new("irregularity", error),
    }
}

fn missing(kind: IrregularityKind, key: &str) -> Finding {
    Finding::new("irregularity", format!("the kind {} needs {key}", word(kind)))
}

/// `[irregularity]`; `files` reads a file beside the case.
pub fn irregularity(
    input: &IrregularityInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Irregularity, Finding> {
    let kind = input.kind;
    let given = [
        ("class", input.class.is_some()),
        ("quality", input.quality.is_some()),
        ("roughness", input.roughness.is_some()),
        ("wavelengths", input.wavelengths.is_some()),
        ("seed", input.seed.is_some()),
        ("profiles", input.profiles.is_some()),
        ("file", input.file.is_some()),
        ("abreast", input.abreast.is_some()),
        ("wavelength", input.wavelength.is_some()),
        ("amplitude", input.amplitude.is_some()),
        ("phase", input.phase.is_some()),
        ("radius", input.radius.is_some()),
        ("orders", input.orders.is_some()),
    ];
    let allowed = allowed(kind);
    if let Some((key, _)) = given.iter().find(|(key, there)| *there && !allowed.contains(key)) {
        let message = format!("the kind {} has no {key}", word(kind));
        return Err(Finding::new(format!("irregularity.{key}"), message)
            .help(format!("it has {}", allowed.join(", "))));
    }
    let wavelengths = input.wavelengths.map(|w| span(w, "irregularity.wavelengths")).transpose()?;
    if let Some((from, _)) = wavelengths.filter(|w| w.0 < SHORTEST) {
        let message = format!("from {from} m: the shortest must be at least {SHORTEST} m");
        return Err(Finding::new("irregularity.wavelengths.from", message));
    }
    // seeds are stored as doubles
    if let Some(seed) = input.seed.filter(|seed| *seed > 1 << 53) {
        let message = format!("found {seed}: it must not be above {}", 1u64 << 53);
        return Err(Finding::new("irregularity.seed", message));
    }
    match kind {
        IrregularityKind::Measured => profile(input, wavelengths, files),
        IrregularityKind::Sinusoidal => {
            let need = |value: Option<f64>, key| value.ok_or_else(|| missing(kind, key));
            let (wavelength, amplitude) =
                (need(input.wavelength, "wavelength")?, need(input.amplitude, "amplitude")?);
            let profile = sinusoidal(wavelength, amplitude, input.phase.unwrap_or(0.0)).map_err(fault)?;
            if wavelength < SHORTEST {
                let message = format!("{wavelength} m: it must be at least {SHORTEST} m");
                return Err(Finding::new("irregularity.wavelength", message));
            }
            let text =
                format!("one sinusoid, wavelength {wavelength} m, amplitude {:.4} mm", 1e3 * amplitude);
            Ok(Irregularity::Given { profile, text, carrier: Carrier::Rail })
        }
        IrregularityKind::OutOfRound => wheels(input),
        _ => {
            let spectrum = spectrum(input)?;
            let wavelengths = wavelengths.ok_or_else(|| missing(kind, "wavelengths"))?;
            let count = input.profiles.unwrap_or(10);
            if !(1..=MOST_PROFILES).contains(&count) {
                let message = format!("found {count}: it must lie between 1 and {MOST_PROFILES}");
                return Err(Finding::new("irregularity.profiles", message));
            }
            Ok(Irregularity::Random { spectrum, wavelengths, seed: input.seed.unwrap_or(1), count })
        }
    }
}

/// A measured profile, its middle abreast of the receivers unless told otherwise.
fn profile(
    input: &IrregularityInput,
    wavelengths: Option<(f64, f64)>,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Irregularity, Finding> {
    let at = "irregularity.file";
    let file = input.file.as_ref().ok_or_else(|| missing(input.kind, "file"))?;
    let csv = files(file).map_err(|reason| {
        Finding::new(at, format!("cannot read \"{file}\": {reason}"))
            .help("the path is relative to the case file")
    })?;
    let whole = measured(&csv).map_err(|e| {
        Finding::new(at, format!("{file}: {e}"))
            .help("a header line, then x [m] and r [m, positive down], x rising")
    })?;
    // N spacings, less their rounding
    let (first, length) = (whole.from(), (1e6 * whole.repeat_length()).round() / 1e6);
    if let Some((_, longest)) = wavelengths.filter(|w| w.1 > length) {
        let message = format!("to {longest} m: the profile of {file} is only {length} m long");
        return Err(Finding::new("irregularity.wavelengths.to", message)
            .help("it holds no longer waves: measure a longer profile, or narrow the wavelengths"));
    }
    let abreast = input.abreast.unwrap_or(first + 0.5 * length);
    if !(abreast >= first && abreast <= first + length) {
        let message = format!("{abreast} m: the profile reaches from {first} to {} m", first + length);
        return Err(Finding::new("irregularity.abreast", message));
    }
    let profile = match wavelengths {
        Some((shortest, longest)) => whole.between(shortest, longest),
        None => whole.between(SHORTEST, f64::INFINITY),
    };
    if profile.components().is_empty() {
        let message = format!("the profile of {file} has no waves between them");
        return Err(Finding::new("irregularity.wavelengths", message).help("widen them"));
    }
    let range = wavelengths.map_or(String::new(), |(a, b)| format!(", wavelengths {a} to {b} m"));
    let text = format!(
        "measured, {file}, {length} m from x = {first} m, x = {abreast} m abreast of the receivers{range}"
    );
    Ok(Irregularity::Given { profile: profile.shifted(abreast), text, carrier: Carrier::Rail })
}

/// Wheels that are not round.
fn wheels(input: &IrregularityInput) -> Result<Irregularity, Finding> {
    let refused = |e| Finding::out_of_range("irregularity", e);
    let radius = input.radius.ok_or_else(|| missing(input.kind, "radius"))?;
    positive("radius", radius, "m").map_err(refused)?;
    let orders = input.orders.as_ref().ok_or_else(|| missing(input.kind, "orders"))?;
    let mut list = Vec::new();
    for (i, o) in orders.iter().enumerate() {
        if !(1..=MOST_ORDERS).contains(&o.order) {
            let message = format!("found {}: it must lie between 1 and {MOST_ORDERS}", o.order);
            return Err(Finding::new(format!("irregularity.orders[{i}].order"), message));
        }
        let wavelength = TAU * radius / f64::from(o.order);
        if wavelength < SHORTEST {
            let message = format!("waves of {wavelength:.4} m: the shortest must be at least {SHORTEST} m");
            return Err(Finding::new(format!("irregularity.orders[{i}].order"), message));
        }
        let refused = |e| Finding::out_of_range(&format!("irregularity.orders[{i}]"), e);
        let amplitude = positive("amplitude", o.amplitude, "m").map_err(refused)?;
        list.push(Order {
            order: o.order,
            amplitude,
            phase: finite("phase", o.phase, "rad").map_err(refused)?,
        });
    }
    let profile = out_of_round(radius, &list).map_err(|e| Finding::new("irregularity.orders", e))?;
    let shown: Vec<String> =
        list.iter().map(|o| format!("order {} of {:.4} mm", o.order, 1e3 * o.amplitude)).collect();
    let seed = input.seed.unwrap_or(1);
    let text = format!(
        "wheels of radius {radius} m that are not round, {}, each turned by a random angle, seed {seed}",
        shown.join(", ")
    );
    Ok(Irregularity::Given { profile, text, carrier: Carrier::Wheels { seed } })
}

/// The spectrum of a random profile.
fn spectrum(input: &IrregularityInput) -> Result<Spectrum, Finding> {
    let (kind, wanted) = (word(input.kind), parameter(input.kind));
    let at = format!("irregularity.{wanted}");
    let missing = || Finding::new("irregularity", format!("the kind {kind} needs {wanted}"));
    let fault = |error: IrregularityError| Finding::new(&at, error);
    let quality = |names: [&str; 2]| {
        let found = input.quality.as_deref().ok_or_else(missing)?;
        names.iter().position(|n| *n == found).ok_or_else(|| {
            let message = format!("the kind {kind} has no quality \"{found}\"");
            Finding::new(&at, message).help(format!("allowed: {}, {}", names[0], names[1]))
        })
    };
    Ok(match input.kind {
        IrregularityKind::FraBreakWavenumber => Spectrum::FraBreakWavenumber(
            FraBreakWavenumber::new(input.class.ok_or_else(missing)?).map_err(fault)?,
        ),
        IrregularityKind::FraCorner => {
            Spectrum::FraCorner(FraCorner::new(input.class.ok_or_else(missing)?).map_err(fault)?)
        }
        IrregularityKind::German => Spectrum::German([German::Low, German::High][quality(["low", "high"])?]),
        IrregularityKind::Sncf => Spectrum::Sncf([Sncf::Good, Sncf::Poor][quality(["good", "poor"])?]),
        IrregularityKind::ChinaBallastless => Spectrum::ChinaBallastless(ChinaBallastless),
        IrregularityKind::Iso8608 => {
            Spectrum::Iso8608(Iso8608::new(input.roughness.ok_or_else(missing)?).map_err(fault)?)
        }
        IrregularityKind::Measured | IrregularityKind::Sinusoidal | IrregularityKind::OutOfRound => {
            return Err(missing());
        }
    })
}
