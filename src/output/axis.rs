//! Scales of a picture: where a value lands, and which values get a tick.

/// Powers of ten written out in full up to here; beyond, the axis carries a factor ×10ⁿ.
const PLAIN: std::ops::Range<f64> = 1e-2..1e5;

/// Sizes that have a place on an axis: beyond, margins and ticks leave the range of floating-point numbers.
pub(super) const PLACES: std::ops::Range<f64> = 1e-290..1e290;

/// A linear or logarithmic map from values to pixels.
#[derive(Clone, Copy, Debug)]
pub(super) struct Scale {
    lo: f64,
    hi: f64,
    log: bool,
    /// Pixel of `lo` and of `hi`: descending for an axis that points up.
    pixels: (f64, f64),
}

/// A labelled tick.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Tick {
    pub value: f64,
    pub label: String,
}

/// The ticks of one axis and the power of ten their labels are to be multiplied by.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Ticks {
    pub major: Vec<Tick>,
    /// Unlabelled, on logarithmic axes.
    pub minor: Vec<f64>,
    /// Labels × 10^exponent = values.
    pub exponent: i32,
}

impl Scale {
    pub fn new((lo, hi): (f64, f64), log: bool, pixels: (f64, f64)) -> Self {
        Self { lo, hi, log, pixels }
    }

    /// The values at both ends.
    pub fn range(&self) -> (f64, f64) {
        (self.lo, self.hi)
    }

    /// The pixels of both ends.
    pub fn pixels(&self) -> (f64, f64) {
        self.pixels
    }

    pub fn is_log(&self) -> bool {
        self.log
    }

    /// The pixel of `value`.
    pub fn at(&self, value: f64) -> f64 {
        let f = |v: f64| if self.log { v.log10() } else { v };
        let part = (f(value) - f(self.lo)) / (f(self.hi) - f(self.lo));
        self.pixels.0 + part * (self.pixels.1 - self.pixels.0)
    }

    /// The same stretch of pixels in other units: value × `factor`.
    pub fn times(&self, factor: f64) -> Self {
        Self { lo: self.lo * factor, hi: self.hi * factor, ..*self }
    }

    /// Those of `own` ticks, value and label, that lie on the axis; of none about `count` as they fall.
    pub fn ticks_or(&self, own: &[(f64, String)], count: usize) -> Ticks {
        if own.is_empty() {
            return self.ticks(count);
        }
        let (lo, hi) = (self.lo.min(self.hi), self.lo.max(self.hi));
        let inside = own.iter().filter(|(value, _)| (lo..=hi).contains(value));
        let major = inside.map(|(value, label)| Tick { value: *value, label: label.clone() }).collect();
        Ticks { major, minor: Vec::new(), exponent: 0 }
    }

    /// Ticks at 1, 2 or 5 times a power of ten, about `count` of them.
    pub fn ticks(&self, count: usize) -> Ticks {
        let (lo, hi) = (self.lo.min(self.hi), self.lo.max(self.hi));
        if self.log { log_ticks(lo, hi) } else { linear_ticks(lo, hi, count) }
    }
}

/// The 1-2-5 step that divides `span` into about `count` parts.
pub(super) fn step(span: f64, count: usize) -> f64 {
    let raw = span / count.max(1) as f64;
    let power = 10f64.powf(raw.log10().floor());
    let factor = match raw / power {
        r if r < 2f64.sqrt() => 1.0,
        r if r < 10f64.sqrt() => 2.0,
        r if r < 50f64.sqrt() => 5.0,
        _ => 10.0,
    };
    factor * power
}

fn linear_ticks(lo: f64, hi: f64, count: usize) -> Ticks {
    let step = step(hi - lo, count);
    // A hair of slack keeps the ends, which rounding may push out.
    let first = (lo / step - 1e-9).ceil() as i64;
    let last = (hi / step + 1e-9).floor() as i64;
    let size = lo.abs().max(hi.abs());
    let exponent = if PLAIN.contains(&size) { 0 } else { 3 * (size.log10() / 3.0).floor() as i32 };
    let unit = 10f64.powi(exponent);
    let decimals = (-((step / unit).log10() + 1e-9).floor()).max(0.0) as usize;
    let major = (first..=last)
        .map(|i| {
            let value = i as f64 * step;
            let label = minus(format!("{:.decimals$}", value / unit));
            Tick { value, label }
        })
        .collect();
    Ticks { major, minor: Vec::new(), exponent }
}

fn log_ticks(lo: f64, hi: f64) -> Ticks {
    let decades = (hi / lo).log10();
    let (first, last) = (lo.log10().floor() as i32, hi.log10().ceil() as i32);
    let inside = |v: &f64| (lo * (1.0 - 1e-9)..=hi * (1.0 + 1e-9)).contains(v);
    let labelled: &[i32] = if decades < 2.5 { &[1, 2, 5] } else { &[1] };
    // Over many decades every second or third power is enough.
    let stride = (decades / 8.0).ceil().max(1.0) as i32;
    let mut ticks = Ticks { major: Vec::new(), minor: Vec::new(), exponent: 0 };
    for power in first..=last {
        for digit in 1..10 {
            let value = f64::from(digit) * 10f64.powi(power);
            if !inside(&value) {
                continue;
            }
            if labelled.contains(&digit) && power.rem_euclid(stride) == 0 {
                let label = if decades < 2.5 && (-3..5).contains(&power) {
                    format!("{:.*}", (-power).max(0) as usize, value)
                } else if digit == 1 {
                    format!("10{}", superscript(power))
                } else {
                    format!("{digit}·10{}", superscript(power))
                };
                ticks.major.push(Tick { value, label });
            } else if stride == 1 || digit == 1 {
                ticks.minor.push(value);
            }
        }
    }
    ticks
}

/// `n` in superscript digits.
pub(super) fn superscript(n: i32) -> String {
    const DIGITS: [char; 10] = ['⁰', '¹', '²', '³', '⁴', '⁵', '⁶', '⁷', '⁸', '⁹'];
    n.to_string().chars().map(|c| c.to_digit(10).map_or('⁻', |d| DIGITS[d as usize])).collect()
}

/// A true minus sign, and none before a zero.
fn minus(text: String) -> String {
    match text.strip_prefix('-') {
        Some(rest) if rest.chars().all(|c| "0.".contains(c)) => rest.to_owned(),
        Some(rest) => format!("−{rest}"),
        None => text,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: &Ticks) -> Vec<&str> {
        ticks.major.iter().map(|t| t.label.as_str()).collect()
    }

    #[test]
    fn linear_ticks_are_one_two_five() {
        let ticks = |lo, hi| Scale::new((lo, hi), false, (0.0, 1.0)).ticks(6);
        assert_eq!(labels(&ticks(0.0, 1.0)), ["0.0", "0.2", "0.4", "0.6", "0.8", "1.0"]);
        assert_eq!(labels(&ticks(-0.3, 0.25)), ["−0.3", "−0.2", "−0.1", "0.0", "0.1", "0.2"]);
        assert_eq!(labels(&ticks(10.0, 200.0)), ["50", "100", "150", "200"]);
    }

    #[test]
    fn small_values_share_a_power_of_ten() {
        let ticks = Scale::new((0.0, 4e-9), false, (0.0, 1.0)).ticks(4);
        assert_eq!(ticks.exponent, -9);
        assert_eq!(labels(&ticks), ["0", "1", "2", "3", "4"]);
        assert_eq!(superscript(-12), "⁻¹²");
    }

    #[test]
    fn logarithmic_ticks_fit_bands_and_spectra() {
        let bands = Scale::new((1.0, 80.0), true, (0.0, 1.0)).ticks(6);
        assert_eq!(labels(&bands), ["1", "2", "5", "10", "20", "50"]);
        assert!(bands.minor.contains(&30.0));
        let spectrum = Scale::new((1e-12, 1e-8), true, (0.0, 1.0)).ticks(6);
        assert_eq!(labels(&spectrum), ["10⁻¹²", "10⁻¹¹", "10⁻¹⁰", "10⁻⁹", "10⁻⁸"]);
    }

    #[test]
    fn scales_meet_their_ends() {
        let scale = Scale::new((1.0, 100.0), true, (10.0, 30.0));
        assert_eq!((scale.at(1.0), scale.at(10.0), scale.at(100.0)), (10.0, 20.0, 30.0));
        let kmh = Scale::new((10.0, 60.0), false, (0.0, 100.0)).times(3.6);
        assert_eq!(kmh.at(36.0), 0.0);
        assert_eq!(kmh.at(216.0), 100.0);
    }
}
