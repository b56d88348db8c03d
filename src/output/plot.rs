//! Pictures of a figure, as SVG and as PNG, from one drawing.

use super::{OutputError, bars, lines, map, save, sketch};
use crate::figure::Figure;
use std::path::Path;

/// A figure, drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// SVG text, 900 px wide, with a `viewBox`, scalable.
    pub svg: String,
    /// The bytes of a PNG, 1800 px wide.
    pub png: Vec<u8>,
}

impl Picture {
    /// Draws `figure`.
    ///
    /// # Errors
    /// [`OutputError::Figure`] if it holds nothing that can be drawn.
    pub fn of(figure: &Figure) -> Result<Self, OutputError> {
        let canvas = match figure {
            Figure::Lines(lines) => lines::draw(lines)?,
            Figure::Map(map) => map::draw(map)?,
            Figure::Bars(bars) => bars::draw(bars)?,
            Figure::Sketch(sketch) => sketch::draw(sketch),
        };
        let png = canvas.png().map_err(|reason| OutputError::Figure {
            figure: figure.name().to_owned(),
            reason,
            needed: "a size above zero".to_owned(),
        })?;
        Ok(Self { svg: canvas.svg(), png })
    }

    /// Writes `<name>.svg` and `<name>.png` into the folder `dir`, which must exist.
    ///
    /// # Errors
    /// [`OutputError::Write`] if a file cannot be written.
    pub fn write(&self, name: &str, dir: &Path) -> Result<(), OutputError> {
        save(&dir.join(format!("{name}.svg")), self.svg.as_bytes())?;
        save(&dir.join(format!("{name}.png")), &self.png)
    }
}
