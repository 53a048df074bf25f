//! The fits of many groups of readings.

use std::ops::Range;

use boundfit_estimation::{GroupFit, GroupLine, Measurements, Question};
use boundfit_exact::english::counted;
use boundfit_exact::{Foreign, Work};
use boundfit_formats::{ColumnSelector, Source, TableNotes};
use boundfit_questions::times;
use boundfit_report::{
    FleetCsv, FleetSummary, FleetTable, GroupCells, LineInput, Style, TableJson, in_page_width, table_line,
    write_group_json,
};
use serde::Deserialize;

use crate::asked::{Asked, assumed, remarks};
use crate::form::{Form, Shows, Written};
use crate::misuse::Misuse;
use crate::paper::Paper;
use crate::question::Ask;
use crate::refusal::Refusal;

/// The fit of each group of rows with the same text in a column.
#[derive(Debug, Clone, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(deny_unknown_fields)]
pub struct Fleet {
    /// The column whose equal texts make a group.
    pub by: String,
}

/// Groups without a reading that are named.
const MOST_NAMED: usize = 10;

/// Groups of readings, and what is asked of each.
pub struct Groups {
    question: Question,
    fleet: boundfit_estimation::Fleet,
}

impl Groups {
    /// Reads the groups that a column makes, whose numbers are not too long for a fit of each. [`Shows::Readings`] keeps every reading.
    ///
    /// # Errors
    /// When the table cannot be read, or its numbers are too long.
    pub fn read(asked: &Asked, source: Source, by: &ColumnSelector, shows: Shows) -> Result<Self, Refusal> {
        if asked.x_errors.is_some() {
            return Err(Refusal::Misuse(Misuse::FleetOfXErrors));
        }
        let options = asked.held(asked.options.table.row_cost, Shows::Nothing);
        let read = if shows < Shows::Readings {
            boundfit_estimation::Fleet::read
        } else {
            boundfit_estimation::Fleet::read_every
        };
        let fleet = read(source, &asked.question.columns, by, options)?;
        let groups = Groups { question: asked.question.clone(), fleet };
        if groups.has_nameless() && groups.fleet.table().is_some_and(|table| table.looks.merged > 0) {
            let by = by.text().quoted();
            let problem = format!(
                "cells of {by} are empty, and the sheet has merged cells, whose first cell alone has the value: write the \
                 name of the group into every row"
            );
            return Err(Refusal::Readings(problem));
        }
        groups.check(asked.most_work())?;
        Ok(groups)
    }

    /// The groups.
    pub fn fleet(&self) -> &boundfit_estimation::Fleet {
        &self.fleet
    }

    /// Returns the question about each group.
    pub fn question(&self) -> &Question {
        &self.question
    }

    /// Refuses groups whose numbers are long. A multiple of the least bound is not looked for: it is work itself.
    fn check(&self, most_work: u64) -> Result<(), Refusal> {
        let Groups { question, fleet } = self;
        if !question.has_long_bound() && !fleet.has_fractions() {
            return Ok(());
        }
        question.work_of_every(fleet.readings()).check(times::FIT, most_work)?;
        let mut work = Work::default();
        let problem = |group| question.stated_problem(fleet.measurements(group));
        (0..fleet.len()).for_each(|group| work.append(problem(group).work(&[])));
        Ok(work.check(times::FIT, most_work)?)
    }

    /// Returns whether rows have an empty name of a group.
    fn has_nameless(&self) -> bool {
        (0..self.fleet.len()).any(|group| self.fleet.key(group).is_empty())
    }

    /// Says which groups have no reading, since each of their rows lacks a number; nothing where each has one.
    pub fn without_readings(&self) -> Option<String> {
        let empty = self.fleet.without_readings();
        let count = empty.len();
        let names: Vec<String> = empty.take(MOST_NAMED).map(|name| name.quoted()).collect();
        let more = count.saturating_sub(MOST_NAMED);
        let more = if more > 0 { format!(" and {more} more") } else { String::new() };
        let groups = counted(count, "group", "groups");
        (count > 0).then(|| format!("{groups} without a reading: {}{more}", names.join(", ")))
    }

    fn remarks(&self) -> String {
        let assumed = self.question.multiple_of_least.as_ref().map(|factor| assumed(factor, "its own group"));
        let nameless =
            self.has_nameless().then(|| "rows without the name of a group are one group, \"\"".to_owned());
        let notes = self.without_readings().into_iter().chain(nameless).chain(assumed);
        remarks(self.fleet.rows_missing(), notes)
    }

    fn write_json(&self, paper: &mut Paper<'_>, whole: &mut FleetSummary) -> Result<(), Refusal> {
        let style = paper.style;
        let input = LineInput::new(self.fleet.table().map(TableJson::new));
        let lines = |groups: Range<usize>| {
            /// The length of the line of a polygon.
            const USUAL: usize = 4096;
            let mut lines = Vec::with_capacity(USUAL * groups.len());
            let mut summary = FleetSummary::default();
            for group in groups {
                let key = self.fleet.key(group);
                let answer = self.question.answer_of_group(&self.fleet, group);
                summary.add(key, answer.fit.rows, answer.fit.kind);
                write_group_json(&mut lines, key, &answer, &input, &style);
            }
            (lines, summary)
        };
        self.fleet.in_order(lines, |(lines, summary)| {
            whole.append(summary);
            paper.put(lines)
        })
    }

    fn write_csv(&self, paper: &mut Paper<'_>, whole: &mut FleetSummary) -> Result<(), Refusal> {
        let style = paper.style;
        let mut header = FleetCsv::new();
        header.header(self.fleet.is_bounded_per_row());
        paper.put(header.into_bytes())?;
        let rows = |groups| {
            let mut rows = FleetCsv::new();
            let mut summary = FleetSummary::default();
            for group in groups {
                let key = self.fleet.key(group);
                let line = self.question.line_of_group(&self.fleet, group);
                match line.filter(|line| rows.line(key, line, &style)) {
                    Some(line) => summary.add(key, line.rows, GroupLine::KIND),
                    None => {
                        let line = self.question.of_group(&self.fleet, group);
                        summary.add(key, line.rows, line.kind);
                        rows.group(key, &line, &style);
                    }
                }
            }
            (rows.into_bytes(), summary)
        };
        self.fleet.in_order(rows, |(rows, summary)| {
            whole.append(summary);
            paper.put(rows)
        })
    }

    fn write_text(&self, paper: &mut Paper<'_>, whole: &mut FleetSummary) -> Result<(), Refusal> {
        let style = paper.style;
        let mut table = FleetTable::new(self.fleet.is_bounded_per_row());
        let lines = |groups| {
            let mut lines = Vec::new();
            let summary = self.each(groups, |key, group| lines.push(GroupCells::new(key, group, &style)));
            (lines, summary)
        };
        self.fleet.in_order(lines, |(lines, summary)| {
            whole.append(summary);
            let mut text = String::new();
            lines.into_iter().for_each(|cells| table.push(cells, &mut text));
            paper.put(text)
        })?;
        let mut text = String::new();
        table.finish(&mut text);
        let summary = whole.to_text() + &table_line(self.fleet.table()) + &self.remarks();
        // The counts stay one line.
        let (counts, below) = summary.split_once('\n').unwrap_or((&summary, ""));
        paper.put(format!("{text}\n{counts}\n{}", in_page_width(below)))
    }

    /// Fits groups and shows each as a line.
    fn each(&self, groups: Range<usize>, mut show: impl FnMut(Foreign<&str>, &GroupFit)) -> FleetSummary {
        let mut summary = FleetSummary::default();
        for group in groups {
            let line = self.question.of_group(&self.fleet, group);
            summary.add(self.fleet.key(group), line.rows, line.kind);
            show(self.fleet.key(group), &line);
        }
        summary
    }
}

impl Ask for Fleet {
    const NAME: &'static str = "fleet";
    const FORMS: &'static [Form] = &[Form::Text, Form::Json, Form::Csv];
    /// [`Groups::read`] refuses them in words of its own.
    const LOOKS_AT_X_ERRORS: bool = true;
    type Problem = Groups;
    /// Groups are written one by one, as they are fitted.
    type Answer = ();

    fn read(&self, asked: &Asked, source: Source, shows: Shows) -> Result<Groups, Refusal> {
        Groups::read(asked, source, &ColumnSelector::name_or_number(&self.by), shows)
    }

    fn measurements<'a>(&self, _: &'a Groups) -> Option<&'a Measurements> {
        None
    }

    fn table<'a>(&self, groups: &'a Groups) -> Option<&'a TableNotes> {
        groups.fleet.table()
    }

    fn answer(&self, _: &Groups) -> Result<(), Refusal> {
        Ok(())
    }

    fn refuse_vain_style(&self, _: Form, _: &Style) -> Result<(), Misuse> {
        // Lines of many sets are decimals in every form.
        Ok(())
    }

    fn write(&self, groups: &Groups, (): &(), paper: &mut Paper<'_>) -> Result<Written, Refusal> {
        let write_groups = match paper.form {
            Form::Text => Groups::write_text,
            Form::Json => Groups::write_json,
            Form::Csv => Groups::write_csv,
            form => return Err(Self::no_form(form)),
        };
        let mut summary = FleetSummary::default();
        write_groups(groups, paper, &mut summary)?;
        let is_empty = summary.has_empty();
        // The text form itself ends with the summary.
        let is_beside = paper.form != Form::Text;
        let summary = if is_beside { summary.to_text() + &groups.remarks() } else { String::new() };
        Ok(Written { is_empty, summary, ..Written::default() })
    }
}
