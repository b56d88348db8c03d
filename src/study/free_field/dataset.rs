//! What the free field leaves in files.

use super::metrics::Direction;
use super::{Driven, Irregularity, PassVelocities, Roughness, StudyError};
use crate::assessment::PassageSpectrum;
use crate::dataset::Group;
use ndarray::{Array1, Array2};

impl PassVelocities<'_> {
    /// Arrays of the study.
    ///
    /// # Errors
    /// A passage time that is not positive.
    pub(super) fn group(&self, velocities: &[Array2<f64>; 3]) -> Result<Group, StudyError> {
        let bands = self.building_arrays(self.passage_spectra(self.band_arrays(velocities)), &velocities[2]);
        let group = self.quasi_static_arrays(bands);
        match &self.study.roughness {
            Some(roughness) => self.rough_arrays(group, roughness),
            None => self.measures(group, &["receiver"]),
        }
    }

    /// Third octaves of the first profile as DIN 45672-2 takes them of a measured passage.
    fn passage_spectra(&self, group: Group) -> Group {
        let spectra = &self.metrics.spectra;
        let shape = (spectra.len(), self.study.bands.len());
        let table = |of: fn(&PassageSpectrum) -> &[f64]| {
            Array2::from_shape_fn(shape, |(r, b)| of(&spectra[r])[b]).into_dyn()
        };
        let dims = ["receiver", "band"];
        let interval =
            "running r.m.s. FAST of the band, r.m.s. over the passage (DIN 45672-2, interval), first profile";
        let hold =
            "running r.m.s. FAST of the band, its largest value (DIN 45672-2, max hold), first profile";
        group.variable("v_interval", &dims, table(|s| &s.interval), "m s-1", interval).variable(
            "v_max_hold",
            &dims,
            table(|s| &s.max_hold),
            "m s-1",
            hold,
        )
    }

    /// Coordinates, and r.m.s. velocities in bands.
    fn band_arrays(&self, velocities: &[Array2<f64>; 3]) -> Group {
        let study = self.study;
        let centres: Vec<f64> = study.bands.iter().map(|band| band.centre()).collect();
        let after = "time after the leading axle was abreast of the receivers";
        let group = Group::new("free_field")
            .coordinate("receiver", &study.receivers, "m", "distance from the centre line of the track")
            .coordinate("band", &centres, "Hz", "exact centre of the base-10 third-octave band")
            .coordinate("time", &self.times.values(), "s", after)
            .attribute("speed", study.speed)
            .attribute("passage_time", self.passage_time)
            .attribute(
                "direction",
                if self.three.is_some() {
                    "three components, surface of the ground"
                } else {
                    "vertical, surface of the ground"
                },
            )
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
        parts.into_iter().zip(velocities).fold(group, |group, ((name, what), values)| {
            let what = format!("r.m.s. velocity over the passage time: {what}");
            group.variable(name, &["receiver", "band"], values.clone().into_dyn(), "m s-1", &what)
        })
    }

    fn quasi_static_arrays(&self, group: Group) -> Group {
        let dims = ["receiver", "time"];
        let (velocity, kb_f) = (self.quasi_static.clone(), self.metrics.kb_f.clone());
        let what = "velocity of the quasi-static part, positive down";
        let severity = "KB_F(t) of the total velocity, for the first profile";
        group.variable("v_quasi_static", &dims, velocity.into_dyn(), "m s-1", what).variable(
            "kb_f",
            &dims,
            kb_f.into_dyn(),
            "1",
            severity,
        )
    }

    /// Histories of the first profile, contact forces, and the measures of all profiles.
    fn rough_arrays(&self, group: Group, roughness: &Roughness) -> Result<Group, StudyError> {
        let first = &self.histories[0];
        let dims = ["receiver", "time"];
        let dynamic = "velocity of the dynamic part for the first profile, positive down";
        let total = "velocity of both parts for the first profile, positive down";
        let frequencies: Vec<f64> = self.driven.iter().map(|d| d.frequency).collect();
        let group = group
            .variable("v_dynamic", &dims, (first - &self.quasi_static).into_dyn(), "m s-1", dynamic)
            .variable("v_total", &dims, first.clone().into_dyn(), "m s-1", total)
            .attribute("irregularity", roughness.irregularity.text())
            .attribute("band_rms", roughness.irregularity.rms())
            .coordinate("driving_frequency", &frequencies, "Hz", "speed over wavelength of the profile");
        let force = |of: fn(&Driven) -> f64| self.driven.iter().map(of).collect::<Array1<f64>>().into_dyn();
        let along = ["driving_frequency"];
        match &roughness.irregularity {
            Irregularity::Random { wavelengths, seed, count, .. } => {
                let seeds: Vec<f64> = (0..*count).map(|i| seed.wrapping_add(i as u64) as f64).collect();
                let what = "one-sided spectral density of the dynamic force of the leading wheelset";
                let group = group
                    .variable("contact_force", &along, force(|d| d.force.powi(2)), "N2 Hz-1", what)
                    .attribute("shortest_wavelength", wavelengths.0)
                    .attribute("longest_wavelength", wavelengths.1)
                    .coordinate("profile", &seeds, "1", "seed of the profile");
                self.measures(group, &["profile", "receiver"])
            }
            Irregularity::Given { .. } => {
                let what = "amplitude of the dynamic force of the leading wheelset";
                let group = group.variable("contact_force", &along, force(|d| d.force), "N", what);
                self.measures(group, &["receiver"])
            }
        }
    }

    /// Adds the measures of all histories, and what horizontal components there are.
    fn measures(&self, group: Group, dims: &[&str]) -> Result<Group, StudyError> {
        let group = self.metrics.measured.arrays(group, dims, "", Direction::Vertical, "vertical");
        self.component_arrays(group, dims)
    }
}
