//! A picture as a PDF of one page (ISO 32000): its paths, filled and stroked, without fonts and without pixels.

use std::collections::BTreeMap;

use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use resvg::tiny_skia::{PathSegment, Transform};
use resvg::usvg::{FillRule, Group, LineCap, LineJoin, Node, Paint, Path, Tree};

/// Points of a PDF in a unit of the SVG: 72 and 96 to an inch.
const POINTS: f32 = 0.75;
const CATALOG: i32 = 1;
const PAGES: i32 = 2;
const PAGE: i32 = 3;
const CONTENT: i32 = 4;
const INFORMATION: i32 = 5;
/// The first object of those that say how opaque something is.
const FIRST_STATE: i32 = 6;

/// The file. Equal pictures give equal bytes.
pub(crate) fn document(tree: &Tree, title: &str, description: &str) -> Vec<u8> {
    let [width, height] = [tree.size().width(), tree.size().height()].map(|length| length * POINTS);
    let mut page = Page { content: Content::new(), opacities: BTreeMap::new() };
    // A PDF counts upwards.
    page.content.transform([POINTS, 0.0, 0.0, -POINTS, 0.0, height]);
    page.group(tree.root(), 1.0);
    let mut pdf = Pdf::new();
    // First, so that its first bytes tell who wrote it.
    pdf.document_info(reference(INFORMATION))
        .title(TextStr(title))
        .subject(TextStr(description))
        .producer(TextStr("boundfit"));
    pdf.catalog(reference(CATALOG)).pages(reference(PAGES));
    pdf.pages(reference(PAGES)).kids([reference(PAGE)]).count(1);
    {
        let mut written = pdf.page(reference(PAGE));
        written
            .parent(reference(PAGES))
            .media_box(Rect::new(0.0, 0.0, width, height))
            .contents(reference(CONTENT));
        let mut resources = written.resources();
        let mut states = resources.ext_g_states();
        for (index, name) in (FIRST_STATE..).zip(page.opacities.values()) {
            states.pair(Name(name.as_bytes()), reference(index));
        }
        states.finish();
        resources.finish();
        written.finish();
    }
    for (index, thousandths) in (FIRST_STATE..).zip(page.opacities.keys()) {
        let opacity = *thousandths as f32 / 1000.0;
        pdf.ext_graphics(reference(index)).non_stroking_alpha(opacity).stroking_alpha(opacity);
    }
    pdf.stream(reference(CONTENT), &page.content.finish());
    pdf.finish()
}

fn reference(index: i32) -> Ref {
    Ref::new(index)
}

/// The content of the page so far.
struct Page {
    content: Content,
    /// Names of the opacities in use, in thousandths.
    opacities: BTreeMap<u32, String>,
}

impl Page {
    /// Writes the content of a group of this opacity. Our groups that are not opaque have one path each.
    fn group(&mut self, group: &Group, around: f32) {
        let opacity = around * group.opacity().get();
        for node in group.children() {
            match node {
                Node::Group(group) => self.group(group, opacity),
                Node::Path(path) => self.path(path, opacity),
                // Letters are paths as well.
                Node::Text(text) => self.group(text.flattened(), opacity),
                Node::Image(_) => {}
            }
        }
    }

    fn path(&mut self, path: &Path, opacity: f32) {
        let transform = path.abs_transform();
        if let Some((fill, Paint::Color(colour))) = path.fill().map(|fill| (fill, fill.paint())) {
            self.begin(opacity * fill.opacity().get());
            self.content.set_fill_rgb(part(colour.red), part(colour.green), part(colour.blue));
            self.outline(path, transform);
            match fill.rule() {
                FillRule::NonZero => self.content.fill_nonzero(),
                FillRule::EvenOdd => self.content.fill_even_odd(),
            };
            self.content.restore_state();
        }
        if let Some((stroke, Paint::Color(colour))) = path.stroke().map(|stroke| (stroke, stroke.paint())) {
            self.begin(opacity * stroke.opacity().get());
            self.content.set_stroke_rgb(part(colour.red), part(colour.green), part(colour.blue));
            // Pictures are scaled alike in both directions.
            self.content.set_line_width(stroke.width().get() * transform.sx.hypot(transform.ky));
            self.content.set_line_cap(match stroke.linecap() {
                LineCap::Butt => LineCapStyle::ButtCap,
                LineCap::Round => LineCapStyle::RoundCap,
                LineCap::Square => LineCapStyle::ProjectingSquareCap,
            });
            self.content.set_line_join(match stroke.linejoin() {
                LineJoin::Miter | LineJoin::MiterClip => LineJoinStyle::MiterJoin,
                LineJoin::Round => LineJoinStyle::RoundJoin,
                LineJoin::Bevel => LineJoinStyle::BevelJoin,
            });
            self.content.set_miter_limit(stroke.miterlimit().get());
            self.outline(path, transform);
            self.content.stroke();
            self.content.restore_state();
        }
    }

    /// Begins something of this opacity.
    fn begin(&mut self, opacity: f32) {
        self.content.save_state();
        let thousandths = (opacity * 1000.0).round() as u32;
        if thousandths < 1000 {
            let name = self.opacities.entry(thousandths).or_insert_with(|| format!("a{thousandths}"));
            self.content.set_parameters(Name(name.as_bytes()));
        }
    }

    fn outline(&mut self, path: &Path, transform: Transform) {
        let Some(data) = path.data().clone().transform(transform) else { return };
        let (mut from, mut start) = ([0.0, 0.0], [0.0, 0.0]);
        for segment in data.segments() {
            match segment {
                PathSegment::MoveTo(p) => {
                    (from, start) = ([p.x, p.y], [p.x, p.y]);
                    self.content.move_to(p.x, p.y);
                }
                PathSegment::LineTo(p) => {
                    from = [p.x, p.y];
                    self.content.line_to(p.x, p.y);
                }
                PathSegment::QuadTo(c, p) => {
                    // A parabola as a cubic curve.
                    let third = |end: [f32; 2]| {
                        [end[0] + (c.x - end[0]) * 2.0 / 3.0, end[1] + (c.y - end[1]) * 2.0 / 3.0]
                    };
                    let [first, second] = [third(from), third([p.x, p.y])];
                    from = [p.x, p.y];
                    self.content.cubic_to(first[0], first[1], second[0], second[1], p.x, p.y);
                }
                PathSegment::CubicTo(c, d, p) => {
                    from = [p.x, p.y];
                    self.content.cubic_to(c.x, c.y, d.x, d.y, p.x, p.y);
                }
                PathSegment::Close => {
                    from = start;
                    self.content.close_path();
                }
            }
        }
    }
}

/// A colour's part from 0 to 1.
fn part(byte: u8) -> f32 {
    f32::from(byte) / 255.0
}
