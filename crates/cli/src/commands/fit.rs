//! `boundfit fit`.

use std::time::Duration;

use boundfit_ask::Form;
use boundfit_check::{CheckOptions, check, source_names};
use boundfit_estimation::{ErrorBound, Family, Fit, Measurements, Problem, fit};
use boundfit_exact::{Foreign, Rational, Reading};
use boundfit_questions::Guarantee;
use boundfit_report::{
    Document, InverseLine, active_names, brief_document, fit_csv, fit_document, fit_json, fit_script,
    guarantee_document, h_representation, proof_json, region_wkt, sweep_document, v_representation,
    verdict_line, vertices_csv,
};

use crate::CommandResult;
use crate::arguments::{FactorRange, FitArguments, ReportFormat};
use crate::commands::asked::Job;
use crate::commands::{fleet, proof_file, window, x_errors};
use crate::exit::{Exit, Failure};
use crate::input;
use crate::progress::while_working;
use crate::work::refuse_long_sweep;

pub(super) const SWEEP_OF_FIXED: &str = "'--sweep' moves the error bounds, and the data are a reduction under bounds that are fixed: sweep \
                              the table that it was made from";

const CONFIDENCE_OF_INTERVALS: &str = "'--confidence' is about error bounds around y, and intervals are none: a further reading need \
                                       not have one";

/// Reads the data, fits and writes the report.
pub(crate) fn run(arguments: &FitArguments) -> CommandResult {
    arguments.threads.set()?;
    check_usage_of_proof(arguments)?;
    let format = arguments.output.format()?;
    check_usage_of_parts(arguments, format)?;
    let output = arguments.output.file.output.as_deref();
    let mut guard = arguments.output.file.replace.guard([arguments.data.path()]);
    guard.check(output)?;
    guard.check(arguments.proof.as_deref())?;
    if arguments.x_errors.are_asked()? {
        return x_errors::run(arguments, format, &mut guard);
    }
    if let Some(by) = &arguments.by {
        return fleet::run(arguments, by, format, &guard);
    }
    if let Some(window) = arguments.window() {
        return window::run(arguments, &window, format, &mut guard);
    }
    let data = arguments.data.open();
    let origin = data.origin();
    let reading = origin.reading;
    let is_hash_shown = format == ReportFormat::Json || arguments.proof.is_some();
    let is_sweep = arguments.sweep.is_some();
    let problem =
        data.scanned_problem(!arguments.no_eui, is_hash_shown, arguments.proof.is_some(), is_sweep)?;
    if is_sweep && !problem.measurements.are_open() {
        return Err(Failure::Usage(SWEEP_OF_FIXED.to_owned()));
    }
    if arguments.confidence.is_some()
        && matches!(problem.measurements.error_bound(), ErrorBound::Interval { .. })
    {
        return Err(Failure::Usage(CONFIDENCE_OF_INTERVALS.to_owned()));
    }
    if let Some(FactorRange { to, .. }) = &arguments.sweep {
        let limits = &arguments.data.table.limits;
        refuse_long_sweep(arguments.data.file_name(), &problem, to, limits)?;
    }
    if !format.has_input() {
        input::say_table(arguments.data.file_name(), problem.measurements.table());
    }
    let fit = while_working("fitting", || fit(&problem));
    let family = arguments.sweep.as_ref().map(|FactorRange { from, to }| {
        while_working("sweeping", || Family::new(&problem, from.clone(), to.clone()))
    });
    let confidence = arguments.confidence.as_ref();
    let guarantee = confidence.and_then(|confidence| Guarantee::new(&problem.measurements, confidence));
    let style = arguments.data.table.limits.limited(arguments.output.style());
    let inverse = if arguments.inverse { InverseLine::Always } else { InverseLine::default() };
    let document = |lp_verdict: Option<String>| {
        if arguments.brief {
            return brief_document(&problem, &fit, &origin, &style);
        }
        let mut document = fit_document(&problem, &fit, &origin, inverse, &style);
        lp_verdict.into_iter().for_each(|verdict| document.add_result("LP solver", &verdict));
        document.append(
            family.as_ref().map_or_else(Document::default, |family| sweep_document(&problem, family, &style)),
        );
        let of_guarantee = |own: &Guarantee| guarantee_document(&problem, &fit, own, &style);
        document.append(guarantee.as_ref().map_or_else(Document::default, of_guarantee));
        document
    };
    let report = match format {
        ReportFormat::Json => fit_json(&problem, &fit, family.as_ref(), guarantee.as_ref(), &origin, &style),
        ReportFormat::Latex => document(None).to_latex(),
        ReportFormat::Markdown => document(None).to_markdown(),
        ReportFormat::Csv if !arguments.vertices => fit_csv(&problem, &fit),
        ReportFormat::Csv => {
            vertices_csv(fit.fps.polyhedron(), &|indices| active_names(&fit, indices), &style)
        }
        ReportFormat::Wkt => region_wkt(fit.fps.polyhedron(), &style).map_err(Failure::data)?,
        ReportFormat::M => fit_script(&problem, &fit, &|indices| active_names(&fit, indices)),
        ReportFormat::Ine => h_representation(fit.fps.polyhedron()),
        ReportFormat::Ext => v_representation(fit.fps.polyhedron()),
        ReportFormat::Text => {
            let verdict =
                if arguments.no_lp || arguments.brief { None } else { lp_verdict(&problem, reading)? };
            document(verdict).to_text()
        }
    };
    let proof = match &arguments.proof {
        Some(file) => Some((proof(&problem, &fit, reading, arguments.data.file_name())?, file.as_str())),
        None => None,
    };
    proof_file::write(report.as_bytes(), output, proof, &mut guard)?;
    Ok(if fit.fps.polyhedron().region().is_empty() { Exit::Empty } else { Exit::Answer })
}

impl FitArguments {
    /// What is asked about, and where the answer goes.
    pub(super) fn job(&self, form: Form) -> Job<'_> {
        Job {
            data: &self.data,
            x_errors: None,
            form,
            style: self.data.table.limits.limited(self.output.style()),
            output: self.output.file.output.as_deref(),
            proof: self.proof.as_deref(),
        }
    }
}

/// Refuses what only some formats have.
fn check_usage_of_parts(arguments: &FitArguments, format: ReportFormat) -> Result<(), Failure> {
    let is_document = matches!(format, ReportFormat::Text | ReportFormat::Latex | ReportFormat::Markdown);
    let problem = if arguments.vertices && format != ReportFormat::Csv {
        "'--vertices' is about '--format csv'; other formats have the vertices anyway"
    } else if (arguments.brief || arguments.inverse) && !is_document {
        "'--brief' and '--inverse' are about text, latex and markdown; other formats have all there is"
    } else if arguments.confidence.is_some() && !is_document && format != ReportFormat::Json {
        "'--confidence' is about text, latex, markdown and json; other formats have no place for a guarantee"
    } else {
        return Ok(());
    };
    Err(Failure::Usage(problem.to_owned()))
}

/// Refuses a proof that would have no file of its own, or be about many sets.
fn check_usage_of_proof(arguments: &FitArguments) -> Result<(), Failure> {
    if arguments.by.is_some() && arguments.proof.is_some() {
        let instead = "fit the rows of one group with '--rows', or a file with these rows only";
        return Err(Failure::Usage(format!("'--proof' is about one set and '--by' about many: {instead}")));
    }
    proof_file::check(arguments.proof.as_deref(), arguments.output.file.output.as_deref())
}

/// The proof of a fit.
fn proof(problem: &Problem, fit: &Fit, reading: Reading, file: Foreign<&str>) -> Result<String, Failure> {
    proof_json(problem, fit, reading).ok_or_else(|| {
        let (what, instead) = if problem.measurements.is_of_reductions() {
            ("is a reduction", "prove the fit of the table that it was made from")
        } else {
            ("is not plain delimited text (docs/proof.md)", "prove the fit of the same table as CSV")
        };
        Failure::Usage(format!("'--proof' is about the rows of delimited text, and {file} {what}: {instead}"))
    })
}

/// Readings that an LP solver is asked about beside a fit. Measured: microlp takes 40 µs for each, for 50 about as long as the
/// whole program without it.
const MOST_READINGS_FOR_LP: usize = 50;

/// What the default solver makes of the same data; where they are many, of those that can bound the set.
fn lp_verdict(problem: &Problem, reading: Reading) -> Result<Option<String>, Failure> {
    const MOST: usize = MOST_READINGS_FOR_LP;
    let measurements = &problem.measurements;
    let fitted = measurements.fitted();
    let few = (fitted > MOST).then(|| measurements.supporting()).flatten();
    let asked = few.as_ref().map_or(fitted, Vec::len);
    if asked > MOST {
        let (which, more) = match few {
            Some(_) => (" that can bound the set", format!(", these are {asked}")),
            None => ("", String::new()),
        };
        return Ok(Some(format!(
            "not asked about more than {MOST} readings{which}{more} (see boundfit check)"
        )));
    }
    let few = few.map(|rows| {
        let (model, response) = (measurements.model().clone(), measurements.response().to_owned());
        let error_bound = measurements.error_bound().clone();
        let measurements = Measurements::new(model, response, error_bound, rows);
        Problem { measurements, conditions: problem.conditions.clone() }
    });
    let problem = few.as_ref().unwrap_or(problem);
    let options = CheckOptions {
        solvers: source_names().into_iter().take(1).collect(),
        answers: Vec::new(),
        tolerance: Rational::ratio(1, 1_000_000),
        as_printed: true,
        time_limit: Duration::from_secs(10),
        directions: None,
        all_rows: true,
    };
    let check = check(problem, reading, &options).map_err(Failure::data)?;
    let about = match asked < fitted {
        true => format!(", on the {asked} of {fitted} readings that can bound the set"),
        false => String::new(),
    };
    Ok(verdict_line(&check, reading).map(|verdict| verdict + &about))
}
