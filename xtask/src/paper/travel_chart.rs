//! Figure 6 and what is said about it.

use clench_draw::{
    Band, Chart, ChartAxis, ChartMark, Color, Curve, DrawError, Figure, GraspPicture, LineStyle,
    Tick, Veil, Way,
};

use super::figures::{CORNERS, fingers, outline};
use super::grasps::Paper;
use super::travel::{Sample, Travel};

/// The top of the chart: above `Q_V`, with room for a name.
const TOP: f64 = 2.1;

/// How far inside the outline the way of the finger is drawn, in parts of the distance of each
/// corner from the middle, and where on the last edge it ends.
const INSIDE: f64 = 0.17;
const LAST: f64 = 0.86;

/// Letters in a line of the page.
const PAGE_WIDTH: usize = 100;

impl Travel {
    /// The measures over the way of the finger.
    pub(crate) fn figure(&self, paper: &Paper) -> Result<Figure, DrawError> {
        let band = Band {
            label: "from Q/2 to Q: where Q_{pt} has to be".into(),
            color: Color::GREEN,
            pieces: self.pieces(|at| [at.way, at.bound() / 2.0, at.bound()]),
        };
        let veil = Veil { label: "the four fingers do not close".into(), spans: self.open() };
        let mut chart = Chart::new(self.axes()?).with_band(band)?.with_veil(veil)?;
        for curve in self.curves() {
            chart = chart.with_curve(curve)?;
        }
        for mark in self.marks() {
            chart = chart.with_mark(mark)?;
        }
        Ok(chart.with_part(&part(paper))?.figure())
    }

    fn curves(&self) -> [Curve; 3] {
        let curve = |label: &str, color, line, value: fn(&Sample) -> f64| Curve {
            label: label.into(),
            color,
            line,
            pieces: self.pieces(|at| [at.way, value(at)]),
        };
        let smaller = "Q, the smaller of σ_{min} and μ_{eq}";
        [
            curve(smaller, Color::BLUE, LineStyle::Plain, |at| at.quality),
            curve("Q_{V} = μ_{eq}, of rotations", Color::ORANGE, LineStyle::Broad, |at| {
                at.rotational
            }),
            curve("Q_{pt}, of the worst point", Color::GREEN, LineStyle::Plain, |at| at.worst),
        ]
    }

    fn marks(&self) -> [ChartMark; 2] {
        let mark = |at: &Sample, name: &str, value: f64, meaning: &str, color| ChartMark {
            point: [at.way, value],
            label: format!("{name} = {value:.4}"),
            meaning: meaning.into(),
            color,
        };
        let Self { paper, best, .. } = self;
        [
            mark(paper, "Q", paper.quality, "largest Q: finger 4 as in the paper", Color::BLUE),
            mark(best, "Q_{pt}", best.worst, "largest Q_{pt}", Color::GREEN),
        ]
    }

    fn axes(&self) -> Result<[ChartAxis; 2], DrawError> {
        let corners = self.corners();
        let length = corners.iter().copied().fold(0.0, f64::max);
        let names = CORNERS.into_iter().cycle();
        let ticks = corners.into_iter().zip(names);
        let ticks = ticks.map(|(at, name)| Tick { at, label: name.into() }).collect();
        let way = ChartAxis::new("place of finger 4 on its way round the outline", [0.0, length])?;
        let stiffness = ChartAxis::new("stiffness, that of each finger being 1", [0.0, TOP])?;
        Ok([way.with_ticks(ticks)?, stiffness])
    }

    /// One piece for each edge: the normal jumps at corners.
    fn pieces<T>(&self, point: impl Fn(&Sample) -> T) -> Vec<Vec<T>> {
        self.edges.iter().map(|samples| samples.iter().map(&point).collect()).collect()
    }

    /// The stretches without closure, joined at corners.
    fn open(&self) -> Vec<[f64; 2]> {
        let mut spans: Vec<[f64; 2]> = Vec::new();
        for pair in self.edges.iter().flat_map(|samples| samples.windows(2)) {
            let [from, to] = [pair[0], pair[1]];
            if from.closes || to.closes {
                continue;
            }
            match spans.last_mut() {
                Some(span) if span[1] >= from.way => span[1] = to.way,
                _ => spans.push([from.way, to.way]),
            }
        }
        spans
    }

    /// The section of the page.
    pub(crate) fn section(&self) -> String {
        let Self { paper, best, plateau: [from, to], .. } = self;
        let corners = self.corners();
        let (start, end) = (corners[self.paper_edge], corners[self.paper_edge + 1]);
        let name = |corner: usize| CORNERS[corner % CORNERS.len()];
        let [d, a] = [self.paper_edge, self.paper_edge + 1].map(name);
        let text = format!(
            "Fingers 1 to 3 of Figure 5 stay, finger 4 goes round the outline; where the curves \
             are faint, four fingers that only push cannot hold the part. Q is {:.4} on {:.2} of \
             the {:.2} from {d} to {a}: sigma_min limits it there, and no place among these is \
             better. Q_pt, the stiffness of the worst point, tells them apart: it is {:.4} where \
             the paper has finger 4, {:.2} from {d}, and largest, {:.4}, at {:.2} from {d}. It is \
             always between Q / 2 and Q.",
            paper.quality,
            to - from,
            end - start,
            paper.worst,
            paper.way - start,
            best.worst,
            best.way - start,
        );
        format!("{HEAD}{}\n", wrapped(&text))
    }
}

const HEAD: &str = "
## Beyond the paper: three measures as one finger moves

![Q, Q_V and Q_pt over the way of the fourth finger](figure-6.svg)

";

/// The words in lines as long as those of the page.
fn wrapped(text: &str) -> String {
    let mut lines = String::new();
    let mut length = 0;
    for word in text.split(' ') {
        if length > 0 && length + 1 + word.len() > PAGE_WIDTH {
            lines.push('\n');
            length = 0;
        } else if length > 0 {
            lines.push(' ');
            length += 1;
        }
        lines.push_str(word);
        length += word.len();
    }
    lines
}

/// The grasp of the paper with the way of the last finger.
fn part(paper: &Paper) -> GraspPicture {
    let picture = outline(paper);
    let count = picture.outline.len() as f64;
    let middle =
        [0, 1].map(|i| picture.outline.iter().map(|corner| corner[i]).sum::<f64>() / count);
    let toward = |from: [f64; 2], to: [f64; 2], share: f64| {
        [0, 1].map(|i| from[i] + share * (to[i] - from[i]))
    };
    let mut points: Vec<_> =
        picture.outline.iter().map(|&corner| toward(corner, middle, INSIDE)).collect();
    if let [first, .., last] = points[..] {
        points.push(toward(last, first, LAST));
    }
    GraspPicture {
        fingers: fingers(&paper.four.best),
        ways: vec![Way { points, color: Color::GREY }],
        ..picture
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_fingers_close_on_two_edges_only() {
        let travel = Travel::compute(&Paper::compute().unwrap()).unwrap();
        // On AB three normals are parallel; on BC two are, and nothing pushes to the right.
        assert_eq!(travel.open(), [[0.0, travel.corners()[2]]]);
    }

    #[test]
    fn the_section_has_the_numbers_of_the_chart() {
        let paper = Paper::compute().unwrap();
        let travel = Travel::compute(&paper).unwrap();
        let svg = travel.figure(&paper).unwrap().to_svg();
        let section = travel.section();
        for value in [travel.paper.quality, travel.best.worst] {
            let digits = format!("{value:.4}");
            assert!(svg.contains(&digits) && section.contains(&digits), "{digits}");
        }
    }
}
