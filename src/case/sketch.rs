//! A drawing of train, track and ground for the report.

use super::track_table::{self, link_name, member_name};
use crate::figure::{DrawnLayer, DrawnPart, Figure, SketchFigure};
use crate::railway::{Railway, Support};
use crate::soil::{Base, Material};
use crate::track::Stack;

/// What a layer is, in one line.
fn described(name: String, thickness: Option<f64>, m: &Material) -> String {
    let thickness = thickness.map_or(String::new(), |h| format!("{h} m, "));
    format!(
        "{name}: {thickness}c_s {:.0} m/s, c_p {:.0} m/s, {:.0} kg/m³, damping {:.1} %",
        m.c_s(),
        m.c_p(),
        m.density(),
        // ξ = η/2
        50.0 * m.loss_factor()
    )
}

fn layers(railway: &Railway) -> Vec<DrawnLayer> {
    let ground = match railway.support() {
        Support::Ground(ground) => ground,
        Support::Springs(springs) => {
            let label = format!("foundation: {}", springs.model().name());
            return vec![DrawnLayer { label, thickness: None, shear_speed: None }];
        }
    };
    let named = |i: usize, otherwise: String| ground.names.get(i).cloned().flatten().unwrap_or(otherwise);
    let profile = &ground.profile;
    let mut drawn: Vec<DrawnLayer> = profile
        .layers()
        .iter()
        .enumerate()
        .map(|(i, l)| DrawnLayer {
            label: described(named(i, format!("layer {}", i + 1)), Some(l.thickness), &l.material),
            thickness: Some(l.thickness),
            shear_speed: Some(l.material.c_s()),
        })
        .collect();
    drawn.push(match profile.base() {
        Base::HalfSpace(m) => DrawnLayer {
            label: described(named(profile.layers().len(), "half-space".into()), None, &m),
            thickness: None,
            shear_speed: Some(m.c_s()),
        },
        Base::Rigid => DrawnLayer { label: "rigid base".into(), thickness: None, shear_speed: None },
    });
    drawn
}

fn parts(stack: &Stack) -> Vec<DrawnPart> {
    let mut parts = Vec::new();
    for i in 0..stack.members().len() {
        parts.push(DrawnPart { label: member_name(stack, i).into(), is_spring: false });
        if i < stack.links().len() {
            parts.push(DrawnPart { label: link_name(stack, i).into(), is_spring: true });
        }
    }
    parts
}

/// The model of `railway`, to be looked at before its numbers are.
pub fn sketch(railway: &Railway) -> (Figure, String) {
    let track = parts(&track_table::layers(railway).0);
    let axles = railway.train().map_or(Vec::new(), |train| {
        let lead = train.axles()[0].position;
        train.axles().iter().map(|axle| (axle.position - lead, axle.load)).collect()
    });
    let layers = layers(railway);
    let figure =
        SketchFigure { name: "model".into(), title: "Train, track and ground".into(), axles, track, layers };
    let caption = "The model: places along the train to scale, thicknesses as far as their labels leave room; layers are the darker \
                   the stiffer, depths of their upper faces on the right.";
    (Figure::Sketch(figure), caption.into())
}
