//! Pictures of a figure: SVG, and the PNG of the same SVG.

use super::{OutputError, bars, bitmap, lines, map, save, sketch};
use crate::figure::Figure;
use std::path::Path;

/// A figure, drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Picture {
    /// File stem.
    pub name: String,
    /// SVG text, 900 px wide, with a `viewBox`, scalable.
    pub svg: String,
    /// What the report's script tells under the pointer: axes and numbers as JSON; empty of a sketch.
    pub readout: String,
}

impl Picture {
    /// Draws `figure`.
    ///
    /// # Errors
    /// [`OutputError::Figure`] if it holds nothing that can be drawn.
    pub fn of(figure: &Figure) -> Result<Self, OutputError> {
        let (canvas, readout) = match figure {
            Figure::Lines(lines) => lines::draw(lines)?,
            Figure::Map(map) => map::draw(map)?,
            Figure::Bars(bars) => (bars::draw(bars)?, String::new()),
            Figure::Sketch(sketch) => (sketch::draw(sketch), String::new()),
        };
        Ok(Self { name: figure.name().to_owned(), svg: canvas.svg(), readout })
    }

    /// The bytes of a PNG, 1800 px wide, of the same SVG.
    ///
    /// # Errors
    /// [`OutputError::Figure`] if the page has no size that a PNG can have.
    pub fn png(&self) -> Result<Vec<u8>, OutputError> {
        bitmap::of(&self.svg).map_err(|reason| OutputError::Figure {
            figure: self.name.clone(),
            reason,
            needed: "a size above zero".to_owned(),
        })
    }

    /// Writes `<name>.svg` and `<name>.png` into the folder `dir`, which must exist.
    ///
    /// # Errors
    /// [`OutputError::Write`] if a file cannot be written, as well as those of [`png`](Self::png).
    pub fn write(&self, dir: &Path) -> Result<(), OutputError> {
        save(&dir.join(format!("{}.svg", self.name)), self.svg.as_bytes())?;
        save(&dir.join(format!("{}.png", self.name)), &self.png()?)
    }
}
