//! Named arrays with dimensions, units and provenance: what a study hands to the exporters.

use ndarray::{ArrayD, Ix1, IxDyn};
use num_complex::Complex64;

/// More values than this along two dimensions or more are a map, whatever they are over.
const LARGE: usize = 200_000;

/// An attribute of a group or of the whole file.
#[derive(Clone, Debug, PartialEq)]
pub enum Attribute {
    /// Text, stored as UTF-8.
    Text(String),
    /// One number.
    Number(f64),
    /// One whole number.
    Integer(i64),
}

impl From<&str> for Attribute {
    fn from(text: &str) -> Self {
        Self::Text(text.to_owned())
    }
}
impl From<String> for Attribute {
    fn from(text: String) -> Self {
        Self::Text(text)
    }
}
impl From<f64> for Attribute {
    fn from(value: f64) -> Self {
        Self::Number(value)
    }
}
impl From<i64> for Attribute {
    fn from(value: i64) -> Self {
        Self::Integer(value)
    }
}

/// A real array whose axes are named; a coordinate is a 1-D variable whose only dimension is its own name.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name within its group, ASCII.
    pub name: String,
    /// One dimension name per axis, slowest first; empty for a scalar.
    pub dims: Vec<String>,
    /// The values, row-major.
    pub values: ArrayD<f64>,
    /// Units as in CF conventions: `m s-1`, `m`, `rad m-1`, `1`.
    pub units: String,
    /// Description for axes and readers.
    pub long_name: String,
}

/// The variables of one study, with their shared coordinates first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Group {
    /// Group name, e.g. `critical_speed`.
    pub name: String,
    /// Coordinates and data.
    pub variables: Vec<Variable>,
    /// Attributes of the group.
    pub attributes: Vec<(String, Attribute)>,
}

impl Group {
    /// An empty group.
    pub fn new(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    /// Adds a coordinate: a 1-D variable along its own dimension, `values` in `units`.
    pub fn coordinate(self, name: &str, values: &[f64], units: &str, long_name: &str) -> Self {
        let values = ndarray::Array1::from(values.to_vec()).into_dyn();
        self.variable(name, &[name], values, units, long_name)
    }

    /// Adds a real variable along `dims`, which must be coordinates of the group of matching length.
    ///
    /// # Panics
    /// If the number of dimensions differs from that of `values`: a programming error, not an input error.
    pub fn variable(
        mut self,
        name: &str,
        dims: &[&str],
        values: ArrayD<f64>,
        units: &str,
        long_name: &str,
    ) -> Self {
        assert_eq!(dims.len(), values.ndim(), "dimensions of {name}");
        self.variables.push(Variable {
            name: name.to_owned(),
            dims: dims.iter().map(|d| (*d).to_owned()).collect(),
            values,
            units: units.to_owned(),
            long_name: long_name.to_owned(),
        });
        self
    }

    /// Adds a complex variable as the two real ones `…_re` and `…_im`.
    pub fn complex(
        self,
        name: &str,
        dims: &[&str],
        values: &ArrayD<Complex64>,
        units: &str,
        long_name: &str,
    ) -> Self {
        self.variable(
            &format!("{name}_re"),
            dims,
            values.mapv(|z| z.re),
            units,
            &format!("{long_name}, real part"),
        )
        .variable(
            &format!("{name}_im"),
            dims,
            values.mapv(|z| z.im),
            units,
            &format!("{long_name}, imaginary part"),
        )
    }

    /// Adds a scalar.
    pub fn scalar(self, name: &str, value: f64, units: &str, long_name: &str) -> Self {
        let values = ArrayD::from_elem(IxDyn(&[]), value);
        self.variable(name, &[], values, units, long_name)
    }

    /// Adds an attribute.
    pub fn attribute(mut self, name: &str, value: impl Into<Attribute>) -> Self {
        self.attributes.push((name.to_owned(), value.into()));
        self
    }

    /// Its fields over the plane of the ground, and all others of more than 200 000 values: too much for a table.
    pub fn maps(&self) -> impl Iterator<Item = &Variable> {
        self.variables.iter().filter(|v| v.is_map())
    }

    /// The variable called `name`, if the group has it.
    pub fn get(&self, name: &str) -> Option<&Variable> {
        self.variables.iter().find(|v| v.name == name)
    }
}

impl Variable {
    /// True for a 1-D variable along its own name.
    pub fn is_coordinate(&self) -> bool {
        self.dims.len() == 1 && self.dims[0] == self.name
    }

    /// True for a field over x and y, or of more than 200 000 values along several dimensions.
    pub fn is_map(&self) -> bool {
        let over = |axis: &str| self.dims.iter().any(|dimension| dimension == axis);
        self.dims.len() > 1 && (over("x") && over("y") || self.values.len() > LARGE)
    }

    /// The values of a 1-D variable as a vector; flattened in row-major order otherwise.
    pub fn to_vec(&self) -> Vec<f64> {
        match self.values.view().into_dimensionality::<Ix1>() {
            Ok(one) => one.to_vec(),
            Err(_) => self.values.iter().copied().collect(),
        }
    }
}

/// Everything a run leaves in `results.h5`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Dataset<'a> {
    /// Root attributes: version, case text, solver settings, concerns, Conventions.
    pub attributes: Vec<(String, Attribute)>,
    /// One group per study.
    pub groups: Vec<&'a Group>,
}
