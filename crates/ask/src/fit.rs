//! The fit of all readings.

use boundfit_estimation::{
    self as estimation, Bounds, Family, Keep, Measurement, Measurements, MultipleOfLeast, Problem, fit,
};
use boundfit_exact::{Foreign, Limits, Rational, Reading};
use boundfit_formats::{InputError, InputErrorKind, MemoryUse, Source};
use boundfit_questions::{Guarantee, times};
use boundfit_report::{
    Document, InverseLine, NextStep, Origin, Style, active_names, bound_found, brief_document, fit_csv,
    fit_document, fit_json, fit_script, full_fit_document, guarantee_document, h_representation, kernel_fit,
    next_document, next_steps, proof_json, region_wkt, sweep_document, v_representation, vertices_csv,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::given::{Given, ends};
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem};
use crate::refusal::{Refusal, ValueProblem};

/// Every parameter pair that agrees with all readings: the set, its intervals and estimates.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Fit {
    /// `true` skips results that need further passes over more readings than are kept in memory.
    pub no_eui: bool,
    /// The factors on the error bounds, `FROM..TO` such as `0.5..2`, for which the sets are found too.
    pub sweep: Option<String>,
    /// The confidence, such as `0.99`, of the statement about the share of further readings that lies in the band of ε_min.
    pub confidence: Option<Given>,
    /// `true` makes the report ten lines.
    pub brief: bool,
    /// `true` makes the report complete: with the proof of each end, every estimate, and least squares in doubles.
    pub full: bool,
    /// `true` adds the inverse line also where 0 is in the interval of θ1.
    pub inverse: bool,
}

/// Factors on the error bounds.
#[derive(Debug, Clone)]
pub struct Factors {
    /// The least.
    pub from: Rational,
    /// The largest.
    pub to: Rational,
}

/// A problem, and what else is asked of it.
pub struct Fittable {
    /// The problem.
    pub problem: Problem,
    sweep: Option<Sweep>,
    confidence: Option<Rational>,
}

/// The sets for a range of factors of readings in a file.
#[derive(Clone)]
struct Sweep {
    factors: Factors,
    file: Foreign,
    most_memory: u64,
}

/// A fit, with what else was asked.
pub struct Fitted {
    /// The fit.
    pub fit: estimation::Fit,
    family: Option<Family>,
    guarantee: Option<Guarantee>,
    /// The verdict on an LP solver's answer to the same data, if a surface has one and asked it: a line of the report
    /// as text.
    pub verdict: Option<String>,
    /// The surface's words for the next steps where the set is empty; the report as text names them.
    pub next_words: Option<fn(&NextStep) -> Option<String>>,
}

impl From<Problem> for Fittable {
    fn from(problem: Problem) -> Self {
        Fittable { problem, sweep: None, confidence: None }
    }
}

impl Fittable {
    /// This problem with every reading in memory, where now only those that decide are. Exact. Cost: linear.
    pub fn whole(&self) -> Option<Fittable> {
        let Fittable { problem, sweep, confidence } = self;
        let measurements = problem.measurements.whole()?;
        let problem = Problem { measurements, conditions: problem.conditions.clone() };
        Some(Fittable { problem, sweep: sweep.clone(), confidence: confidence.clone() })
    }
}

impl Factors {
    /// Reads `FROM..TO`.
    ///
    /// # Errors
    /// When it is something else.
    pub fn parse(text: &str, limits: &Limits) -> Result<Self, Refusal> {
        const EXPECTED: &str = "expected FROM..TO with numbers 0 <= FROM <= TO, such as 0.5..2";
        let refuse = |problem| Refusal::Value { key: "sweep", text: text.to_owned(), problem };
        let number = |part: &str| {
            let number = Reading::Decimal.read(part.trim(), limits);
            number.map_err(|error| {
                refuse(ValueProblem::Part { part: part.trim().to_owned(), error, expected: EXPECTED })
            })
        };
        let (from, to) = ends(text).ok_or_else(|| refuse(ValueProblem::Expected(EXPECTED)))?;
        let factors = Factors { from: number(from)?, to: number(to)? };
        match factors.from.is_negative() || factors.to < factors.from {
            true => Err(refuse(ValueProblem::Expected(EXPECTED))),
            false => Ok(factors),
        }
    }

    /// Refuses readings whose bounds are fixed, and sets that would take too much work.
    ///
    /// # Errors
    /// Why it does.
    pub fn check(&self, problem: &Problem, most_work: u64) -> Result<(), Refusal> {
        if !problem.measurements.are_open() {
            return Err(Refusal::Misuse(Misuse::SweepOfFixed));
        }
        Ok(problem.work(&[&self.to]).check(times::SWEEP * problem.looks(), most_work)?)
    }

    /// Returns the sets for these factors, of readings in this file.
    ///
    /// # Errors
    /// When they take more bytes of memory than `most_memory`.
    pub fn family(&self, problem: &Problem, file: &str, most_memory: u64) -> Result<Family, Refusal> {
        /// Bytes for each vertex of a set, with what is written of it: 1,000 readings of a curve have 10⁶ and took 360 MB.
        const OF_A_VERTEX: u64 = 400;
        let most = usize::try_from(most_memory / OF_A_VERTEX).unwrap_or(usize::MAX);
        let family = Family::within(problem, self.from.clone(), self.to.clone(), most);
        family.ok_or_else(|| {
            let needed = most_memory.saturating_add(OF_A_VERTEX);
            let problem = InputErrorKind::TooMuchMemory { what: MemoryUse::Sets, needed, limit: most_memory };
            Refusal::Input(InputError::of_file(file, problem))
        })
    }
}

impl Fit {
    /// The confidence: more than 0 and less than 1.
    fn confidence(&self, limits: &Limits) -> Result<Option<Rational>, Refusal> {
        const EXPECTED: &str = "expected a number between 0 and 1, such as 0.99";
        /// The closest to 1 that it may be: what is computed with has more than twice as many digits.
        const LEAST_DOUBT: i64 = -100;
        let Some(given) = &self.confidence else { return Ok(None) };
        let confidence = given.exact("confidence", EXPECTED, limits)?;
        let doubt = Rational::one() - &confidence;
        let refuse = |problem| Err(given.refused("confidence", ValueProblem::Expected(problem)));
        if !confidence.is_positive() || !doubt.is_positive() {
            return refuse(EXPECTED);
        }
        if doubt < Rational::scientific(1, LEAST_DOUBT) {
            return refuse("closer to 1 than 1e-100");
        }
        Ok(Some(confidence))
    }

    /// Reads the readings. Where `lists_all` is false, [`Fittable::whole`] has those that decide nothing.
    ///
    /// # Errors
    /// Errors are those of [`Ask::read`].
    pub fn read_listing(
        &self,
        asked: &Asked,
        source: Source,
        shows: Shows,
        lists_all: bool,
    ) -> Result<Fittable, Refusal> {
        if self.inverse && asked.question.columns.second.is_some() {
            return Err(Refusal::Misuse(Misuse::InverseOfTwoRegressors));
        }
        let limits = &asked.options.table.limits;
        let factors = self.sweep.as_deref().map(|text| Factors::parse(text, limits)).transpose()?;
        let (file, most_memory) = (source.name().clone(), asked.options.table.sizes.memory.limit());
        let sweep = factors.map(|factors| Sweep { factors, file, most_memory });
        let confidence = self.confidence(limits)?;
        // Where the bounds are going to move, those that decide under these are not enough.
        let keeps_all = shows >= Shows::Readings || sweep.is_some() && !asked.question.columns.are_open();
        let is_usual = !self.full && confidence.is_none();
        let usual = if is_usual && !lists_all { Keep::DECIDING } else { Keep::default() };
        let keep = Keep { eui: !self.no_eui, ..if keeps_all { Keep::EVERY } else { usual } };
        let problem = asked.scanned(source, (Asked::ROW_COST, shows), keep)?;
        if let Some(Sweep { factors, .. }) = &sweep {
            factors.check(&problem, asked.most_work())?;
        }
        if confidence.is_some() && problem.measurements.error_bound().has_middles() {
            return Err(Refusal::Misuse(Misuse::ConfidenceOfIntervals));
        }
        let is_zero =
            |row: &Measurement| matches!(&row.bounds, Bounds::Around { epsilon, .. } if epsilon.is_zero());
        let differ = !problem.measurements.error_bound().is_uniform();
        if confidence.is_some() && differ && problem.measurements.kept().iter().any(is_zero) {
            return Err(Refusal::Misuse(Misuse::ConfidenceOfZero));
        }
        Ok(Fittable { problem, sweep, confidence })
    }

    fn document<'a>(
        &self,
        asked: &'a Fittable,
        answer: &'a Fitted,
        form: Form,
        origin: &Origin<'_>,
        style: &Style,
    ) -> Document<'a> {
        let (problem, fit) = (&asked.problem, &answer.fit);
        if self.brief {
            return brief_document(problem, fit, origin, style);
        }
        let inverse = if self.inverse { InverseLine::Always } else { InverseLine::default() };
        let written = if self.full { full_fit_document } else { fit_document };
        let mut document = written(problem, fit, origin, inverse, style);
        if let Some(verdict) = &answer.verdict {
            document.add_result("LP solver", verdict);
        }
        if let Some(family) = &answer.family {
            document.append(sweep_document(problem, family, style));
        }
        if let Some(guarantee) = &answer.guarantee {
            document.append(guarantee_document(problem, fit, guarantee, style));
        }
        if let Some(words) = answer.next_words.filter(|_| form == Form::Text) {
            document.append(next_document(&next_steps(problem, fit, style), words));
        }
        document
    }
}

impl Ask for Fit {
    const NAME: &'static str = "fit";
    const FORMS: &'static [Form] = &[
        Form::Text,
        Form::Latex,
        Form::Markdown,
        Form::Json,
        Form::Csv,
        Form::Wkt,
        Form::Vertices,
        Form::M,
        Form::Ine,
        Form::Ext,
        Form::Proof,
    ];
    type Problem = Fittable;
    type Answer = Fitted;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Fittable, Refusal> {
        // A form that lists no other reading than those that decide needs no other as numbers.
        self.read_listing(asked, source, shows, shows != Shows::Nothing)
    }

    fn measurements<'a>(&self, asked: &'a Fittable) -> Option<&'a Measurements> {
        Some(&asked.problem.measurements)
    }

    fn multiple_of_least<'a>(&self, asked: &'a Fittable, form: Form) -> Option<&'a MultipleOfLeast> {
        let has_place = !matches!(form, Form::Vertices | Form::Wkt);
        asked.problem.measurements.multiple_of_least().filter(|_| !has_place)
    }

    fn answer(&self, asked: &Fittable) -> Result<Fitted, Refusal> {
        let problem = &asked.problem;
        let family =
            |Sweep { factors, file, most_memory }: &Sweep| factors.family(problem, file.raw(), *most_memory);
        let guarantee = |confidence| Guarantee::new(&problem.measurements, confidence);
        Ok(Fitted {
            fit: fit(problem),
            family: asked.sweep.as_ref().map(family).transpose()?,
            guarantee: asked.confidence.as_ref().and_then(guarantee),
            verdict: None,
            next_words: None,
        })
    }

    fn write(&self, asked: &Fittable, answer: &Fitted, paper: &mut Paper<'_>) -> Result<Written, Refusal> {
        let (problem, fit) = (&asked.problem, &answer.fit);
        let Paper { form, origin, style, .. } = *paper;
        let polyhedron = fit.fps.polyhedron();
        let names = |indices: &[usize]| active_names(fit, indices);
        match form {
            Form::Json => {
                let (family, guarantee) = (answer.family.as_ref(), answer.guarantee.as_ref());
                paper.put(fit_json(problem, fit, family, guarantee, &origin, &style))
            }
            Form::Csv => paper.put(fit_csv(problem, fit)),
            Form::Vertices => paper.put(vertices_csv(polyhedron, &names, &style)),
            Form::Wkt => paper.put(region_wkt(polyhedron, &style).map_err(Refusal::Wkt)?),
            Form::M => paper.put(fit_script(problem, fit, &names)),
            Form::Ine => paper.put(commented(problem, h_representation(polyhedron))),
            Form::Ext => paper.put(commented(problem, v_representation(polyhedron))),
            Form::Proof => {
                let why = NoProof::about(&problem.measurements);
                paper.put(proof_json(problem, fit, origin.reading).ok_or(Refusal::NoProof(why))?)
            }
            _ => Self::report(paper, || self.document(asked, answer, form, &origin, &style)),
        }?;
        Ok(Written::of_set(fit.is_empty()))
    }

    fn refuse_vain(&self, form: Form) -> Result<(), Refusal> {
        let is_more = self.full || self.inverse || self.sweep.is_some() || self.confidence.is_some();
        let has_documents = form.is_document() || form == Form::Proof;
        let vain = if (self.brief || self.full || self.inverse) && !has_documents {
            Misuse::VainReport
        } else if self.sweep.is_some() && !has_documents && form != Form::Json {
            Misuse::VainSweep
        } else if self.confidence.is_some() && !has_documents && form != Form::Json {
            Misuse::VainConfidence
        } else if self.brief && is_more {
            Misuse::BriefAlone
        } else {
            return Ok(());
        };
        Err(Refusal::Misuse(vain))
    }

    fn theorem(&self, asked: &Fittable, answer: &Fitted, told: AskedTheorem<'_>) -> Result<String, Refusal> {
        theorem(&asked.problem, &answer.fit, told)
    }
}

/// The theorem about the set of a problem, all of whose readings are in memory.
pub(crate) fn theorem(
    problem: &Problem,
    fit: &estimation::Fit,
    AskedTheorem { reading, theory, data }: AskedTheorem<'_>,
) -> Result<String, Refusal> {
    let sha256 = problem.measurements.sha256();
    let same = data.filter(|&(_, own)| sha256 == Some(own)).map(|(bytes, _)| bytes);
    kernel_fit(problem, fit, reading, same, theory).ok_or(Refusal::NoProof(NoProof::Reduction))
}

/// A representation below the comment with the bound on the errors, if that was found from the readings.
fn commented(problem: &Problem, text: String) -> String {
    let multiple = problem.measurements.multiple_of_least();
    multiple.map_or_else(String::new, |multiple| format!("* {}\n", bound_found(multiple))) + &text
}
