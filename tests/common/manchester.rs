//! The vehicle of the Manchester benchmarks, as `reference/track_fe_vehicle.json` has it.

use groundwave::vehicle::{
    Body, Bogie, BogieVehicle, Freedom, Motion, Multibody, Part, Suspension, Wheelset,
};
use serde_json::Value;

/// The whole vehicle of the file's `inputs`; its suspensions are those of both sides together.
pub fn manchester(inputs: &Value) -> BogieVehicle {
    let of = |key: &str| inputs["whole_vehicle"][key].as_f64().unwrap();
    BogieVehicle {
        body: Body { mass: of("mc"), pitch_inertia: of("Ic"), bogie_centres: of("Lc"), count: 1 },
        bogie: Bogie { mass: of("mb"), pitch_inertia: of("Ib"), wheelbase: of("Lb"), wheelsets: 2 },
        wheelset: Wheelset { mass: of("mw") },
        primary: Suspension { stiffness: of("kp"), damping: of("cp") },
        secondary: Suspension { stiffness: of("ks"), damping: of("cs") },
    }
}

/// The half body of the models with 2 and 4 degrees of freedom moves with the bogie.
pub fn heavy(v: BogieVehicle) -> BogieVehicle {
    let bogie = Bogie { mass: v.bogie.mass + 0.5 * v.body.mass, ..v.bogie };
    // no less than a milligram may remain: 2e-10 of the body
    BogieVehicle { bogie, body: Body { mass: 1e-6, ..v.body }, ..v }
}

/// As the file orders them: from the body down, each body's bounce and pitch together. Its pitch is positive where the front goes down.
pub fn order(model: &Multibody) -> Vec<(usize, f64)> {
    let rank = |f: &Freedom| match f.part {
        Part::Body => (0, f.number, f.motion == Motion::Pitch),
        Part::Bogie => (1, f.number, f.motion == Motion::Pitch),
        Part::Wheelset => (2, f.number, false),
    };
    let mut order: Vec<usize> = (0..model.freedoms().len()).collect();
    order.sort_by_key(|i| rank(&model.freedoms()[*i]));
    let sign = |i: usize| if model.freedoms()[i].motion == Motion::Pitch { -1.0 } else { 1.0 };
    order.into_iter().map(|i| (i, sign(i))).collect()
}
