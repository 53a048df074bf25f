//! The standing of every reading against the set of all readings, and against the set of the others.

mod looks;

use std::cell::OnceCell;

use boundfit_estimation::{Fit, Keep, Measurement, Measurements, Seen, fit};
use boundfit_formats::Source;
use boundfit_questions::{Deciding, NoRepair, Others, Ranking, Repair, Standing, Statuses, times};
use boundfit_report::{
    Document, NewReadings, StatusCsv, StatusJson, StatusReport, kernel_status, status_document, status_proof,
};
use serde::Deserialize;

use crate::asked::Asked;
use crate::form::{Form, Shows, Written};
use crate::misuse::{Misuse, NoProof};
use crate::paper::Paper;
use crate::question::{Ask, AskedTheorem};
use crate::refusal::Refusal;
pub use looks::Judgeable;
use looks::Parts;

/// The status of every reading: what it says of the set of all readings, and of that of all others.
#[derive(Debug, Clone, Default, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields, default)]
pub struct Status {
    /// A table of further readings, in the same columns, which are judged by the set as it is.
    pub new: Option<String>,
    /// `true` finds the least total widening of the bounds under which some parameters meet all of them.
    pub repair: bool,
    /// `true` lists every reading in reports.
    pub all: bool,
}

/// The set of all readings, and what is found of each.
pub struct Judgement {
    fit: Fit,
    repair: Option<Result<Repair, NoRepair>>,
    /// Found with the first form that needs them: reports look at every reading at the same time.
    statuses: OnceCell<Statuses>,
}

impl Status {
    fn most_listed(&self) -> usize {
        if self.all { usize::MAX } else { Document::MOST_LISTED }
    }

    /// Finds the statuses, where they are not found yet, and for reports what these list.
    fn judge<'a>(
        &self,
        asked: &Judgeable,
        answer: &'a Judgement,
        is_ranked: bool,
    ) -> Result<(&'a Statuses, Ranking), Refusal> {
        let mut ranking = Ranking::listing(self.most_listed());
        let found = answer.statuses.get();
        if let (Some(statuses), false) = (found, is_ranked) {
            return Ok((statuses, ranking));
        }
        if let (Some(all), Some(statuses)) = (asked.problem.measurements.all(), found) {
            let deciding = statuses.deciding_readings();
            let is_other =
                |own: &&Measurement| deciding.binary_search_by_key(&own.row, |other| other.row).is_err();
            let others: Vec<&Measurement> = all.iter().filter(is_other).collect();
            Others::around(statuses.set()).rank_in_memory(&others, &mut ranking);
            for reading in deciding {
                ranking.add(reading.clone(), statuses.status(reading));
            }
            return Ok((statuses, ranking));
        }
        let deciding = Deciding::new(&asked.problem, &answer.fit);
        // The others stand to the set of all as to that of the others.
        let set = is_ranked.then(|| Others::around(deciding.set()));
        let judge = |readings: &Seen<'_>| {
            let mut ranking = Ranking::listing(self.most_listed());
            set.iter().for_each(|set| set.rank(readings, &mut ranking));
            ranking
        };
        let rows: Vec<usize> = deciding.rows().collect();
        let others = asked.look(&rows, judge, |part| ranking.merge(part))?;
        let statuses = answer.statuses.get_or_init(|| Statuses::new(deciding.clone(), &others));
        for reading in deciding.readings().iter().filter(|_| is_ranked) {
            ranking.add(reading.clone(), statuses.status(reading));
        }
        Ok((statuses, ranking))
    }

    /// Further readings for reports.
    fn rank_new<'a>(
        &'a self,
        asked: &'a Judgeable,
        statuses: &Statuses,
    ) -> Result<Option<NewReadings<'a>>, Refusal> {
        let Some(name) = &self.new else { return Ok(None) };
        let set = Others::around(statuses.set());
        let judge = |readings: &Seen<'_>| {
            let mut ranking = Ranking::listing(self.most_listed());
            set.rank(readings, &mut ranking);
            ranking
        };
        let mut ranking = Ranking::listing(self.most_listed());
        asked.see_new(name, judge, |part| ranking.merge(part))?;
        Ok(Some(NewReadings { file: asked.tables()?.file(name), ranking }))
    }

    /// Writes every reading while the data are read once more, or from memory, and then further ones.
    fn write_rows(
        &self,
        asked: &Judgeable,
        answer: &Judgement,
        statuses: &Statuses,
        paper: &mut Paper<'_>,
    ) -> Result<(), Refusal> {
        let Paper { form, origin, style, .. } = *paper;
        let (is_json, style) = (form == Form::Json, &style);
        paper.put(match is_json {
            true => StatusJson::head(&asked.problem, &answer.fit, statuses.deciding(), &origin, style),
            false => StatusCsv::HEADER.to_owned(),
        })?;
        let row = |reading: Measurement| {
            let status = statuses.status(&reading);
            if is_json { StatusJson::row(&status, style) } else { StatusCsv::row(&status) }
        };
        let new_row = |reading: Measurement| {
            let standing = Standing::against(&reading, statuses.set());
            match is_json {
                true => StatusJson::new_row(reading.row, standing.as_ref(), style),
                false => StatusCsv::new_row(reading.row, standing.as_ref()),
            }
        };
        let between = if is_json { StatusJson::BETWEEN } else { "" };
        let made = |readings: &mut dyn Iterator<Item = Measurement>| {
            readings.map(&row).collect::<Vec<_>>().join(between)
        };
        let made_new =
            |readings: &Seen<'_>| readings.readings().map(&new_row).collect::<Vec<_>>().join(between);
        let mut parts = Parts::new(paper.out, between);
        asked.each(made, |part| parts.take(&part))?;
        parts.end()?;
        if is_json {
            paper.put(StatusJson::END_OF_ROWS)?;
        }
        if let Some(name) = &self.new {
            if is_json {
                paper.put(StatusJson::new_head(asked.tables()?.file(name)))?;
            }
            let mut parts = Parts::new(paper.out, between);
            asked.see_new(name, made_new, |part| parts.take(&part))?;
            parts.end()?;
            if is_json {
                paper.put(StatusJson::END_OF_NEW)?;
            }
        }
        if let Some(repair) = answer.repair.as_ref().filter(|_| is_json) {
            paper.put(StatusJson::repair(repair, style))?;
        }
        if is_json { paper.put(StatusJson::TAIL) } else { Ok(()) }
    }
}

impl Ask for Status {
    const NAME: &'static str = "status";
    const FORMS: &'static [Form] =
        &[Form::Text, Form::Latex, Form::Markdown, Form::Json, Form::Csv, Form::Proof];
    type Problem = Judgeable;
    type Answer = Judgement;

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Judgeable, Refusal> {
        if self.new.is_some() {
            asked.tables()?;
        }
        let (name, again) = (source.name().clone(), source.again());
        // A repair moves every bound, and what is read once is kept.
        let keeps_all = self.repair || again.is_none() || shows >= Shows::Readings;
        let keep = Keep { eui: false, ..if keeps_all { Keep::EVERY } else { Keep::default() } };
        // The hash tells whether the data have changed when they are read once more.
        let shows_hash = shows.max(Shows::Hash);
        let problem = asked.scanned(source, (Asked::ROW_COST, shows_hash), keep)?;
        if problem.measurements.is_of_reductions() {
            return Err(Refusal::Reduction { ask: Self::NAME });
        }
        problem.check_work(times::STATUS, asked.most_work())?;
        if shows >= Shows::Rows {
            // A proof has the set without each reading that decides.
            let readings = problem.measurements.kept().len() as u64;
            problem.work(&[]).of_leaving_out_each(readings).check(times::FIT, asked.most_work())?;
        }
        Ok(Judgeable::new(asked, problem, name, again))
    }

    fn measurements<'a>(&self, asked: &'a Judgeable) -> Option<&'a Measurements> {
        Some(&asked.problem.measurements)
    }

    fn answer(&self, asked: &Judgeable) -> Result<Judgement, Refusal> {
        let problem = &asked.problem;
        let fit = fit(problem);
        let repair = self.repair.then(|| Repair::of(problem, &fit));
        let statuses = OnceCell::new();
        if let Some(found) = Statuses::of(problem, &fit) {
            let _ = statuses.set(found);
        }
        Ok(Judgement { fit, repair, statuses })
    }

    fn write(
        &self,
        asked: &Judgeable,
        answer: &Judgement,
        paper: &mut Paper<'_>,
    ) -> Result<Written, Refusal> {
        let problem = &asked.problem;
        let Paper { form, origin, style, .. } = *paper;
        if !Self::FORMS.contains(&form) {
            return Err(Self::no_form(form));
        }
        let (statuses, ranking) = self.judge(asked, answer, form.is_document())?;
        match form {
            Form::Json | Form::Csv => {
                self.write_rows(asked, answer, statuses, paper)?;
            }
            Form::Proof => {
                check_proof(statuses)?;
                let proof = status_proof(problem, statuses, origin.reading);
                paper.put(proof.ok_or(Refusal::NoProof(NoProof::about(&problem.measurements)))?)?;
            }
            _ => {
                let (new, repair) = (self.rank_new(asked, statuses)?, answer.repair.clone());
                let report = StatusReport { problem, fit: &answer.fit, ranking, new, repair };
                Self::report(paper, || status_document(report, &origin, &style))?;
            }
        }
        Ok(Written::of_set(answer.fit.is_empty()))
    }

    fn refuse_vain(&self, form: Form) -> Result<(), Refusal> {
        match form {
            Form::Csv if self.repair => Err(Refusal::Misuse(Misuse::VainRepair)),
            Form::Csv | Form::Json if self.all => Err(Refusal::Misuse(Misuse::VainAll)),
            _ => Ok(()),
        }
    }

    fn theorem(
        &self,
        asked: &Judgeable,
        answer: &Judgement,
        AskedTheorem { reading, theory, .. }: AskedTheorem<'_>,
    ) -> Result<String, Refusal> {
        let (statuses, _) = self.judge(asked, answer, false)?;
        check_proof(statuses)?;
        let theorem = kernel_status((&asked.problem, &answer.fit), statuses, reading, theory);
        theorem.ok_or(Refusal::NoProof(NoProof::Reduction))
    }
}

/// Refuses to prove what is said of too many readings.
fn check_proof(statuses: &Statuses) -> Result<(), Refusal> {
    let deciding = statuses.deciding().count();
    NoProof::check(deciding, NoProof::MOST, "readings that decide").map_err(Refusal::NoProof)
}
