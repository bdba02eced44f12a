//! From where a solid is looked at if the caller does not say.

use clench_screw::Vector;

use crate::solid::SolidPicture;
use crate::solid::hiding::{Screens, is_behind};
use crate::solid::scene::{PartFrame, Scene, flat};

/// The directions to choose from have these components in all orders and with all signs: none is
/// along an axis or a diagonal. The first are from the front, a little to the right and above.
const OBLIQUE: [[f64; 3]; 6] = [
    [3.0, 5.0, 2.5],
    [5.0, 3.0, 2.5],
    [2.5, 5.0, 3.0],
    [5.0, 2.5, 3.0],
    [3.0, 2.5, 5.0],
    [2.5, 3.0, 5.0],
];
const SIGNS: [[f64; 3]; 8] = [
    [1.0, -1.0, 1.0],
    [-1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
    [1.0, -1.0, -1.0],
    [-1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
];

/// A solid with more faces than this is a mesh, which has no view that shows many of them.
const MESH: usize = 60;

/// What counts, against a contact in sight counting 1: all faces turned to the viewer, all faces
/// seen as lines, looking from below, looking from where x goes left, looking rather from above
/// than from the side.
const ALL_FACES: f64 = 5.0;
const ALL_EDGE_ON: f64 = -3.0;
const FROM_BELOW: f64 = -2.2;
const FROM_BACK: f64 = -0.7;
const FROM_ABOVE: f64 = -0.4;

/// What a direction counts that is seen nearly along itself: of a finger, of another thing.
const FINGER_END_ON: f64 = -0.6;
const END_ON: f64 = -0.3;

/// What two fingers count that fall onto one another, or a finger and a mark; when they do; and
/// where fingers have their middle: both in parts of the size.
const PILED: f64 = -0.5;
const PILED_WITHIN: f64 = 0.08;
const FINGER_MIDDLE: f64 = 0.05;

/// The cosine to the line of sight from which on a direction is seen along itself, and the one
/// below which a face is seen as a line.
const ALONG_SIGHT: f64 = 0.9;
const ACROSS_SIGHT: f64 = 0.12;

/// A view has to be better by this to be chosen over an earlier one: rounding must not decide.
const BETTER: f64 = 1e-3;

/// The unit direction towards the viewer.
pub(crate) fn eye(picture: &SolidPicture, frame: PartFrame) -> Vector<3> {
    let first = unit(OBLIQUE[0], SIGNS[0]);
    if let Some(view) = picture.view {
        return Vector::new(view).direction().unwrap_or(first);
    }
    let mut best = (f64::NEG_INFINITY, first);
    for sizes in OBLIQUE {
        for signs in SIGNS {
            let eye = unit(sizes, signs);
            let worth = worth(picture, &Scene::new(picture, frame, eye), eye);
            if worth > best.0 + BETTER {
                best = (worth, eye);
            }
        }
    }
    best.1
}

fn unit(sizes: [f64; 3], signs: [f64; 3]) -> Vector<3> {
    let along = Vector::from_fn(|i| sizes[i] * signs[i]);
    along * along.norm().recip()
}

fn worth(picture: &SolidPicture, scene: &Scene, eye: Vector<3>) -> f64 {
    let mut worth = if eye[2] < 0.0 { FROM_BELOW } else { 0.0 };
    worth += if eye[1] > 0.0 { FROM_BACK } else { 0.0 };
    if eye[2].abs() > eye[0].abs().max(eye[1].abs()) {
        worth += FROM_ABOVE;
    }
    if scene.faces.len() <= MESH {
        for face in &scene.faces {
            let count = if face.normal[2].abs() < ACROSS_SIGHT {
                ALL_EDGE_ON
            } else if face.is_front() {
                ALL_FACES
            } else {
                0.0
            };
            worth += count / scene.faces.len() as f64;
        }
    }
    let end_on = |along: [f64; 3]| scene.direction(along)[2].abs() > ALONG_SIGHT;
    let others = picture.axes.iter().map(|axis| axis.direction);
    let others = others.chain(picture.worst_point.iter().map(|worst| worst.direction));
    worth += END_ON * others.filter(|&along| end_on(along)).count() as f64;
    worth + fingers_worth(picture, scene, &end_on)
}

fn fingers_worth(picture: &SolidPicture, scene: &Scene, end_on: &impl Fn([f64; 3]) -> bool) -> f64 {
    let screens = Screens::of_part(scene);
    let mut worth = 0.0;
    let marks = picture.center.iter().map(|center| center.point);
    let marks = marks.chain(picture.worst_point.iter().map(|worst| worst.point));
    let mut places: Vec<_> = marks.map(|point| flat(scene.point(point))).collect();
    for finger in &picture.fingers {
        let tip = scene.point(finger.point);
        let inward = scene.direction(finger.inward_normal);
        if !is_behind(&screens, tip, inward) {
            worth += 1.0;
        }
        if end_on(finger.inward_normal) {
            worth += FINGER_END_ON;
        }
        let [x, y] = flat(tip - inward * FINGER_MIDDLE);
        let piled = places.iter().filter(|[u, v]| (x - u).hypot(y - v) < PILED_WITHIN).count();
        worth += PILED * piled as f64;
        places.push([x, y]);
    }
    worth
}
