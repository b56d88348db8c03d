//! `[train]` → axle loads, the bodies on them and their contact with the rail, with every fault at its key.

use super::consist;
use super::error::CaseError;
use super::loader::Loader;
use super::schema::{TrainInput, VehicleInput, VehiclesInput};
use super::values::Named;
use super::vehicle::{
    Place, Wheels, above_zero, body_fault, bogie_vehicle, contact, loads, model_has_its_parts, reasonable,
};
use crate::vehicle::{Axle, BogieVehicle, Multibody, Train, VehicleModel};

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

/// The vehicle `name` of a train, which brings itself and nothing else; a list of vehicles stands as one.
fn named_vehicle(loader: &Loader, outer: &Place, name: &str) -> Result<Place, CaseError> {
    consist::alone(outer)?;
    let inner =
        loader.resolve(&Named::<TrainInput>::Name(name.to_owned()), &outer.at("vehicle"), "vehicles")?;
    let table = &inner.table;
    let list = matches!(table.vehicle, Some(VehiclesInput::Several(_)));
    let twice = table.length.is_some() && outer.table.length.is_some();
    if (table.vehicle.is_some() && !list) || table.count.is_some() || table.reversed || twice {
        return Err(outer.advise(
            "vehicle",
            "a vehicle brings its axles and length, nothing else",
            "say count and reversed in the case, length with the axles",
        ));
    }
    Ok(inner)
}

/// Vehicles of bodies at `offsets` [m], one behind the other.
fn of_bodies(
    four: &BogieVehicle,
    (model, mass): (Option<VehicleModel>, Option<f64>),
    offsets: Vec<f64>,
    (outer, vehicle): (&Place, &Place),
) -> Result<(Train, Multibody), CaseError> {
    let Some(model) = model else {
        let help = "add model = \"unsprung\", \"two\", \"four\", \"five\" or \"ten\"";
        return Err(vehicle.advise("", "missing key `model`: which of the bodies move", help));
    };
    let span = four.span();
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
    let inner = match &outer.table.vehicle {
        None => None,
        Some(VehiclesInput::One(name)) => Some(named_vehicle(loader, &outer, name)?),
        Some(VehiclesInput::Several(list)) => return consist::train(loader, &outer, list),
    };
    if let (Some(VehiclesInput::One(name)), Some(Some(VehiclesInput::Several(_)))) =
        (&outer.table.vehicle, inner.as_ref().map(|inner| &inner.table.vehicle))
    {
        let whole = VehicleInput { name: name.clone(), count: None, reversed: false, length: None };
        return consist::train(loader, &outer, &[whole]);
    }
    let vehicle = inner.as_ref().unwrap_or(&outer);
    let first = |there: fn(&TrainInput) -> bool| if there(&outer.table) { &outer } else { vehicle };
    let (model_at, mass_at, contact_at) = (
        first(|t| t.model.is_some()),
        first(|t| t.unsprung_mass.is_some()),
        first(|t| t.wheel_rail.is_some()),
    );
    let (model, mass) = (model_at.table.model, mass_at.table.unsprung_mass);
    let four = bogie_vehicle(vehicle)?;
    model_has_its_parts((model, model_at), (mass, mass_at), four.is_some())?;
    let offsets = offsets(&outer, vehicle)?;
    let (train, bodies) = match four {
        Some(four) => {
            let (train, bodies) = of_bodies(&four, (model, mass), offsets, (&outer, vehicle))?;
            (train, Some(bodies))
        }
        None => of_axles(mass, &offsets, (&outer, vehicle))?,
    };
    let spring = contact(contact_at, train.total_load() / train.axles().len() as f64)?;
    match (&bodies, spring, mass) {
        // a wheel of a library vehicle has a radius, whatever is asked
        (None, Some(_), _) if !contact_at.prefix.is_empty() => {
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
            let contact = spring.filter(|_| bodies.is_some()).map(|one| vec![one; train.axles().len()]);
            Ok((train, Wheels { bodies, contact, length }))
        }
    }
}
