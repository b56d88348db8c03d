//! A measured profile as a Fourier series.

use super::{Component, IrregularityError, Realisation};
use crate::columns::{self, Columns, ColumnsError};
use crate::math::fourier;
use num_complex::Complex64;
use schemars::JsonSchema;
use serde::Deserialize;
use std::f64::consts::{PI, TAU};

/// Points a profile needs at least.
const LEAST: usize = 8;

/// The profile in `csv`: a header line, then x and r (positive down) in each line, x rising, in metres unless the header names
/// another unit ([`columns::read`]).
///
/// r is a Fourier series over the length of the profile and one more spacing, Ω_j = 2πj/L. It goes through every measured
/// point, less mean and slope. What is lost: mean and slope (line of least squares); waves longer than the
/// profile and shorter than two spacings; beyond its ends the profile repeats, with a step where they do not meet. Spacings that
/// differ by more than 1e-6 are made uniform by linear interpolation between as many points, which flattens the
/// waves shorter than some six of the widest spacings.
///
/// # Errors
/// No header; a line that is not two finite numbers; x that does not rise; fewer than eight points. The line is named.
///
/// Accuracy: at the points of a uniform profile of a thousand points, 2e-15 m, rounding (test `goes_through_every_point`).
pub fn measured(csv: &str) -> Result<Realisation, IrregularityError> {
    measured_rail(csv, None)
}

/// One of two rails.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema, PartialEq, Eq)]
#[serde(rename_all = "kebab-case")]
pub enum Rail {
    /// The second column.
    Left,
    /// The third one.
    Right,
    /// Both together, (r_left + r_right)/2: what wheelsets follow up and down.
    Mean,
}

/// As [`measured`], of a file that may hold both rails: a header, then x, r_left and r_right in each line. Of these the mean is taken,
/// unless one `rail` is asked for.
///
/// # Errors
/// As `measured`; a rail asked for where the file has one profile alone.
pub fn measured_rail(csv: &str, rail: Option<Rail>) -> Result<Realisation, IrregularityError> {
    let (x, r) = read(csv, rail)?;
    let (x_0, length) = (x[0], x[x.len() - 1] - x[0]);
    let spacing = length / (x.len() - 1) as f64;
    let place = |i: usize| x_0 + i as f64 * spacing;
    let uniform = x.iter().enumerate().all(|(i, &x)| (x - place(i)).abs() <= 1e-6 * spacing);
    let mut r = if uniform { r } else { resampled(&x, &r, place) };
    remove_line(&mut r);
    series(&r, x_0, spacing)
}

/// Positions and heights of a `rail` in `csv` [m], and their lines.
///
/// # Errors
/// No table; a rail asked for where there is one profile alone.
pub fn rail_columns(csv: &str, rail: Option<Rail>) -> Result<Columns, IrregularityError> {
    let pair = columns::read(csv);
    let table = match pair {
        Ok(pair) if rail.is_none() => return Ok(pair),
        Ok(_) => return Err(IrregularityError::Rails { found: 2, asked: true }),
        // a line with three numbers, or a fault that a table has too
        Err(fault) => match columns::table(csv) {
            Ok(table) if table.columns.len() > 2 => table,
            Err(wide @ ColumnsError::Line { wanted: 3.., .. }) => return Err(wide.into()),
            _ => return Err(fault.into()),
        },
    };
    let columns = columns::lengths(table)?;
    let [x, left, right] = &columns.columns[..] else {
        return Err(IrregularityError::Rails { found: columns.columns.len(), asked: false });
    };
    let values = match rail.unwrap_or(Rail::Mean) {
        Rail::Left => left.clone(),
        Rail::Right => right.clone(),
        Rail::Mean => left.iter().zip(right).map(|(l, r)| 0.5 * (l + r)).collect(),
    };
    Ok(Columns { x: x.clone(), values, lines: columns.lines })
}

/// Positions [m] and heights [m].
fn read(csv: &str, rail: Option<Rail>) -> Result<(Vec<f64>, Vec<f64>), IrregularityError> {
    let Columns { x, values, lines } = rail_columns(csv, rail)?;
    if let Some(i) = x.windows(2).position(|x| x[1] <= x[0]) {
        return Err(IrregularityError::NotRising { line: lines[i + 1], x: x[i + 1], before: x[i] });
    }
    if x.len() < LEAST {
        return Err(IrregularityError::TooFew { found: x.len(), least: LEAST });
    }
    Ok((x, values))
}

/// Linear interpolation of (x, r) at as many equal steps.
fn resampled(x: &[f64], r: &[f64], place: impl Fn(usize) -> f64) -> Vec<f64> {
    (0..x.len())
        .map(|i| {
            let at = place(i);
            // the interval with x[j − 1] ≤ at, the last one at the end
            let j = x.partition_point(|&x| x <= at).clamp(1, x.len() - 1);
            r[j - 1] + (r[j] - r[j - 1]) * (at - x[j - 1]) / (x[j] - x[j - 1])
        })
        .collect()
}

/// Takes the line of least squares away.
fn remove_line(r: &mut [f64]) {
    let n = r.len() as f64;
    let middle = 0.5 * (n - 1.0);
    let mean = r.iter().sum::<f64>() / n;
    let slope =
        r.iter().enumerate().map(|(i, r)| (i as f64 - middle) * r).sum::<f64>() * 12.0 / (n * (n * n - 1.0));
    for (i, r) in r.iter_mut().enumerate() {
        *r -= mean + slope * (i as f64 - middle);
    }
}

/// r_i = Σ a_j cos(Ω_j x_i + θ_j), Ω_j = 2πj/L, L = N · spacing.
fn series(r: &[f64], x_0: f64, spacing: f64) -> Result<Realisation, IrregularityError> {
    let count = r.len();
    let length = spacing * count as f64;
    // of r_i = Σ g_n e^{inφ_i}, φ_i = 2π(i + ½)/N = Ω_1(x_i − x_0) + π/N
    let g = fourier::harmonics(r.iter().map(|&r| Complex64::new(r, 0.0)).collect());
    let components = (1..=count / 2)
        .map(|j| {
            let n = j as f64;
            let wavenumber = n * TAU / length;
            // harmonics n and −n; the last one of an even count stands alone
            let pair = if 2 * j == count { 1.0 } else { 2.0 };
            Component {
                wavenumber,
                amplitude: pair * g[j].norm(),
                phase: g[j].arg() + n * PI / count as f64 - wavenumber * x_0,
            }
        })
        .collect();
    Ok(Realisation::new(components, length)?.starting(x_0))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn csv(points: impl Iterator<Item = (f64, f64)>) -> String {
        points.fold("x_m,r_m\n".to_owned(), |text, (x, r)| text + &format!("{x}, {r}\n"))
    }

    /// Three waves that fit into 100 m.
    fn waves(x: f64) -> f64 {
        [(1.0, 4e-3, 0.2), (7.0, 1e-3, 1.5), (40.0, 0.1e-3, -2.0)]
            .iter()
            .map(|(n, a, phase)| a * (n * TAU * x / 100.0 + phase).cos())
            .sum()
    }

    #[test]
    fn goes_through_every_point() {
        for count in [1000, 999] {
            // noise, a mean and a slope
            let noise = |i: i32| 1e-3 * (f64::from(i) * f64::from(i) * 0.731).sin();
            let point = |i: i32| (250.0 + 0.1 * f64::from(i), 0.5 + 2e-3 * f64::from(i) + noise(i));
            let r = measured(&csv((0..count).map(point))).unwrap();
            assert!((r.repeat_length() - 0.1 * f64::from(count)).abs() < 1e-9);
            // what is left after a line through the noise
            let mut expected: Vec<f64> = (0..count).map(noise).collect();
            remove_line(&mut expected);
            for (i, expected) in (0..count).zip(expected) {
                // measured 1.5e-15 m, rounding of values of up to 2.5 m
                assert!((r.at(point(i).0) - expected).abs() < 1e-13, "{i}");
            }
        }
    }

    #[test]
    fn finds_the_waves() {
        let r = measured(&csv((0..400).map(|i| (0.25 * f64::from(i), waves(0.25 * f64::from(i)))))).unwrap();
        // the line of least squares takes some of the longest wave with it and leaks into the others: measured 1.7, 7.8, 11 %
        for (n, amplitude) in [(1, 4e-3), (7, 1e-3), (40, 0.1e-3)] {
            let found = r.components()[n - 1];
            assert!((found.wavelength() - 100.0 / n as f64).abs() < 1e-9);
            assert!((found.amplitude / amplitude - 1.0).abs() < 0.12, "{n} {}", found.amplitude);
        }
    }

    #[test]
    fn uneven_spacing_is_made_even() {
        // spacings 0.17 to 0.33 m; measured 7.9e-6 m, most of it from the wave of 2.5 m and 0.1 mm
        let place = |i: i32| 0.25 * f64::from(i) + 0.05 * (f64::from(i) * 1.7).sin();
        let uneven = measured(&csv((0..=399).map(|i| (place(i), waves(place(i)))))).unwrap();
        let even =
            measured(&csv((0..=399).map(|i| (0.25 * f64::from(i), waves(0.25 * f64::from(i)))))).unwrap();
        for i in 20..380 {
            let x = 0.25 * f64::from(i);
            assert!((uneven.at(x) - even.at(x)).abs() < 0.01e-3, "{x} {} {}", uneven.at(x), even.at(x));
        }
    }

    #[test]
    fn rails_left_and_right() {
        let text = (0..40).fold("% car 3\nx [m];left [mm];right [mm]\n".to_owned(), |text, i| {
            let x = 0.25 * f64::from(i);
            text + &format!("{x};{};{}\n", (2.0 * x).sin(), (3.0 * x).cos()).replace('.', ",")
        });
        let of = |rail| rail_columns(&text, rail).unwrap();
        let (left, right, mean) = (of(Some(Rail::Left)), of(Some(Rail::Right)), of(None));
        for i in 0..40 {
            assert!((mean.values[i] - 0.5 * (left.values[i] + right.values[i])).abs() < 1e-18);
        }
        assert!((left.values[4] - 1e-3 * 2f64.sin()).abs() < 1e-12);
        assert!(measured_rail(&text, Some(Rail::Right)).is_ok());
        let why = |text: &str, rail| measured_rail(text, rail).unwrap_err().to_string();
        assert!(why("x,r\n0,1\n1,2\n", Some(Rail::Left)).contains("only the latter has rails"));
        assert!(why("x,l,r,z\n0,1,2,3\n1,2,3,4\n", None).starts_with("4 columns"));
        // a gap in one of them
        let gap = text.replacen("3,75;", "3,75;;", 1);
        assert!(why(&gap, None).starts_with("line 18 reads"), "{}", why(&gap, None));
    }

    #[test]
    fn says_what_is_wrong_and_where() {
        let why = |text: &str| measured(text).unwrap_err().to_string();
        assert!(why("0, 1\n1, 2").starts_with("line 1 reads \"0, 1\": it must be a header"));
        assert!(why("x,r\n0, 1\n\n1; 2").starts_with("line 4 reads \"1; 2\": it must be two finite numbers"));
        assert!(why("x,r\n0, inf").starts_with("line 2"));
        assert!(why("x,r\n0, 1\n0, 2").starts_with("line 3 stands at x = 0 m"));
        assert!(why("x,r\n0, 1\n1, 2").contains("has 2 points"));
        assert!(why("").contains("has 0 points"));
    }
}
