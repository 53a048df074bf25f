//! The common parts of the JSON documents: numbers, names of half-planes, ends with their proofs, regions.

use std::fmt;

use boundfit_estimation::{ActiveBounds, BoundName, Fit, ParameterBound, ParameterInterval, Problem};
use boundfit_exact::{Endpoint, Interval, Rational};
use boundfit_geometry::{Direction, Measures, Multiplier, Point, Region, Vertex};
use boundfit_questions::BoxBound;
use serde::Serialize;
use serde::ser::{SerializeStruct, Serializer};

use crate::answer::parts::{
    ActiveJson, ActiveListJson, BoundJson, CertificateJson, EndJson, FeasibleSetJson, IntervalJson,
    ProgramJson, RangeJson, RegionJson, SlopeJson, TermJson, VertexJson,
};
use crate::number::{Number, Reader};
use crate::style::Style;

impl RangeJson {
    /// An interval, its ends rounded as the style says.
    pub fn new(interval: &Interval, style: &Style) -> Self {
        RangeJson {
            lower: interval.lower().value().map(|value| style.lower_number(value)),
            upper: interval.upper().value().map(|value| style.upper_number(value)),
        }
    }

    /// The intervals of both parameters.
    pub(crate) fn both(intervals: &[Interval; 2], style: &Style) -> [Self; 2] {
        intervals.each_ref().map(|interval| RangeJson::new(interval, style))
    }
}

impl From<BoundName> for ActiveJson {
    fn from(name: BoundName) -> Self {
        match name {
            BoundName::Upper(row) => ActiveJson { row: Some(row), bound: "upper".into() },
            BoundName::Lower(row) => ActiveJson { row: Some(row), bound: "lower".into() },
            of_condition => ActiveJson { row: None, bound: of_condition.to_string().into() },
        }
    }
}

impl From<BoxBound> for ActiveJson {
    /// `upper left` is the bound at a corner of the box of a reading.
    fn from(bound: BoxBound) -> Self {
        match bound {
            BoxBound::Bound(name, corner) => {
                let ActiveJson { row, bound } = name.into();
                let bound = corner.map_or(bound.clone(), |corner| format!("{bound} {corner}").into());
                ActiveJson { row, bound }
            }
            BoxBound::Slope(_) => ActiveJson { row: None, bound: bound.to_string().into() },
        }
    }
}

impl<A> ActiveListJson<A> {
    /// Names, and how many there are beside them.
    pub(crate) fn of(active: Vec<A>, active_more: usize) -> Self {
        ActiveListJson { active, active_more }
    }
}

impl<A> From<Vec<A>> for ActiveListJson<A> {
    fn from(active: Vec<A>) -> Self {
        ActiveListJson { active, active_more: 0 }
    }
}

impl From<&ActiveBounds> for ActiveListJson<ActiveJson> {
    fn from(bounds: &ActiveBounds) -> Self {
        let active = bounds.names.iter().map(|&name| name.into()).collect();
        ActiveListJson { active, active_more: bounds.more }
    }
}

impl TermJson {
    pub(crate) fn new(name: impl Into<ActiveJson>, multiplier: &Rational, style: &Style) -> Self {
        let ActiveJson { row, bound } = name.into();
        TermJson { row, bound, multiplier: style.number(multiplier) }
    }

    /// Half-planes with their multipliers.
    pub(crate) fn all<A: Into<ActiveJson> + Copy>(terms: &[(A, Rational)], style: &Style) -> Vec<Self> {
        terms.iter().map(|(name, multiplier)| TermJson::new(*name, multiplier, style)).collect()
    }

    /// Multipliers of half-planes that have these names.
    pub(crate) fn named<A: Into<ActiveJson>>(
        multipliers: &[Multiplier],
        name: impl Fn(usize) -> A,
        style: &Style,
    ) -> Vec<Self> {
        multipliers.iter().map(|own| TermJson::new(name(own.index), &own.value, style)).collect()
    }
}

impl CertificateJson {
    /// The half-planes that contradict each other.
    pub(crate) fn new<A: Into<ActiveJson> + Copy>(terms: &[(A, Rational)], style: &Style) -> Self {
        CertificateJson { farkas: TermJson::all(terms, style) }
    }
}

impl FeasibleSetJson {
    /// The kind of the feasible set of a fit; of an empty one why it is.
    pub(crate) fn new(problem: &Problem, fit: &Fit, style: &Style) -> Self {
        let contradiction = fit.contradiction(problem.measurements.error_bound());
        FeasibleSetJson {
            kind: fit.fps.polyhedron().kind().name(),
            certificate: contradiction.map(|terms| CertificateJson::new(&terms, style)),
        }
    }
}

impl IntervalJson {
    /// The intervals of both parameters with the proof of each end, rounded outward; `None` when no end is bounded.
    pub(crate) fn both<A: Into<ActiveJson>>(
        pui: &[ParameterInterval; 2],
        name: impl Fn(usize) -> A,
        style: &Style,
    ) -> Option<[Self; 2]> {
        let interval = |own: &ParameterInterval| IntervalJson {
            lower: BoundJson::new(&own.lower, false, &name, style),
            upper: BoundJson::new(&own.upper, true, &name, style),
        };
        has_bounded_end(pui).then(|| pui.each_ref().map(interval))
    }

    /// Returns whether one of its ends is bounded.
    pub(crate) fn is_bounded(&self) -> bool {
        [&self.lower, &self.upper].iter().any(|own| matches!(own.end, EndJson::Bounded(_)))
    }
}

/// Returns whether one of the intervals has an end.
pub(crate) fn has_bounded_end(pui: &[ParameterInterval; 2]) -> bool {
    let mut ends = pui.iter().flat_map(|own| [&own.lower, &own.upper]);
    ends.any(|end| matches!(end, ParameterBound::Bounded { .. }))
}

impl BoundJson {
    /// An end with its proof, rounded outward.
    pub(crate) fn new<A: Into<ActiveJson>>(
        bound: &ParameterBound,
        is_upper: bool,
        name: impl Fn(usize) -> A,
        style: &Style,
    ) -> Self {
        match bound {
            ParameterBound::Unbounded(_) => {
                BoundJson { end: EndJson::new(None, is_upper, style), active: Vec::new() }
            }
            ParameterBound::Bounded { value, proof } => BoundJson {
                end: EndJson::new(Some(value), is_upper, style),
                active: TermJson::named(&proof.multipliers, name, style),
            },
        }
    }

    /// An end with the terms that prove it, rounded outward.
    pub(crate) fn of_terms(
        end: &Endpoint,
        terms: &[(BoundName, Rational)],
        is_upper: bool,
        style: &Style,
    ) -> Self {
        BoundJson { end: EndJson::new(end.value(), is_upper, style), active: TermJson::all(terms, style) }
    }
}

impl EndJson {
    /// An end, rounded outward.
    fn new(value: Option<&Rational>, is_upper: bool, style: &Style) -> Self {
        match value {
            Some(value) if is_upper => EndJson::Bounded(style.upper_number(value)),
            Some(value) => EndJson::Bounded(style.lower_number(value)),
            None => EndJson::Unbounded(style.reader),
        }
    }
}

impl Serialize for EndJson {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let reader = match self {
            EndJson::Bounded(number) => return number.serialize(serializer),
            EndJson::Unbounded(reader) => reader,
        };
        let forms: &[&'static str] = match reader {
            Reader::Program => &["exact", "decimal", "value", "outward"],
            Reader::Person => &["exact", "decimal"],
        };
        let mut fields = serializer.serialize_struct("Number", forms.len())?;
        for form in forms {
            fields.serialize_field(form, &None::<f64>)?;
        }
        fields.end()
    }
}

impl ProgramJson {
    /// This one.
    pub(crate) const OWN: ProgramJson = ProgramJson { name: "boundfit", version: env!("CARGO_PKG_VERSION") };
}

impl fmt::Display for ProgramJson {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.name, self.version)
    }
}

impl SlopeJson {
    /// Returns the end of the interval, with the names of the half-planes; `None` where there is no end.
    pub(crate) fn new<A: Into<ActiveJson>>(
        bound: &ParameterBound,
        side: Option<&'static str>,
        name: impl Fn(usize) -> A,
        style: &Style,
    ) -> Option<Self> {
        let ParameterBound::Bounded { proof, .. } = bound else { return None };
        let active = proof.multipliers.iter().map(|own| name(own.index).into()).collect();
        Some(SlopeJson { theta: style.numbers(&proof.attained_at.coordinates()), side, active })
    }
}

impl<A> RegionJson<A> {
    /// A region with its measures; `name` gives the names of the half-planes active at a vertex or boundary, `certificate` the
    /// certificate.
    pub(crate) fn new(
        region: &Region,
        measures: &Measures,
        style: &Style,
        name: impl Fn(&[usize]) -> ActiveListJson<A>,
        certificate: Option<CertificateJson>,
    ) -> Self {
        let direction = |d: &Direction| [d.dx(), d.dy()].map(|c| style.number(&Rational::from(c)));
        let point = |point: &Point| style.numbers(&point.coordinates());
        let vertex = |v: &Vertex| VertexJson { theta: point(v.point()), active: name(v.active()) };
        let boundaries = region.boundaries().iter();
        RegionJson {
            kind: region.kind().name(),
            vertices: region.vertices().iter().map(vertex).collect(),
            rays: region.rays().iter().map(direction).collect(),
            lines: region.lines().iter().map(direction).collect(),
            boundaries: boundaries.map(|boundary| name(boundary.active())).collect(),
            witness: region.witness().as_ref().map(point),
            area: measures.area().filter(|_| !region.is_empty()).map(|area| style.measure_number(&area)),
            certificate,
        }
    }
}

impl<A> RegionJson<A> {
    /// The area, if it is finite.
    pub(crate) fn area(&self) -> Option<&Number> {
        self.area.as_ref()
    }
}

/// The centroid of an area with finite coordinates.
pub(crate) fn centroid_json(measures: &Measures, style: &Style) -> Option<[Number; 2]> {
    measures.centroid().map(|centroid| centroid.each_ref().map(|coordinate| style.measure_number(coordinate)))
}

/// Returns the reason why each of these has no fraction, the area under the name of its part.
pub(crate) fn long_fractions(
    area_name: &'static str,
    area: Option<&Number>,
    centroid: Option<&[Number; 2]>,
    style: &Style,
) -> impl Iterator<Item = (&'static str, String)> {
    let centroid = centroid.is_some_and(|centroid| centroid.iter().any(Number::lacks_fraction));
    let lacking = [(area_name, area.is_some_and(Number::lacks_fraction)), ("area_centroid", centroid)];
    let reason = style.too_long();
    lacking.into_iter().filter(|(_, lacks)| *lacks).map(move |(name, _)| (name, reason.clone()))
}

/// Indented JSON with a line end.
pub(crate) fn to_text(report: &impl Serialize) -> String {
    // The report types hold strings, numbers and lists only: there is nothing in them that cannot be written.
    let mut text = serde_json::to_string_pretty(report).expect("a report that is not JSON");
    text.push('\n');
    text
}
