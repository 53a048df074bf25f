//! The page that a figure is laid out on: as wide as its letters leave it.

use crate::figure::PlotOptions;

/// Nominal width of a figure with letters of the usual size, in pixels.
pub(crate) const WIDTH: f64 = 800.0;
/// The letters of legends in nominal pixels; those of titles are a little larger, those of ticks and notes a little smaller.
const LETTERS: f64 = 12.0;
/// Micrometres in a nominal pixel: 96 to an inch.
const PIXEL: f64 = 25_400.0 / 96.0;
/// Widths on which panels and words have room.
const WIDTHS: [f64; 2] = [320.0, 3200.0];
/// Panels of narrow pages are lower, but not in proportion.
const LOWEST: f64 = 0.6;

/// A page, in nominal pixels: those in which letters have their usual size, however large the picture is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Page {
    pub(crate) width: f64,
    /// Pixels of the picture, 96 to an inch, for each nominal one.
    pub(crate) scale: f64,
}

impl Default for Page {
    fn default() -> Self {
        Page { width: WIDTH, scale: 1.0 }
    }
}

impl Page {
    /// The page that is asked for, within what has room.
    pub(crate) fn of(options: &PlotOptions) -> Self {
        let pixels = options.width.map_or(WIDTH, |width| f64::from(width) / PIXEL);
        let [least, most] = WIDTHS;
        // A whole number of canvas units.
        let width = (asked(options).clamp(least, most) * 10.0).round() / 10.0;
        Page { width, scale: pixels / width }
    }

    /// The height of a panel that usually has this one.
    pub(crate) fn height(self, usual: f64) -> f64 {
        usual * (self.width / WIDTH).max(LOWEST)
    }

    /// Returns whether panels stand below each other that usually stand side by side.
    pub(crate) fn is_narrow(self) -> bool {
        self.width < WIDTH
    }
}

/// The width that letters of the asked size leave.
fn asked(options: &PlotOptions) -> f64 {
    let pixels = options.width.map_or(WIDTH, |width| f64::from(width) / PIXEL);
    options.letters.map_or(WIDTH, |letters| LETTERS * PIXEL * pixels / f64::from(letters.max(1)))
}

impl PlotOptions {
    /// Returns whether letters of the asked size leave room for a figure of the asked width, which must be 27 to 266 times as wide.
    pub fn have_letters_room(&self) -> bool {
        let [least, most] = WIDTHS;
        (least..=most).contains(&asked(self))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn page(width: Option<u32>, letters: Option<u32>) -> Page {
        Page::of(&PlotOptions { width, letters, ..PlotOptions::default() })
    }

    #[test]
    fn letters_have_the_size_that_is_asked_for() {
        assert_eq!(page(None, None), Page::default());
        assert_eq!(page(Some(85_000), None).width, WIDTH);
        for (width, letters) in [(85_000, 2_822), (170_000, 2_822), (170_000, 4_233), (85_000, 1_764)] {
            let page = page(Some(width), Some(letters));
            let drawn = LETTERS * page.scale * PIXEL;
            assert!((drawn - f64::from(letters)).abs() < 1.0, "{drawn} for {letters}");
            assert!((page.width * page.scale * PIXEL - f64::from(width)).abs() < 1e-6);
        }
    }

    #[test]
    fn letters_that_leave_no_room_are_told() {
        let has_room = |width, letters| {
            PlotOptions { width: Some(width), letters: Some(letters), ..PlotOptions::default() }
                .have_letters_room()
        };
        assert!(has_room(27_000, 1_000) && has_room(266_000, 1_000));
        assert!(!has_room(26_000, 1_000) && !has_room(267_000, 1_000) && !has_room(1_000, 0));
    }
}
