//! What a reader sees of the ground at depth: arrays, curves over depth, sections, answers, concerns.

use super::GroundStates;
use crate::concern::Concern;
use crate::dataset::Group;
use crate::field::COMPONENTS;
use crate::figure::{Figure, LineFigure, MapFigure, Series, Stroke};
use crate::railway::Railway;
use crate::study::doubts::{missed_accuracy, outruns_waves, sinks_as_no_track_does};
use crate::study::{Answer, Outcome, speed_text, tag};
use ndarray::{Array2, ArrayD, ArrayView2, Axis, IxDyn};

/// Places of u_z and σ_zz among the components.
const U_Z: usize = 2;
const SIGMA_ZZ: usize = 11;
/// Length over depth from which on a section is not drawn to scale.
const FLATTEST: f64 = 8.0;
/// Depths from which on a section is drawn.
const ENOUGH: usize = 5;

/// "at rest", or the speed.
fn at(speed: f64) -> String {
    if speed == 0.0 { "at rest".into() } else { format!("at {}", speed_text(speed)) }
}

/// "rest", or the speed, in names of files and keys.
fn key(speed: f64) -> String {
    if speed == 0.0 { "rest".into() } else { tag(speed) }
}

impl GroundStates {
    /// Everything a run leaves.
    pub(super) fn shown(&self, railway: &Railway) -> Outcome {
        let (strain, pressure, sinking) =
            (self.largest_strain(), self.largest_of(SIGMA_ZZ, -1.0), self.largest_of(U_Z, 1.0));
        let curves = [
            ("strain", "octahedral shear strain γ_oct [1]", &strain, 1.0),
            ("stress", "vertical compression −σ_zz [kPa]", &pressure, 1e-3),
            ("displacement", "displacement u_z [mm], positive down", &sinking, 1e3),
        ];
        let mut figures: Vec<(Figure, String)> = curves
            .iter()
            .map(|(name, label, values, scale)| self.over_depth(name, label, values, *scale))
            .collect();
        if let Some(ratio) = self.ratio(&strain) {
            figures.push(ratio);
        }
        let strains = self.octahedral.iter().map(|o| o.index_axis(Axis(1), 0)).collect();
        figures.extend(self.sections("strain", "γ_oct [1e-6]", strains, 1e6, false));
        let stresses = self
            .fields
            .iter()
            .map(|f| f.values.index_axis(Axis(0), SIGMA_ZZ).index_axis_move(Axis(1), 0))
            .collect();
        figures.extend(self.sections("stress", "σ_zz [kPa], tension positive", stresses, 1e-3, true));
        Outcome {
            group: self.group(&strain, &pressure, &sinking),
            figures,
            answers: (0..self.speeds.len()).flat_map(|n| self.answers(n, &strain, &pressure)).collect(),
            concerns: self.concerns(railway, &strain),
        }
    }

    /// Depth of the largest value of a row.
    fn deepest(&self, row: ndarray::ArrayView1<f64>) -> (f64, f64) {
        let largest = (0..row.len()).max_by(|a, b| row[*a].total_cmp(&row[*b])).unwrap_or(0);
        (row[largest], self.depths[largest])
    }

    fn answers(&self, n: usize, strain: &Array2<f64>, pressure: &Array2<f64>) -> Vec<Answer> {
        let (speed, at) = (self.speeds[n], at(self.speeds[n]));
        let tag = key(speed);
        let (gamma, z) = self.deepest(strain.row(n));
        let mut answers = vec![Answer::new(
            &format!("max_octahedral_strain_{tag}"),
            format!("Largest octahedral shear strain {at}, of the asked depths at z = {z} m"),
            gamma,
            "1",
            format!("{gamma:.2e} ({:.2} of the threshold {:.0e})", gamma / self.threshold, self.threshold),
        )];
        if n > 0 {
            let ratios: Vec<f64> =
                strain.row(n).iter().zip(strain.row(0)).map(|(moving, rest)| moving / rest).collect();
            let (ratio, z) = self.deepest(ndarray::ArrayView1::from(&ratios));
            answers.push(Answer::new(
                &format!("strain_amplification_{tag}"),
                format!("Largest ratio of that strain {at} to the one at rest, at z = {z} m"),
                ratio,
                "1",
                format!("{ratio:.2}"),
            ));
        }
        let (stress, z) = self.deepest(pressure.row(n));
        answers.push(Answer::new(
            &format!("max_compression_{tag}"),
            format!("Largest vertical compression by the train {at}, of the asked depths at z = {z} m"),
            stress,
            "Pa",
            format!("{:.1} kPa", 1e-3 * stress),
        ));
        answers
    }

    /// One curve per speed over depth.
    fn over_depth(&self, name: &str, label: &str, values: &Array2<f64>, scale: f64) -> (Figure, String) {
        let series = self.speeds.iter().enumerate().map(|(n, speed)| Series {
            name: at(*speed),
            x: values.row(n).iter().map(|v| scale * v).collect(),
            y: self.depths.clone(),
            stroke: if n == 0 { Stroke::Dashed } else { Stroke::Solid },
        });
        let what = label.split(" [").next().unwrap_or(label);
        let picture = LineFigure {
            y_down: true,
            series: series.collect(),
            ..LineFigure::new(
                format!("ground_at_depth_{name}"),
                format!("Largest {what} over depth"),
                label,
                "depth z [m]",
            )
        };
        let faces = self.interfaces.iter().map(|z| format!("{z}")).collect::<Vec<_>>().join(", ");
        let faces = if faces.is_empty() { String::new() } else { format!(" Layers end at {faces} m.") };
        (Figure::Lines(picture), format!("Largest value in the window at each depth.{faces}"))
    }

    /// γ_oct over that of the train at rest, over depth.
    fn ratio(&self, strain: &Array2<f64>) -> Option<(Figure, String)> {
        let mut ratios = strain.clone();
        for mut row in ratios.outer_iter_mut() {
            row /= &strain.row(0);
        }
        let (Figure::Lines(mut picture), _) =
            self.over_depth("amplification", "strain γ_oct over that at rest [1]", &ratios, 1.0)
        else {
            return None;
        };
        picture.series.remove(0);
        picture.title = "Dynamic amplification of the strain over depth".into();
        let caption =
            "Largest octahedral shear strain at each depth over the largest of the same train at rest.";
        (!picture.series.is_empty()).then_some((Figure::Lines(picture), caption.into()))
    }

    /// Sections along the track at the first y, one for each of `planes` (z, x′) and all in the same colours, where the depths are in
    /// equal steps.
    fn sections(
        &self,
        name: &str,
        label: &str,
        planes: Vec<ArrayView2<f64>>,
        scale: f64,
        symmetric: bool,
    ) -> Vec<(Figure, String)> {
        let steps: Vec<f64> = self.depths.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let even = steps.iter().all(|step| (step - steps[0]).abs() < 1e-6 * steps[0]);
        if self.depths.len() < ENOUGH || !even {
            return Vec::new();
        }
        let largest = scale * planes.iter().flatten().fold(0.0f64, |m, v| m.max(v.abs()));
        let map = |(values, &speed): (&ArrayView2<f64>, &f64)| {
            // rows upward from the deepest: z is drawn as height
            let mut upward = values.mapv(|v| scale * v);
            upward.invert_axis(Axis(0));
            let map = MapFigure {
                name: format!("ground_at_depth_{name}_{}", key(speed)),
                title: format!("Ground along the track, y = {} m, {}", self.y[0], at(speed)),
                x_label: "x′ [m], travel to the right".into(),
                y_label: "height −z [m]".into(),
                value_label: label.into(),
                x: self.x.clone(),
                y: self.depths.iter().rev().map(|z| -z).collect(),
                values: upward,
                holds: Some(if symmetric { (-largest, largest) } else { (0.0, largest) }),
                symmetric,
                // a long train's section to scale would be a line
                equal_axes: self.x[self.x.len() - 1] - self.x[0]
                    < FLATTEST * self.depths[self.depths.len() - 1],
                overlay: Vec::new(),
            };
            (Figure::Map(map), format!("Section along the track {}, seen from the leading axle.", at(speed)))
        };
        planes.iter().zip(&self.speeds).map(map).collect()
    }

    fn group(&self, strain: &Array2<f64>, pressure: &Array2<f64>, sinking: &Array2<f64>) -> Group {
        let dims = ["speed", "z", "y", "x"];
        let shape = [self.speeds.len(), self.depths.len(), self.y.len(), self.x.len()];
        let mut group = Group::new("ground_at_depth")
            .coordinate("speed", &self.speeds, "m s-1", "train speed, 0 at rest")
            .coordinate("z", &self.depths, "m", "depth below the surface")
            .coordinate("y", &self.y, "m", "position across the track, from its centre line")
            .coordinate("x", &self.x, "m", "position relative to the leading axle, positive ahead");
        for (c, component) in COMPONENTS.iter().enumerate() {
            let values = self
                .fields
                .iter()
                .flat_map(|field| field.values.index_axis(Axis(0), c).iter().copied().collect::<Vec<_>>());
            let values = ArrayD::from_shape_vec(IxDyn(&shape), values.collect()).unwrap_or_default();
            group = group.variable(component.name, &dims, values, component.unit, component.long_name);
        }
        let octahedral = self.octahedral.iter().flat_map(|o| o.iter().copied()).collect();
        let octahedral = ArrayD::from_shape_vec(IxDyn(&shape), octahedral).unwrap_or_default();
        group = group.variable("gamma_oct", &dims, octahedral, "1", "octahedral shear strain");
        let over = ["speed", "z"];
        for (name, values, unit, what) in [
            ("max_gamma_oct", strain, "1", "largest octahedral shear strain in the window"),
            ("max_compression", pressure, "Pa", "largest vertical compression in the window"),
            ("max_u_z", sinking, "m", "largest downward displacement in the window"),
        ] {
            group = group.variable(name, &over, values.clone().into_dyn(), unit, what);
        }
        let cyclic = strain.mapv(|gamma| gamma / self.threshold).into_dyn();
        group
            .variable(
                "cyclic_strain_ratio",
                &over,
                cyclic,
                "1",
                "largest octahedral shear strain over the threshold strain",
            )
            .attribute("threshold_strain", self.threshold)
    }

    fn concerns(&self, railway: &Railway, strain: &Array2<f64>) -> Vec<Concern> {
        let mut concerns = Vec::new();
        let (worst, row) = (0..self.speeds.len())
            .map(|n| (self.deepest(strain.row(n)), n))
            .max_by(|a, b| a.0.0.total_cmp(&b.0.0))
            .unwrap_or(((0.0, 0.0), 0));
        if worst.0 > self.threshold {
            concerns.push(Concern::new(
                "large-strain",
                format!(
                    "the octahedral shear strain reaches {:.1e} at z = {} m {}, above the threshold of {:.0e} from which on soil softens: \
                     the linear ground is too stiff there, and waves are slower than computed",
                    worst.0,
                    worst.1,
                    at(self.speeds[row]),
                    self.threshold
                ),
                "reduce the moduli (and raise the damping) of these layers to the strain, and run again",
            ));
        }
        concerns.extend(missed_accuracy(&self.missed, "1e-5", (self.speeds.len(), "speeds", "m/s")));
        concerns.extend(sinks_as_no_track_does(railway));
        concerns.extend(self.speeds.iter().filter_map(|v| outruns_waves(railway, *v)));
        concerns
    }
}
