//! The numbers of a grasp that holds the part, in words.

use super::analysis_text::AnalysisText;
use super::axes::{AxisReport, Rotational, Translational};
use super::measures::{InSpace, MetricsReport};
use super::number::{beside, spot};
use super::page::Page;
use super::quality::QualityReport;
use crate::wording::digits;

impl AnalysisText<'_> {
    /// The quality, and the centers.
    pub(super) fn metrics(&self, page: &mut Page) {
        let Some(metrics) = &self.report.metrics else { return };
        self.quality(page, &metrics.quality);
        self.centers(page, metrics);
    }

    fn quality(&self, page: &mut Page, quality: &QualityReport) {
        let units = self.units();
        let row = |page: &mut Page, label: &str, value: f64, meaning: &str| {
            page.row(label, units.stiffness(value), meaning);
        };
        row(page, "sigma_min", quality.sigma_min, "least translational stiffness");
        let moved = if self.planar() { "reach" } else { "deflection" };
        let meaning = format!("least mu / {moved}^2: comparable to sigma_min");
        row(page, "mu_eq", quality.mu_eq, &meaning);
        if !self.planar() {
            let meaning = format!(
                "least mu_eq of all rotations that need no force{}",
                self.proved(quality.quality_rotational_at_least)
            );
            row(page, "Q_V", quality.quality_rotational, &meaning);
        }
        let meaning = format!(
            "worst point, least force per deflection: at {}, along {}{}",
            self.place(&quality.worst_point, quality.worst_corner),
            spot(&quality.worst_direction, 1.0),
            self.proved(quality.worst_point_stiffness_at_least)
        );
        row(page, "Q_pt", quality.worst_point_stiffness, &meaning);
    }

    /// What a search could not decide.
    pub(super) fn proved(&self, at_least: Option<f64>) -> String {
        at_least.map_or_else(String::new, |bound| {
            format!("; only {} is proved", self.units().stiffness(bound))
        })
    }

    fn centers(&self, page: &mut Page, metrics: &MetricsReport) {
        if let Some(center) = &metrics.center_of_compliance {
            let in_plane = metrics.in_plane.as_ref();
            let of_file = in_plane.and_then(|p| p.center_of_compliance_in_file_frame.as_ref());
            let of_file =
                of_file.map(|center| format!("in the file's frame {}", self.spot(center)));
            page.row("center of compliance", self.spot(center), of_file.unwrap_or_default());
        }
        if let Some(space) = metrics.in_space.as_ref().filter(|space| !space.true_center_exists) {
            self.centers_of_space(page, space);
        }
    }

    /// What takes the place of the center of compliance, where there is none.
    fn centers_of_space(&self, page: &mut Page, space: &InSpace) {
        let meaning = "where force and rotation couple symmetrically; no center of compliance";
        page.row("canonical point", self.spot(&space.center), meaning);
        for (label, center, meaning) in [
            ("Loncaric stiffness", &space.loncaric_center_of_stiffness, "K"),
            ("Loncaric compliance", &space.loncaric_center_of_compliance, "the inverse of K"),
        ] {
            let meaning = format!("where the coupling of {meaning} is symmetric");
            page.row(label, self.spot(center), meaning);
        }
    }

    /// The principal stiffnesses with their axes.
    pub(super) fn axes(&self, page: &mut Page) {
        let Some(metrics) = &self.report.metrics else { return };
        self.translations(page, &metrics.translational);
        self.rotations(page, &metrics.rotational);
        repeated(page, &metrics.rotational);
    }

    fn translations(&self, page: &mut Page, translational: &[Translational]) {
        let mut rows = vec![self.axis_head("translation", &self.units().per_length())];
        for (i, principal) in translational.iter().enumerate() {
            let name = ranked("sigma", i, translational.len());
            rows.push(self.axis_row(name, principal.value, &principal.axis));
        }
        self.axis_table(page, rows, &["pitch"]);
        if translational.iter().any(|principal| principal.repeated) {
            page.line(
                "repeated: translational stiffnesses are equal, and any direction between \
                 theirs is principal; the axes shown are one choice",
            );
        }
    }

    fn rotations(&self, page: &mut Page, rotational: &[Rotational]) {
        let (units, length) = (self.units(), &self.report.units.length);
        let mut rows = vec![self.axis_head("rotation", &units.per_turn())];
        rows[0].extend([
            format!("reach [{length}]"),
            format!("deflection [{length}/rad]"),
            format!("mu_eq [{}]", units.per_length()),
            "farthest".to_owned(),
        ]);
        for (i, principal) in rotational.iter().enumerate() {
            let name = ranked("mu", i, rotational.len());
            let mut row = self.axis_row(name, principal.value, &principal.axis);
            row.extend([principal.reach, principal.deflection, principal.equivalent].map(digits));
            row.push(self.place(&principal.farthest_point, principal.farthest_corner));
            rows.push(row);
        }
        self.axis_table(page, rows, &["along", "pitch", "deflection"]);
    }

    fn axis_head(&self, name: &str, unit: &str) -> Vec<String> {
        let length = &self.report.units.length;
        vec![
            name.to_owned(),
            format!("stiffness [{unit}]"),
            "along".to_owned(),
            format!("through [{length}]"),
            format!("pitch [{length}]"),
        ]
    }

    fn axis_row(&self, name: String, value: f64, axis: &AxisReport) -> Vec<String> {
        let size = self.report.size;
        let (direction, point) = (spot(&axis.direction, 1.0), spot(&axis.axis_point, size));
        vec![name, digits(value), direction, point, beside(size, axis.pitch)]
    }

    /// A table without those columns that say nothing in the plane: there all rotations are about
    /// z, and no axis has a pitch.
    fn axis_table(&self, page: &mut Page, mut rows: Vec<Vec<String>>, of_space: &[&str]) {
        let named = |head: &String| of_space.iter().any(|name| head.starts_with(name));
        let idle: Vec<bool> = rows[0].iter().map(|head| self.planar() && named(head)).collect();
        for row in &mut rows {
            let mut idle = idle.iter();
            row.retain(|_| idle.next() == Some(&false));
        }
        page.line("");
        page.table(&rows);
    }
}

/// What repeated rotational stiffnesses mean for the table of rotations.
fn repeated(page: &mut Page, rotational: &[Rotational]) {
    if let Some(softest) = rotational.iter().find_map(|r| r.softest_direction.as_ref()) {
        page.line(format_args!(
            "degenerate: rotational stiffnesses are repeated, and the same about any axis between \
             theirs; reach, deflection and mu_eq are those of the softest such rotation, along {}",
            spot(softest, 1.0)
        ));
    }
}

/// The name of number `i` of `count` ascending values.
fn ranked(name: &str, i: usize, count: usize) -> String {
    match (i, count) {
        (_, 1) => name.to_owned(),
        (0, _) => format!("{name}_min"),
        _ if i + 1 == count => format!("{name}_max"),
        _ => name.to_owned(),
    }
}
