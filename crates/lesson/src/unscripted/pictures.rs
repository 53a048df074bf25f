//! Both pictures of the start, as figures are plotted. Their words are English; what stands around them is in the page's language.

use boundfit_figures::{Encoding, Figure, PictureFormat, PlotOptions, draw};

use super::Facts;
use crate::options::LessonError;
use crate::texts::{Message, escaped, say, text};

/// Both pictures, side by side.
pub(super) fn pictures(facts: &Facts<'_>) -> Result<String, LessonError> {
    let count = facts.problem.measurements.kept().len();
    let readings = match count {
        0 => String::new(),
        _ => {
            let words = text!("data-plane.readings", count: count);
            picture(facts, Figure::Data, &text!("data-plane.title"), &words)?
        }
    };
    let words = text!("parameter-plane.set", set: facts.kind());
    let set = picture(facts, Figure::Fps, &text!("parameter-plane.title"), &words)?;
    Ok(format!("<div class=\"pair\">{readings}{set}</div>"))
}

/// A figure below a title, and in words for those who cannot see it, which stand in place of its own title.
fn picture(
    facts: &Facts<'_>,
    figure: Figure,
    title: &Message,
    words: &Message,
) -> Result<String, LessonError> {
    let options = PlotOptions {
        x_unit: facts.options.x_unit.clone(),
        y_unit: facts.options.y_unit.clone(),
        title: Some("".into()),
        ..PlotOptions::default()
    };
    let encoding = Encoding { real_text: true, ..Encoding::default() };
    let svg = draw(facts.problem, facts.fit, figure, &options)?.encoded_as(PictureFormat::Svg, &encoding)?;
    let label = format!("<svg aria-label=\"{}\"", escaped(&say(words, facts.language())));
    let svg = String::from_utf8_lossy(&svg).replacen("<svg", &label, 1).replacen("<title></title>\n", "", 1);
    let title = facts.say(title);
    Ok(format!("<figure><figcaption><h3>{title}</h3></figcaption>{svg}</figure>"))
}
