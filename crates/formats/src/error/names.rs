//! What a column that is not there may have been meant for.

use boundfit_exact::{Limits, Reading};
use strsim::osa_distance;

/// Behind the message that there is no such column: what to do.
pub(super) fn advice(wanted: &str, available: &[String], numbers: Option<usize>) -> String {
    match (nearest(wanted, available), numbers) {
        (Some(name), _) => format!("; did you mean {name:?}?"),
        (None, Some(columns)) if are_no_names(available) => {
            format!("; the file has no header: ask for columns by number, 1 to {columns}")
        }
        _ => String::new(),
    }
}

/// Whether the cells of the first row are numbers: it was taken for a header only because a column was asked for by name.
pub(super) fn are_no_names(available: &[String]) -> bool {
    let is_number = |name: &String| Reading::Decimal.read(name, &Limits::default()).is_ok();
    !available.is_empty() && available.iter().all(is_number)
}

/// The name that differs from the wanted one in upper and lower case, by what follows its first words (`r` and `r (Mpc)`),
/// or in a third of its letters at most: of each kind the first, of the last kind the nearest.
fn nearest<'a>(wanted: &str, available: &'a [String]) -> Option<&'a str> {
    let lower = wanted.to_lowercase();
    let begins = |name: &str| {
        let rest = name.to_lowercase();
        let rest = rest.strip_prefix(&lower).map(str::trim_start);
        !lower.is_empty() && rest.is_some_and(|rest| rest.starts_with(['(', '[', '/', ',', ':']))
    };
    let distance = |name: &str| osa_distance(&lower, &name.to_lowercase());
    let names = || available.iter().map(String::as_str);
    let near = || {
        names().min_by_key(|name| distance(name)).filter(|name| 3 * distance(name) <= lower.chars().count())
    };
    names()
        .find(|name| name.to_lowercase() == lower)
        .or_else(|| names().find(|name| begins(name)))
        .or_else(near)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_that_was_meant_is_found() {
        let names = ["speed", "dist", "r (Mpc)", "v [km/s]", "Air.Flow", "x"].map(str::to_owned);
        for (wanted, meant) in [
            ("Speed", Some("speed")),
            ("sped", Some("speed")),
            ("psed", None),
            ("R", Some("r (Mpc)")),
            ("v", Some("v [km/s]")),
            ("air flow", Some("Air.Flow")),
            ("dsit", Some("dist")),
            ("X", Some("x")),
            ("y", None),
            ("", None),
            ("temperature", None),
        ] {
            assert_eq!(nearest(wanted, &names), meant, "{wanted}");
        }
    }

    #[test]
    fn numbers_are_no_names() {
        let names = |names: &[&str]| names.iter().map(|&name| name.to_owned()).collect::<Vec<_>>();
        assert!(
            are_no_names(&names(&["1", "2.5e3"])) && !are_no_names(&names(&["1", "x"])) && !are_no_names(&[])
        );
        assert_eq!(
            advice("x", &names(&["1", "2"]), Some(2)),
            "; the file has no header: ask for columns by number, 1 to 2"
        );
        assert_eq!(advice("Y", &names(&["x", "y"]), Some(2)), "; did you mean \"y\"?");
        assert_eq!(advice("z", &names(&["x", "y"]), Some(2)), "");
    }
}
