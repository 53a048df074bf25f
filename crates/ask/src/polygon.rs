//! The set of half-planes, or of generators.

use boundfit_estimation::Measurements;
use boundfit_formats::{HalfPlaneFile, InputErrorKind, Source, TableNotes, TableOptions, read_half_planes};
use boundfit_geometry::Polyhedron;
use boundfit_report::{
    ProofQuestion, Style, h_representation, kernel_half_planes, polygon_document, polygon_json,
    region_script, region_wkt, v_representation, vertices_csv,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem, Subject};
use crate::refusal::Refusal;

/// The set of half-planes, rows of `a1`, `a2` and `b` or an H-representation of cdd and lrs; or of the generators of a
/// V-representation.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Polygon {}

impl Ask for Polygon {
    const NAME: &'static str = "polygon";
    const FORMS: &'static [Form] = &[
        Form::Text,
        Form::Latex,
        Form::Markdown,
        Form::Json,
        Form::Csv,
        Form::Wkt,
        Form::M,
        Form::Ine,
        Form::Ext,
    ];
    const SUBJECT: Subject = Subject::HalfPlanes;
    type Problem = HalfPlaneFile;
    type Answer = Polyhedron;

    fn read(&self, asked: &Asked, source: Source, _: Shows) -> Result<HalfPlaneFile, Refusal> {
        /// Bytes that the budget counts for each half-plane: 10⁶ half-planes took 2.1 GB.
        const ROW_COST: usize = 2_300;
        /// The cost of a set with its redundant rows, relative to a fit.
        const TIMES: u64 = 2;
        let table = TableOptions { row_cost: ROW_COST, ..asked.options.table.clone() };
        let file = read_half_planes(source, &table).map_err(|error| match error.kind {
            InputErrorKind::UnknownColumn { .. } => Refusal::NoHalfPlanes(error),
            _ => Refusal::Input(error),
        })?;
        file.system.work().check(TIMES, asked.most_work())?;
        Ok(file)
    }

    fn measurements<'a>(&self, _: &'a HalfPlaneFile) -> Option<&'a Measurements> {
        None
    }

    fn table<'a>(&self, file: &'a HalfPlaneFile) -> Option<&'a TableNotes> {
        file.table.as_ref()
    }

    fn answer(&self, file: &HalfPlaneFile) -> Result<Polyhedron, Refusal> {
        Ok(Polyhedron::intersect(file.system.clone()))
    }

    fn write(
        &self,
        file: &HalfPlaneFile,
        answer: &Polyhedron,
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let Paper { origin, style, .. } = *paper;
        let name_of = |&index: &usize| {
            let row = file.origins.get(index).map_or(0, |origin| origin.row);
            if file.generators.is_some() { format!("facet:{row}") } else { row.to_string() }
        };
        let active = |indices: &[usize]| (indices.iter().map(name_of).collect(), 0);
        match paper.form {
            Form::Json => paper.put(polygon_json(file, answer, origin.file, origin.reading, &style)),
            Form::Csv => paper.put(vertices_csv(answer, &active, &style)),
            Form::Wkt => paper.put(region_wkt(answer, &style).map_err(Refusal::Wkt)?),
            Form::M => paper.put(region_script(answer, &active)),
            Form::Ine => paper.put(h_representation(answer)),
            Form::Ext => paper.put(v_representation(answer)),
            _ => Self::report(paper, || polygon_document(file, answer, origin.name(), &style)),
        }?;
        Ok(Written::of_set(answer.is_empty()))
    }

    fn refuse_vain_style(&self, form: Form, style: &Style) -> Result<(), Misuse> {
        // The table is that of the vertices.
        if form == Form::Csv { Form::Vertices } else { form }.refuse_vain_style(style)
    }

    fn theorem(
        &self,
        file: &HalfPlaneFile,
        answer: &Polyhedron,
        AskedTheorem { reading, theory, .. }: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        if file.generators.is_some() {
            return Err(Refusal::NoProof(NoProof::NoTheorem));
        }
        let question = ProofQuestion::of_half_planes(file, reading);
        kernel_half_planes(&file.system, answer, Some(&file.sha256), question, theory)
            .ok_or_else(|| Refusal::Readings("its set has no certificate".to_owned()))
    }
}
