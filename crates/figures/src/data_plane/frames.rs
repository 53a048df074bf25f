//! The places of the panels of a figure.

use crate::drawing::Frame;
use crate::figure::PlotOptions;
use crate::page::Page;
use crate::render::{BOTTOM_LABELS, LEFT_LABELS};

/// Distance of panels from the right edge of the picture.
pub(super) const RIGHT: f64 = 22.0;

/// Returns the frames above each other, or flipped beside each other to share the axis of x if the page is wide
/// enough.
pub(super) fn frames(options: &PlotOptions) -> [Frame; 2] {
    let page = Page::of(options);
    let left = LEFT_LABELS + 16.0;
    let width = page.width - left - RIGHT;
    if are_side_by_side(options) {
        let frame = |left, width| Frame { left, top: 20.0, width, height: page.height(420.0) };
        let [first, gap] = [width * 0.56, 34.0];
        [frame(left, first), frame(left + first + gap, width - first - gap)]
    } else {
        let [first, second] = if options.flip { [420.0, 420.0] } else { [250.0, 170.0] };
        let frame = |top, height| Frame { left, top, width, height: page.height(height) };
        let labels = if options.flip { BOTTOM_LABELS } else { 0.0 };
        // A heading that is too wide to stand beside the scale of the axis stands above it.
        let gap = if page.is_narrow() { 46.0 } else { 32.0 };
        [frame(20.0, first), frame(20.0 + page.height(first) + labels + gap, second)]
    }
}

/// Returns whether the panels of a figure stand beside each other.
pub(super) fn are_side_by_side(options: &PlotOptions) -> bool {
    options.flip && !Page::of(options).is_narrow()
}
