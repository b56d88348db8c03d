//! The quasi-static history at a receiver against the contour and against the spectrum of the free field.

use crate::common::{named, tracks};
use groundwave::assessment::Band;
use groundwave::field::{Channel, GroundField, GroundLoad, Quantity, Window};
use groundwave::foundation::LayeredSoil;
use groundwave::progress::Silent;
use groundwave::rail::TrackOnFoundation;
use groundwave::railway::{Contact, Ground, Railway, Support};
use groundwave::signal::{EnergySpectrum, History};
use groundwave::soil::{Motion, Solver, Strip};
use groundwave::study::{Components, FreeField};
use groundwave::vehicle::{Axle, Train};

const LOAD: f64 = 150e3;

fn strip() -> Strip {
    Strip { half_width: 1.25, compatibility: tracks::named("paper_ballasted").1 }
}

/// The line y = 8 m through the contours around the load: u_z, u_x and u_y, with their signs.
#[test]
fn history_is_the_slice_of_the_contour() {
    let profile = named("paper_layered");
    let soil = LayeredSoil::new(profile.clone(), Solver::DirectStiffness, strip()).unwrap();
    let stack = tracks::ballasted();
    let track = TrackOnFoundation::new(&stack, &soil, 0.0);
    let train = Train::new(vec![Axle { position: 0.0, load: LOAD }]).unwrap();
    for speed in [68.5, 137.0] {
        let spectrum = track.spectrum(speed).unwrap();
        let force = |beta: f64| spectrum.force(beta);
        let load = GroundLoad::Strip { force: &force, beta_max: spectrum.force_extent(), half_width: 1.25 };
        let field =
            GroundField { profile: &profile, solver: Solver::DirectStiffness, speed, train: &train, load };
        let window = Window { x: (-40.0, 20.0), y: (0.0, 8.0), spacing: 0.25 };
        let quantities = [Quantity::Vertical, Quantity::Along, Quantity::Across];
        let contour = field.compute(&window, &field.grid(&window, 400.0), &quantities, &Silent).unwrap();
        for (values, motion) in contour.values.iter().zip(Motion::ALL) {
            let line = values.row(contour.y.len() - 1).to_vec();
            let channel = Channel { y: 8.0, motion };
            let passage =
                spectrum.passage((&profile, Solver::DirectStiffness), strip(), channel, 60.0).unwrap();
            assert!(passage.worst <= 1.0, "{motion:?}: {}", passage.worst);
            let largest = line.iter().fold(0.0f64, |m, u| m.max(u.abs()));
            let apart = contour.x.iter().zip(&line);
            let apart = apart.map(|(x, u)| (LOAD * passage.displacement(-x / speed) - u).abs() / largest);
            let worst = apart.fold(0.0, f64::max);
            println!("{speed} m/s {motion:?}: {worst:.1e}");
            // measured 7.8e-4 and 1.6e-4, of which the contour's wrap-around is the larger part; horizontally 8.1e-5 at most
            let allowed = if motion == Motion::Vertical { 1e-3 } else { 3e-4 };
            assert!(worst < allowed, "{speed} m/s {motion:?}: {worst:e}");
        }
    }
}

/// Third octaves of the history are those of the spectrum: two axles, so that phases count.
#[test]
fn bands_of_the_history_are_those_of_the_spectrum() {
    let (profile, speed, y) = (named("paper_layered"), 67.5, 8.0);
    let axles = vec![Axle { position: 0.0, load: LOAD }, Axle { position: 2.5, load: 120e3 }];
    let train = Train::new(axles.clone()).unwrap();
    let model = Railway::new(
        Support::Ground(Ground::new(profile.clone(), Solver::DirectStiffness, Some(Contact::Strip(strip())))),
        tracks::ballasted(),
        Some(train),
    )
    .unwrap();
    // above 8 Hz the part is too small for the accuracy of the history, 1e-5 of its displacement
    let bands = Band::range(2.0, 8.0).unwrap();
    let study = FreeField {
        speed,
        receivers: vec![y],
        passage_time: Some(1.0),
        components: Components::Three,
        bands: bands.clone(),
        sections: None,
        assessment: Default::default(),
        building: Default::default(),
        roughness: None,
    };
    let outcome = study.run(&model, &Silent).unwrap();
    let track = model.track().unwrap();
    let load = track.spectrum(speed).unwrap();
    for (motion, suffix) in Motion::ALL.into_iter().zip(["", "_along", "_across"]) {
        let spectrum = outcome.group.get(&format!("v_rms_quasi_static{suffix}")).unwrap().to_vec();
        let channel = Channel { y, motion };
        let passage = load.passage((&profile, Solver::DirectStiffness), strip(), channel, 700.0).unwrap();
        // long enough that the 1/t² tails of velocity do not count
        let step = 1.0 / 256.0;
        let values = passage.of_train(&axles).velocities(-2560.0 * step, step, 5120);
        let history = EnergySpectrum::of(&History::new(step, values).unwrap());
        for (band, v) in bands.iter().zip(spectrum) {
            let error = band.energy(&history).unwrap() / (v * v) - 1.0;
            println!("{motion:?}, {} Hz: {error:.1e}", band.label());
            // measured: 1.6e-5 at 2 Hz to 6.8e-4 at 8 Hz, across 1.0e-3
            assert!(error.abs() < 2e-3, "{motion:?}, {} Hz: {error:e}", band.label());
        }
    }
}
