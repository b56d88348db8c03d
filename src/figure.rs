//! What a study wants drawn, free of any plotting library: `output::plot` draws it as SVG and PNG.

use ndarray::Array2;

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stroke {
    /// A solid line.
    Solid,
    /// A dashed line.
    Dashed,
    /// Markers without a line: measured or published points.
    Points,
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Legend entry.
    pub name: String,
    /// Abscissae, in the unit of the figure's x label.
    pub x: Vec<f64>,
    /// Ordinates, in the unit of the figure's y label.
    pub y: Vec<f64>,
    /// Line or markers.
    pub stroke: Stroke,
}

/// A second scale along the same x axis, drawn on top: `label` and second = factor × first.
#[derive(Clone, Debug, PartialEq)]
pub struct SecondAxis {
    /// Label with unit, e.g. `speed [km/h]`.
    pub label: String,
    /// Second scale = factor × first scale.
    pub factor: f64,
}

/// Curves over one abscissa.
#[derive(Clone, Debug, PartialEq)]
pub struct LineFigure {
    /// File stem, e.g. `critical_speed`.
    pub name: String,
    /// Title above the picture.
    pub title: String,
    /// Label of the x axis, with unit.
    pub x_label: String,
    /// Label of the y axis, with unit.
    pub y_label: String,
    /// Optional second scale on top.
    pub second_x: Option<SecondAxis>,
    /// Draw the y axis pointing down (deflections positive downward).
    pub y_down: bool,
    /// Logarithmic x axis.
    pub log_x: bool,
    /// Logarithmic y axis.
    pub log_y: bool,
    /// The curves.
    pub series: Vec<Series>,
    /// Vertical marks: abscissa and label, e.g. the critical speed.
    pub marks: Vec<(f64, String)>,
}

impl LineFigure {
    /// An empty picture called `name` under a `title`, with the labels of its axes; both linear, y upward.
    pub fn new(
        name: impl Into<String>,
        title: impl Into<String>,
        x_label: impl Into<String>,
        y_label: impl Into<String>,
    ) -> Self {
        Self {
            name: name.into(),
            title: title.into(),
            x_label: x_label.into(),
            y_label: y_label.into(),
            second_x: None,
            y_down: false,
            log_x: false,
            log_y: false,
            series: Vec::new(),
            marks: Vec::new(),
        }
    }
}

/// A field over a rectangle, drawn as a filled map with a colour bar and equal axes.
#[derive(Clone, Debug, PartialEq)]
pub struct MapFigure {
    /// File stem, e.g. `contour_137`.
    pub name: String,
    /// Title above the picture.
    pub title: String,
    /// Label of the x axis, with unit.
    pub x_label: String,
    /// Label of the y axis, with unit.
    pub y_label: String,
    /// Label of the colour bar, with unit.
    pub value_label: String,
    /// x coordinates, uniform, ascending.
    pub x: Vec<f64>,
    /// y coordinates, uniform, ascending.
    pub y: Vec<f64>,
    /// Values (y, x), in the unit of the label.
    pub values: Array2<f64>,
    /// True where the sign matters: a diverging map symmetric about zero; else a sequential one.
    pub symmetric: bool,
    /// Equal scales on both axes.
    pub equal_axes: bool,
    /// Curves over the field, named in a legend below it.
    pub overlay: Vec<Series>,
}

/// Anything a study may ask for.
#[derive(Clone, Debug, PartialEq)]
pub enum Figure {
    /// Curves.
    Lines(LineFigure),
    /// A filled map.
    Map(MapFigure),
}

impl Figure {
    /// File stem of the picture.
    pub fn name(&self) -> &str {
        match self {
            Self::Lines(figure) => &figure.name,
            Self::Map(figure) => &figure.name,
        }
    }

    /// Title of the picture.
    pub fn title(&self) -> &str {
        match self {
            Self::Lines(figure) => &figure.title,
            Self::Map(figure) => &figure.title,
        }
    }
}
