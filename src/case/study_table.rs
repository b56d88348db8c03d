//! `[study]`: what of a case is uncertain, as it is read.

use crate::sampling::{SamplingMethod, Site};
use schemars::JsonSchema;
use serde::Deserialize;
use toml::Value;

/// A number in the unit of the key that varies, or a text with its unit.
#[derive(Clone, Debug, Deserialize, JsonSchema, PartialEq)]
pub struct Amount(#[schemars(with = "f64")] pub Value);

/// `[study]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StudyInput {
    /// How many samples; a grid and one-at-a-time count theirs by themselves.
    pub samples: Option<usize>,
    /// Of all that is drawn; 1 by default.
    pub seed: Option<u64>,
    /// How samples are chosen; a Latin hypercube by default.
    pub method: Option<SamplingMethod>,
    /// What varies.
    #[serde(default)]
    pub vary: Vec<VaryInput>,
    /// What varies together.
    #[serde(default)]
    pub correlation: Vec<CorrelationInput>,
    /// Shear wave speeds of all layers that scatter together.
    pub shear_speed_profile: Option<ProfileInput>,
    /// Derivatives of every answer by each number of ground and track, two runs for each; true by default.
    pub derivatives: Option<bool>,
}

/// `[[study.vary]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VaryInput {
    /// Path of a number of the case: "soil.layer[0].shear_speed", with the place of the layer or its name.
    pub key: String,
    /// What is drawn multiplies the number that stands there.
    #[serde(default)]
    pub factor: bool,
    /// Nothing below it.
    pub min: Option<Amount>,
    /// Nothing above it.
    pub max: Option<Amount>,
    /// Of a grid: how many values; 3 by default.
    pub points: Option<usize>,
    /// Its distribution.
    #[serde(rename = "$rest")]
    #[schemars(flatten)]
    pub distribution: DistributionInput,
}

/// `study.vary.kind` and its parameters.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum DistributionInput {
    /// Gaussian.
    Normal {
        /// μ
        mean: Amount,
        /// σ
        standard_deviation: Option<Amount>,
        /// Coefficient of variation σ/μ, instead of σ.
        cov: Option<f64>,
    },
    /// Its logarithm is Gaussian.
    Lognormal {
        /// Half of all lies below it.
        median: Option<Amount>,
        /// Standard deviation of the logarithm, with a median.
        sigma_ln: Option<f64>,
        /// Mean, with a cov.
        mean: Option<Amount>,
        /// Coefficient of variation, with a mean.
        cov: Option<f64>,
    },
    /// All equally likely.
    Uniform {
        /// Least.
        from: Amount,
        /// Largest.
        to: Amount,
    },
    /// Most likely in one place, less so towards both ends.
    Triangular {
        /// Least.
        from: Amount,
        /// Most likely.
        mode: Amount,
        /// Largest.
        to: Amount,
    },
    /// One of several.
    List {
        /// Which.
        values: Vec<Amount>,
        /// How likely each is, against the others; all alike by default.
        weights: Option<Vec<f64>>,
    },
}

/// `[[study.correlation]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CorrelationInput {
    /// Two keys that vary.
    pub keys: Vec<String>,
    /// Correlation coefficient of their normal scores, above -1 and below 1.
    pub value: f64,
}

/// `[study.shear_speed_profile]`: after Toro (1995).
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ProfileInput {
    /// Kind of the site, with its published scatter.
    pub site: Option<Site>,
    /// Standard deviation of the logarithm of the shear wave speeds; that of the site by default.
    pub sigma_ln: Option<f64>,
    /// l [m]: neighbours correlate by e^(-distance/l); as those of the site by default.
    pub correlation_length: Option<f64>,
    /// No speed farther from its median than this many standard deviations; no limit by default.
    pub limit: Option<f64>,
}
