//! Findings about solutions as JUnit XML, which continuous integration shows as tests.

use boundfit_judge::{Finding, JudgedSolution, Worth};
use boundfit_lp::Model;

use super::sentence::sentence;

/// The findings as JUnit XML, with a line end: a suite for each file, a test case for each aspect. A refuted aspect
/// has failed, and an aspect without an answer was skipped.
pub fn solutions_junit(model: &Model, solutions: &[JudgedSolution]) -> String {
    let count = |worth: Worth, judged: &JudgedSolution| {
        judged.findings.findings.iter().filter(|finding| finding.worth == worth).count()
    };
    let all = |worth| solutions.iter().map(|judged| count(worth, judged)).sum::<usize>();
    let tests: usize = solutions.iter().map(|judged| judged.findings.findings.len()).sum();
    let mut xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n".to_owned();
    xml.push_str(&format!(
        "<testsuites name=\"boundfit judge\" tests=\"{tests}\" failures=\"{}\" skipped=\"{}\">\n",
        all(Worth::Refuted),
        all(Worth::NoAnswer)
    ));
    for judged in solutions {
        xml.push_str(&format!(
            "  <testsuite name=\"{}\" tests=\"{}\" failures=\"{}\" skipped=\"{}\">\n",
            escaped(&judged.file.to_string()),
            judged.findings.findings.len(),
            count(Worth::Refuted, judged),
            count(Worth::NoAnswer, judged)
        ));
        for finding in &judged.findings.findings {
            xml.push_str(&case(model, judged, finding));
        }
        xml.push_str("  </testsuite>\n");
    }
    xml.push_str("</testsuites>\n");
    xml
}

fn case(model: &Model, judged: &JudgedSolution, finding: &Finding) -> String {
    let message = escaped(&format!("{}: {}", finding.worth.name(), sentence(model, finding)));
    let open = format!(
        "    <testcase classname=\"{}\" name=\"{}\" file=\"{}\" line=\"{}\"",
        escaped(judged.solution.writer),
        finding.aspect.name(),
        escaped(&judged.file.to_string()),
        finding.line
    );
    let inside = match finding.worth {
        Worth::Refuted => {
            format!("      <failure type=\"{}\" message=\"{message}\"/>\n", finding.aspect.name())
        }
        Worth::NoAnswer => format!("      <skipped message=\"{message}\"/>\n"),
        _ => format!("      <system-out>{message}</system-out>\n"),
    };
    format!("{open}>\n{inside}    </testcase>\n")
}

/// A text for XML, without the characters that XML 1.0 cannot hold.
fn escaped(text: &str) -> String {
    let mut xml = String::new();
    for character in text.chars() {
        match character {
            '&' => xml.push_str("&amp;"),
            '<' => xml.push_str("&lt;"),
            '>' => xml.push_str("&gt;"),
            '"' => xml.push_str("&quot;"),
            '\t' | '\n' | '\r' => xml.push_str(&format!("&#{};", u32::from(character))),
            '\u{0}'..='\u{1f}' | '\u{fffe}' | '\u{ffff}' => xml.push('\u{fffd}'),
            other => xml.push(other),
        }
    }
    xml
}
