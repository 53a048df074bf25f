//! `boundfit outliers`.

use boundfit_estimation::fit;
use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Reading};
use boundfit_questions::{NoOutliers, Outliers};
use boundfit_report::{
    NoOutliersProof, OutliersReport, outliers_csv, outliers_document, outliers_json, outliers_proof,
};

use super::proof_file;
use crate::CommandResult;
use crate::arguments::{OutliersArguments, TableFormat};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::memory;
use crate::progress::while_working;
use crate::work::refuse_long_outliers;

/// Reads the data, finds the outliers and writes the report.
pub(crate) fn run(arguments: &OutliersArguments) -> CommandResult {
    arguments.threads.set()?;
    let format = arguments.output.format()?;
    let output = arguments.output.file.output.as_deref();
    let mut guard = arguments.output.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    guard.check(arguments.proof.as_deref())?;
    proof_file::check(arguments.proof.as_deref(), output)?;
    let data = arguments.data.open().holding(memory::OF_AN_OUTLIER);
    let origin = data.origin();
    let shows_data = format == TableFormat::Json || arguments.proof.is_some();
    let problem = data.counted_readings(shows_data, shows_data)?;
    let (file, limits) = (arguments.data.file_name(), arguments.data.table.limits.outliers());
    refuse_long_outliers(file, &problem, &arguments.data.table.limits)?;
    if format == TableFormat::Csv {
        input::say_table(arguments.data.file_name(), problem.measurements.table());
    }
    let fit = while_working("fitting", || fit(&problem));
    let found = while_working("looking for outliers", || Outliers::new(&problem, &limits));
    let refused = |why: &NoOutliers| refusal(file, why, Some(limits.steps));
    let growth = match &found {
        Ok(outliers) => {
            let most = arguments.most.map_or(outliers.least, |most| most as usize);
            // What nobody asked for is left out where it takes too much.
            match while_working("looking for outliers", || outliers.growth(&problem, most, &limits)) {
                Ok(growth) => growth,
                Err(_) if arguments.most.is_none() => Vec::new(),
                Err(why) => return Err(refused(&why)),
            }
        }
        Err(NoOutliers::Conditions(_)) => Vec::new(),
        Err(why) => return Err(refused(why)),
    };
    let report = OutliersReport {
        problem: &problem,
        fit: &fit,
        outliers: found.as_ref(),
        growth: &growth,
        shows_growth: arguments.most.is_some() && found.is_ok(),
    };
    let style = arguments.data.table.limits.limited(arguments.output.style());
    let document = || outliers_document(&report, &origin, &style);
    let text = match format {
        TableFormat::Text => document().to_text(),
        TableFormat::Latex => document().to_latex(),
        TableFormat::Markdown => document().to_markdown(),
        TableFormat::Csv => outliers_csv(found.as_ref().ok()),
        TableFormat::Json => outliers_json(&report, &origin, &style),
    };
    let proof = match &arguments.proof {
        Some(file) => Some((proof(&report, origin.reading, arguments.data.file_name())?, file.as_str())),
        None => None,
    };
    proof_file::write(text.as_bytes(), output, proof, &mut guard)?;
    Ok(if found.is_ok() { Exit::Answer } else { Exit::Empty })
}

fn proof(report: &OutliersReport, reading: Reading, file: Foreign<&str>) -> Result<String, Failure> {
    outliers_proof(report, reading).map_err(|why| match why {
        NoOutliersProof::NoText => proof_file::no_text(file),
        NoOutliersProof::TooMany(most) => {
            Failure::data(format_args!("{file}: '--proof' would take more than {most} contradictions"))
        }
    })
}

/// Why there is no answer. A number of steps is one that an option can raise.
pub(crate) fn refusal(file: Foreign<&str>, why: &NoOutliers, steps: Option<u64>) -> Failure {
    let help = |needed: &u64| match steps {
        Some(steps) => {
            format!("takes {needed} crossings of bounds, more than {steps}; --limit steps=N raises it")
        }
        None => format!("takes {needed} crossings of bounds, too many for a figure (see boundfit outliers)"),
    };
    match why {
        NoOutliers::NotInMemory => Failure::Usage(format!(
            "outliers are looked for among all readings, and {file} is a reduction: take the table that it was made from"
        )),
        NoOutliers::Conditions(_) => {
            Failure::data(format_args!("{file}: the conditions contradict each other"))
        }
        NoOutliers::Steps { at_least, enough, needed } => {
            let least = counted(*at_least, "reading has", "readings have");
            let enough = enough.map(|enough| format!(", and {enough} are enough")).unwrap_or_default();
            let help = help(needed);
            Failure::data(format_args!(
                "{file}: at least {least} to be left out{enough}; to find the least number {help}"
            ))
        }
        NoOutliers::GrowthSteps { needed } => {
            let help = help(needed);
            Failure::data(format_args!(
                "{file}: to see how the set grows {help}, a smaller '--most' takes fewer"
            ))
        }
        NoOutliers::Corners => Failure::data(format_args!(
            "{file}: the set has more than 150000 corners (expected a smaller '--most')"
        )),
    }
}
