//! A solid as the viewer of a page gets it: in radii of the part about its middle, so that neither
//! its size nor its place costs digits.

use std::collections::BTreeMap;

use clench_draw::{SolidAxis, SolidFace, SolidFinger, SolidLoad, SolidMark, SolidPicture};
use serde::Serialize;

use crate::report::UnitNames;

/// What the viewer draws.
#[derive(Debug, Serialize)]
pub(crate) struct Scene {
    /// Three coordinates of each vertex.
    positions: Vec<f32>,
    /// Three vertices of each triangle.
    triangles: Vec<u32>,
    fingers: Vec<FingerScene>,
    axes: Vec<AxisScene>,
    #[serde(skip_serializing_if = "Option::is_none")]
    center: Option<MarkScene>,
    #[serde(skip_serializing_if = "Option::is_none")]
    worst: Option<ArrowScene>,
    cases: Vec<CaseScene>,
    /// Towards the viewer.
    view: [f32; 3],
}

#[derive(Debug, Serialize)]
struct FingerScene {
    point: [f32; 3],
    normal: [f32; 3],
    /// 0 for a pointed tip.
    radius: f32,
    label: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    force: Option<String>,
    /// Of the largest force.
    push: f32,
    fixed: bool,
}

#[derive(Debug, Serialize)]
struct AxisScene {
    point: [f32; 3],
    direction: [f32; 3],
    label: String,
    strong: bool,
}

#[derive(Debug, Serialize)]
struct MarkScene {
    point: [f32; 3],
    label: String,
}

#[derive(Debug, Serialize)]
struct ArrowScene {
    point: [f32; 3],
    direction: [f32; 3],
    label: String,
}

/// A load case: the motion of the part as it is drawn, about the middle.
#[derive(Debug, Default, Serialize)]
struct CaseScene {
    translation: [f32; 3],
    rotation: [f32; 3],
    forces: Vec<ArrowScene>,
}

/// What a picture does not say of a finger.
#[derive(Clone, Debug)]
pub(super) struct Tip {
    /// (length)
    pub(super) radius: f64,
    /// In any unit.
    pub(super) force: f64,
    /// The force as it is written.
    pub(super) shown: Option<String>,
}

/// The middle and half the diagonal of the box around a part.
#[derive(Clone, Copy, Debug)]
pub(super) struct Frame {
    middle: [f64; 3],
    size: f64,
}

impl Tip {
    /// The tip with its force written beside it.
    pub(super) fn with_value(self, units: UnitNames<'_>) -> Self {
        let shown = (self.force > 0.0).then(|| units.force(self.force));
        Self { shown, ..self }
    }
}

impl Frame {
    /// That of these faces.
    pub(super) fn around(faces: &[SolidFace]) -> Self {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for corner in faces.iter().flat_map(|face| face.triangles.as_flattened()) {
            for i in 0..3 {
                low[i] = low[i].min(corner[i]);
                high[i] = high[i].max(corner[i]);
            }
        }
        let half = [0, 1, 2].map(|i| high[i] / 2.0 - low[i] / 2.0);
        Self {
            middle: [0, 1, 2].map(|i| f64::midpoint(low[i], high[i])),
            size: half[0].hypot(half[1]).hypot(half[2]).max(f64::MIN_POSITIVE),
        }
    }

    fn point(&self, point: [f64; 3]) -> [f32; 3] {
        [0, 1, 2].map(|i| single((point[i] - self.middle[i]) / self.size))
    }

    fn length(&self, length: f64) -> f32 {
        single(length / self.size)
    }
}

impl Scene {
    /// The scene of a picture whose fingers have these tips, seen from a direction.
    pub(super) fn new(picture: &SolidPicture, tips: &[Tip], frame: Frame, view: [f64; 3]) -> Self {
        let (positions, triangles) = mesh(picture, frame);
        let most = tips.iter().map(|tip| tip.force).fold(0.0, f64::max);
        let finger = |(finger, tip): (&SolidFinger, &Tip)| FingerScene {
            point: frame.point(finger.point),
            normal: finger.inward_normal.map(single),
            radius: if tip.radius.is_finite() { frame.length(tip.radius.max(0.0)) } else { 0.0 },
            label: finger.label.clone(),
            force: tip.shown.clone(),
            push: if most > 0.0 { single(tip.force.max(0.0) / most) } else { 0.0 },
            fixed: finger.fixed,
        };
        let axis = |axis: &SolidAxis| AxisScene {
            point: frame.point(axis.point),
            direction: axis.direction.map(single),
            label: plain_label(&axis.label),
            strong: axis.emphasized,
        };
        let mark = |SolidMark { point, label }: &SolidMark| MarkScene {
            point: frame.point(*point),
            label: label.clone(),
        };
        Self {
            positions,
            triangles,
            fingers: picture.fingers.iter().zip(tips).map(finger).collect(),
            axes: picture.axes.iter().map(axis).collect(),
            center: picture.center.as_ref().map(mark),
            worst: picture.worst_point.as_ref().map(|worst| ArrowScene {
                point: frame.point(worst.point),
                direction: worst.direction.map(single),
                label: worst.label.clone(),
            }),
            cases: Vec::new(),
            view: view.map(single),
        }
    }

    /// Adds what a picture of the part under a load shows.
    pub(super) fn add_case(&mut self, picture: &SolidPicture, frame: Frame) {
        let force = |load: &SolidLoad| ArrowScene {
            point: frame.point(load.point),
            direction: load.along.map(single),
            label: load.label.clone(),
        };
        let forces = picture.loads.iter().map(force).collect();
        let Some(displaced) = &picture.displaced else {
            self.cases.push(CaseScene { forces, ..CaseScene::default() });
            return;
        };
        let times = displaced.exaggeration;
        let middle = displaced.displacement_at(frame.middle);
        self.cases.push(CaseScene {
            translation: middle.map(|moved| single(times * (moved / frame.size))),
            rotation: displaced.rotation.map(|turn| single(times * turn)),
            forces,
        });
    }

    /// The scene as JSON that no text of a file can break out of.
    pub(crate) fn json(&self) -> Result<String, serde_json::Error> {
        // In a script a browser looks for nothing but its end and comments, which begin so.
        Ok(serde_json::to_string(self)?.replace('<', "\\u003c"))
    }
}

/// The vertices of the faces' triangles, each once, and the triangles by their numbers.
fn mesh(picture: &SolidPicture, frame: Frame) -> (Vec<f32>, Vec<u32>) {
    let (mut positions, mut triangles) = (Vec::new(), Vec::new());
    let mut numbers = BTreeMap::new();
    for &corner in picture.faces.iter().flat_map(|face| face.triangles.as_flattened()) {
        let next = u32::try_from(numbers.len()).unwrap_or(u32::MAX);
        let number = *numbers.entry(corner.map(f64::to_bits)).or_insert_with(|| {
            positions.extend(frame.point(corner));
            next
        });
        triangles.push(number);
    }
    (positions, triangles)
}

/// `μ_{1}` with an index that needs no markup.
fn plain_label(label: &str) -> String {
    let indices = [("_{1}", "₁"), ("_{2}", "₂"), ("_{3}", "₃")];
    indices.iter().fold(label.to_owned(), |label, (set, plain)| label.replace(set, plain))
}

/// What a screen shows of a number, zero without a sign.
#[expect(clippy::cast_possible_truncation, reason = "a screen has thousands of pixels")]
fn single(value: f64) -> f32 {
    value as f32 + 0.0
}
