//! Frequencies of the track without loss that explain its curves, as a reader sees them.

use super::Answer;
use crate::concern::Concern;
use crate::rail::Landmark;
use crate::track::Member;

fn name(landmark: Landmark) -> &'static str {
    match landmark {
        Landmark::CutOn => "cut-on",
        Landmark::Antiresonance => "antiresonance",
        Landmark::PinnedPinned => "pinned–pinned",
        Landmark::BandEdge => "band edge",
    }
}

/// The first of each kind, and how many are cut-ons.
fn told(landmarks: &[(Landmark, f64)]) -> impl Iterator<Item = (String, String, f64)> {
    let mut counts = [0usize; 4];
    landmarks.iter().filter_map(move |(landmark, frequency)| {
        let count = &mut counts[*landmark as usize];
        *count += 1;
        let (key, what) = match landmark {
            Landmark::CutOn => (
                format!("undamped_cut_on_{count}"),
                format!("Cut-on number {count} of the track without loss"),
            ),
            Landmark::Antiresonance => (
                format!("undamped_antiresonance_{count}"),
                "Without loss the supports hold the rail still (antiresonance)".to_owned(),
            ),
            Landmark::PinnedPinned if *count == 1 => (
                "pinned_pinned".to_owned(),
                "Half a wave of the rail between supports (pinned–pinned)".to_owned(),
            ),
            Landmark::PinnedPinned | Landmark::BandEdge => return None,
        };
        Some((key, what, *frequency))
    })
}

/// Landmarks as answers.
pub(super) fn landmark_answers(landmarks: &[(Landmark, f64)]) -> Vec<Answer> {
    told(landmarks)
        .map(|(key, what, frequency)| Answer::new(&key, what, frequency, "Hz", format!("{frequency:.1} Hz")))
        .collect()
}

/// Ranges without a wave as answers.
pub(super) fn stop_band_answers(bands: &[(f64, f64)]) -> Vec<Answer> {
    let one = |(i, (from, to)): (usize, &(f64, f64))| {
        let what = format!("Stop band number {} of the track without loss: no wave travels", i + 1);
        let shown = format!("{from:.1} to {to:.1} Hz");
        Answer::new(&format!("stop_band_{}_to", i + 1), what, *to, "Hz", shown)
    };
    bands.iter().enumerate().map(one).collect()
}

/// Landmarks as vertical marks of a picture; of the half waves between supports the first.
pub(super) fn marks(landmarks: &[(Landmark, f64)]) -> Vec<(f64, String)> {
    let first = landmarks.iter().position(|mark| mark.0 == Landmark::PinnedPinned);
    let marked = landmarks.iter().enumerate();
    marked
        .filter(|(i, mark)| mark.0 != Landmark::PinnedPinned || Some(*i) == first)
        .map(|(_, (landmark, frequency))| (*frequency, name(*landmark).to_owned()))
        .collect()
}

/// What a rail without loss leaves unsaid at its half waves between supports, at which a response between them has no bound.
pub(super) fn unbounded(landmarks: &[(Landmark, f64)], rail: &Member) -> Option<Concern> {
    let first = landmarks.iter().find(|mark| mark.0 == Landmark::PinnedPinned && !rail.loses())?;
    Some(Concern::new(
        "pinned-pinned",
        format!(
            "the rail loses nothing by itself: at {:.1} Hz, half a wave between supports, its receptance between them has no bound, \
             and what is computed nearby depends on the frequencies asked",
            first.1
        ),
        "give rail.loss_factor (0.01 to 0.02 is usual for rails with pads)",
    ))
}

/// What the marks of a picture are.
pub(super) fn marks_caption(landmarks: &[(Landmark, f64)]) -> &'static str {
    if landmarks.is_empty() { "" } else { " Marks: of the track without loss." }
}
