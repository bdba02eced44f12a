//! The numbers of a grasp that holds the part, in words.

use super::analysis_text::AnalysisText;
use super::measures::{MetricsReport, Rotational};
use super::number::{INVISIBLE, spot};
use super::page::Page;
use super::words::OrderWord;
use crate::wording::digits;

/// The coordinates of twists in the plane.
const PLANAR: [&str; 3] = ["x", "y", "rot"];

/// The coordinates of twists in space.
const SPATIAL: [&str; 6] = ["x", "y", "z", "rot x", "rot y", "rot z"];

impl AnalysisText<'_> {
    /// The principal stiffnesses, their centers, and the quality where there is one.
    pub(super) fn metrics(&self, page: &mut Page) {
        let Some(metrics) = &self.report.metrics else { return };
        self.translations(page, metrics);
        if let [principal] = &metrics.rotational[..] {
            self.rotation(page, principal);
        }
        if let Some(center) = &metrics.center_of_compliance {
            page.row("center of compliance", self.spot(center), "");
        }
        if let Some(center) = &metrics.center {
            let meaning = "where force and rotation couple symmetrically";
            page.row("center", self.spot(center), meaning);
        }
        self.quality(page, metrics);
    }

    fn translations(&self, page: &mut Page, metrics: &MetricsReport) {
        let count = metrics.translational.len();
        for (i, principal) in metrics.translational.iter().enumerate() {
            let along = along(&principal.direction);
            let meaning =
                if i == 0 { format!("least translational stiffness, {along}") } else { along };
            let value = self.units().stiffness(principal.value);
            page.row(&ranked("sigma", i, count), value, meaning);
        }
    }

    /// The one rotation of the plane.
    fn rotation(&self, page: &mut Page, principal: &Rotational) {
        let units = self.units();
        page.row("mu", units.torque(principal.value), "rotational stiffness");
        if let Some(equivalent) = principal.equivalent {
            let meaning = "mu / reach^2: comparable to sigma_min";
            page.row("mu_eq", units.stiffness(equivalent), meaning);
        }
    }

    /// The principal rotations of space.
    pub(super) fn axes(&self, page: &mut Page) {
        let Some(metrics) = self.report.metrics.as_ref().filter(|_| !self.planar()) else { return };
        let (units, size) = (self.report.units, self.report.size);
        let head = [
            "rotation".to_owned(),
            format!("stiffness [{} {}]", units.force, units.length),
            "axis along".to_owned(),
            format!("through [{}]", units.length),
            format!("pitch [{}]", units.length),
        ];
        let mut rows = vec![head.to_vec()];
        for (i, Rotational { value, axis, .. }) in metrics.rotational.iter().enumerate() {
            let pitch = if axis.pitch.abs() <= INVISIBLE * size { 0.0 } else { axis.pitch };
            rows.push(vec![
                ranked("mu", i, metrics.rotational.len()),
                digits(*value),
                spot(&axis.direction, 1.0),
                spot(&axis.axis_point, size),
                digits(pitch),
            ]);
        }
        page.line("");
        page.table(&rows);
    }

    fn quality(&self, page: &mut Page, metrics: &MetricsReport) {
        let Some(quality) = &metrics.quality else { return };
        let (units, reach) = (self.units(), &quality.reach);
        page.row(
            "reach",
            units.length(reach.distance),
            format_args!("to corner {} at {}, the farthest", reach.corner, self.spot(&reach.point)),
        );
        page.row(
            "worst point",
            units.stiffness(quality.worst_point_stiffness),
            format_args!(
                "least force per deflection: at corner {}, {}",
                quality.worst_corner,
                along(&quality.worst_direction)
            ),
        );
    }

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
        let [translation, rotation] = [0..count, count..rows.len()].map(|block| {
            let entry = |i: usize| rows[i][block.clone()].iter();
            block.clone().flat_map(entry).fold(0.0, |m: f64, v| m.max(v.abs()))
        });
        if self.report.order == OrderWord::Second && translation.max(rotation) > 0.0 {
            page.line(format_args!(
                "of this, preloads, curvatures and loads add up to {} to an entry for \
                 translations, and {} for rotations",
                units.stiffness(translation),
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

/// The name of number `i` of `count` ascending values.
fn ranked(name: &str, i: usize, count: usize) -> String {
    match i {
        0 => format!("{name}_min"),
        _ if i + 1 == count => format!("{name}_max"),
        _ => name.to_owned(),
    }
}

fn along(direction: &[f64]) -> String {
    format!("along {}", spot(direction, 1.0))
}
