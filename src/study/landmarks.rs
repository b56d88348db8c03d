//! Frequencies of the track without loss that explain its curves, as a reader sees them.

use super::Answer;
use crate::rail::Landmark;

fn name(landmark: Landmark) -> &'static str {
    match landmark {
        Landmark::CutOn => "cut-on",
        Landmark::Antiresonance => "antiresonance",
        Landmark::PinnedPinned => "pinned–pinned",
    }
}

/// The first of each kind, and how many are cut-ons.
fn told(landmarks: &[(Landmark, f64)]) -> impl Iterator<Item = (String, String, f64)> {
    let mut counts = [0usize; 3];
    landmarks.iter().filter_map(move |(landmark, frequency)| {
        let count = &mut counts[*landmark as usize];
        *count += 1;
        let (key, what) = match landmark {
            Landmark::CutOn => {
                (format!("undamped_cut_on_{count}"), format!("Cut-on number {count} of the track without loss"))
            }
            Landmark::Antiresonance => (
                format!("undamped_antiresonance_{count}"),
                "Without loss the supports hold the rail still (antiresonance)".to_owned(),
            ),
            Landmark::PinnedPinned if *count == 1 => (
                "pinned_pinned".to_owned(),
                "Half a wave of the rail between supports (pinned–pinned); without loss in the rail its mid-span has no bound there"
                    .to_owned(),
            ),
            Landmark::PinnedPinned => return None,
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

/// Landmarks as vertical marks of a picture.
pub(super) fn marks(landmarks: &[(Landmark, f64)]) -> Vec<(f64, String)> {
    landmarks.iter().map(|(landmark, frequency)| (*frequency, name(*landmark).to_owned())).collect()
}

/// What the marks of a picture are.
pub(super) fn marks_caption(landmarks: &[(Landmark, f64)]) -> &'static str {
    if landmarks.is_empty() { "" } else { " Marks: of the track without loss." }
}
