//! What a picture tells under the pointer: its axes and the exact numbers it was drawn from, for the report's script.

use super::axis::Scale;
use super::curves::{levels, marks};
use super::page::Area;
use crate::figure::{LineFigure, MapFigure, SecondAxis, Series};
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use flate2::Compression;
use flate2::write::ZlibEncoder;
use ndarray::Slice;
use serde_json::{Value, json};
use std::io::Write as _;

/// Longest text of a packed field [bytes]; larger fields are thinned out.
const LARGEST_FIELD: usize = 60_000;
/// Steps between the smallest and the largest value of a field; the last of 16 bits stands for what is not a number.
const STEPS: f64 = 65_534.0;

/// The readout of curves in `frame` with the scales `x` and `y`, as JSON.
pub(super) fn of_lines(figure: &LineFigure, frame: Area, x: Scale, y: Scale) -> String {
    let (curves, numbers) = curves(&figure.series);
    let second = figure.second_x.as_ref().map(|SecondAxis { label, factor }| {
        json!({"label": label, "factor": factor, "exponent": x.times(*factor).ticks(8).exponent})
    });
    text(json!({
        "frame": [frame.left, frame.top, frame.right, frame.bottom],
        "x": axis(&figure.x_label, x), "y": axis(&figure.y_label, y), "second": second,
        "marks": marks(figure).map(|m| m.0).collect::<Vec<_>>(),
        "levels": levels(figure).map(|l| l.0).collect::<Vec<_>>(),
        "ticks": figure.x_ticks, "curves": curves, "numbers": numbers,
    }))
}

/// The readout of a field, and of the curves over it.
pub(super) fn of_map(figure: &MapFigure, frame: Area, x: Scale, y: Scale) -> String {
    let (curves, numbers) = curves(&figure.overlay);
    text(json!({
        "frame": [frame.left, frame.top, frame.right, frame.bottom],
        "x": axis(&figure.x_label, x), "y": axis(&figure.y_label, y),
        "marks": [], "levels": [], "ticks": [], "curves": curves, "numbers": numbers, "field": field(figure),
    }))
}

/// JSON that may stand in a script element.
fn text(value: Value) -> String {
    value.to_string().replace('<', "\\u003c")
}

/// Label, values at the start and the end of the scale's pixels, those pixels, and the power of ten the ticks leave out.
fn axis(label: &str, scale: Scale) -> Value {
    let exponent = scale.ticks(7).exponent;
    json!({"label": label, "range": scale.range(), "pixels": scale.pixels(), "log": scale.is_log(), "exponent": exponent})
}

/// Of each curve its name and where its numbers start among all, which are told once where curves share them; and the numbers.
fn curves(series: &[Series]) -> (Vec<Value>, String) {
    let mut numbers: Vec<f32> = Vec::new();
    let mut kept: Vec<(&[f64], usize)> = Vec::new();
    let mut place = |values| {
        // equal bits: what is not a number equals itself
        let same =
            |other: &[f64]| other.iter().map(|v| v.to_bits()).eq(<[f64]>::iter(values).map(|v| v.to_bits()));
        if let Some((_, start)) = kept.iter().find(|(other, _)| same(other)) {
            return *start;
        }
        let start = numbers.len();
        kept.push((values, start));
        numbers.extend(values.iter().map(|v| *v as f32));
        start
    };
    let curves = series
        .iter()
        .map(|s| {
            let count = s.x.len().min(s.y.len());
            json!({"name": s.name, "x": place(&s.x), "y": place(&s.y), "count": count})
        })
        .collect();
    (curves, pack(numbers.iter().map(|v| v.to_le_bytes())))
}

/// A field in steps of its range: differences along each row in 16 bits, every so many values as the size allows.
fn field(figure: &MapFigure) -> Value {
    let finite = figure.values.iter().copied().filter(|v| v.is_finite());
    let (low, high) = finite.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(v), h.max(v)));
    let step = (high - low) / STEPS;
    let code = |value: f64| if value.is_finite() { ((value - low) / step) as u16 } else { u16::MAX };
    let packed = |stride: usize| {
        let thin = figure.values.slice_each_axis(|_| Slice::new(0, None, stride as isize));
        let rows = thin.rows().into_iter().flat_map(|row| {
            let codes: Vec<u16> = row.iter().map(|v| code(*v + 0.5 * step)).collect();
            let before: Vec<u16> = std::iter::once(0).chain(codes.iter().copied()).collect();
            codes
                .into_iter()
                .zip(before)
                .map(|(own, before)| own.wrapping_sub(before).to_le_bytes())
                .collect::<Vec<_>>()
        });
        pack(rows)
    };
    let fits = (1..).map(|stride| (stride, packed(stride))).find(|(_, text)| text.len() <= LARGEST_FIELD);
    let (stride, numbers) = fits.unwrap_or_default();
    let thin =
        |axis: &[f64]| axis.iter().copied().step_by(stride.max(1)).map(|v| v as f32).collect::<Vec<_>>();
    json!({"label": figure.value_label, "low": low, "step": step, "x": thin(&figure.x), "y": thin(&figure.y), "numbers": numbers})
}

/// Numbers of N bytes: all first bytes, then all second ones, …, deflated (zlib), as base 64.
fn pack<const N: usize>(numbers: impl Iterator<Item = [u8; N]>) -> String {
    let numbers: Vec<[u8; N]> = numbers.collect();
    let bytes: Vec<u8> = (0..N).flat_map(|i| numbers.iter().map(move |number| number[i])).collect();
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::best());
    // a Vec takes whatever is written to it
    match encoder.write_all(&bytes).and_then(|()| encoder.finish()) {
        Ok(packed) => BASE64_STANDARD.encode(packed),
        Err(_) => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::Stroke;
    use flate2::read::ZlibDecoder;
    use ndarray::Array2;
    use std::io::Read as _;

    fn unpack<const N: usize>(text: &str) -> Vec<[u8; N]> {
        let mut bytes = Vec::new();
        ZlibDecoder::new(&BASE64_STANDARD.decode(text).unwrap()[..]).read_to_end(&mut bytes).unwrap();
        let count = bytes.len() / N;
        (0..count).map(|i| std::array::from_fn(|k| bytes[k * count + i])).collect()
    }

    #[test]
    fn curves_that_share_abscissae_tell_them_once_to_seven_digits() {
        let line = |name: &str, y: Vec<f64>| Series {
            name: name.into(),
            x: vec![0.1, 0.2, 0.3],
            y,
            stroke: Stroke::Solid,
        };
        let series = [line("a", vec![1.0, f64::NAN, 1.0 / 3.0]), line("b", vec![1e-9, 2.0, 3.0])];
        let (curves, numbers) = curves(&series);
        let numbers: Vec<f32> = unpack(&numbers).into_iter().map(f32::from_le_bytes).collect();
        assert_eq!(numbers.len(), 9);
        assert_eq!((&curves[0]["x"], &curves[1]["x"]), (&json!(0), &json!(0)));
        let start = curves[0]["y"].as_u64().unwrap() as usize;
        assert!(numbers[start + 1].is_nan());
        // half a step of single precision, 2⁻²⁵
        assert!((f64::from(numbers[start + 2]) * 3.0 - 1.0).abs() < 3e-8);
    }

    fn map(n: usize) -> MapFigure {
        let axis: Vec<f64> = (0..n).map(|i| i as f64 * 0.25).collect();
        let mut values =
            Array2::from_shape_fn((n, n), |(j, i)| (0.31 * i as f64).sin() * (0.17 * j as f64).cos() * 2.3);
        values[[1, 2]] = f64::NAN;
        MapFigure {
            name: "m".into(),
            title: "t".into(),
            x_label: "x".into(),
            y_label: "y".into(),
            value_label: "u [mm]".into(),
            x: axis.clone(),
            y: axis,
            values,
            holds: None,
            symmetric: true,
            equal_axes: true,
            overlay: Vec::new(),
        }
    }

    #[test]
    fn a_field_comes_back_to_half_a_step_and_stays_small() {
        for n in [9, 700] {
            let figure = map(n);
            let told = field(&figure);
            let text = told["numbers"].as_str().unwrap();
            assert!(text.len() <= LARGEST_FIELD);
            let count = told["x"].as_array().unwrap().len();
            let place = |i: usize| told["x"][i].as_f64().unwrap();
            let stride = ((place(1) - place(0)) / 0.25) as usize;
            assert_eq!((count, stride > 1), (n.div_ceil(stride), n == 700));
            let (low, step) = (told["low"].as_f64().unwrap(), told["step"].as_f64().unwrap());
            let codes: Vec<u16> = unpack(text).into_iter().map(u16::from_le_bytes).collect();
            for (j, row) in codes.chunks(count).enumerate() {
                let mut code = 0u16;
                for (i, difference) in row.iter().enumerate() {
                    code = code.wrapping_add(*difference);
                    let exact = figure.values[[j * stride, i * stride]];
                    if exact.is_nan() {
                        assert_eq!(code, u16::MAX);
                    } else {
                        let apart = (low + f64::from(code) * step - exact).abs() / step;
                        // half a step, and rounding
                        assert!(apart < 0.5 + 1e-6, "{apart} steps at {j}, {i}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_label_cannot_end_the_script() {
        assert!(!text(json!({"a": "</script>"})).contains("</"));
    }
}
