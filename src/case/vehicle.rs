//! What one vehicle of `[train]` is made of, with every fault at its key.

use super::error::CaseError;
use super::loader::Resolved;
use super::schema::TrainInput;
use crate::quantity::positive;
use crate::vehicle::{
    Axle, BodyError, BogieVehicle, ContactSpring, Hertz, Multibody, Train, VehicleError, VehicleModel,
};

/// Longest train [m] and heaviest axle [N] a case may ask for.
const LONGEST_TRAIN: f64 = 2000.0;
const HEAVIEST_AXLE: f64 = 1e8;

/// What of the train the dynamics need.
#[derive(Default)]
pub struct Wheels {
    /// Bodies of the whole train, on the axles of [`Train`].
    pub bodies: Option<Multibody>,
    /// The contact of each wheelset.
    pub contact: Option<Vec<ContactSpring>>,
    /// Between the first and the last axle [m].
    pub length: f64,
}

pub type Place = Resolved<TrainInput>;

/// Keys of a vehicle on bogies, and whether they are there.
pub fn parts(table: &TrainInput) -> [(&'static str, bool); 5] {
    [
        ("body", table.body.is_some()),
        ("bogie", table.bogie.is_some()),
        ("wheelset", table.wheelset.is_some()),
        ("primary", table.primary.is_some()),
        ("secondary", table.secondary.is_some()),
    ]
}

/// The key a fault of a constructor names.
fn key(error: &BodyError) -> &'static str {
    match error {
        BodyError::OutOfRange(error) => error.key,
        BodyError::Offset { .. } => "length",
        BodyError::BogiesOverlap { .. } => "bogie.wheelbase",
        BodyError::Count { key, .. } => key,
        BodyError::HalfBodies => "body.count",
    }
}

/// A fault of a constructor, at its key.
pub fn body_fault(place: &Place, error: &BodyError) -> CaseError {
    place.fault(key(error), error)
}

/// `value` at `key` of `place`, if finite and above zero.
pub fn above_zero(
    place: &Place,
    key: &'static str,
    value: f64,
    unit: &'static str,
) -> Result<f64, CaseError> {
    positive(key, value, unit).map_err(|e| place.fault(key, e))
}

/// The vehicle on bogies of `vehicle`, if it has one.
pub fn bogie_vehicle(vehicle: &Place) -> Result<Option<BogieVehicle>, CaseError> {
    let table = &vehicle.table;
    let (Some(body), Some(bogie), Some(wheelset), Some(primary), Some(secondary)) =
        (table.body, table.bogie, table.wheelset, table.primary, table.secondary)
    else {
        let there = parts(table);
        let Some((given, _)) = there.iter().find(|part| part.1) else { return Ok(None) };
        let missing: Vec<&str> = there.iter().filter(|part| !part.1).map(|part| part.0).collect();
        let message = format!("a vehicle on bogies also needs {}", missing.join(", "));
        return Err(vehicle.advise(given, message, "its keys: body, bogie, wheelset, primary, secondary"));
    };
    if table.axles.is_some() {
        let message = "axles beside a vehicle on bogies, which brings its own";
        return Err(vehicle.advise(
            "axles",
            message,
            "remove axles, or body, bogie, wheelset, primary, secondary",
        ));
    }
    let four = BogieVehicle { body, bogie, wheelset, primary, secondary };
    four.checked().map(Some).map_err(|e| body_fault(vehicle, &e))
}

/// Refuses slips of unit, which would run for hours.
pub fn reasonable(axles: &[Axle], place: &Place, key: &str) -> Result<(), CaseError> {
    let reach = axles.iter().map(|a| a.position.abs()).fold(0.0, f64::max);
    if reach > LONGEST_TRAIN {
        let message = format!("an axle stands {reach} m from the first: more than {LONGEST_TRAIN} m");
        return Err(place.advise(key, message, "positions are in metres"));
    }
    if let Some(i) = axles.iter().position(|a| a.load > HEAVIEST_AXLE) {
        let message =
            format!("axle {} has a load of {} N: more than {HEAVIEST_AXLE} N", i + 1, axles[i].load);
        return Err(place.advise(key, message, "loads are in newtons, masses in kilograms"));
    }
    Ok(())
}

pub fn loads(axles: Vec<Axle>, vehicle: &Place) -> Result<Train, CaseError> {
    Train::new(axles).map_err(|error| {
        let path = match &error {
            VehicleError::NoLoad => "axles".to_owned(),
            VehicleError::Load { index, .. } => format!("axles[{}].load", index - 1),
            VehicleError::Position { index, .. } => format!("axles[{}].position", index - 1),
        };
        vehicle.fault(&path, error)
    })
}

/// The contact of wheelsets that carry `load` [N] on average, from the `wheel_rail` of `place`.
pub fn contact(place: &Place, load: f64) -> Result<Option<ContactSpring>, CaseError> {
    let Some(input) = place.table.wheel_rail else { return Ok(None) };
    let spring = |stiffness| Some(ContactSpring { stiffness, load });
    match (input.stiffness, input.radius, input.tread) {
        (Some(stiffness), None, None) => {
            above_zero(place, "wheel_rail.stiffness", stiffness, "N/m").map(spring)
        }
        (None, Some(radius), tread) => Hertz::new(tread.unwrap_or_default(), radius)
            .and_then(|hertz| hertz.wheelset_stiffness(load))
            .map(spring)
            .map_err(|e| place.fault(&format!("wheel_rail.{}", key(&e)), e)),
        (None, None, _) => Err(place.advise(
            "wheel_rail",
            "it has neither stiffness nor radius",
            "add stiffness [N/m per wheelset] or radius [m]",
        )),
        (Some(_), _, _) => Err(place.advise(
            "wheel_rail",
            "stiffness stands alone: radius and tread belong to Hertz contact",
            "give stiffness, or radius with tread",
        )),
    }
}

/// Refuses a model without what it needs, or with what it has already.
pub fn model_has_its_parts(
    (model, model_at): (Option<VehicleModel>, &Place),
    (mass, mass_at): (Option<f64>, &Place),
    bodies: bool,
) -> Result<(), CaseError> {
    if let Some(mass) = mass {
        above_zero(mass_at, "unsprung_mass", mass, "kg")?;
    }
    let several = model.filter(|m| *m != VehicleModel::Unsprung);
    match (several, model, bodies, mass) {
        (Some(model), _, false, _) => {
            let message =
                format!("the model \"{}\" needs body, bogie, wheelset, primary and secondary", model.name());
            let help = "add them, or say model = \"unsprung\" with unsprung_mass";
            Err(model_at.advise("model", message, help))
        }
        (Some(model), _, true, Some(_)) => {
            let message =
                format!("the model \"{}\" takes the mass of its wheelsets from wheelset.mass", model.name());
            Err(mass_at.advise("unsprung_mass", message, "remove it, or say model = \"unsprung\""))
        }
        (None, Some(_), false, None) => {
            let message = "the model \"unsprung\" needs unsprung_mass";
            Err(model_at.advise("model", message, "add it [kg per wheelset]"))
        }
        _ => Ok(()),
    }
}
