//! `boundfit polygon`.

use boundfit_exact::Limits;
use boundfit_formats::{Source, TableOptions, read_half_planes};
use boundfit_geometry::Polyhedron;
use boundfit_report::{polygon_json, polygon_text};

use crate::CommandResult;
use crate::arguments::{Format, PolygonArguments};
use crate::exit::{Exit, Failure};
use crate::output;

/// Reads the half-planes, intersects them and writes the report.
pub(crate) fn run(arguments: &PolygonArguments) -> CommandResult {
    let reading = arguments.table.reading();
    let options = TableOptions {
        header: arguments.table.header(),
        delimiter: arguments.table.delimiter(),
        reading,
        limits: Limits::default(),
        ..TableOptions::default()
    };
    let source = Source::open(&arguments.file).map_err(Failure::data)?;
    let name = source.name().to_owned();
    let file = read_half_planes(source, &options).map_err(Failure::data)?;
    let polyhedron = Polyhedron::intersect(file.system.clone());
    let style = arguments.output.style();
    let report = match arguments.output.format {
        Format::Json => polygon_json(&file, &polyhedron, reading, &style),
        Format::Text => polygon_text(&file, &polyhedron, &name, &style),
    };
    output::write(&report, arguments.output.file.output.as_deref())?;
    Ok(if polyhedron.region().is_empty() { Exit::Empty } else { Exit::Answer })
}
