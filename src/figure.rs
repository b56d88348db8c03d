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
    /// Values that the y axis holds whatever the curves: the same in pictures to be compared.
    pub y_holds: Option<(f64, f64)>,
    /// Logarithmic x axis.
    pub log_x: bool,
    /// Logarithmic y axis.
    pub log_y: bool,
    /// The curves.
    pub series: Vec<Series>,
    /// Vertical marks: abscissa and label, e.g. the critical speed.
    pub marks: Vec<(f64, String)>,
    /// Horizontal lines, labelled at their right end: ordinate and label, e.g. a guide value.
    pub levels: Vec<(f64, String)>,
    /// Labelled ticks of the x axis, e.g. nominal centres of bands; none: where they fall well.
    pub x_ticks: Vec<(f64, String)>,
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
            y_holds: None,
            log_x: false,
            log_y: false,
            series: Vec::new(),
            marks: Vec::new(),
            levels: Vec::new(),
            x_ticks: Vec::new(),
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
    /// Values that the colours hold whatever the field: the same in maps to be compared.
    pub holds: Option<(f64, f64)>,
    /// True where the sign matters: a diverging map symmetric about zero; else a sequential one.
    pub symmetric: bool,
    /// Equal scales on both axes.
    pub equal_axes: bool,
    /// Curves over the field, named in a legend below it.
    pub overlay: Vec<Series>,
}

/// Horizontal bars from zero, one below the other; those of several series lie over one another.
#[derive(Clone, Debug, PartialEq)]
pub struct BarFigure {
    /// File stem.
    pub name: String,
    /// Title above the picture.
    pub title: String,
    /// Label of the x axis, with unit.
    pub x_label: String,
    /// What each bar is of, from above.
    pub labels: Vec<String>,
    /// Name of each series, and its values for all labels.
    pub series: Vec<(String, Vec<f64>)>,
}

/// A layer of the ground, drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnLayer {
    /// What is written in it.
    pub label: String,
    /// h [m]; None of what never ends.
    pub thickness: Option<f64>,
    /// c_s [m/s], which its shade stands for; None of rock.
    pub shear_speed: Option<f64>,
}

/// A part of the track, drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct DrawnPart {
    /// What is written beside it.
    pub label: String,
    /// A spring between two masses or beams.
    pub is_spring: bool,
}

/// Train, track and ground, one above the other.
#[derive(Clone, Debug, PartialEq)]
pub struct SketchFigure {
    /// File stem.
    pub name: String,
    /// Title above the picture.
    pub title: String,
    /// Place behind the leading axle [m] and load [N] of each axle; may be empty.
    pub axles: Vec<(f64, f64)>,
    /// From the rail downward; may be empty.
    pub track: Vec<DrawnPart>,
    /// From the surface downward; may be empty.
    pub layers: Vec<DrawnLayer>,
}

/// Anything a study may ask for.
#[derive(Clone, Debug, PartialEq)]
pub enum Figure {
    /// Curves.
    Lines(LineFigure),
    /// A filled map.
    Map(MapFigure),
    /// Bars.
    Bars(BarFigure),
    /// Train, track and ground.
    Sketch(SketchFigure),
}

impl Figure {
    /// File stem of the picture.
    pub fn name(&self) -> &str {
        match self {
            Self::Lines(figure) => &figure.name,
            Self::Map(figure) => &figure.name,
            Self::Bars(figure) => &figure.name,
            Self::Sketch(figure) => &figure.name,
        }
    }

    /// Title of the picture.
    pub fn title(&self) -> &str {
        match self {
            Self::Lines(figure) => &figure.title,
            Self::Map(figure) => &figure.title,
            Self::Bars(figure) => &figure.title,
            Self::Sketch(figure) => &figure.title,
        }
    }
}
