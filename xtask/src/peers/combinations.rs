//! Single combinations of four edges: the closed forms beside SCIP.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use clench::optimize::polygon::{Fingers, Part, four_fingers_on};
use clench::shape::Polygon;
use serde::{Deserialize, Serialize};

use super::PeersError;
use super::outline::Outline;
use super::python::{Python, Script};
use super::stopwatch::{median, median_of, shown};
use crate::workspace::ROOT;

/// The reference cases whose combinations are taken.
const CASES: &str = "crates/testkit/cases/polygon_four_finger.json";

const SCRIPT: Script = Script { name: "combinations", text: include_str!("combinations.py") };

/// When SCIP stops.
const LIMITS: Limits = Limits { seconds: 60.0, gap: 1e-6 };

/// Ten times the gap at which SCIP may stop: beyond it the two differ.
const AGREEMENT: f64 = 1e-5;

/// How often the library solves each combination.
const RUNS: usize = 101;

const HEAD: &str = "
| part | edges | library | its time | SCIP | its bound | status | its time | difference | ratio |
| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |
";

#[derive(Debug, Deserialize)]
struct Case {
    vertices: Vec<[f64; 2]>,
    edge_stiffness: Vec<f64>,
    four_finger: FourFinger,
}

#[derive(Debug, Deserialize)]
struct FourFinger {
    /// Edges, `sigma_min` and `mu_eq`.
    combos: Vec<([usize; 4], f64, f64)>,
}

#[derive(Debug, Serialize)]
struct Limits {
    seconds: f64,
    /// Relative.
    gap: f64,
}

#[derive(Debug, Serialize)]
struct Questions {
    limits: Limits,
    cases: Vec<Question>,
}

#[derive(Debug, Serialize)]
struct Question {
    #[serde(flatten)]
    outline: Outline,
    edges: [usize; 4],
}

#[derive(Debug, Deserialize)]
struct Answers {
    version: String,
    answers: Vec<Answer>,
}

/// What SCIP found of `mu_eq`.
#[derive(Debug, Deserialize)]
struct Answer {
    objective: Option<f64>,
    bound: Option<f64>,
    status: String,
    seconds: f64,
}

/// One combination, by both.
#[derive(Debug)]
struct Row {
    part: usize,
    edges: [usize; 4],
    /// `mu_eq` by the library.
    equivalent: f64,
    seconds: f64,
    scip: Answer,
}

/// All combinations, by both.
#[derive(Debug)]
pub(super) struct Comparison {
    version: String,
    rows: Vec<Row>,
}

impl Comparison {
    pub(super) fn compute(python: &Python) -> Result<Self, PeersError> {
        let (mut cases, mut solved) = (Vec::new(), Vec::new());
        for (number, case) in read()?.into_iter().enumerate() {
            let part = Part::new(Polygon::new(&case.vertices)?, case.edge_stiffness)?;
            for (edges, _, _) in case.four_finger.combos {
                let (found, seconds) =
                    median_of(RUNS, || four_fingers_on(&part, edges, &Fingers::new(4)))?;
                let found = found.ok_or(PeersError::Combination { part: number, edges })?;
                solved.push((number, found.quality.equivalent(), seconds));
                cases.push(Question { outline: Outline::of(&part), edges });
            }
        }
        let questions = Questions { limits: LIMITS, cases };
        let Answers { version, answers } = python.ask(SCRIPT, &questions)?;
        let (found, asked) = (answers.len(), solved.len());
        if found != asked {
            return Err(PeersError::AnswerCount { script: SCRIPT.name, found, asked });
        }
        let pairs = questions.cases.iter().zip(solved).zip(answers);
        let row = |((question, (part, equivalent, seconds)), scip): ((&Question, _), _)| Row {
            part,
            edges: question.edges,
            equivalent,
            seconds,
            scip,
        };
        Ok(Self { version, rows: pairs.map(row).collect() })
    }

    /// Rows that cannot both be right.
    pub(super) fn contradictions(&self) -> usize {
        self.rows.iter().filter(|row| row.contradicts()).count()
    }

    /// The section of the page.
    pub(super) fn section(&self) -> String {
        let count = self.rows.len();
        let mut page = format!(
            "## Single combinations: SCIP {}\n\n\
             The largest `mu_eq` on each of the {count} combinations of `{CASES}`.\n\
             SCIP stops at a relative gap of {:e} or after {} s; the library's time is the median \
             of {RUNS} runs.\n{HEAD}",
            self.version, LIMITS.gap, LIMITS.seconds
        );
        // Writing to a string does not fail.
        for row in &self.rows {
            let _ = writeln!(page, "{}", row.line());
        }
        let agree = self.rows.iter().filter(|row| row.agrees()).count();
        let largest =
            self.rows.iter().filter_map(Row::difference).map(f64::abs).fold(0.0, f64::max);
        let of =
            |value: fn(&Row) -> f64| median(&mut self.rows.iter().map(value).collect::<Vec<_>>());
        let _ = writeln!(
            page,
            "\n{agree} of {count} agree to {AGREEMENT:e}, {} contradict; the largest difference is \
             {largest:.1e}.\nMedians: library {}, SCIP {}, ratio {:.0}.",
            self.contradictions(),
            shown(of(|row| row.seconds)),
            shown(of(|row| row.scip.seconds)),
            of(Row::ratio),
        );
        page
    }
}

impl Row {
    fn line(&self) -> String {
        let Self { part, edges, equivalent, seconds, scip } = self;
        let number = |x: Option<f64>| x.map_or("-".to_owned(), |x| format!("{x:.9}"));
        format!(
            "| {part} | {edges:?} | {equivalent:.9} | {} | {} | {} | {} | {} | {} | {:.0} |",
            shown(*seconds),
            number(scip.objective),
            number(scip.bound),
            scip.status,
            shown(scip.seconds),
            self.difference().map_or("-".to_owned(), |x| format!("{x:.1e}")),
            self.ratio(),
        )
    }

    /// By what part of it SCIP's number exceeds the library's.
    fn difference(&self) -> Option<f64> {
        self.scip.objective.map(|objective| objective / self.equivalent - 1.0)
    }

    /// How many times as long SCIP takes.
    fn ratio(&self) -> f64 {
        self.scip.seconds / self.seconds
    }

    fn agrees(&self) -> bool {
        self.difference().is_some_and(|difference| difference.abs() <= AGREEMENT)
    }

    /// Whether SCIP has found more than the library, or proved that there is less.
    fn contradicts(&self) -> bool {
        let found_more = self.difference().is_some_and(|difference| difference > AGREEMENT);
        let limit = self.equivalent * (1.0 - AGREEMENT);
        found_more || self.scip.bound.is_some_and(|bound| bound < limit)
    }
}

fn read() -> Result<Vec<Case>, PeersError> {
    let text = fs::read_to_string(Path::new(ROOT).join(CASES))
        .map_err(|source| PeersError::Unreadable { path: CASES, source })?;
    serde_json::from_str(&text).map_err(|source| PeersError::Unknown { place: CASES, source })
}

#[cfg(test)]
mod tests {
    use super::{Answer, Row, read};

    fn row(objective: Option<f64>, bound: f64) -> Row {
        let scip = Answer { objective, bound: Some(bound), status: String::new(), seconds: 1.0 };
        Row { part: 0, edges: [0; 4], equivalent: 2.0, seconds: 1e-6, scip }
    }

    #[test]
    fn the_reference_file_has_forty_combinations() {
        assert_eq!(
            read().unwrap().iter().map(|case| case.four_finger.combos.len()).sum::<usize>(),
            40
        );
    }

    #[test]
    fn a_number_within_the_tolerance_agrees() {
        let near = row(Some(2.000_01), 2.000_01);
        assert!(near.agrees() && !near.contradicts());
    }

    #[test]
    fn a_search_that_ran_out_of_time_neither_agrees_nor_contradicts() {
        for row in [row(Some(1.5), 2.5), row(None, 2.5)] {
            assert!(!row.agrees() && !row.contradicts());
        }
    }

    #[test]
    fn more_than_the_library_has_and_a_bound_below_it_contradict() {
        assert!(row(Some(2.1), 2.2).contradicts());
        assert!(row(Some(1.8), 1.9).contradicts());
    }
}
