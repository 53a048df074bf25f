//! Colours, strokes and marks. The colours are Okabe and Ito's, which colour-blind readers tell apart; what stands for
//! different things also differs in dash, mark or lightness, so that nothing is lost in grey.

/// Red, green and blue.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Colour(pub(crate) u8, pub(crate) u8, pub(crate) u8);

impl Colour {
    /// The grey that is as light (Rec. 709).
    pub(crate) fn grey(self) -> Self {
        let Colour(red, green, blue) = self;
        let [red, green, blue] = [red, green, blue].map(u32::from);
        let light = (2126 * red + 7152 * green + 722 * blue + 5000) / 10_000;
        let light = u8::try_from(light).unwrap_or(u8::MAX);
        Colour(light, light, light)
    }
}

pub(crate) const PAPER: Colour = Colour(0xff, 0xff, 0xff);
pub(crate) const INK: Colour = Colour(0x26, 0x26, 0x26);
pub(crate) const FAINT_INK: Colour = Colour(0x5e, 0x5e, 0x5e);
pub(crate) const GRID: Colour = Colour(0xe4, 0xe4, 0xe4);
pub(crate) const FRAME: Colour = Colour(0x8c, 0x8c, 0x8c);
pub(crate) const GREY: Colour = Colour(0x9a, 0x9a, 0x9a);
pub(crate) const LIGHT_GREY: Colour = Colour(0xb4, 0xb4, 0xb4);
pub(crate) const ORANGE: Colour = Colour(0xe6, 0x9f, 0x00);
pub(crate) const SKY: Colour = Colour(0x56, 0xb4, 0xe9);
pub(crate) const GREEN: Colour = Colour(0x00, 0x9e, 0x73);
pub(crate) const BLUE: Colour = Colour(0x00, 0x72, 0xb2);
pub(crate) const VERMILLION: Colour = Colour(0xd5, 0x5e, 0x00);
pub(crate) const PURPLE: Colour = Colour(0xcc, 0x79, 0xa7);
/// The edge of purple areas.
pub(crate) const DARK_PURPLE: Colour = Colour(0x8f, 0x3c, 0x6b);

/// The way in which a line is broken. Lengths are in pixels of the nominal size.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dash {
    Solid,
    Long,
    Short,
    Dots,
    Alternating,
}

impl Dash {
    /// Lengths drawn and left out in turn; empty for a solid line.
    pub(crate) fn pattern(self) -> &'static [f64] {
        match self {
            Dash::Solid => &[],
            Dash::Long => &[9.0, 4.0],
            Dash::Short => &[4.5, 3.0],
            Dash::Dots => &[1.6, 2.6],
            Dash::Alternating => &[8.0, 3.0, 1.6, 3.0],
        }
    }
}

/// The look of a line; the width in pixels of the nominal size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stroke {
    pub(crate) colour: Colour,
    pub(crate) width: f64,
    pub(crate) dash: Dash,
}

impl Stroke {
    pub(crate) const fn new(colour: Colour, width: f64, dash: Dash) -> Self {
        Stroke { colour, width, dash }
    }
}

/// The look of an area; an opacity from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Fill {
    pub(crate) colour: Colour,
    pub(crate) opacity: f64,
}

#[cfg(test)]
impl Fill {
    /// The grey of the area on white paper, from 0 to 255.
    pub(crate) fn grey_on_paper(self) -> f64 {
        let Colour(grey, ..) = self.colour.grey();
        255.0 - self.opacity * (255.0 - f64::from(grey))
    }
}

/// The form of a mark.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Shape {
    /// A disc.
    Disc,
    /// A circle with a white inside.
    Circle,
    /// A circle around other marks.
    Ring,
    /// A filled square, the cheapest mark in bytes.
    Square,
    /// A filled square on its tip.
    Diamond,
    /// A filled triangle.
    Triangle,
    /// Two crossing strokes.
    Cross,
}

/// A mark; the radius in pixels of the nominal size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Mark {
    pub(crate) shape: Shape,
    pub(crate) radius: f64,
    pub(crate) colour: Colour,
}

impl Mark {
    pub(crate) const fn new(shape: Shape, radius: f64, colour: Colour) -> Self {
        Mark { shape, radius, colour }
    }
}

/// The styles of the same things in every figure.
pub(crate) mod style {
    use super::*;

    pub(crate) const LEAST_SQUARES: Stroke = Stroke::new(VERMILLION, 1.6, Dash::Solid);
    pub(crate) const LEAST_SQUARES_MARK: Mark = Mark::new(Shape::Cross, 5.4, VERMILLION);
    pub(crate) const CENTRAL: Stroke = Stroke::new(INK, 1.4, Dash::Alternating);
    pub(crate) const CENTRAL_MARK: Mark = Mark::new(Shape::Diamond, 4.6, INK);
    pub(crate) const MINIMAX: Stroke = Stroke::new(GREEN, 1.4, Dash::Dots);
    pub(crate) const MINIMAX_MARK: Mark = Mark::new(Shape::Triangle, 6.4, GREEN);
    pub(crate) const EUI_EDGE: Stroke = Stroke::new(ORANGE, 1.5, Dash::Short);
    pub(crate) const EUI_FILL: Fill = Fill { colour: ORANGE, opacity: 0.16 };
    pub(crate) const PUI_EDGE: Stroke = Stroke::new(BLUE, 1.3, Dash::Long);
    pub(crate) const PUI_FILL: Fill = Fill { colour: SKY, opacity: 0.2 };
    pub(crate) const SET_EDGE: Stroke = Stroke::new(BLUE, 1.5, Dash::Solid);
    pub(crate) const SET_FILL: Fill = Fill { colour: BLUE, opacity: 0.3 };
    pub(crate) const VERTEX: Mark = Mark::new(Shape::Disc, 2.8, BLUE);
    /// A set that is one point, which estimates cover.
    pub(crate) const POINT: Mark = Mark::new(Shape::Ring, 9.5, BLUE);
    pub(crate) const READING: Mark = Mark::new(Shape::Disc, 2.2, INK);
    pub(crate) const READING_BAR: Stroke = Stroke::new(FAINT_INK, 1.0, Dash::Solid);
    pub(crate) const OTHER: Mark = Mark::new(Shape::Circle, 2.6, GREY);
    pub(crate) const DENSE_READING: Mark = Mark::new(Shape::Square, 1.0, INK);
    pub(crate) const DENSE_BAR: Stroke = Stroke::new(LIGHT_GREY, 0.7, Dash::Solid);
    pub(crate) const DENSE_OTHER: Mark = Mark::new(Shape::Square, 1.2, GREY);
    pub(crate) const ALL_READINGS: Fill = Fill { colour: GRID, opacity: 1.0 };
    /// The greys from few to many readings at a place.
    pub(crate) const COUNTS: [Fill; 4] = [grey(0xc2), grey(0x96), grey(0x62), grey(0x2b)];
    pub(crate) const CONFLICT: Mark = Mark::new(Shape::Diamond, 5.0, PURPLE);
    pub(crate) const CONFLICT_BAR: Stroke = Stroke::new(PURPLE, 2.4, Dash::Solid);

    const fn grey(light: u8) -> Fill {
        Fill { colour: Colour(light, light, light), opacity: 1.0 }
    }
}
