//! `boundfit polygon`.

use boundfit_ask::{Form, RowWords};
use boundfit_exact::{Foreign, Limit, Reading};
use boundfit_figures::{PictureFormat, draw_region};
use boundfit_formats::{HalfPlaneFile, InputError, InputErrorKind, TableOptions, read_half_planes};
use boundfit_geometry::Polyhedron;
use boundfit_report::{
    ProofQuestion, Theory, h_representation, kernel_half_planes, polygon_document, polygon_json,
    region_script, region_wkt, v_representation, vertices_csv,
};
use clap::Args;
use clap::builder::NonEmptyStringValueParser;

use super::set_files::SetFiles;
use crate::exit::{CommandResult, Exit, Failure};
use crate::input;
use crate::memory;
use crate::options::{
    BAD_DATA, BAD_USAGE, Notes, OutputArguments, PictureArguments, ReportFormat, TableArguments, limits,
};
use crate::work::{refuse_long, times};

pub(super) const NOTES: Notes = Notes {
    examples: &[
        ("Half-planes in an H-representation of cdd or lrs", "boundfit polygon square.ine"),
        (
            "To a V-representation, whose rows are points and rays; the report on it; and back",
            "boundfit polygon square.ine --format ext -o corners.ext\n\
             boundfit polygon corners.ext\n\
             boundfit polygon corners.ext --format ine",
        ),
        (
            "A table with columns a1,a2,b, each row meaning a1*theta1 + a2*theta2 <= b",
            "printf 'a1,a2,b\\n-1,0,0\\n0,-1,0\\n2,3,6\\n' | boundfit polygon -",
        ),
    ],
    statuses: &[
        (0, "an answer was found"),
        BAD_DATA,
        BAD_USAGE,
        (3, "the region is empty; the proof is printed"),
    ],
};

/// Intersect half-planes: vertices, rays, bounds, area, and redundant half-planes
///
/// A V-representation of cdd or lrs also gives a set: rows '1 x y' are points, '0 x y' rays, or lines if a linearity
/// line lists them. The report then lists its half-planes (facets); the rows active at a vertex are the points equal to
/// it, and redundant rows are unnecessary generators. 'W x y' with W > 0 is the point (x/W, y/W). Rays without a point
/// start at the origin, and a set without any row is empty, as in cdd. Options for other output (maximize, verbose,
/// ...) are ignored; options for another set (nonnegative, project, hull in an H-representation, ...) are refused.
#[derive(Debug, Args)]
#[command(after_help = NOTES.to_string(), mut_arg("limit", limits::with(&[Limit::Fraction])))]
pub(crate) struct PolygonArguments {
    /// FILE.ine or FILE.ext (H- or V-representation of cdd and lrs) or FILE.csv (columns a1,a2,b), or - for standard input
    file: String,
    /// Also draw the set, or the half-planes that contradict each other: FILE.svg, .png, .pdf, .tikz or .tex
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    plot: Option<String>,
    /// Also write a theorem that the kernel of Coq checks to this file, which ends in .v: the half-planes describe just the
    /// convex hull of the vertices, together with rays
    #[arg(long, value_name = "FILE", value_parser = NonEmptyStringValueParser::new())]
    proof: Option<String>,
    /// Let the theorem of '--proof FILE.v' require the installed theory 'Boundfit' instead of holding it
    #[arg(long, requires = "proof")]
    proof_library: bool,
    #[command(flatten)]
    picture: PictureArguments,
    #[command(flatten)]
    table: TableArguments,
    #[command(flatten)]
    output: OutputArguments<ReportFormat>,
}

/// Reports a refusal; of a table with other columns it says which columns half-planes have.
fn refused(problem: InputError) -> Failure {
    let has_others = matches!(problem.kind, InputErrorKind::UnknownColumn { .. });
    match Failure::refused(problem) {
        Failure::Data(message) if has_others => {
            Failure::Data(format!("{message}; a row a1,a2,b means a1*theta1 + a2*theta2 <= b"))
        }
        failure => failure,
    }
}

/// Reads the half-planes, or finds those of generators, intersects them and writes the report.
pub(super) fn run(arguments: &PolygonArguments) -> CommandResult {
    let output = arguments.output.file.output.as_deref();
    let files = SetFiles {
        plot: arguments.plot.as_deref(),
        proof: arguments.proof.as_deref(),
        proof_library: arguments.proof_library,
        picture: &arguments.picture,
    };
    let (plot, theory) = files.checked(output, "a set of half-planes")?;
    let format = arguments.output.format()?;
    let mut guard = arguments.output.file.replace.guard([arguments.file.as_str()]);
    guard.check(output)?;
    files.check(&guard)?;
    arguments.output.check_decimals(if format == ReportFormat::Csv {
        Form::Vertices
    } else {
        format.into()
    })?;
    let words = arguments.table.words();
    let options = words.reading(false).and_then(|reading| words.resolve(reading, &RowWords::default()));
    let options = options.map_err(Failure::misused)?;
    let reading = options.reading;
    let options = TableOptions { row_cost: memory::OF_A_HALF_PLANE, ..options };
    let source = input::open(&arguments.file).map_err(Failure::refused)?;
    let name = source.name().to_owned();
    let file = read_half_planes(source, &options).map_err(refused)?;
    refuse_long(name.borrowed(), &file.system.work(), times::POLYGON, &arguments.table.limits)?;
    if !Form::from(format).has_input() {
        input::say_table(name.borrowed(), file.table.as_ref(), 0);
    }
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
    let theorem =
        theory.map(|theory| theorem(&file, &polyhedron, (reading, theory), name.borrowed())).transpose()?;
    files.write((&report, output), picture.as_deref(), theorem.as_deref(), &mut guard)?;
    Ok(if polyhedron.is_empty() { Exit::Empty } else { Exit::Answer })
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
    let names = ["θ₁".into(), "θ₂".into()];
    let title = Foreign::from(format!("Set of {}", file.raw()));
    let picture = draw_region(polyhedron, &names, &title, &asked.options()).map_err(Failure::data)?;
    picture.encoded_as(format, &asked.encoding()).map_err(Failure::data)
}
