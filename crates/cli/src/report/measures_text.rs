//! The numbers of a grasp that holds the part, in words.

use super::analysis_text::AnalysisText;
use super::measures::{MetricsReport, Rotational};
use super::number::{INVISIBLE, spot};
use super::page::Page;
use super::words::OrderWord;
use crate::wording::digits;

/// The coordinates of twists in space.
const SPATIAL: [&str; 6] = ["x", "y", "z", "rot x", "rot y", "rot z"];

impl AnalysisText<'_> {
    /// The principal stiffnesses, their centers, and the quality where there is one.
    pub(super) fn metrics(&self, page: &mut Page) {
        let Some(metrics) = &self.report.metrics else { return };
        self.translations(page, metrics);
        for principal in &metrics.rotational {
            self.rotation(page, principal);
        }
        if let Some(center) = &metrics.center_of_compliance {
            page.row("center of compliance", self.spot(center), "");
        }
        if let Some(center) = &metrics.center {
            let meaning = "the center of compliance, if there is one";
            page.row("center", self.spot(center), meaning);
        }
        self.quality(page, metrics);
    }

    fn translations(&self, page: &mut Page, metrics: &MetricsReport) {
        let last = metrics.translational.len() - 1;
        for (i, principal) in metrics.translational.iter().enumerate() {
            let name = match i {
                0 => "sigma_min",
                _ if i == last => "sigma_max",
                _ => "sigma",
            };
            let along = along(&principal.direction);
            let meaning =
                if i == 0 { format!("least translational stiffness, {along}") } else { along };
            page.row(name, self.units().stiffness(principal.value), meaning);
        }
    }

    fn rotation(&self, page: &mut Page, principal: &Rotational) {
        let units = self.units();
        let meaning = if self.planar() {
            "rotational stiffness".to_owned()
        } else {
            let rounding = INVISIBLE * self.report.size;
            let pitch = if principal.pitch.abs() <= rounding { 0.0 } else { principal.pitch };
            format!(
                "rotational stiffness, about the axis {} through {}, pitch {}",
                along(&principal.direction),
                self.spot(&principal.axis_point),
                units.length(pitch)
            )
        };
        page.row("mu", units.torque(principal.value), meaning);
        if let Some(equivalent) = principal.equivalent {
            let meaning = "mu / reach^2: comparable to sigma_min";
            page.row("mu_eq", units.stiffness(equivalent), meaning);
        }
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
        let units = self.units();
        let twists =
            if self.planar() { "x, y, rotation" } else { "x, y, z, rotation about x, y, z" };
        page.line(format_args!(
            "stiffness matrix about the frame's origin, of ({twists}) [{}, {}, {} {}]",
            units.per_length(),
            units.0.force,
            units.0.force,
            units.0.length
        ));
        let cells = |row: &Vec<f64>| row.iter().map(|&value| digits(value)).collect::<Vec<_>>();
        let mut rows: Vec<_> = self.report.stiffness.iter().map(cells).collect();
        if !self.planar() {
            for (row, name) in rows.iter_mut().zip(self.wrenches()) {
                row.insert(0, name);
            }
            rows.insert(0, std::iter::once(String::new()).chain(self.twists()).collect());
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

    /// The names of the columns of a stiffness in space, with units.
    fn twists(&self) -> impl Iterator<Item = String> {
        let length = &self.report.units.length;
        let unit = move |i: usize| if i < 3 { length.0.as_str() } else { "rad" };
        SPATIAL.iter().enumerate().map(move |(i, name)| format!("{name} [{}]", unit(i)))
    }

    /// The names of its rows, with units.
    fn wrenches(&self) -> impl Iterator<Item = String> {
        let units = self.report.units;
        let name = move |i: usize| match i {
            0..3 => format!("force {} [{}]", SPATIAL[i], units.force),
            _ => format!("torque {} [{} {}]", SPATIAL[i - 3], units.force, units.length),
        };
        (0..6).map(name)
    }
}

fn along(direction: &[f64]) -> String {
    format!("along {}", spot(direction, 1.0))
}
