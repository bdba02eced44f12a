//! Whole polygons: the search beside plain enumeration, of a grid by `NumPy` and of closed forms.

use std::fmt::Write;

use clench::metrics::LimitedBy;
use clench::optimize::polygon::{Fingers, Part, fingers, four_fingers_on};
use clench::optimize::{Effort, OptimizeError, unwatched};
use serde::{Deserialize, Serialize};

use super::PeersError;
use super::outline::{Outline, combinations, smooth_part};
use super::python::{Python, Script};
use super::stopwatch::{median_of, shown};

const SCRIPT: Script = Script { name: "polygons", text: include_str!("polygons.py") };

/// The corners of the outlines.
const CORNERS: [usize; 3] = [10, 15, 20];

/// The seed of the outlines, the one of the benches.
const SEED: u64 = 7;

/// Places per edge of the grid, with both ends.
const PLACES: usize = 5;

/// How often search and enumeration are run by the library.
const RUNS: usize = 9;

/// What rounding may do to two ways of solving the same combination.
const ROUNDING: f64 = 1e-9;

const HEAD: &str = "
| corners | placements | grid | its time | optimum | limited by | its time | grid reaches | ratio |
| --- | --- | --- | --- | --- | --- | --- | --- | --- |
";

const HEAD_OF_ALL: &str = "
| corners | combinations | best of all | its time | difference from search | ratio |
| --- | --- | --- | --- | --- | --- |
";

#[derive(Debug, Serialize)]
struct Questions {
    places: usize,
    outlines: Vec<Outline>,
}

#[derive(Debug, Deserialize)]
struct Answers {
    version: String,
    answers: Vec<Answer>,
}

/// The best of the grid.
#[derive(Debug, Deserialize)]
struct Answer {
    quality: f64,
    placements: u64,
    seconds: f64,
}

/// A quality and the time it took.
#[derive(Debug)]
struct Solved {
    quality: f64,
    seconds: f64,
}

/// One polygon, in three ways.
#[derive(Debug)]
struct Row {
    corners: usize,
    /// Proved to be the optimum.
    search: Solved,
    /// What limits the optimum.
    limit: LimitedBy,
    /// Each combination by closed forms, nothing skipped.
    all: Solved,
    grid: Answer,
}

/// All polygons.
#[derive(Debug)]
pub(super) struct Comparison {
    version: String,
    rows: Vec<Row>,
}

impl Comparison {
    pub(super) fn compute(python: &Python) -> Result<Self, PeersError> {
        let parts = CORNERS.map(|corners| smooth_part(corners, SEED));
        let parts = parts.into_iter().collect::<Result<Vec<_>, _>>()?;
        let outlines = parts.iter().map(Outline::of).collect();
        let Answers { version, answers } =
            python.ask(SCRIPT, &Questions { places: PLACES, outlines })?;
        let (found, asked) = (answers.len(), parts.len());
        if found != asked {
            return Err(PeersError::AnswerCount { script: SCRIPT.name, found, asked });
        }
        let rows = parts.iter().zip(answers).map(|(part, grid)| Row::compute(part, grid));
        Ok(Self { version, rows: rows.collect::<Result<_, _>>()? })
    }

    /// Rows that cannot be right.
    pub(super) fn contradictions(&self) -> usize {
        self.rows.iter().filter(|row| row.contradicts()).count()
    }

    /// The section of the page.
    pub(super) fn section(&self) -> String {
        let mut page = format!(
            "## Whole polygons: NumPy {}\n\n\
             The best quality of four fingers on the smooth outlines of the benches, seed {SEED}.\n\
             The grid has {PLACES} places per edge, so its best is a lower bound. It is the \
             optimum where `sigma_min`\nlimits that, or where the best places are corners. The \
             library's times are medians of {RUNS} runs.\n{HEAD}",
            self.version
        );
        // Writing to a string does not fail.
        for Row { corners, search, limit, grid, .. } in &self.rows {
            let _ = writeln!(
                page,
                "| {corners} | {} | {:.9} | {} | {:.9} | {} | {} | {:.2} % | {:.0} |",
                grid.placements,
                grid.quality,
                shown(grid.seconds),
                search.quality,
                name(*limit),
                shown(search.seconds),
                grid.quality / search.quality * 100.0,
                grid.seconds / search.seconds,
            );
        }
        let _ =
            writeln!(page, "\nEach combination by the library's closed forms, beside its search:");
        page.push_str(HEAD_OF_ALL);
        for Row { corners, search, all, .. } in &self.rows {
            let _ = writeln!(
                page,
                "| {corners} | {} | {:.9} | {} | {:.1e} | {:.1} |",
                combinations(*corners).count(),
                all.quality,
                shown(all.seconds),
                all.quality / search.quality - 1.0,
                all.seconds / search.seconds,
            );
        }
        page
    }
}

impl Row {
    fn compute(part: &Part, grid: Answer) -> Result<Self, PeersError> {
        let four = Fingers::new(4);
        let (outcome, seconds) =
            median_of(RUNS, || fingers(part, &four, &Effort::default(), unwatched))?;
        let search = Solved { quality: outcome.best.objective, seconds };
        let limit = outcome.best.quality.limited_by;
        let (quality, seconds) = median_of(RUNS, || best_of_all(part, &four))?;
        let all = Solved { quality, seconds };
        Ok(Self { corners: part.outline().corners().len(), search, limit, all, grid })
    }

    /// Whether search and enumeration differ, or the grid has more.
    fn contradicts(&self) -> bool {
        let optimum = self.search.quality;
        (self.all.quality - optimum).abs() > ROUNDING * optimum
            || self.grid.quality > optimum * (1.0 + ROUNDING)
    }
}

fn name(limit: LimitedBy) -> &'static str {
    match limit {
        LimitedBy::Translation => "sigma_min",
        LimitedBy::Rotation => "mu_eq",
    }
}

/// The best quality of all combinations, 0 when none holds.
fn best_of_all(part: &Part, four: &Fingers) -> Result<f64, OptimizeError> {
    let mut best = 0.0_f64;
    for edges in combinations(part.outline().edges().len()) {
        if let Some(found) = four_fingers_on(part, edges, four)? {
            best = best.max(found.objective);
        }
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::{Answer, LimitedBy, Row, Solved};

    fn row(all: f64, grid: f64) -> Row {
        let solved = |quality| Solved { quality, seconds: 1.0 };
        let grid = Answer { quality: grid, placements: 1, seconds: 1.0 };
        Row { corners: 10, search: solved(2.0), limit: LimitedBy::Rotation, all: solved(all), grid }
    }

    #[test]
    fn a_grid_may_miss_the_optimum_but_not_exceed_it() {
        assert!(!row(2.0, 1.9).contradicts());
        assert!(row(2.0, 2.001).contradicts());
    }

    #[test]
    fn search_and_enumeration_must_agree() {
        assert!(row(2.000_001, 1.9).contradicts());
        assert!(row(1.999_999, 1.9).contradicts());
    }
}
