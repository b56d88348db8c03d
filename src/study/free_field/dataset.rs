//! What the free field leaves in files.

use super::metrics::MEASURES;
use super::{Answered, Irregularity};
use crate::dataset::Group;
use ndarray::{Array1, Array2};

impl Answered<'_> {
    /// Arrays of the study.
    pub(super) fn group(&self, velocities: &[Array2<f64>; 3]) -> Group {
        let study = self.pass.study;
        let centres: Vec<f64> = study.bands.iter().map(|band| band.centre()).collect();
        let mut group = Group::new("free_field")
            .coordinate("receiver", &study.receivers, "m", "distance from the centre line of the track")
            .coordinate("band", &centres, "Hz", "exact centre of the base-10 third-octave band")
            .coordinate(
                "time",
                &self.times.values(),
                "s",
                "time after the leading axle was abreast of the receivers",
            )
            .attribute("speed", study.speed)
            .attribute("passage_time", self.pass.passage_time)
            .attribute("direction", "vertical, surface of the ground")
            .attribute("weighting", "none")
            .attribute("sections", self.sections);
        let dynamic = match study.roughness.as_ref().map(|r| &r.irregularity) {
            None => "none: smooth rail",
            Some(Irregularity::Random { .. }) => "expected value over all profiles",
            Some(Irregularity::Given { .. }) => "of the given profile",
        };
        let parts = [
            ("v_rms_quasi_static", "quasi-static part (moving axle loads)".to_owned()),
            ("v_rms_dynamic", format!("dynamic part (rough rail), {dynamic}")),
            ("v_rms_total", "both".to_owned()),
        ];
        for ((name, what), values) in parts.into_iter().zip(velocities) {
            let what = format!("r.m.s. velocity over the passage time: {what}");
            group = group.variable(name, &["receiver", "band"], values.clone().into_dyn(), "m s-1", &what);
        }
        group = group.variable(
            "v_quasi_static",
            &["receiver", "time"],
            self.quasi_static.velocity.clone().into_dyn(),
            "m s-1",
            "velocity of the quasi-static part, positive down",
        );
        group = group.variable(
            "kb_f",
            &["receiver", "time"],
            self.metrics.kb_f.clone().into_dyn(),
            "1",
            "KB_F(t) of the total velocity, for the first profile",
        );
        let Some(roughness) = &study.roughness else { return self.measures(group, &["receiver"]) };
        let first = &self.histories[0];
        let dims = ["receiver", "time"];
        group = group
            .variable(
                "v_dynamic",
                &dims,
                (first - &self.quasi_static.velocity).into_dyn(),
                "m s-1",
                "velocity of the dynamic part for the first profile, positive down",
            )
            .variable(
                "v_total",
                &dims,
                first.clone().into_dyn(),
                "m s-1",
                "velocity of both parts for the first profile, positive down",
            )
            .attribute("irregularity", roughness.irregularity.text())
            .attribute("band_rms", roughness.irregularity.rms());
        let frequencies: Vec<f64> = self.driven.iter().map(|d| d.frequency).collect();
        group =
            group.coordinate("driving_frequency", &frequencies, "Hz", "speed over wavelength of the profile");
        match &roughness.irregularity {
            Irregularity::Random { wavelengths, seed, count, .. } => {
                let seeds: Vec<f64> = (0..*count).map(|i| seed.wrapping_add(i as u64) as f64).collect();
                let densities: Array1<f64> = self.driven.iter().map(|d| d.force.powi(2)).collect();
                group = group
                    .variable(
                        "contact_force",
                        &["driving_frequency"],
                        densities.into_dyn(),
                        "N2 Hz-1",
                        "one-sided spectral density of the dynamic force of the leading wheelset",
                    )
                    .attribute("shortest_wavelength", wavelengths.0)
                    .attribute("longest_wavelength", wavelengths.1)
                    .coordinate("profile", &seeds, "1", "seed of the profile");
                self.measures(group, &["profile", "receiver"])
            }
            Irregularity::Given { .. } => {
                let forces: Array1<f64> = self.driven.iter().map(|d| d.force).collect();
                group = group.variable(
                    "contact_force",
                    &["driving_frequency"],
                    forces.into_dyn(),
                    "N",
                    "amplitude of the dynamic force of the leading wheelset",
                );
                self.measures(group, &["receiver"])
            }
        }
    }

    /// Adds the measures of all histories.
    fn measures(&self, mut group: Group, dims: &[&str]) -> Group {
        for (measure, values) in MEASURES.iter().zip(&self.metrics.values) {
            let values =
                if dims.len() == 2 { values.clone().into_dyn() } else { values.row(0).to_owned().into_dyn() };
            group = group.variable(measure.key, dims, values, measure.units, measure.what);
        }
        group
    }
}
