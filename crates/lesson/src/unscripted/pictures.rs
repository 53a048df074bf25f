//! Both pictures of the start, as figures are plotted. Their words are English; what stands around them is in the page's language.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
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
            picture(facts, Figure::Corridor, &text!("data-plane.title"), &words)?
        }
    };
    let words = text!("parameter-plane.set", set: facts.kind());
    let set = picture(facts, Figure::Fps, &text!("parameter-plane.title"), &words)?;
    Ok(format!("<div class=\"pair\">{readings}{set}</div>"))
}

/// A figure below a title, and in words for those who cannot see it. As an image it takes none of the page's styles.
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
    Ok(format!(
        "<figure><figcaption><h3>{}</h3></figcaption><img alt=\"{}\" src=\"data:image/svg+xml;base64,{}\"></figure>",
        facts.say(title),
        escaped(&say(words, facts.language())),
        STANDARD.encode(svg)
    ))
}
