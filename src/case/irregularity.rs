//! `[irregularity]` → what the wheels roll over, with every fault at its key.

use super::checks::span;
use super::error::Finding;
use super::schema::IrregularityInput;
use super::values::SpanInput;
use crate::irregularity::{
    IrregularityError, Order, Rail, Spectrum, measured_rail, out_of_round, sinusoidal,
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

/// A fault of a constructor, at the key it names.
fn fault(error: IrregularityError) -> Finding {
    match error {
        IrregularityError::OutOfRange(error) => Finding::out_of_range("irregularity", error),
        error => Finding::new("irregularity", error),
    }
}

/// Shortest and longest wavelength [m].
fn wavelengths(input: SpanInput) -> Result<(f64, f64), Finding> {
    let (from, to) = span(input, "irregularity.wavelengths")?;
    if from < SHORTEST {
        let message = format!("from {from} m: the shortest must be at least {SHORTEST} m");
        return Err(Finding::new("irregularity.wavelengths.from", message));
    }
    Ok((from, to))
}

/// Of random numbers; stored as a double.
fn seed(given: Option<u64>) -> Result<u64, Finding> {
    match given {
        Some(seed) if seed > 1 << 53 => {
            let message = format!("found {seed}: it must not be above {}", 1u64 << 53);
            Err(Finding::new("irregularity.seed", message))
        }
        given => Ok(given.unwrap_or(1)),
    }
}

/// `[irregularity]`; `files` reads a file beside the case.
pub fn irregularity(
    input: &IrregularityInput,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Irregularity, Finding> {
    match *input {
        IrregularityInput::Measured { ref file, rail, abreast, wavelengths: range } => {
            profile((file, rail), abreast, range.map(wavelengths).transpose()?, files)
        }
        IrregularityInput::Table(ref table) => {
            let spectrum = table.spectrum(files)?;
            let reach = spectrum.valid().unwrap_or((SHORTEST, 1.0));
            let wavelengths = match table.wavelengths {
                Some(span) => wavelengths(span)?,
                None => (reach.0.max(SHORTEST), reach.1.max(2.0 * SHORTEST)),
            };
            random(spectrum, wavelengths, table.seed, table.profiles)
        }
        IrregularityInput::Sinusoidal { wavelength, amplitude, phase } => {
            let profile = sinusoidal(wavelength, amplitude, phase).map_err(fault)?;
            if wavelength < SHORTEST {
                let message = format!("{wavelength} m: it must be at least {SHORTEST} m");
                return Err(Finding::new("irregularity.wavelength", message));
            }
            let text =
                format!("one sinusoid, wavelength {wavelength} m, amplitude {:.4} mm", 1e3 * amplitude);
            Ok(Irregularity::Given { profile, text, carrier: Carrier::Rail })
        }
        IrregularityInput::OutOfRound { radius, ref orders, seed: given } => {
            wheels(radius, orders, seed(given)?)
        }
        IrregularityInput::Random { ref spectrum, wavelengths: range, seed: given, profiles } => {
            random(spectrum.clone(), wavelengths(range)?, given, profiles)
        }
    }
}

/// Profiles with a `spectrum`.
fn random(
    spectrum: Spectrum,
    wavelengths: (f64, f64),
    given: Option<u64>,
    profiles: Option<usize>,
) -> Result<Irregularity, Finding> {
    let count = profiles.unwrap_or(10);
    if !(1..=MOST_PROFILES).contains(&count) {
        let message = format!("found {count}: it must lie between 1 and {MOST_PROFILES}");
        return Err(Finding::new("irregularity.profiles", message));
    }
    Ok(Irregularity::Random { spectrum, wavelengths, seed: seed(given)?, count })
}

/// A measured profile, its middle abreast of the receivers unless told otherwise.
fn profile(
    (file, rail): (&str, Option<Rail>),
    abreast: Option<f64>,
    wavelengths: Option<(f64, f64)>,
    files: &dyn Fn(&str) -> Result<String, String>,
) -> Result<Irregularity, Finding> {
    let at = "irregularity.file";
    let csv = files(file).map_err(|reason| {
        Finding::new(at, format!("cannot read \"{file}\": {reason}"))
            .help("the path is relative to the case file")
    })?;
    let whole = measured_rail(&csv, rail).map_err(|e| {
        Finding::new(at, format!("{file}: {e}"))
            .help("a header line, then x [m] and r [m, positive down], or x and the heights of both rails; x rising")
    })?;
    // N spacings, less their rounding
    let (first, length) = (whole.from(), (1e6 * whole.repeat_length()).round() / 1e6);
    if let Some((_, longest)) = wavelengths.filter(|w| w.1 > length) {
        let message = format!("to {longest} m: the profile of {file} is only {length} m long");
        return Err(Finding::new("irregularity.wavelengths.to", message)
            .help("it holds no longer waves: measure a longer profile, or narrow the wavelengths"));
    }
    let abreast = abreast.unwrap_or(first + 0.5 * length);
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
    let which = rail.map_or("", |rail| match rail {
        Rail::Left => ", left rail",
        Rail::Right => ", right rail",
        Rail::Mean => ", mean of both rails",
    });
    let text = format!(
        "measured, {file}{which}, {length} m from x = {first} m, x = {abreast} m abreast of the receivers{range}"
    );
    Ok(Irregularity::Given { profile: profile.shifted(abreast), text, carrier: Carrier::Rail })
}

/// Wheels that are not round.
fn wheels(radius: f64, orders: &[Order], seed: u64) -> Result<Irregularity, Finding> {
    let refused = |e| Finding::out_of_range("irregularity", e);
    positive("radius", radius, "m").map_err(refused)?;
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
        positive("amplitude", o.amplitude, "m").map_err(refused)?;
        finite("phase", o.phase, "rad").map_err(refused)?;
    }
    let profile = out_of_round(radius, orders).map_err(|e| Finding::new("irregularity.orders", e))?;
    let shown: Vec<String> =
        orders.iter().map(|o| format!("order {} of {:.4} mm", o.order, 1e3 * o.amplitude)).collect();
    let text = format!(
        "wheels of radius {radius} m that are not round, {}, each turned by a random angle, seed {seed}",
        shown.join(", ")
    );
    Ok(Irregularity::Given { profile, text, carrier: Carrier::Wheels { seed } })
}
