//! Suggests names in place of one that is not there.

use boundfit_exact::{Foreign, Limits, Reading};
use strsim::osa_distance;

/// Returns the advice behind the message that there is no such column.
pub(super) fn advice(wanted: &Foreign, available: &[Foreign], numbers: Option<usize>) -> String {
    match (nearest(wanted.raw(), available), numbers) {
        // Where several columns are asked for, a comma separates their names.
        (Some(name), _) if name.raw().contains(',') && name.raw().contains('"') => {
            let number = available.iter().position(|other| other == name).map_or(0, |place| place + 1);
            format!("; did you mean {name:?}? Ask for it by its number, {number}")
        }
        (Some(name), _) if name.raw().contains(',') => {
            format!("; did you mean '\"{name}\"', with the quotes?")
        }
        (Some(name), _) => format!("; did you mean {name:?}?"),
        (None, Some(columns)) if are_no_names(available) => {
            format!("; the file has no header: ask for columns by number, 1 to {columns}")
        }
        _ => String::new(),
    }
}

/// Returns whether the cells of the first row are numbers or nothing: it was taken for a header only because a column was asked for by name.
pub(crate) fn are_no_names(available: &[Foreign]) -> bool {
    let is_none =
        |name: &Foreign| name.is_empty() || Reading::Decimal.read(name.raw(), &Limits::default()).is_ok();
    !available.is_empty() && available.iter().all(is_none)
}

/// Returns the first name that differs from the wanted one only in upper and lower case, or else the first with more behind the wanted
/// words (`r` and `r (Mpc)`). Without such names it returns the nearest with at most a third of the letters different. Exchanged
/// neighbours are one letter. Cost: the product of the lengths for each name.
pub fn nearest<'a>(wanted: &str, available: &'a [Foreign]) -> Option<&'a Foreign> {
    let lower = wanted.to_lowercase();
    let begins = |name: &str| {
        let rest = name.to_lowercase();
        let rest = rest.strip_prefix(&lower).map(str::trim_start);
        !lower.is_empty() && rest.is_some_and(|rest| rest.starts_with(['(', '[', '/', ',', ':']))
    };
    let distance = |name: &str| osa_distance(&lower, &name.to_lowercase());
    let names = || available.iter();
    let near = || {
        names()
            .min_by_key(|name| distance(name.raw()))
            .filter(|name| 3 * distance(name.raw()) <= lower.chars().count())
    };
    names()
        .find(|name| name.raw().to_lowercase() == lower)
        .or_else(|| names().find(|name| begins(name.raw())))
        .or_else(near)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_name_that_was_meant_is_found() {
        let names = ["speed", "dist", "r (Mpc)", "v [km/s]", "Air.Flow", "x"].map(Foreign::from);
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
            assert_eq!(nearest(wanted, &names).map(Foreign::raw), meant, "{wanted}");
        }
    }

    #[test]
    fn numbers_are_no_names() {
        let names = |names: &[&str]| names.iter().map(|&name| Foreign::from(name)).collect::<Vec<_>>();
        assert!(
            are_no_names(&names(&["1", "2.5e3"])) && !are_no_names(&names(&["1", "x"])) && !are_no_names(&[])
        );
        assert_eq!(
            advice(&"x".into(), &names(&["1", "2"]), Some(2)),
            "; the file has no header: ask for columns by number, 1 to 2"
        );
        assert_eq!(advice(&"Y".into(), &names(&["x", "y"]), Some(2)), "; did you mean \"y\"?");
        assert_eq!(
            advice(&"U".into(), &names(&["U, V", "y"]), None),
            "; did you mean '\"U, V\"', with the quotes?"
        );
        assert_eq!(
            advice(&"a\"".into(), &names(&["x", "a\",b"]), Some(2)),
            "; did you mean \"a\\\",b\"? Ask for it by its number, 2"
        );
        assert_eq!(advice(&"z".into(), &names(&["x", "y"]), Some(2)), "");
    }
}
