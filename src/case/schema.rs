//! The vocabulary of a case file, as it is read: every key, its unit, nothing checked yet.
//!
//! The file is long because it is that list, whole and in one place.

use super::about::About;
use super::assessment::{AssessmentInput, TransferInput};
use super::roughness_table::RoughnessTable;
use super::study_table::StudyInput;
use super::values::{Named, Range, SpanInput};
use crate::assessment::{Guide, Reference};
use crate::field::Quantity;
use crate::foundation::{FoundationModel, Springs};
use crate::irregularity::{Defect, Order, Rail, Spectrum};
use crate::rail::fem::Ends;
use crate::rail::{DecayRate, Method};
use crate::soil::dispersion::SurfaceWave;
use crate::soil::{Solver, Strip};
use crate::study::{Components, ContactLaw, Start};
use crate::track::Track;
use crate::vehicle::{Axle, Body, Bogie, Suspension, Tread, VehicleModel, Wheelset};
use schemars::JsonSchema;
use serde::Deserialize;

/// A case file.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CaseInput {
    /// Title of the case.
    pub title: String,
    /// Where the numbers come from.
    pub source: Option<String>,
    /// For whom the report is, and by whom.
    pub report: Option<About>,
    /// Layered ground, or the name of a library soil.
    pub soil: Option<Named<SoilInput>>,
    /// Springs instead of ground.
    #[schemars(with = "Option<FoundationModel>")]
    pub foundation: Option<Springs>,
    /// The track, or the name of a library track, or such a track by its `library` with other keys changed.
    #[schemars(with = "Option<TrackChoice>")]
    pub track: Option<Named<TrackInput>>,
    /// The train, or the name of a library vehicle.
    pub train: Option<Named<TrainInput>>,
    /// Largest rail deflections against speed.
    pub critical_speed: Option<CriticalSpeedInput>,
    /// Waves that travel along the ground and along the track by themselves.
    pub dispersion: Option<DispersionInput>,
    /// Rail and ground shapes at given speeds.
    pub track_response: Option<TrackResponseInput>,
    /// Maps of the ground's surface.
    pub contour: Option<ContourInput>,
    /// Displacements, strains and stresses of the ground below the surface.
    pub ground_at_depth: Option<GroundAtDepthInput>,
    /// Rail and ground under a standing harmonic load.
    pub receptance: Option<ReceptanceInput>,
    /// How fast vibration dies away along the rail.
    pub decay_rate: Option<DecayRateInput>,
    /// What a change of track does to waves along the rail.
    pub transition: Option<TransitionInput>,
    /// A train passes in time: contact that lets go, defects, hanging sleepers.
    pub passage: Option<PassageInput>,
    /// Roughness of the rail.
    pub irregularity: Option<IrregularityInput>,
    /// Vibration of the ground beside the track during a pass.
    pub free_field: Option<FreeFieldInput>,
    /// Table of k_eq(β, ω).
    pub equivalent_stiffness: Option<EquivalentStiffnessInput>,
    /// Table of G(k, ω).
    pub surface_compliance: Option<SurfaceComplianceInput>,
    /// What is uncertain: samples of the case, run by `groundwave study`.
    pub study: Option<StudyInput>,
}

/// `[soil]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SoilInput {
    /// Library files only: title.
    pub title: Option<String>,
    /// Library files only: source.
    pub source: Option<String>,
    /// Case files only: layers and base of a library soil, or of a TOML file beside the case.
    pub library: Option<String>,
    /// Which solver answers.
    pub solver: Option<SolversInput>,
    /// Layers, top first.
    #[serde(default)]
    pub layer: Vec<MaterialInput>,
    /// The half-space below them.
    pub half_space: Option<MaterialInput>,
    /// "rigid" instead of a half-space.
    pub base: Option<BaseInput>,
}

/// `soil.base`
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum BaseInput {
    /// Rigid rock.
    Rigid,
}

/// `soil.solver`
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SolversInput {
    /// Another solver, which answers every study a second time; the differences are reported. By name, or with its settings.
    #[schemars(with = "Option<Named<Solver>>")]
    pub verify: Option<Solver>,
    /// The solver; direct-stiffness by default.
    #[serde(rename = "$rest")]
    #[schemars(flatten)]
    pub solver: Option<Solver>,
}

/// `[[soil.layer]]` with a thickness, or `[soil.half_space]` without.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MaterialInput {
    /// Its name in reports: "soft clay".
    pub name: Option<String>,
    /// h [m] (layers only)
    pub thickness: Option<f64>,
    /// E [Pa]
    pub young: Option<f64>,
    /// ν
    pub poisson: Option<f64>,
    /// c_s [m/s]
    pub shear_speed: Option<f64>,
    /// c_p [m/s]
    pub pressure_speed: Option<f64>,
    /// ρ [kg/m³]
    pub density: f64,
    /// η of shear waves, and of pressure waves unless given on its own.
    pub loss_factor: Option<f64>,
    /// ξ = η/2
    pub damping_ratio: Option<f64>,
    /// η of pressure waves, acting on λ + 2μ.
    pub loss_factor_pressure: Option<f64>,
    /// ξ = η/2 of pressure waves.
    pub damping_ratio_pressure: Option<f64>,
}

/// Where there is a track, axles press on its rail and not on the ground.
fn load_without_track(schema: &mut schemars::Schema) {
    let kinds = schema.get_mut("oneOf").and_then(|kinds| kinds.as_array_mut());
    for kind in kinds.into_iter().flatten().filter(|kind| kind["properties"]["kind"]["const"] != "none") {
        kind["properties"]["load"] = false.into();
    }
}

/// `[track]`, whole track: both rails.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = load_without_track)]
pub struct TrackInput {
    /// Library files only: title.
    pub title: Option<String>,
    /// Library files only: source.
    pub source: Option<String>,
    /// Contact with the ground (all but none; not on springs).
    pub contact: Option<Strip>,
    /// How each axle presses on the ground (none).
    pub load: Option<LoadInput>,
    /// Supports that stand apart; without them everything is spread along the rail.
    pub support: Option<SupportInput>,
    /// Sections one after another, each with the keys of [track] that differ in it.
    #[serde(default)]
    #[schemars(with = "Vec<SectionInput>")]
    pub section: Vec<toml::Table>,
    /// The track itself.
    #[serde(rename = "$rest")]
    #[schemars(flatten)]
    pub track: Track,
}

/// `track`
#[derive(JsonSchema)]
#[schemars(untagged)]
#[expect(dead_code, reason = "what a library track is changed to is read as a whole track")]
enum TrackChoice {
    /// By name.
    Name(String),
    /// Written out.
    Table(Box<TrackInput>),
    /// A library track with other keys.
    Changed {
        /// Its name, or a TOML file beside the case.
        library: String,
        /// Keys of [track] that differ.
        #[serde(flatten)]
        changes: serde_json::Map<String, serde_json::Value>,
    },
}

/// `track.support`
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SupportInput {
    /// L [m]: every support carries L × the values per metre.
    pub spacing: f64,
    /// w [m], width of a sleeper along the track, on ground that feels its neighbours.
    pub width: Option<f64>,
}

/// `[[track.section]]`: any key of [track] that differs, and
#[derive(JsonSchema)]
pub struct SectionInput {
    /// [m], a whole number of bays; none for the first and the last section, which never end.
    #[expect(dead_code, reason = "read key by key, after the keys of [track]")]
    length: Option<f64>,
}

/// `track.load`
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum LoadInput {
    /// A point.
    Point,
    /// A rectangle.
    Patch {
        /// Half the length along the track [m].
        half_length: f64,
        /// Half the width across it, and which displacement is reported.
        #[serde(rename = "$rest")]
        #[schemars(flatten)]
        strip: Strip,
    },
}

/// `[train]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrainInput {
    /// Library files only: title.
    pub title: Option<String>,
    /// Library files only: source.
    pub source: Option<String>,
    /// Axles.
    pub axles: Option<Vec<Axle>>,
    /// A library vehicle instead of axles, or several of them one behind the other, [[train.vehicle]].
    pub vehicle: Option<VehiclesInput>,
    /// How many of them in a row; how often the whole list.
    pub count: Option<usize>,
    /// Runs the other way: the last axle leads.
    #[serde(default)]
    pub reversed: bool,
    /// Length over couplers [m], the distance at which `count` repeats the vehicle.
    pub length: Option<f64>,
    /// From the front over couplers to the first axle [m], where vehicles differ; by default as much as from the last axle to the rear.
    pub overhang: Option<f64>,
    /// Which bodies follow a rough rail, where dynamics are wanted.
    pub model: Option<VehicleModel>,
    /// Unsprung mass of each wheelset [kg] of the model "unsprung".
    pub unsprung_mass: Option<f64>,
    /// Body of a vehicle on bogies, which brings its axles and loads by itself.
    pub body: Option<Body>,
    /// Each of its bogies.
    pub bogie: Option<Bogie>,
    /// Each of its wheelsets.
    pub wheelset: Option<Wheelset>,
    /// Suspension of one wheelset.
    pub primary: Option<Suspension>,
    /// Suspension of one end of a body.
    pub secondary: Option<Suspension>,
    /// Contact of wheels and rails, where dynamics are wanted.
    pub wheel_rail: Option<WheelRailInput>,
}

/// `train.vehicle`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(expecting = "the name of a library vehicle, or a list [[train.vehicle]] of them")]
#[schemars(untagged)]
pub enum VehiclesInput {
    /// By name.
    #[serde(rename = "$text")]
    One(String),
    /// One behind the other.
    #[serde(rename = "$list")]
    Several(Vec<VehicleInput>),
}

/// `[[train.vehicle]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VehicleInput {
    /// A library vehicle, or a TOML file beside the case.
    pub name: String,
    /// How many of them in a row; 1 by default.
    pub count: Option<usize>,
    /// Runs the other way: its last axle leads.
    #[serde(default)]
    pub reversed: bool,
    /// Length over couplers [m], if the vehicle itself does not say.
    pub length: Option<f64>,
}

/// `[critical_speed]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CriticalSpeedInput {
    /// v [m/s], ascending.
    pub speeds: Range<f64>,
    /// At which trains are to run [m/s]: amplification there, and its share of the critical speed.
    pub line_speed: Option<f64>,
    /// Wanted error of deflections relative to that under an axle [1]; 1e-5 by default. 1e-3 takes half the time.
    pub accuracy: Option<f64>,
}

/// `[dispersion]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DispersionInput {
    /// f [Hz], above zero, ascending.
    pub frequencies: Range<f64>,
    /// How many modes, the slowest first; 3 by default.
    pub modes: Option<usize>,
    /// Which waves; Rayleigh by default.
    pub wave: Option<SurfaceWave>,
    /// How the ground moves over depth in each mode.
    pub shapes: Option<ShapesInput>,
}

/// `[dispersion.shapes]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShapesInput {
    /// f [Hz], above zero, ascending.
    pub frequencies: Range<f64>,
    /// Depths [m] below the surface, ascending.
    pub z: Range<f64>,
}

/// `[track_response]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TrackResponseInput {
    /// v [m/s]
    pub speeds: Range<f64>,
    /// At which trains are to run [m/s]: added to the speeds, with the amplification there on a track without separate supports.
    pub line_speed: Option<f64>,
    /// x′ [m]; by default 40 m behind the train to 20 m ahead of it.
    pub x: Option<SpanInput>,
    /// Spacing [m], 0.1 by default, 0.02 over supports.
    pub spacing: Option<f64>,
    /// Over supports: where the rail is watched [m] from a support; over it and in the middle of the bay by default.
    #[serde(default)]
    pub at: Vec<f64>,
    /// Over supports: frequency [Hz] with which all axle loads oscillate; constant loads by default.
    pub harmonic: Option<f64>,
    /// Over supports: f [Hz], above zero, ascending, of spectra of the rail under the leading axle.
    pub frequencies: Option<Range<f64>>,
    /// Spectra [m s] over frequency to draw beside the computed ones.
    #[serde(default)]
    pub spectra: Vec<BesideInput>,
    /// Records to draw beside the computed shapes.
    #[serde(default)]
    pub measured: Vec<MeasuredInput>,
    /// Another method, whose difference is reported.
    pub verify: Option<Method>,
    /// How the rail is asked; the best for its track by default.
    pub method: Option<Method>,
}

/// `[[track_response.measured]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeasuredInput {
    /// Speed the record belongs to [m/s].
    pub speed: f64,
    /// CSV file beside the case: a header line, then x′ (positive ahead) and deflection (positive down), in m or
    /// the units of the header, such as [mm].
    pub file: String,
    /// Legend entry.
    pub label: String,
}

/// `[contour]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ContourInput {
    /// v [m/s]
    pub speeds: Range<f64>,
    /// x′ [m], positive ahead of the leading axle.
    pub x: SpanInput,
    /// y [m], from the centre line of the track.
    pub y: SpanInput,
    /// [m]
    pub spacing: f64,
    /// What to map; vertical displacement by default.
    pub quantities: Option<Vec<Quantity>>,
    /// Distance to the periodic images [m]; by default from damping and wavelength.
    pub clearance: Option<f64>,
}

/// `[ground_at_depth]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct GroundAtDepthInput {
    /// v [m/s]; the train at rest is computed as well, and alone where this is left out.
    pub speeds: Option<Range<f64>>,
    /// Depths [m] below the surface, ascending, from 0.05 m.
    pub z: Range<f64>,
    /// Distances [m] from the centre line of the track; 0 by default.
    pub y: Option<Range<f64>>,
    /// x′ [m], positive ahead of the leading axle; from 10 m behind the train to 10 m ahead of it by default.
    pub x: Option<SpanInput>,
    /// Along x′ [m]; 0.25 by default.
    pub spacing: Option<f64>,
    /// Cyclic shear strain from which on the soil softens; 1e-4 by default.
    pub threshold_strain: Option<f64>,
}

/// `[receptance]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReceptanceInput {
    /// f [Hz], above zero, ascending.
    pub frequencies: Range<f64>,
    /// Distances from the centre line of the track [m]; none by default.
    #[serde(default)]
    pub receivers: Vec<f64>,
    /// The ground's surface around the force; none by default.
    pub map: Option<ReceptanceMapInput>,
    /// Where the force stands [m], from a support, or from the first change of section; 0 by default.
    pub from: Option<f64>,
    /// Where the rail answers [m], from the same; under the force alone by default.
    pub x: Option<Vec<f64>>,
    /// How the rail is asked; the best for its track by default.
    pub method: Option<Method>,
    /// Another way, whose difference is reported.
    pub verify: Option<Method>,
    /// Moduli over frequency to draw beside the computed ones.
    #[serde(default)]
    pub measured: Vec<BesideInput>,
}

/// `[transition]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TransitionInput {
    /// f [Hz], above zero, ascending.
    pub frequencies: Range<f64>,
    /// f [Hz] at which the receptance is drawn along the rail; none by default.
    pub along: Option<Vec<f64>>,
    /// Where the force of these stands [m] from the first change of section; half a metre before it by default.
    pub from: Option<f64>,
    /// Where they are drawn [m] from the first change; 15 m before it to 15 m behind by default.
    pub x: Option<SpanInput>,
    /// Spacing [m], 0.05 by default.
    pub spacing: Option<f64>,
    /// Another method for the receptances along the rail, whose difference is reported.
    pub verify: Option<Method>,
    /// How the rail is asked; the best for its track by default.
    pub method: Option<Method>,
}

/// `[decay_rate]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DecayRateInput {
    /// f [Hz], above zero, ascending.
    pub frequencies: Range<f64>,
    /// Which decay rate; that of the free wave by default.
    pub method: Option<DecayRate>,
    /// Where the force stands [m] from a support; in the middle of a bay by default.
    pub from: Option<f64>,
    /// How the rail is asked; the best for its track by default.
    pub rail: Option<Method>,
    /// Another way to ask it, whose difference is reported.
    pub verify: Option<Method>,
    /// Rates over frequency to draw beside the computed ones.
    #[serde(default)]
    pub measured: Vec<BesideInput>,
}

/// `[[receptance.measured]]`, `[[decay_rate.measured]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BesideInput {
    /// CSV file beside the case: a header line, then frequency and value, in Hz and SI units or those of the header.
    pub file: String,
    /// Legend entry.
    pub label: String,
}

/// `[receptance.map]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ReceptanceMapInput {
    /// f [Hz], above zero, ascending: a map each.
    pub frequencies: Range<f64>,
    /// x [m], along the track from the force.
    pub x: SpanInput,
    /// y [m], from the centre line of the track.
    pub y: SpanInput,
    /// [m]
    pub spacing: f64,
}

/// `train.wheel_rail`
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WheelRailInput {
    /// k_H of each wheelset [N/m].
    pub stiffness: Option<f64>,
    /// Radius of the wheels [m], instead of the stiffness: Hertz contact under the mean axle load.
    pub radius: Option<f64>,
    /// Profile of the wheels, with a radius; worn by default.
    pub tread: Option<Tread>,
}

/// `[irregularity]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case", deny_unknown_fields)]
#[schemars(tag = "kind")]
pub enum IrregularityInput {
    /// A measured profile of the rail.
    Measured {
        /// CSV file beside the case: a header line, then x and r (positive down), or x and the heights of the left and the right rail,
        /// in m or the units of the header, such as [mm].
        file: String,
        /// Of a file with both rails; their mean by default.
        rail: Option<Rail>,
        /// x of the profile abreast of the receivers, or at x = 0 of a passage [m]; its middle by default.
        abreast: Option<f64>,
        /// Shortest and longest wavelength [m]; all of the profile by default.
        wavelengths: Option<SpanInput>,
    },
    /// One wave of the rail.
    Sinusoidal {
        /// [m]
        wavelength: f64,
        /// [m]
        amplitude: f64,
        /// Of a cosine at the receivers [rad], 0 by default.
        #[serde(default)]
        phase: f64,
    },
    /// Wheels that are not round, on a smooth rail.
    OutOfRound {
        /// Of the wheels [m].
        radius: f64,
        /// Waves around the wheels.
        orders: Vec<Order>,
        /// Of the wheels' angles, 1 by default.
        seed: Option<u64>,
    },
    /// Profiles with a spectrum of one's own.
    Table(RoughnessTable),
    /// Profiles with a published spectrum.
    #[serde(rename = "$other")]
    #[schemars(untagged)]
    Random {
        /// Which.
        #[serde(rename = "$rest")]
        #[schemars(flatten)]
        spectrum: Spectrum,
        /// Shortest and longest wavelength [m].
        wavelengths: SpanInput,
        /// Seed of the first profile histories are made for, 1 by default.
        seed: Option<u64>,
        /// How many profiles histories are made for, with this seed and the next; 10 by default.
        profiles: Option<usize>,
    },
}

/// `[free_field]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FreeFieldInput {
    /// v [m/s]
    pub speed: f64,
    /// Distances from the centre line of the track [m], ascending.
    pub receivers: Vec<f64>,
    /// T [s], over which the energy of the pass is averaged; by default train length and twice the farthest receiver over v.
    pub passage_time: Option<f64>,
    /// Directions of the motion: the vertical one by default, or all three.
    #[serde(default)]
    pub components: Components,
    /// Bands from the one with the lower to the one with the upper frequency [Hz]; 1 to 80 Hz by default.
    pub frequencies: Option<SpanInput>,
    /// Standards whose measures are told and whose guide values are drawn; all by default.
    pub guide: Option<Vec<Guide>>,
    /// Reference of a decibel axis for pictures of third octaves: "1e-9 m/s", "5e-8 m/s" or "vdb"; velocities by default.
    pub levels: Option<Reference>,
    /// Passes of whole days.
    pub assessment: Option<AssessmentInput>,
    /// From the ground into a building, by tables: estimates.
    pub transfer: Option<TransferInput>,
}

/// `[passage]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PassageInput {
    /// v [m/s]
    pub speed: Option<f64>,
    /// Several of them instead [m/s].
    pub speeds: Option<Range<f64>>,
    /// Where the leading axle stands at first [m], x as its supports have it: one at 0, or the first change of section.
    pub from: f64,
    /// Where it stands at last [m].
    pub to: f64,
    /// What of the track is computed [m]; by default from behind the last axle to ahead of the first one, with 18 m beyond both,
    /// 30 m where something strikes.
    pub track: Option<SpanInput>,
    /// Finite elements between two supports, or on 0.6 m of a continuous track; 8 by default.
    pub elements_per_bay: Option<usize>,
    /// Δt [s]; by default what the profiles and frequencies need.
    pub step: Option<f64>,
    /// v Δt [m] instead.
    pub step_length: Option<f64>,
    /// "non-linear" by default.
    pub contact: Option<ContactLaw>,
    /// "static" where wheels have a mass, "ramp" for constant loads by default.
    pub start: Option<Start>,
    /// Way over which a start by "ramp" takes hold, or [irregularity] under wheels that start at rest [m]; 12 by default.
    pub ramp: Option<f64>,
    /// "pinned" by default.
    pub ends: Option<Ends>,
    /// α of Hilber, Hughes & Taylor, −1/3 to 0; 0 by default, without damping by the steps.
    pub alpha: Option<f64>,
    /// Damping of the track in proportion to mass and stiffness, besides its own; none by default.
    pub damping: Option<ModalInput>,
    /// Defects of the rail and of wheels.
    #[serde(default)]
    pub defect: Vec<DefectInput>,
    /// Sleepers that do not reach their bed.
    #[serde(default)]
    pub hanging_sleeper: Vec<HangingInput>,
    /// Numbers of supports that are not there: number n stands at x = n × spacing; of sections, 0 is the first behind the first change.
    #[serde(default)]
    pub missing_sleepers: Vec<i64>,
    /// Where rail and sleepers are watched [m].
    #[serde(default)]
    pub at: Vec<f64>,
    /// Lowest and highest frequency of interest [Hz], for third octaves of the contact force; 5 to 500 Hz by default.
    pub frequencies: Option<SpanInput>,
}

/// `[passage.damping]`: of Rayleigh with two modes, of Caughey with more.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModalInput {
    /// f of the modes [Hz].
    pub frequencies: Vec<f64>,
    /// ζ of each.
    pub ratios: Vec<f64>,
}

/// `[[passage.defect]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DefectInput {
    /// Where the x = 0 of its formula lies [m]: middle of a joint, edge of a step, beginning of the others, first touch of a flat.
    pub at: f64,
    /// Of a flat: wheels that have it, counted from 1, the leading one.
    pub wheels: Option<Vec<usize>>,
    /// The defect itself.
    #[serde(rename = "$rest")]
    #[schemars(flatten)]
    pub defect: Defect,
}

/// `[[passage.hanging_sleeper]]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HangingInput {
    /// Their numbers, as those of `missing_sleepers`.
    pub sleepers: Vec<i64>,
    /// Between sleeper and bed [m].
    pub gap: f64,
}

/// `[equivalent_stiffness]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EquivalentStiffnessInput {
    /// β [rad/m]
    pub beta: Range<f64>,
    /// f [Hz]
    pub frequencies: Range<f64>,
}

/// `[surface_compliance]`
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SurfaceComplianceInput {
    /// k [rad/m]
    pub k: Range<f64>,
    /// f [Hz]
    pub frequencies: Range<f64>,
}
