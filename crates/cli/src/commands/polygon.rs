//! `boundfit polygon`.

use boundfit_ask::RowWords;
use boundfit_exact::{Foreign, Reading};
use boundfit_figures::{PictureFormat, draw_region};
use boundfit_formats::{HalfPlaneFile, TableOptions, read_half_planes};
use boundfit_geometry::Polyhedron;
use boundfit_report::{
    ProofQuestion, Theory, h_representation, kernel_half_planes, polygon_document, polygon_json,
    region_script, region_wkt, v_representation, vertices_csv,
};

use super::judge::files_apart;
use super::pictures::picture_format;
use super::proof_file;
use crate::CommandResult;
use crate::arguments::{PictureArguments, PolygonArguments, ReportFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::memory;
use crate::output;
use crate::work::{refuse_long, times};

/// Reads the half-planes, or finds those of generators, intersects them and writes the report.
pub(crate) fn run(arguments: &PolygonArguments) -> CommandResult {
    let output = arguments.output.file.output.as_deref();
    let proof = arguments.proof.as_deref();
    files_apart(&[
        ("--output", Some(output.unwrap_or("-"))),
        ("--plot", arguments.plot.as_deref()),
        ("--proof", proof),
    ])?;
    let theory = proof_file::only_theory(proof, arguments.proof_library, "a set of half-planes")?;
    arguments.picture.check("--plot", arguments.plot.is_some())?;
    let plot = arguments.plot.as_deref().map(|file| picture_format("--plot <FILE>", file)).transpose()?;
    plot.map_or(Ok(()), |format| arguments.picture.check_format(format))?;
    let format = arguments.output.format()?;
    let mut guard = arguments.output.file.replace.guard([arguments.file.as_str()]);
    guard.check(output)?;
    guard.check(arguments.plot.as_deref())?;
    guard.check(proof)?;
    let words = arguments.table.words();
    let options = words.reading(false).and_then(|reading| words.resolve(reading, &RowWords::default()));
    let options = options.map_err(Failure::misused)?;
    let reading = options.reading;
    let options = TableOptions { row_cost: memory::OF_A_HALF_PLANE, ..options };
    let source = input::open(&arguments.file).map_err(Failure::refused)?;
    let name = source.name().to_owned();
    let file = read_half_planes(source, &options).map_err(Failure::refused)?;
    refuse_long(name.borrowed(), &file.system.work(), times::POLYGON, &arguments.table.limits)?;
    input::say_table(name.borrowed(), file.table.as_ref());
    let polyhedron = Polyhedron::intersect(file.system.clone());
    let name_of = |&index: &usize| {
        let row = file.origins.get(index).map_or(0, |origin| origin.row);
        if file.generators.is_some() { format!("facet:{row}") } else { row.to_string() }
    };
    let active = |indices: &[usize]| (indices.iter().map(name_of).collect(), 0);
    let style = arguments.table.limits.limited(arguments.output.style());
    let document = || polygon_document(&file, &polyhedron, name.borrowed(), &style);
    let report = match format {
        ReportFormat::Text => document().to_text(),
        ReportFormat::Json => polygon_json(
            &file,
            &polyhedron,
            Some(Foreign::of(&arguments.file)).filter(|file| *file != "-"),
            reading,
            &style,
        ),
        ReportFormat::Latex => document().to_latex(),
        ReportFormat::Markdown => document().to_markdown(),
        ReportFormat::Csv => vertices_csv(&polyhedron, &active, &style),
        ReportFormat::Wkt => region_wkt(&polyhedron, &style).map_err(Failure::data)?,
        ReportFormat::M => region_script(&polyhedron, &active),
        ReportFormat::Ine => h_representation(&polyhedron),
        ReportFormat::Ext => v_representation(&polyhedron),
    };
    let picture = plot.map(|format| picture(&polyhedron, &name, (format, &arguments.picture))).transpose()?;
    let picture = picture.as_deref().map(|picture| (picture, arguments.plot.as_deref()));
    let theorem =
        theory.map(|theory| theorem(&file, &polyhedron, (reading, theory), name.borrowed())).transpose()?;
    let theorem = theorem.as_deref().map(|text| (text.as_bytes(), proof));
    let parts: Vec<_> = theorem.into_iter().chain(picture).chain([(report.as_bytes(), output)]).collect();
    output::write_together(&parts, &mut guard)?;
    Ok(if polyhedron.region().is_empty() { Exit::Empty } else { Exit::Answer })
}

/// The theorem about a set of half-planes.
fn theorem(
    file: &HalfPlaneFile,
    polyhedron: &Polyhedron,
    (reading, theory): (Reading, Theory),
    name: Foreign<&str>,
) -> Result<String, Failure> {
    if file.generators.is_some() {
        let instead = "write its half-planes with '--format ine', and prove that file";
        return Err(Failure::Usage(format!(
            "'--proof' is about half-planes, and {name} has generators: {instead}"
        )));
    }
    let question = ProofQuestion::of_half_planes(file, reading);
    kernel_half_planes(&file.system, polyhedron, Some(&file.sha256), question, theory)
        .ok_or_else(|| Failure::data(format_args!("{name}: its set has no certificate")))
}

/// The set, encoded.
fn picture(
    polyhedron: &Polyhedron,
    file: &Foreign,
    (format, asked): (PictureFormat, &PictureArguments),
) -> Result<Vec<u8>, Failure> {
    if polyhedron.region().is_empty() {
        return Err(Failure::data(format_args!("{file}: '--plot' has nothing to draw: the set is empty")));
    }
    let names = ["θ₁".into(), "θ₂".into()];
    let title = Foreign::from(format!("Set of {}", file.raw()));
    let picture = draw_region(polyhedron, &names, &title, &asked.options()).map_err(Failure::data)?;
    picture.encoded_as(format, &asked.encoding()).map_err(Failure::data)
}
