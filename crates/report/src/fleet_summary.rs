//! A group of a fleet, and what a whole fleet comes to.

use boundfit_exact::Foreign;
use boundfit_exact::english::counted;
use boundfit_geometry::RegionKind;

/// The number of groups without an answer that a summary names.
const MOST_NAMED: usize = 5;

/// The numbers of groups of a fleet by kind. Parts of a fleet add up in order.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct FleetSummary {
    groups: usize,
    rows: usize,
    empty: usize,
    unbounded: usize,
    degenerate: usize,
    /// Keys of the first empty ones.
    first_empty: Vec<String>,
}

impl FleetSummary {
    /// Counts a group with this key, so many rows and this kind of FPS.
    pub fn add(&mut self, key: Foreign<&str>, rows: usize, kind: RegionKind) {
        self.groups += 1;
        self.rows += rows;
        match kind {
            RegionKind::Empty => {
                self.empty += 1;
                if self.first_empty.len() < MOST_NAMED {
                    self.first_empty.push(shown_key(key));
                }
            }
            RegionKind::Point | RegionKind::Segment => self.degenerate += 1,
            RegionKind::Polygon => {}
            RegionKind::Ray
            | RegionKind::Line
            | RegionKind::UnboundedPolygon
            | RegionKind::Strip
            | RegionKind::HalfPlane
            | RegionKind::Plane => self.unbounded += 1,
        }
    }

    /// Adds the groups that come after these.
    pub fn append(&mut self, later: FleetSummary) {
        self.groups += later.groups;
        self.rows += later.rows;
        self.empty += later.empty;
        self.unbounded += later.unbounded;
        self.degenerate += later.degenerate;
        let room = MOST_NAMED - self.first_empty.len();
        self.first_empty.extend(later.first_empty.into_iter().take(room));
    }

    /// Returns whether the FPS of some group is empty.
    pub fn has_empty(&self) -> bool {
        self.empty > 0
    }

    /// The summary as text, one line, and a second one when groups are empty.
    pub fn to_text(&self) -> String {
        let FleetSummary { groups, rows, empty, unbounded, degenerate, first_empty } = self;
        let polygons = groups - empty - unbounded - degenerate;
        let kinds = [
            (polygons, counted(polygons, "polygon", "polygons")),
            (*unbounded, format!("{unbounded} unbounded")),
            (*degenerate, format!("{degenerate} degenerate (point or segment)")),
            (*empty, format!("{empty} empty")),
        ];
        let present: Vec<String> =
            kinds.into_iter().filter(|(count, _)| *count > 0).map(|(_, words)| words).collect();
        let [groups, rows] = [counted(*groups, "group", "groups"), counted(*rows, "row", "rows")];
        let mut text = format!("{groups}, {rows}: {}\n", present.join(", "));
        if self.has_empty() {
            let more = empty - first_empty.len();
            let more = if more > 0 { format!(" and {more} more") } else { String::new() };
            text.push_str(&format!("No theta meets every bound of: {}{more}\n", first_empty.join(", ")));
        }
        text
    }
}

/// A key on a line of its own: quoted where it is not plain to see.
pub(crate) fn shown_key(key: Foreign<&str>) -> String {
    let raw = key.raw();
    let shown = key.to_string();
    let is_plain = !raw.is_empty() && raw.trim() == raw && !raw.contains(['"', ',']) && shown == raw;
    if is_plain { raw.to_owned() } else { format!("{key:?}") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_add_up_to_the_whole() {
        let part = |keys: &[&str], groups| FleetSummary {
            groups,
            rows: 10 * groups,
            empty: keys.len(),
            unbounded: 1,
            degenerate: 0,
            first_empty: keys.iter().take(MOST_NAMED).map(|key| shown_key(Foreign::of(key))).collect(),
        };
        let mut whole = part(&["a", "", "b\n"], 9);
        whole.append(part(&["c", "d", "e", "f"], 7));
        assert_eq!(
            whole.to_text(),
            "16 groups, 160 rows: 7 polygons, 2 unbounded, 7 empty\n\
             No theta meets every bound of: a, \"\", \"b\\n\", c, d and 2 more\n"
        );
        assert!(whole.has_empty() && !FleetSummary::default().has_empty());
    }
}
