//! What several studies may be doubted for.

use crate::concern::Concern;

/// Static deflections of tracks [m]: a stiff slab under a light axle to a soft embankment under a heavy train, with room on both sides.
const TRACKS_SINK: std::ops::RangeInclusive<f64> = 0.05e-3..=50e-3;

/// One concern for all `speeds` at which a quadrature missed its tolerance.
pub(super) fn missed_accuracy(speeds: impl Iterator<Item = f64>) -> Option<Concern> {
    let speeds: Vec<String> = speeds.map(|v| format!("{v:.1}")).collect();
    (!speeds.is_empty()).then(|| {
        Concern::new(
            "quadrature",
            format!("the wavenumber integrals missed their accuracy (1e-5) at {} m/s", speeds.join(", ")),
            "poles lie too close to the real axis (more damping helps), or the track spreads the load too little, or a layer is very thin",
        )
    })
}

/// A concern if the rail sinks by `deflection` [m] at rest as no track does: mostly a number in the wrong unit.
pub(super) fn static_deflection(deflection: f64) -> Option<Concern> {
    let likely = if deflection < *TRACKS_SINK.start() {
        "train.axles.load in N (150e3, not 150), and stiffnesses and moduli not too large"
    } else {
        "stiffnesses of pads, ballast and foundation in N/m² (7e8, not 700), soil moduli in Pa (60e6, not 60), bending stiffness in N m², \
         and loads not too large"
    };
    (!TRACKS_SINK.contains(&deflection)).then(|| {
        Concern::new(
            "static-deflection",
            format!("at rest the rail sinks by {:.3e} mm; tracks sink by 0.05 to 50 mm", 1e3 * deflection),
            format!("check the units: {likely}"),
        )
    })
}
