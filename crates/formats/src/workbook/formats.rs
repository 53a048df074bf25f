//! Tells by the format of a cell if its number stands for itself, a date or a duration.

use boundfit_exact::DecimalMark;

use super::stored_text;
use crate::doubles::double_text;

/// The meaning that the format of a cell gives to its number.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub(super) enum Shows {
    /// The number.
    #[default]
    Number,
    /// A date, a time of day or both: days since the first one of the workbook.
    Date,
    /// Days as hours, minutes or seconds.
    Duration,
}

impl Shows {
    /// Returns the meaning of a format that is known by number (ECMA-376, part 1, 18.8.30, and the formats of
    /// East Asia).
    pub(super) fn of_number(id: u32) -> Self {
        match id {
            14..=22 | 27..=36 | 45 | 47 | 50..=58 => Shows::Date,
            46 => Shows::Duration,
            _ => Shows::Number,
        }
    }

    /// Returns the meaning of a format that is written out: of its first section, without the characters that
    /// stand for themselves.
    pub(super) fn of_code(code: &str) -> Self {
        let mut characters = code.chars();
        while let Some(character) = characters.next() {
            match character {
                ';' => break,
                '\\' | '_' | '*' => drop(characters.next()),
                '"' => drop(characters.by_ref().find(|&character| character == '"')),
                '[' => {
                    let inside: String =
                        characters.by_ref().take_while(|&character| character != ']').collect();
                    let is_all = |letter: &str| {
                        !inside.is_empty() && inside.to_ascii_lowercase().replace(letter, "").is_empty()
                    };
                    if ["h", "m", "s"].into_iter().any(is_all) {
                        return Shows::Duration;
                    }
                }
                'd' | 'D' | 'm' | 'M' | 'y' | 'Y' | 'h' | 'H' | 's' | 'S' => return Shows::Date,
                _ => {}
            }
        }
        Shows::Number
    }

    /// The text of a number, with this mark where it stands for itself.
    pub(super) fn text(self, number: f64, decimal: DecimalMark, counts_from_1904: bool) -> String {
        match self {
            Shows::Number => stored_text(number, decimal),
            // From here on spreadsheets show no date either.
            _ if !(0.0..2_958_466.0).contains(&number) => {
                format!("{} days", double_text(number))
            }
            Shows::Duration => {
                let seconds = (number * 86_400.0).round() as u64;
                format!("{}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60)
            }
            Shows::Date => date_text(number, counts_from_1904),
        }
    }
}

/// A date, with its time unless that is midnight; a time alone before the first day.
fn date_text(number: f64, counts_from_1904: bool) -> String {
    let seconds = (number * 86_400.0).round() as i64;
    let (days, seconds) = (seconds / 86_400, seconds % 86_400);
    let time = format!("{:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
    if days == 0 {
        return time;
    }
    // Day 60 is February 29, 1900, which there never was.
    let since_1970 = match (counts_from_1904, days) {
        (true, _) => days - 24_107,
        (false, ..60) => days - 25_568,
        (false, _) => days - 25_569,
    };
    let (year, month, day) = civil(since_1970);
    let date = format!("{year:04}-{month:02}-{day:02}");
    if seconds == 0 { date } else { format!("{date} {time}") }
}

/// Year, month and day of so many days since January 1, 1970 (Hinnant 2013, years that begin in March).
fn civil(days: i64) -> (i64, i64, i64) {
    let days = days + 719_468;
    let (era, of_era) = (days.div_euclid(146_097), days.rem_euclid(146_097));
    let year = (of_era - of_era / 1460 + of_era / 36_524 - of_era / 146_096) / 365;
    let of_year = of_era - (365 * year + year / 4 - year / 100);
    let month = (5 * of_year + 2) / 153;
    let day = of_year - (153 * month + 2) / 5 + 1;
    let month = if month < 10 { month + 3 } else { month - 9 };
    (era * 400 + year + i64::from(month <= 2), month, day)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_of_dates_are_known() {
        for (code, shows) in [
            ("General", Shows::Number),
            ("0.00E+00", Shows::Number),
            ("#,##0.00\\ \"mm\"", Shows::Number),
            ("[Red]#,##0;[Blue]-d", Shows::Number),
            ("_(* #,##0_);_(* (#,##0)", Shows::Number),
            ("0.0\\ \\s", Shows::Number),
            ("[$-409]0.0", Shows::Number),
            ("yyyy\\-mm\\-dd", Shows::Date),
            ("[$-409]mmmm\\ d\\,\\ yyyy;@", Shows::Date),
            ("h:mm AM/PM", Shows::Date),
            ("[hh]:mm:ss", Shows::Duration),
            ("[Red][s]", Shows::Duration),
        ] {
            assert_eq!(Shows::of_code(code), shows, "{code}");
        }
        assert_eq!([14, 46, 2].map(Shows::of_number), [Shows::Date, Shows::Duration, Shows::Number]);
    }

    #[test]
    fn dates_are_those_that_spreadsheets_show() {
        let date = |number, from_1904| Shows::Date.text(number, DecimalMark::Point, from_1904);
        assert_eq!(date(45_000.0, false), "2023-03-15");
        assert_eq!(date(45_000.5, false), "2023-03-15 12:00:00");
        assert_eq!(date(1.0, false), "1900-01-01");
        assert_eq!(date(59.0, false), "1900-02-28");
        assert_eq!(date(61.0, false), "1900-03-01");
        assert_eq!(date(43_538.0, true), "2023-03-15");
        assert_eq!(date(2_958_465.0, false), "9999-12-31");
        assert_eq!(date(0.25, false), "06:00:00");
        assert_eq!(date(-1.0, false), "-1 days");
        assert_eq!(Shows::Duration.text(1.5, DecimalMark::Comma, false), "36:00:00");
    }
}
