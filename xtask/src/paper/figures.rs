//! Figures 1 to 5.

use clench::contact::Order;
use clench::optimize::Solution;
use clench::screw::{Cholesky, Mat, Vector};
use clench::shape::Edge;
use clench_draw::{
    Color, DrawError, EnergyEllipsoids, EnergySpace, Figure, Finger, GraspPicture, Mark, Region,
};

use super::grasps::Paper;

/// How far the strips of Figure 3 reach, across the whole quadrilateral.
const STRIP_LENGTH: f64 = 14.0;

/// A point inside the region S of Figure 3, for its name.
const IN_S: [f64; 2] = [4.6, 4.2];

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
    let form = |origin: Vector<2>| {
        let k = paper.figure_1.stiffness(origin, Order::First);
        let k = Mat::<3, 3>::from_fn(|i, j| k.entry(i, j));
        let form = match space {
            EnergySpace::Twist => k,
            EnergySpace::Wrench => Cholesky::new(&k).map_or(k, |factors| factors.inverse()),
        };
        *form.rows()
    };
    let (center, origin) = (paper.figure_1_principal.center(), Vector::ZERO);
    EnergyEllipsoids::new(space, form(center), form(origin)).figure()
}

/// The outline with its corners named.
fn outline(paper: &Paper) -> GraspPicture {
    GraspPicture {
        outline: paper.part.outline().corners().iter().map(|c| c.to_array()).collect(),
        corner_labels: ["A", "B", "C", "D"].map(String::from).to_vec(),
        ..GraspPicture::default()
    }
}

fn fingers(solution: &Solution) -> Vec<Finger> {
    let finger = |(i, p): (usize, &clench::optimize::Placement)| Finger {
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
    let edges = solution.placements.iter().map(|p| &paper.part.outline().edges()[p.edge]);
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
    solution: &Solution,
    title: &str,
    per_preload: &str,
) -> Result<Figure, DrawError> {
    let q = &solution.quality;
    let farthest = paper.part.outline().corners()[q.reach.corner];
    GraspPicture {
        title: Some(title.into()),
        fingers: fingers(solution),
        center: Some(Mark { point: solution.center().to_array(), label: String::new() }),
        farthest_corner: Some(farthest.to_array()),
        caption: vec![
            format!("σ_{{min}} = {:.4}", q.translational),
            format!("ρ_{{max}} = {:.4}", q.reach.distance),
            format!("μ_{{eq}}{per_preload} = {:.4}", q.equivalent),
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
