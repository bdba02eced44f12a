//! The stiffness matrix, in words.

use super::analysis_text::AnalysisText;
use super::page::Page;
use super::words::OrderWord;
use crate::wording::digits;

/// The coordinates of twists in the plane.
const PLANAR: [&str; 3] = ["x", "y", "rot"];

/// The coordinates of twists in space.
const SPATIAL: [&str; 6] = ["x", "y", "z", "rot x", "rot y", "rot z"];

impl AnalysisText<'_> {
    /// The stiffness matrix.
    pub(super) fn stiffness(&self, page: &mut Page) {
        page.line("stiffness matrix about the frame's origin");
        let names: &[&str] = if self.planar() { &PLANAR } else { &SPATIAL };
        let mut rows = vec![vec![String::new()]];
        rows[0].extend(names.iter().enumerate().map(|(i, name)| self.twist(i, name)));
        for (i, entries) in self.report.stiffness.iter().enumerate() {
            let mut row = vec![self.wrench(i, names[i])];
            row.extend(entries.iter().map(|&value| digits(value)));
            rows.push(row);
        }
        page.table(&rows);
        self.added(page);
    }

    /// What preloads, curvatures and loads have added to the stiffness.
    fn added(&self, page: &mut Page) {
        let (units, count) = (self.units(), self.report.dimension);
        let rows = &self.report.stiffness_preload;
        let (slides, turns) = (0..count, count..rows.len());
        let blocks =
            [(slides.clone(), slides.clone()), (slides, turns.clone()), (turns.clone(), turns)];
        let [translation, coupling, rotation] = blocks.map(|(down, along)| {
            let entry =
                |row: &Vec<f64>| row[along.clone()].iter().fold(0.0, |m: f64, v| m.max(v.abs()));
            rows[down].iter().map(entry).fold(0.0, f64::max)
        });
        if self.report.order == OrderWord::Second && translation.max(coupling).max(rotation) > 0.0 {
            page.line(format_args!(
                "of this, preloads, curvatures and loads add up to {} to an entry for \
                 translations, {} for the coupling, and {} for rotations",
                units.stiffness(translation),
                units.force(coupling),
                units.torque(rotation)
            ));
        }
    }

    /// The heading of a column of the stiffness: a motion with its unit.
    fn twist(&self, i: usize, name: &str) -> String {
        let length = self.report.units.length.0.as_str();
        format!("{name} [{}]", if i < self.report.dimension { length } else { "rad" })
    }

    /// The name of a row: the force or torque that goes with a motion, and its unit.
    fn wrench(&self, i: usize, name: &str) -> String {
        let units = self.report.units;
        if i < self.report.dimension {
            return format!("force {name} [{}]", units.force);
        }
        let torque = name.replace("rot", "torque");
        format!("{torque} [{} {}]", units.force, units.length)
    }
}
