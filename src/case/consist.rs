//! `[[train.vehicle]]` → different vehicles one behind the other, with every fault at its key.

use super::error::CaseError;
use super::loader::Loader;
use super::schema::{TrainInput, VehicleInput, VehiclesInput};
use super::values::Named;
use super::vehicle::{
    Place, Wheels, body_fault, bogie_vehicle, contact, loads, model_has_its_parts, parts, reasonable,
};
use crate::vehicle::{Axle, ContactSpring, Multibody, Train, VehicleModel};

/// Most vehicles a train may have.
const MOST: usize = 1000;
/// How deep lists may name lists.
const DEEPEST: usize = 3;

/// A vehicle, its places [m] from its front over couplers, or from its first axle where it has no length.
#[derive(Clone)]
struct Car {
    /// The key that names it.
    at: String,
    axles: Vec<Axle>,
    bodies: Option<Multibody>,
    /// Of every wheelset.
    contact: Option<ContactSpring>,
    length: Option<f64>,
}

impl Car {
    /// The same running the other way.
    fn reversed(self) -> Self {
        let end = self.length.unwrap_or_else(|| self.axles.last().map_or(0.0, |axle| axle.position));
        let turned = |a: &Axle| Axle { position: end - a.position, ..*a };
        let axles = self.axles.iter().rev().map(turned).collect();
        Self { axles, bodies: self.bodies.map(|bodies| bodies.reversed(end)), ..self }
    }
}

/// Refuses what a train that names its vehicles has no use for.
pub fn alone(outer: &Place) -> Result<(), CaseError> {
    if outer.table.axles.is_some() {
        return Err(outer.advise("vehicle", "axles and vehicle are both given", "give one of them"));
    }
    if let Some((key, _)) = parts(&outer.table).iter().find(|part| part.1) {
        let message = format!("{key} and vehicle are both given");
        let help = "remove one of them; model, unsprung_mass and wheel_rail may stand beside a vehicle";
        return Err(outer.advise(key, message, help));
    }
    Ok(())
}

/// How often `count` asks for what stands at `at`.
fn times(outer: &Place, at: &str, count: Option<usize>) -> Result<usize, CaseError> {
    match count.unwrap_or(1) {
        count @ 1..=MOST => Ok(count),
        count => Err(outer.fault(at, format!("found {count}: it must lie between 1 and {MOST}"))),
    }
}

/// Cars of the `list` of vehicles at `outer`; what `over` says of model, unsprung mass and contact stands over what they say.
fn cars(
    loader: &Loader,
    (outer, over): (&Place, &Place),
    list: &[VehicleInput],
    depth: usize,
) -> Result<Vec<Car>, CaseError> {
    let mut all = Vec::new();
    for (i, item) in list.iter().enumerate() {
        let at = |key: &str| format!("vehicle[{i}].{key}");
        let name = Named::<TrainInput>::Name(item.name.clone());
        let inner = loader.resolve(&name, &outer.at(&at("name")), "vehicles")?;
        let table = &inner.table;
        let mut some = match &table.vehicle {
            Some(VehiclesInput::Several(_)) if depth == DEEPEST || item.length.is_some() => {
                let (key, message) = match item.length {
                    Some(_) => ("length", "a list of vehicles has the lengths of its vehicles"),
                    None => ("name", "lists of vehicles name one another too deeply"),
                };
                return Err(outer.advise(&at(key), message, "remove it"));
            }
            Some(VehiclesInput::Several(list)) => {
                let mut some = cars(loader, (&inner, over), list, depth + 1)?;
                some.iter_mut().for_each(|car| car.at = at("name"));
                some
            }
            Some(VehiclesInput::One(_)) => {
                let help = "name what it names";
                return Err(outer.advise(&at("name"), "the vehicle only names another one", help));
            }
            None if table.count.is_some() || table.reversed => {
                let message = "a vehicle brings its axles and length, nothing else";
                return Err(outer.advise(&at("name"), message, "say count and reversed in the list"));
            }
            None => vec![car((outer, over), &inner, (item, &at("name")))?],
        };
        if item.reversed {
            some = some.into_iter().rev().map(Car::reversed).collect();
        }
        for _ in 0..times(outer, &at("count"), item.count)? {
            all.extend(some.iter().cloned());
        }
        if all.len() > MOST {
            let message = format!("the train has more than {MOST} vehicles");
            return Err(outer.fault(&at("count"), message));
        }
    }
    Ok(all)
}

/// One vehicle, `item` of a list at `outer`, from its own file `inner`.
fn car(
    (outer, over): (&Place, &Place),
    inner: &Place,
    (item, at): (&VehicleInput, &str),
) -> Result<Car, CaseError> {
    let table = &inner.table;
    let four = bogie_vehicle(inner)?;
    let model = over.table.model.or(table.model);
    let own = table.unsprung_mass.or(over.table.unsprung_mass);
    // the mass of a whole train is that of the wheelsets that have none
    let mass = own.filter(|_| four.is_none() || model == Some(VehicleModel::Unsprung));
    let model_at = if over.table.model.is_some() { over } else { inner };
    let mass_at = if table.unsprung_mass.is_some() { inner } else { over };
    if four.is_none() && over.table.model.is_some_and(|model| model != VehicleModel::Unsprung) {
        let message = format!("\"{}\" has no bodies for the model of the train", item.name);
        return Err(outer.advise(at, message, "leave model out: every vehicle brings its own"));
    }
    model_has_its_parts((model, model_at), (mass, mass_at), four.is_some())?;
    let (axles, bodies) = match (&four, &table.axles) {
        (Some(four), _) => {
            let Some(model) = model else {
                let help = "add model = \"unsprung\", \"two\", \"four\", \"five\" or \"ten\"";
                return Err(inner.advise("", "missing key `model`: which of the bodies move", help));
            };
            let bodies = model.of(four, mass).map_err(|e| body_fault(inner, &e))?;
            (bodies.axles().to_vec(), Some(bodies))
        }
        (None, Some(axles)) => {
            let train = loads(axles.clone(), inner)?;
            let bodies = mass.map(|mass| Multibody::unsprung_train(mass, &train)).transpose();
            (train.axles().to_vec(), bodies.map_err(|e| body_fault(inner, &e))?)
        }
        (None, None) => {
            let help = "add axles = [{ position = 0.0, load = … }]";
            return Err(inner.advise("", "the vehicle has no axles", help));
        }
    };
    let (first, last) = (axles[0].position, axles[axles.len() - 1].position);
    let length = length((outer, inner), (item, at), last - first)?;
    let shift = length.map_or(0.0, |(_, overhang)| overhang) - first;
    let shifted = |a: &Axle| Axle { position: a.position + shift, ..*a };
    let axles: Vec<Axle> = axles.iter().map(shifted).collect();
    reasonable(&axles, inner, if four.is_some() { "body" } else { "axles" })?;
    let bodies = bodies.map(|bodies| bodies.row(&[shift])).transpose().map_err(|e| body_fault(inner, &e))?;
    let contact_at = if over.table.wheel_rail.is_some() { over } else { inner };
    let contact = contact(contact_at, axles.iter().map(|a| a.load).sum::<f64>() / axles.len() as f64)?;
    Ok(Car { at: at.to_owned(), axles, bodies, contact, length: length.map(|(length, _)| length) })
}

/// Length over couplers and what of it lies ahead of the first axle [m] of `item`, whose axles are `span` [m] apart.
fn length(
    (outer, inner): (&Place, &Place),
    (item, at): (&VehicleInput, &str),
    span: f64,
) -> Result<Option<(f64, f64)>, CaseError> {
    let Some(length) = item.length.or(inner.table.length) else { return Ok(None) };
    let overhang = inner.table.overhang.unwrap_or(0.5 * (length - span));
    if length.is_finite() && overhang >= 0.0 && overhang + span <= length {
        return Ok(Some((length, overhang)));
    }
    let (place, key) = match item.length {
        Some(_) => (outer, at.replace("name", "length")),
        None => (inner, "length".to_owned()),
    };
    let reach = overhang + span;
    let message = format!("length is {length} m: the axles reach from {overhang} to {reach} m");
    Err(place.advise(&key, message, "it must hold them, with `overhang` in front"))
}

/// Axle loads of the `list` of vehicles of the train `outer`, its first axle at 0, and what of it meets a rough rail.
pub fn train(loader: &Loader, outer: &Place, list: &[VehicleInput]) -> Result<(Train, Wheels), CaseError> {
    alone(outer)?;
    if let Some(length) = outer.table.length {
        let message = format!("found {length} m beside a list of vehicles, which have their own lengths");
        return Err(outer.advise("length", message, "remove it, or give it to one of them"));
    }
    if list.is_empty() {
        return Err(outer.advise("vehicle", "the list is empty", "name at least one vehicle"));
    }
    let one = cars(loader, (outer, outer), list, 0)?;
    let mut all = Vec::new();
    for _ in 0..times(outer, "count", outer.table.count)? {
        all.extend(one.iter().cloned());
    }
    if outer.table.reversed {
        all = all.into_iter().rev().map(Car::reversed).collect();
    }
    placed(outer, all)
}

/// The cars one behind the other.
fn placed(outer: &Place, mut all: Vec<Car>) -> Result<(Train, Wheels), CaseError> {
    let mut front = -all[0].axles[0].position;
    let last = all.len() - 1;
    for (i, car) in all.iter_mut().enumerate() {
        car.axles.iter_mut().for_each(|axle| axle.position += front);
        let moved = car.bodies.as_ref().map(|bodies| bodies.row(&[front])).transpose();
        car.bodies = moved.map_err(|e| body_fault(outer, &e))?;
        front += match car.length {
            Some(length) => length,
            None if i == last && last == 0 => 0.0,
            None => {
                let message = "this vehicle has no `length` to put others before or behind it";
                return Err(outer.advise(
                    &car.at,
                    message,
                    "add length = … [m], over couplers, beside its name",
                ));
            }
        };
    }
    let train = loads(all.iter().flat_map(|car| car.axles.clone()).collect(), outer)?;
    reasonable(train.axles(), outer, "vehicle")?;
    let bodies: Option<Vec<Multibody>> = all.iter().map(|car| car.bodies.clone()).collect();
    let springs = |car: &Car| car.contact.map(|spring| vec![spring; car.axles.len()]);
    let contact: Option<Vec<Vec<ContactSpring>>> = all.iter().map(springs).collect();
    if let Some(car) = all.iter().find(|car| car.bodies.is_none() && outer.table.wheel_rail.is_some()) {
        let message = "the wheels of this vehicle have no mass, which wheel_rail needs";
        let help = "add unsprung_mass [kg per wheelset] of the train, or name a vehicle with bodies";
        return Err(outer.advise(&car.at, message, help));
    }
    let length = train.length();
    let bodies = bodies.map(|bodies| Multibody::train(&bodies));
    let contact = contact.map(|springs| springs.concat()).filter(|_| bodies.is_some());
    Ok((train, Wheels { bodies, contact, length }))
}
