//! Documents in LaTeX. The text keeps within the lines of a page: tables are small, and a column that is too wide is
//! broken into lines.

use boundfit_exact::latex;

use super::{Block, Facts, Inline, Symbol, Table, Text};

/// The number of digits of the size `\small` that a line on A4 holds in the class `article`: 71 at 12 points, 75
/// at 10.
const LINE: f64 = 75.0;
/// The number of these digits that are filled, since widths are estimates.
const ROOM: f64 = 71.0;
/// Titles and paragraphs break whatever is wider than half a line.
const SENTENCE: Option<f64> = Some(ROOM / 2.0);
/// The space between two columns, in digits.
const GAP: f64 = 2.6;

/// The blocks in order.
pub(super) fn written(blocks: &[Block]) -> String {
    let blocks = blocks.iter().filter_map(|block| match block {
        Block::Title(title) => Some(title_of(title)),
        // Set ragged, since formulas and long numbers leave no room to stretch.
        Block::Lead(text) | Block::Paragraph(text) => {
            Some(format!("{{\\raggedright {}\\par}}\n", line(text, SENTENCE)))
        }
        Block::Facts(Facts { rows, .. }) => facts(rows),
        Block::Results(rows) => Some(title_of(&super::RESULTS.into()) + "\n" + &facts(rows)?),
        Block::Table(table) => tabular_unless_empty(table),
        Block::LongTable(table) => tabular_unless_empty(&table.to_table()),
        Block::Space => None,
    });
    format!("% needs \\usepackage{{booktabs}}\n{}", blocks.collect::<Vec<_>>().join("\n"))
}

/// A heading on lines of its own. A heading that runs into another one is set in a box, which does not break.
fn title_of(title: &Text) -> String {
    format!("{{\\raggedright\\paragraph{{{}}}\\leavevmode\\par}}\n", line(title, SENTENCE))
}

fn facts(rows: &[(Text, Text)]) -> Option<String> {
    let rows: Vec<Vec<Text>> = rows.iter().map(|(label, fact)| vec![label.clone(), fact.clone()]).collect();
    tabular_unless_empty(&Table { rows, ..Table::default() })
}

fn tabular_unless_empty(table: &Table) -> Option<String> {
    (!table.rows.is_empty()).then(|| tabular(table))
}

fn tabular(table: &Table) -> String {
    let limits = limits(table);
    let is_broken = limits.iter().any(Option::is_some);
    // Within a broken column a double backslash ends a line of the cell, not the row.
    let end = if is_broken { "\\tabularnewline" } else { "\\\\" };
    let row = |cells: &Vec<Text>| {
        let cells = cells.iter().zip(&limits);
        let cells = cells.map(|(cell, limit)| match limit {
            Some(_) if !cell.is_empty() => format!("\\raggedright {}", line(cell, *limit)),
            _ => line(cell, None),
        });
        let cells = cells.collect::<Vec<_>>().join(" & ");
        // Behind the end of a row and \midrule a bracket or a star would be theirs.
        let guard = if cells.starts_with(['[', '*']) { "{}" } else { "" };
        format!("{guard}{cells} {end}\n")
    };
    let columns = limits.iter().map(|limit| match limit {
        Some(width) => format!("p{{{:.2}\\linewidth}}", width / LINE),
        None => "l".to_owned(),
    });
    let columns: String = columns.collect();
    let header = if table.header.is_empty() { String::new() } else { row(&table.header) + "\\midrule\n" };
    let rows: String = table.rows.iter().map(row).collect();
    format!(
        "\\begin{{center}}\\small\n\\begin{{tabular}}{{@{{}}{columns}@{{}}}}\n\\toprule\n{header}{rows}\\bottomrule\n\
         \\end{{tabular}}\n\\end{{center}}\n"
    )
}

/// The widths of the columns that have to be broken, in digits: the widest ones, all alike, and as wide as the others
/// leave them room for.
fn limits(table: &Table) -> Vec<Option<f64>> {
    let columns = table.rows.first().map_or(0, Vec::len);
    let lines = || table.rows.iter().chain(Some(&table.header).filter(|header| !header.is_empty()));
    let widest = |column: usize| lines().map(|row| row.get(column).map_or(0.0, width)).fold(0.0, f64::max);
    let natural: Vec<f64> = (0..columns).map(widest).collect();
    let mut room = (1..columns).fold(ROOM, |room, _| room - GAP);
    let mut sorted = natural.clone();
    sorted.sort_by(f64::total_cmp);
    for (narrower, width) in sorted.iter().enumerate() {
        let share = room / (columns - narrower) as f64;
        if *width > share {
            return natural.iter().map(|width| (*width > share).then_some(share)).collect();
        }
        room -= width;
    }
    vec![None; columns]
}

/// Returns about how wide a text is set, in digits.
fn width(text: &Text) -> f64 {
    let length = |text: &str| text.chars().count() as f64;
    let of = |inline: &Inline| match inline {
        // Before a small exponent there are a cross with space around it, and 10.
        Inline::Number(number) => match number.split_once('e') {
            Some((mantissa, exponent)) => length(mantissa) + 4.5 + 0.8 * length(exponent),
            None => length(number),
        },
        Inline::Mark(mark) => 0.6 * length(mark),
        Inline::Symbol(Symbol::LeastEpsilon) => 4.0,
        Inline::Symbol(_) | Inline::Operator(_) => 2.2,
        words => 0.9 * length(&words.to_string()),
    };
    text.0.iter().map(of).sum()
}

/// A text in which adjacent parts of formulas are one formula. With a limit to its width, in digits, there are places to
/// break it where TeX knows none.
fn line(text: &Text, limit: Option<f64>) -> String {
    let mut result = String::new();
    let mut pieces = text.0.iter().peekable();
    let mut in_formula = false;
    while let Some(piece) = pieces.next() {
        let math = formula(piece, limit);
        if math.is_some() != in_formula {
            result.push('$');
        }
        let opens = math.is_some() && !in_formula;
        in_formula = math.is_some();
        let Some(math) = math else {
            result.push_str(&words(piece, limit));
            continue;
        };
        // An operator needs an operand on either side: without one TeX takes it for a sign and sets it close.
        let is_operator = matches!(piece, Inline::Operator(_));
        if is_operator && opens {
            result.push_str("{}");
        }
        result.push_str(&math);
        if is_operator && pieces.peek().is_none_or(|next| formula(next, None).is_none()) {
            result.push_str("{}");
        }
    }
    if in_formula {
        result.push('$');
    }
    result
}

/// A part of a formula; `None` for words.
fn formula(inline: &Inline, limit: Option<f64>) -> Option<String> {
    Some(match inline {
        Inline::Words(_) | Inline::Given(_) | Inline::Indent => return None,
        Inline::Number(number) => {
            let digits =
                |digits| breakable(digits, limit, r"\allowbreak ", |digit, result| result.push(digit));
            match number.split_once('e') {
                Some((mantissa, exponent)) => format!(r"{} \times 10^{{{exponent}}}", digits(mantissa)),
                None => digits(number),
            }
        }
        Inline::Mark(", ") if limit.is_some() => r", \allowbreak ".to_owned(),
        Inline::Mark(mark) => (*mark).to_owned(),
        Inline::Symbol(symbol) => symbol.forms().1.to_owned(),
        Inline::Operator(operator) => operator.forms().1.to_owned(),
    })
}

/// The LaTeX source of these words.
fn words(inline: &Inline, limit: Option<f64>) -> String {
    match inline {
        Inline::Indent => r"\quad ".to_owned(),
        Inline::Given(text) => breakable(&text.to_string(), limit, r"\allowbreak{}", latex::escape_in_name),
        other => {
            let mut result = String::new();
            other.to_string().chars().for_each(|character| latex::escape(character, &mut result));
            result
        }
    }
}

/// A text with places to break it where a run without blanks is wider than the limit: behind slashes, and twice in a line.
fn breakable(text: &str, limit: Option<f64>, place: &str, write: impl Fn(char, &mut String)) -> String {
    let limit = limit.map_or(usize::MAX, |limit| (0.9 * limit) as usize);
    let mut result = String::new();
    for (index, run) in text.split(' ').enumerate() {
        if index > 0 {
            result.push(' ');
        }
        let is_long = run.chars().count() > limit;
        let mut unbroken = 0;
        for character in run.chars() {
            write(character, &mut result);
            unbroken += 1;
            if is_long && (character == '/' || unbroken >= limit / 2) {
                result.push_str(place);
                unbroken = 0;
            }
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::super::Operator;
    use super::*;
    use crate::formula::products;

    #[test]
    fn operators_have_their_operands() {
        let terms = ["1/8", "2"].map(|m| (Text::new().number(m), format!("{m} upper")));
        let sum = r"$1/8 \cdot {}$(1/8 upper)${} + 2 \cdot {}$(2 upper)";
        assert_eq!(line(&products(terms), None), sum);
        let relation = Text::new().given("a-b").operator(Operator::Equals).symbol(Symbol::Theta1);
        assert_eq!(line(&relation, None), r"a{-}b${} = \theta_1$");
        assert_eq!(line(&Text::from("at ").number("-1.8e-3").words("."), None), r"at $-1.8 \times 10^{-3}$.");
    }

    #[test]
    fn what_is_too_wide_can_be_broken() {
        let text = Text::new().number("123456/7890123").words(" ").given("to/the/names");
        assert_eq!(line(&text, None), "$123456/7890123$ to/the/names");
        assert_eq!(
            line(&text, Some(10.0)),
            r"$1234\allowbreak 56/\allowbreak 7890\allowbreak 123$ to/\allowbreak{}the/\allowbreak{}name\allowbreak{}s"
        );
        let table = |cells: [&str; 3]| Table::new(["", "", ""], vec![cells.map(Text::from).into()]);
        assert_eq!(limits(&table(["ab", "cd", "ef"])), [None; 3]);
        let long = "many words ".repeat(9);
        let [short, first, second] = limits(&table(["ab", &long, &long]))[..] else { panic!() };
        assert!(
            short.is_none() && first == second && first.is_some_and(|width| 30.0 < width && width < 35.0)
        );
    }

    #[test]
    fn a_row_begins_with_no_argument_of_the_row_before() {
        let row = |name: &str| vec![Text::new().given(name), "1".into()];
        let table = Table::new(["name", "value"], ["[x]", "*y", "z"].map(row).into());
        let source = tabular(&table);
        assert!(source.contains("\\midrule\n{}[x] & 1 \\\\\n{}*y & 1 \\\\\nz & 1"), "{source}");
    }

    #[test]
    fn names_are_shown_as_they_are() {
        let shown = |text: &str| line(&Text::new().given(text), None);
        assert_eq!(shown("V_z & 5%"), r"V\_z \& 5\%");
        assert_eq!(
            shown("a\\b{^~}|<>--"),
            r"a\textbackslash{}b\{\textasciicircum{}\textasciitilde{}\}\textbar{}\textless{}\textgreater{}{-}{-}"
        );
    }
}
