//! Figures 1 to 5.

use clench::optimize::Solution;
use clench::screw::{Frame, Vector};
use clench::shape::Edge;
use clench_draw::{
    Color, DrawError, EnergyEllipsoids, EnergySpace, Figure, Finger, GraspPicture, Mark, Region,
};

use super::grasps::Paper;

/// How far the strips of Figure 3 reach, across the whole quadrilateral.
const STRIP_LENGTH: f64 = 14.0;

/// A point inside the region S of Figure 3, for its name.
const IN_S: [f64; 2] = [4.6, 4.2];

/// The names of the corners.
pub(super) const CORNERS: [&str; 4] = ["A", "B", "C", "D"];

/// The figures with their file names.
pub(crate) fn all(paper: &Paper) -> Result<Vec<(&'static str, Figure)>, DrawError> {
    let [one, two] = &paper.triplets;
    Ok(vec![
        ("figure-1", energy(paper, EnergySpace::Twist)?),
        ("figure-2", energy(paper, EnergySpace::Wrench)?),
        ("figure-3", strips(paper)?),
        ("figure-4-I", grasp(paper, one, "Grasp I", "/f_{T}")?),
        ("figure-4-II", grasp(paper, two, "Grasp II", "/f_{T}")?),
        ("figure-5", grasp(paper, &paper.four.best, "The best four fingers", "")?),
    ])
}

fn energy(paper: &Paper, space: EnergySpace) -> Result<Figure, DrawError> {
    let axes = [([1.0, 0.0], [0.0]), ([0.0, 1.0], [0.0]), ([0.0, 0.0], [1.0])];
    let points = |origin: Vector<2>| {
        let principal = paper.figure_1.in_frame(&Frame::at(origin));
        axes.map(|(along, about)| match space {
            EnergySpace::Twist => {
                let q = principal.displacement_of_unit_energy(along.into(), about.into());
                [q.linear[0], q.linear[1], q.angular[0]]
            }
            EnergySpace::Wrench => {
                let w = principal.wrench_of_unit_energy(along.into(), about.into());
                [w.force[0], w.force[1], w.torque[0]]
            }
        })
    };
    let (center, origin) = (paper.figure_1.center(), Vector::ZERO);
    EnergyEllipsoids::new(space, points(center), points(origin)).figure()
}

/// The outline with its corners named.
pub(super) fn outline(paper: &Paper) -> GraspPicture {
    GraspPicture {
        outline: paper.part.outline().corners().iter().map(|c| c.to_array()).collect(),
        corner_labels: CORNERS.map(String::from).to_vec(),
        ..GraspPicture::default()
    }
}

pub(super) fn fingers(solution: &Solution<2, 1>) -> Vec<Finger> {
    let finger = |(i, p): (usize, &clench::optimize::Placement<2>)| Finger {
        point: p.point.to_array(),
        inward_normal: p.inward_normal.to_array(),
        label: (i + 1).to_string(),
        ..Finger::default()
    };
    solution.placements.iter().enumerate().map(finger).collect()
}

fn strips(paper: &Paper) -> Result<Figure, DrawError> {
    let solution = &paper.triplets[1];
    let colors = [Color::BLUE, Color::ORANGE, Color::GREEN];
    let edges = solution.placements.iter().map(|p| &paper.part.outline().edges()[p.on]);
    let regions = edges.zip(colors).map(|(edge, color)| Region { corners: strip(edge), color });
    GraspPicture {
        regions: regions.collect(),
        fingers: fingers(solution),
        center: Some(Mark { point: solution.center().to_array(), label: String::new() }),
        notes: vec![Mark { point: IN_S, label: "S".into() }],
        caption: vec![
            "shaded thrice: S, where the".into(),
            "normals of AB, BC and DA".into(),
            "can meet".into(),
        ],
        ..outline(paper)
    }
    .figure()
}

/// The points that an edge faces, up to a distance.
fn strip(edge: &Edge) -> Vec<[f64; 2]> {
    let reach = edge.inward_normal() * STRIP_LENGTH;
    let (a, b) = (edge.start(), edge.end());
    [a, b, b + reach, a + reach].map(Vector::to_array).to_vec()
}

fn grasp(
    paper: &Paper,
    solution: &Solution<2, 1>,
    title: &str,
    per_preload: &str,
) -> Result<Figure, DrawError> {
    let q = &solution.quality;
    let rotation = q.softest_rotation();
    GraspPicture {
        title: Some(title.into()),
        fingers: fingers(solution),
        center: Some(Mark { point: solution.center().to_array(), label: String::new() }),
        farthest_corner: Some(rotation.farthest.point.to_array()),
        caption: vec![
            format!("σ_{{min}} = {:.4}", q.translational),
            format!("ρ_{{max}} = {:.4}", rotation.reach),
            format!("μ_{{eq}}{per_preload} = {:.4}", rotation.value),
        ],
        ..outline(paper)
    }
    .figure()
}

#[cfg(test)]
mod tests {
    use clench::screw::planar;

    use super::*;

    #[test]
    fn strips_lie_on_the_inner_side_of_their_edge() {
        let paper = Paper::compute().unwrap();
        for edge in paper.part.outline().edges() {
            let corners = strip(edge);
            let inward = Vector::new(corners[3]) - Vector::new(corners[0]);
            assert!(planar::cross(edge.direction(), inward) > 0.0);
        }
    }

    #[test]
    fn all_figures_are_drawn() {
        let figures = all(&Paper::compute().unwrap()).unwrap();
        assert_eq!(figures.len(), 6);
        for (name, figure) in figures {
            assert!(figure.to_svg().contains("</svg>"), "{name}");
        }
    }
}
