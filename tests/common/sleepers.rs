//! One rail on equal supports as in Table 3 of the paper, and a reader for `reference/boef_*.json`.

use groundwave::foundation::{Asked, Foundation, FoundationError, Stiffness};
use groundwave::track::{Element, Link, Member, Stack, Supports};
use num_complex::Complex64;
use serde_json::Value;

/// What does not yield.
pub struct Rock;

impl Foundation for Rock {
    fn answer(&self, _asked: Asked) -> Result<Stiffness, FoundationError> {
        Ok(Stiffness { value: f64::INFINITY.into(), relative_error: 0.0, converged: true, count: 0 })
    }
}

/// A reference file by the name it has there.
pub fn reference(name: &str) -> Value {
    let text = match name {
        "boef_discrete" => include_str!("../reference/boef_discrete.json"),
        "boef_shear_link" => include_str!("../reference/boef_shear_link.json"),
        "boef_moving_load" => include_str!("../reference/boef_moving_load.json"),
        "boef_transition" => include_str!("../reference/boef_transition.json"),
        "track_fe_contact" => include_str!("../reference/track_fe_contact.json"),
        "track_fe_defects" => include_str!("../reference/track_fe_defects.json"),
        "track_fe_length" => include_str!("../reference/track_fe_length.json"),
        "track_fe_moving_load" => include_str!("../reference/track_fe_moving_load.json"),
        "track_fe_oscillator" => include_str!("../reference/track_fe_oscillator.json"),
        "track_fe_receptance" => include_str!("../reference/track_fe_receptance.json"),
        "track_fe_transition" => include_str!("../reference/track_fe_transition.json"),
        "track_fe_vehicle" => include_str!("../reference/track_fe_vehicle.json"),
        _ => panic!("unknown reference {name}"),
    };
    serde_json::from_str(text).unwrap()
}

/// The numbers of a list.
pub fn numbers(list: &Value) -> Vec<f64> {
    list.as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
}

/// `{re: [...], im: [...]}`.
pub fn complexes(list: &Value) -> Vec<Complex64> {
    let (re, im) = (numbers(&list["re"]), numbers(&list["im"]));
    re.into_iter().zip(im).map(|(re, im)| Complex64::new(re, im)).collect()
}

/// L of Table 3 [m]
pub const SPACING: f64 = 0.6;

/// How the layers lose.
#[derive(Clone, Copy, PartialEq)]
pub enum Loss {
    Hysteretic,
    Viscous,
    None,
}

fn spring(stiffness: f64, damping: f64, eta: f64, loss: Loss) -> Link {
    let l = SPACING;
    let (damping, eta) = match loss {
        Loss::Hysteretic => (0.0, eta),
        Loss::Viscous => (l * damping, 0.0),
        Loss::None => (0.0, 0.0),
    };
    Link::spring(l * stiffness, damping, eta).unwrap()
}

/// The rail of Table 3: "EB" or "T".
pub fn rail(beam: &str, eta: f64) -> Member {
    match beam {
        "EB" => Member::beam(6.38e6, 60.23, eta),
        _ => Member::timoshenko(6.38e6, 60.23, 0.4 * 5.91e8, 0.239, eta),
    }
    .unwrap()
}

/// One layer, or two with ballast of `ballast` [N/m²], standing on rock.
pub fn layers(rail: Member, count: usize, ballast: f64, loss: Loss) -> Supports {
    let mass = |m: f64| Member::mass(SPACING * m).unwrap();
    let under = match count {
        1 => Stack::new(vec![mass(0.0)], vec![spring(4.5e8, 3.29e4, 0.2, loss)]),
        _ => Stack::new(
            vec![mass(0.0), mass(245.0)],
            vec![spring(3.5e8, 1.92e4, 0.15, loss), spring(ballast, 2.34e5, 1.0, loss)],
        ),
    };
    Supports { rail, spacing: SPACING, under, width: None }
}

/// "EB_2layer_hysteretic", "T_2layer_hysteretic_rail_loss_0.02", …
pub fn named(name: &str) -> Supports {
    let beam = name.split('_').next().unwrap();
    let eta = if name.contains("rail_loss_0.02") { 0.02 } else { 0.0 };
    let count = if name.contains("1layer") { 1 } else { 2 };
    let loss = match name {
        name if name.contains("viscous") => Loss::Viscous,
        name if name.contains("undamped") => Loss::None,
        _ => Loss::Hysteretic,
    };
    layers(rail(beam, eta), count, 1.8e8, loss)
}

/// Three layers, the masses of ballast joined or not.
pub fn three_layers(beam: &str, link: bool) -> Supports {
    let l = SPACING;
    let mass = |m: f64| Member::mass(l * m).unwrap();
    let ballast =
        if link { mass(848.0).joined(Element::spring(l * 8e7, 0.0, 0.1).unwrap()) } else { mass(848.0) };
    let spring = |k, eta| spring(k, 0.0, eta, Loss::Hysteretic);
    let links = vec![spring(3.5e8, 0.15), spring(1.8e8, 1.0), spring(1.2e8, 0.1)];
    let under = Stack::new(vec![mass(0.0), mass(245.0), ballast], links);
    Supports { rail: rail(beam, 0.0), spacing: l, under, width: None }
}
