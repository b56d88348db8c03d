//! Pictures of a figure, as SVG and as PNG.

use super::canvas::Canvas;
use super::{OutputError, lines, map, whole::write_bytes};
use crate::figure::Figure;
use std::path::{Path, PathBuf};

/// The figure as SVG text, 900 px wide, with a `viewBox`, scalable.
///
/// # Errors
/// [`OutputError::Figure`] if it holds nothing that can be drawn.
pub fn svg(figure: &Figure) -> Result<String, OutputError> {
    Ok(draw(figure)?.svg())
}

/// The figure as the bytes of a PNG, 1800 px wide.
///
/// # Errors
/// [`OutputError::Figure`] if it holds nothing that can be drawn.
pub fn png(figure: &Figure) -> Result<Vec<u8>, OutputError> {
    rasterise(&draw(figure)?, figure)
}

/// Writes `<name>.svg` and `<name>.png` into the folder `dir`, which must exist, and returns their paths.
///
/// # Errors
/// [`OutputError::Figure`] if it holds nothing that can be drawn, [`OutputError::Write`] if a file cannot be written.
pub fn write(figure: &Figure, dir: &Path) -> Result<[PathBuf; 2], OutputError> {
    let canvas = draw(figure)?;
    let paths = ["svg", "png"].map(|end| dir.join(format!("{}.{end}", figure.name())));
    write_bytes(&paths[0], canvas.svg().as_bytes())?;
    write_bytes(&paths[1], &rasterise(&canvas, figure)?)?;
    Ok(paths)
}

fn draw(figure: &Figure) -> Result<Canvas, OutputError> {
    match figure {
        Figure::Lines(lines) => lines::draw(lines),
        Figure::Map(map) => map::draw(map),
    }
}

fn rasterise(canvas: &Canvas, figure: &Figure) -> Result<Vec<u8>, OutputError> {
    canvas.png().map_err(|reason| OutputError::Figure {
        figure: figure.name().to_owned(),
        reason,
        remedy: "a size above zero".to_owned(),
    })
}
