//! The places of the texts of a panel: beside their points, so that none covers a mark or another text while there is
//! room.

use super::written::{HALF_LINE, Pixel, Rectangle};
use crate::clip::Place;
use crate::drawing::{Anchor, Frame};

/// The distances of texts from their places, best first.
const GAPS: [f64; 4] = [3.5, 8.0, 15.0, 26.0];
/// The turns of texts away from their preferred direction, in radians, best first.
const TURNS: [f64; 12] = [0.0, 0.4, -0.4, 0.8, -0.8, 1.2, -1.2, 1.6, -1.6, 2.3, -2.3, std::f64::consts::PI];
/// Steps in which a text on an edge of the panel moves along it.
const STEP: f64 = 12.0;
/// Covering a text is worse than covering as many marks.
const OF_TEXT: usize = 1_000_000;
/// Distance from the edges of panels and of the picture.
const EDGE: f64 = 2.0;

/// A text to be placed.
pub(super) struct Label {
    /// The place of the text in fractions of the panel, and on the canvas.
    pub(super) place: Place,
    pub(super) at: Pixel,
    /// The preferred direction of the text.
    pub(super) anchor: Anchor,
    pub(super) width: f64,
}

/// The left end and the middle line of each text. `texts` are there already, `marks` as well; the page
/// is this wide. Cost: texts by marks.
pub(super) fn placed(
    labels: &[Label],
    mut texts: Vec<Rectangle>,
    marks: &[Rectangle],
    frame: Frame,
    page: f64,
) -> Vec<Pixel> {
    let mut found = Vec::with_capacity(labels.len());
    for label in labels {
        let covered = |at: &Pixel| {
            let own = Rectangle::of_text(*at, label.width);
            let count = |others: &[Rectangle]| others.iter().filter(|other| own.overlaps(other)).count();
            count(&texts) * OF_TEXT + count(marks)
        };
        let mut best: Option<(usize, Pixel)> = None;
        for at in candidates(label, frame, page) {
            let score = covered(&at);
            if best.is_none_or(|(least, _)| score < least) {
                best = Some((score, at));
            }
            if score == 0 {
                break;
            }
        }
        let at = best.map_or(label.at, |(_, at)| at);
        texts.push(Rectangle::of_text(at, label.width));
        found.push(at);
    }
    found
}

/// Returns the places where a text may stand, best first.
fn candidates(label: &Label, frame: Frame, page: f64) -> Vec<Pixel> {
    let Anchor { across, up } = label.anchor;
    let straight = up.atan2(across);
    let is_inside = label.place.iter().all(|&coordinate| coordinate > 0.0 && coordinate < 1.0);
    if !is_inside {
        let [left, middle] = beside(label, label.anchor, GAPS[0], frame, page);
        let moved = |steps: i32| [kept_on_page(left + f64::from(steps) * STEP, label.width, page), middle];
        return (0..40).flat_map(|steps| [moved(steps), moved(-steps)]).collect();
    }
    let turned = |turn: f64| Anchor { across: (straight + turn).cos(), up: (straight + turn).sin() };
    GAPS.iter().flat_map(|&gap| TURNS.map(|turn| beside(label, turned(turn), gap, frame, page))).collect()
}

/// The left end and the middle line of a text beside a point: wholly beyond the line through the point that the
/// direction of its anchor is normal to. A text whose place is inside of the frame is kept inside.
fn beside(label: &Label, Anchor { across, up }: Anchor, gap: f64, frame: Frame, page: f64) -> Pixel {
    let Label { place, at, width, .. } = label;
    let far = gap + across.abs() * (width / 2.0 + 1.0) + up.abs() * HALF_LINE;
    let left = at[0] + across * far - width / 2.0;
    let middle = at[1] - up * far;
    let inside = |coordinate: f64| coordinate > 0.0 && coordinate < 1.0;
    let kept = |value: f64, least: f64, most: f64| value.min(most).max(least);
    let (right, bottom) = (frame.left + frame.width, frame.top + frame.height);
    [
        if inside(place[0]) {
            kept(left, frame.left + EDGE, right - EDGE - width)
        } else {
            kept_on_page(left, *width, page)
        },
        if inside(place[1]) {
            kept(middle, frame.top + HALF_LINE + EDGE, bottom - HALF_LINE - EDGE)
        } else {
            middle
        },
    ]
}

fn kept_on_page(left: f64, width: f64, page: f64) -> f64 {
    left.min(page - EDGE - width).max(EDGE)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Frame = Frame { left: 0.0, top: 0.0, width: 200.0, height: 200.0 };

    fn label(at: Pixel) -> Label {
        let place = [at[0] / FRAME.width, 1.0 - at[1] / FRAME.height];
        Label { place, at, anchor: Anchor { across: 1.0, up: 0.0 }, width: 20.0 }
    }

    #[test]
    fn texts_cover_no_mark_and_no_other_text() {
        let marks: Vec<Rectangle> =
            (0..12).map(|k| Rectangle::around([100.0 + f64::from(k) * 5.0, 100.0], 5.0)).collect();
        let labels: Vec<Label> = (0..6).map(|k| label([100.0 + f64::from(k) * 10.0, 100.0])).collect();
        let found = placed(&labels, Vec::new(), &marks, FRAME, 200.0);
        let texts: Vec<Rectangle> = found.iter().map(|&at| Rectangle::of_text(at, 20.0)).collect();
        for (index, text) in texts.iter().enumerate() {
            assert!(marks.iter().all(|mark| !text.overlaps(mark)), "{index}");
            assert!(texts[..index].iter().all(|other| !text.overlaps(other)), "{index}");
        }
    }

    #[test]
    fn a_text_with_room_stands_where_it_is_to() {
        assert_eq!(placed(&[label([100.0, 100.0])], Vec::new(), &[], FRAME, 200.0), [[104.5, 100.0]]);
    }
}
