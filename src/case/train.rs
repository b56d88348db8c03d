//! `[train]` → axle loads, the bodies on them and their contact with the rail, with every fault at its key.

use super::error::CaseError;
use super::loader::{Loader, Resolved};
use super::schema::TrainInput;
use super::values::Named;
use crate::quantity::positive;
use crate::vehicle::{Axle, BodyError, FourAxle, Hertz, Multibody, Train, VehicleError, VehicleModel};

/// Longest train [m] and heaviest axle [N] a case may ask for.
const LONGEST_TRAIN: f64 = 2000.0;
const HEAVIEST_AXLE: f64 = 1e8;

/// What of the train the dynamics need.
#[derive(Default)]
pub struct Wheels {
    /// Bodies of the whole train, on the axles of [`Train`].
    pub bodies: Option<Multibody>,
    /// k_H of each wheelset [N/m].
    pub contact: Option<f64>,
    /// Between the first and the last axle [m].
    pub length: f64,
}

type Place = Resolved<TrainInput>;

/// Keys of a vehicle on two bogies, and whether they are there.
fn parts(table: &TrainInput) -> [(&'static str, bool); 5] {
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
    }
}

/// A fault of a constructor, at its key.
fn body_fault(place: &Place, error: &BodyError) -> CaseError {
    place.fault(key(error), error)
}

/// `value` at `key` of `place`, if finite and above zero.
fn above_zero(place: &Place, key: &'static str, value: f64, unit: &'static str) -> Result<f64, CaseError> {
    positive(key, value, unit).map_err(|e| place.fault(key, e))
}

/// The vehicle on two bogies of `vehicle`, if it has one.
fn four_axle(vehicle: &Place) -> Result<Option<FourAxle>, CaseError> {
    let table = &vehicle.table;
    let (Some(body), Some(bogie), Some(wheelset), Some(primary), Some(secondary)) =
        (table.body, table.bogie, table.wheelset, table.primary, table.secondary)
    else {
        let there = parts(table);
        let Some((given, _)) = there.iter().find(|part| part.1) else { return Ok(None) };
        let missing: Vec<&str> = there.iter().filter(|part| !part.1).map(|part| part.0).collect();
        let message = format!("a vehicle on two bogies also needs {}", missing.join(", "));
        return Err(vehicle.advise(given, message, "its keys: body, bogie, wheelset, primary, secondary"));
    };
    if table.axles.is_some() {
        let message = "axles beside a vehicle on two bogies, which brings its own";
        return Err(vehicle.advise(
            "axles",
            message,
            "remove axles, or body, bogie, wheelset, primary, secondary",
        ));
    }
    let four = FourAxle { body, bogie, wheelset, primary, secondary };
    four.checked().map(Some).map_err(|e| body_fault(vehicle, &e))
}

/// Places of `count` vehicles behind the first [m].
fn offsets(outer: &Place, vehicle: &Place) -> Result<Vec<f64>, CaseError> {
    let count = outer.table.count.unwrap_or(1);
    if count == 0 || count > 1000 {
        return Err(outer.fault("count", format!("found {count}: it must lie between 1 and 1000")));
    }
    if count == 1 {
        return Ok(vec![0.0]);
    }
    let (place, length) = match (outer.table.length, vehicle.table.length) {
        (Some(length), _) => (outer, length),
        (None, Some(length)) => (vehicle, length),
        (None, None) => {
            let message = if outer.table.vehicle.is_some() || outer.table.axles.is_none() {
                "this vehicle has no `length` to repeat it at"
            } else {
                "the axles have no `length` to repeat them at"
            };
            return Err(outer.advise("count", message, "add `length = …` [m], or use count = 1"));
        }
    };
    let length = above_zero(place, "length", length, "m")?;
    Ok((0..count).map(|i| length * i as f64).collect())
}

/// Refuses slips of unit, which would run for hours.
fn reasonable(axles: &[Axle], place: &Place, key: &str) -> Result<(), CaseError> {
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

fn loads(axles: Vec<Axle>, vehicle: &Place) -> Result<Train, CaseError> {
    Train::new(axles).map_err(|error| {
        let path = match &error {
            VehicleError::NoLoad => "axles".to_owned(),
            VehicleError::Load { index, .. } => format!("axles[{}].load", index - 1),
            VehicleError::Position { index, .. } => format!("axles[{}].position", index - 1),
        };
        vehicle.fault(&path, error)
    })
}

/// k_H of each wheelset [N/m] from the `wheel_rail` of `place`.
fn contact(place: &Place, train: &Train) -> Result<Option<f64>, CaseError> {
    let Some(input) = place.table.wheel_rail else { return Ok(None) };
    match (input.stiffness, input.radius, input.tread) {
        (Some(stiffness), None, None) => {
            above_zero(place, "wheel_rail.stiffness", stiffness, "N/m").map(Some)
        }
        (None, Some(radius), tread) => {
            let load = train.total_load() / train.axles().len() as f64;
            Hertz::new(tread.unwrap_or_default(), radius)
                .and_then(|hertz| hertz.wheelset_stiffness(load))
                .map(Some)
                .map_err(|e| place.fault(&format!("wheel_rail.{}", key(&e)), e))
        }
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

/// The vehicle a train names, which brings itself and nothing else.
fn named_vehicle(loader: &Loader, outer: &Place) -> Result<Option<Place>, CaseError> {
    let Some(name) = &outer.table.vehicle else { return Ok(None) };
    if outer.table.axles.is_some() {
        return Err(outer.advise("vehicle", "axles and vehicle are both given", "give one of them"));
    }
    if let Some((key, _)) = parts(&outer.table).iter().find(|part| part.1) {
        let message = format!("{key} and vehicle are both given");
        let help = "remove one of them; model, unsprung_mass and wheel_rail may stand beside a vehicle";
        return Err(outer.advise(key, message, help));
    }
    let inner = loader.resolve(&Named::<TrainInput>::Name(name.clone()), "train.vehicle", "vehicles")?;
    let table = &inner.table;
    let twice = table.length.is_some() && outer.table.length.is_some();
    if table.vehicle.is_some() || table.count.is_some() || table.reversed || twice {
        return Err(outer.advise(
            "vehicle",
            "a vehicle brings its axles and length, nothing else",
            "say count and reversed in the case, length with the axles",
        ));
    }
    Ok(Some(inner))
}

/// Refuses a model without what it needs, or with what it has already.
fn model_has_its_parts(
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

/// Vehicles of bodies at `offsets` [m], one behind the other.
fn of_bodies(
    four: &FourAxle,
    (model, mass): (Option<VehicleModel>, Option<f64>),
    offsets: Vec<f64>,
    (outer, vehicle): (&Place, &Place),
) -> Result<(Train, Multibody), CaseError> {
    let Some(model) = model else {
        let help = "add model = \"unsprung\", \"two\", \"four\", \"five\" or \"ten\"";
        return Err(vehicle.advise("", "missing key `model`: which of the bodies move", help));
    };
    let span = four.body.bogie_centres + four.bogie.wheelbase;
    if let Some(&length) = offsets.get(1).filter(|length| **length <= span) {
        let place = if outer.table.length.is_some() { outer } else { vehicle };
        let message = format!("length is {length} m, first and last axle of the vehicle {span} m apart");
        return Err(place.advise("length", message, "it must be longer"));
    }
    // front and rear of a vehicle are alike: one that runs the other way is the same with its rear at −offset
    let places: Vec<f64> = if outer.table.reversed {
        offsets.iter().rev().map(|offset| -offset - span).collect()
    } else {
        offsets
    };
    let bodies =
        model.of(four, mass).and_then(|one| one.row(&places)).map_err(|e| body_fault(vehicle, &e))?;
    reasonable(bodies.axles(), vehicle, "body")?;
    Ok((loads(bodies.axles().to_vec(), vehicle)?, bodies))
}

/// Vehicles of axle loads at `offsets` [m], one behind the other, with unsprung `mass` [kg] under each.
fn of_axles(
    mass: Option<f64>,
    offsets: &[f64],
    (outer, vehicle): (&Place, &Place),
) -> Result<(Train, Option<Multibody>), CaseError> {
    let Some(given) = &vehicle.table.axles else {
        let message = "the train has neither axles nor a vehicle";
        let help = "add axles = [{ position = 0.0, load = … }] or vehicle = \"…\"";
        return Err(outer.advise("", message, help));
    };
    let sign = if outer.table.reversed { -1.0 } else { 1.0 };
    let axles: Vec<Axle> = offsets
        .iter()
        .flat_map(|offset| {
            given.iter().map(move |a| Axle { position: sign * (a.position + offset), load: a.load })
        })
        .collect();
    reasonable(&axles, vehicle, "axles")?;
    let train = loads(axles, vehicle)?;
    let places: Vec<f64> = train.axles().iter().map(|a| a.position).collect();
    let loads: Vec<f64> = train.axles().iter().map(|a| a.load).collect();
    let heaviest = train.heaviest_axle().total_load();
    let bodies = mass
        .map(|mass| Ok(Multibody::unsprung(mass, heaviest)?.row(&places)?.with_loads(&loads)))
        .transpose()
        .map_err(|e| body_fault(vehicle, &e))?;
    Ok((train, bodies))
}

/// Axle loads of `[train]`, and what of it meets a rough rail. What a case says of `model`, `unsprung_mass` and `wheel_rail`
/// stands over what its vehicle says.
pub fn train(loader: &Loader, named: &Named<TrainInput>) -> Result<(Train, Wheels), CaseError> {
    let outer = loader.resolve(named, "train", "vehicles")?;
    let inner = named_vehicle(loader, &outer)?;
    let vehicle = inner.as_ref().unwrap_or(&outer);
    let first = |there: fn(&TrainInput) -> bool| if there(&outer.table) { &outer } else { vehicle };
    let (model_at, mass_at, contact_at) = (
        first(|t| t.model.is_some()),
        first(|t| t.unsprung_mass.is_some()),
        first(|t| t.wheel_rail.is_some()),
    );
    let (model, mass) = (model_at.table.model, mass_at.table.unsprung_mass);
    let four = four_axle(vehicle)?;
    model_has_its_parts((model, model_at), (mass, mass_at), four.is_some())?;
    let offsets = offsets(&outer, vehicle)?;
    let (train, bodies) = match four {
        Some(four) => {
            let (train, bodies) = of_bodies(&four, (model, mass), offsets, (&outer, vehicle))?;
            (train, Some(bodies))
        }
        None => of_axles(mass, &offsets, (&outer, vehicle))?,
    };
    let contact = contact(contact_at, &train)?;
    match (&bodies, contact, mass) {
        (None, Some(_), _) => {
            let message = "wheel_rail needs unsprung_mass";
            Err(contact_at.advise("", message, "add it [kg per wheelset], or a vehicle with a model"))
        }
        (Some(_), None, Some(_)) => Err(mass_at.advise(
            "",
            "unsprung_mass needs wheel_rail",
            "add wheel_rail.stiffness [N/m per wheelset] or wheel_rail.radius [m]",
        )),
        _ => {
            let length = train.length();
            Ok((train, Wheels { bodies, contact, length }))
        }
    }
}
