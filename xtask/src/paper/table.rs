//! Printed numbers against computed ones.

use std::fmt::Write;

use clench::metrics::LimitedBy;
use clench::optimize::Solution;

use super::grasps::Paper;

/// One number, or one statement, of the paper.
#[derive(Debug)]
pub(crate) struct Row {
    place: &'static str,
    quantity: &'static str,
    printed: &'static str,
    computed: Computed,
}

#[derive(Debug)]
enum Computed {
    Number(f64),
    Words(String),
}

impl Row {
    const fn number(
        place: &'static str,
        quantity: &'static str,
        printed: &'static str,
        computed: f64,
    ) -> Self {
        Self { place, quantity, printed, computed: Computed::Number(computed) }
    }

    const fn words(
        place: &'static str,
        quantity: &'static str,
        printed: &'static str,
        computed: String,
    ) -> Self {
        Self { place, quantity, printed, computed: Computed::Words(computed) }
    }

    /// Whether the computed number, rounded to the printed digits, is the printed one.
    pub(crate) fn agrees(&self) -> bool {
        match &self.computed {
            Computed::Number(x) => {
                let decimals = self.printed.split_once('.').map_or(0, |(_, tail)| tail.len());
                format!("{x:.decimals$}") == self.printed
            }
            Computed::Words(words) => words == self.printed,
        }
    }
}

/// Every number that the paper prints for its quadrilateral.
pub(crate) fn rows(paper: &Paper) -> Vec<Row> {
    let circle = paper.part.outline().enclosing_circle();
    let center = paper.figure_1.center();
    let [one, two] = &paper.triplets;
    let best = &paper.four.best;
    let limit = match best.quality.limited_by {
        LimitedBy::Translation => "sigma_min",
        LimitedBy::Rotation => "mu_eq",
    };
    vec![
        Row::number("Figure 1", "center of compliance, x", "6.15", center[0]),
        Row::number("Figure 1", "center of compliance, y", "5.54", center[1]),
        Row::number("Example 5.1", "radius of the object", "6.7315", circle.radius),
        Row::number("Example 5.1", "geometric center, x", "6.5", circle.center[0]),
        Row::number("Example 5.1", "geometric center, y", "1.75", circle.center[1]),
        Row::number("Example 5.1, I", "sigma_min", "0.8609", one.quality.translational),
        Row::number("Example 5.1, I", "Q / f_T", "0.081", one.quality.equivalent()),
        Row::number("Example 5.1, II", "sigma_min", "1.2764", two.quality.translational),
        Row::number("Example 5.1, II", "Q / f_T", "0.0955", two.quality.equivalent()),
        Row::words("Example 5.1", "best triplet", "AB, BC, DA", names(&paper.three.best)),
        Row::number("Example 5.2", "Q = sigma_min", "1.684", best.quality.value),
        Row::number("Example 5.2", "mu_eq", "1.865", best.quality.equivalent()),
        Row::words("Example 5.2", "the smaller of the two", "sigma_min", limit.to_owned()),
    ]
}

/// The edges of a solution by the letters of their corners.
fn names(solution: &Solution<2, 1>) -> String {
    let letters = ["AB", "BC", "CD", "DA"];
    let edges: Vec<&str> = solution.touched().iter().map(|&edge| letters[edge]).collect();
    edges.join(", ")
}

/// The page of the numbers and the figures.
pub(crate) fn page(rows: &[Row]) -> String {
    let mut page = String::from(HEAD);
    for row in rows {
        let computed = match &row.computed {
            Computed::Number(x) => format!("{x:.9}"),
            Computed::Words(words) => words.clone(),
        };
        let agrees = if row.agrees() { "yes" } else { "NO" };
        let Row { place, quantity, printed, .. } = row;
        // Writing to a string does not fail.
        let _ = writeln!(page, "| {place} | {quantity} | {printed} | {computed} | {agrees} |");
    }
    page.push_str(FIGURES);
    page
}

const HEAD: &str = "\
# The paper's numbers and figures

Made by `cargo xtask paper`, which fails when a printed digit is missed; `cargo xtask ci` checks
that this page and its pictures are the ones it makes. The paper is Lin, Burdick and Rimon, *A
Quality Measure for Compliant Grasps*; the object is its quadrilateral A(0, 0) B(13, 0) C(9, 8)
D(2, 6), all stiffnesses are 1, the fingers are pointed.

| place | quantity | printed | computed | agrees |
| --- | --- | --- | --- | --- |
";

const FIGURES: &str = "
## Figure 1: displacements of unit energy

![Two ellipsoids that touch the same two planes](figure-1.svg)

The upright ellipsoid is written about the center of compliance, the slanted one about the origin.
Sections at equal height are equal, and both touch the planes at the square root of 2 / mu.

## Figure 2: wrenches of unit energy

![Two ellipsoids inside one cylinder](figure-2.svg)

The same grasp and frames. Both ellipsoids are inscribed in one cylinder and meet the vertical axis
in the same two points.

## Figure 3: where three normals can meet

![Three strips over the quadrilateral](figure-3.svg)

Each edge of the triplet faces a strip; a grasp exists for each point in all three.

## Figure 4: the best grasps on two triplets

![Grasp I](figure-4-I.svg) ![Grasp II](figure-4-II.svg)

In both the normals meet in the geometric center, as near as possible to the farthest corner.

## Figure 5: the best grasp by four fingers

![Four fingers on the quadrilateral](figure-5.svg)

The equivalent stiffness exceeds the translational one, so all placements on these edges with
mu_eq of at least 1.684 are as good; this one has the largest. Its fingers at corners are limits.
";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_number_agrees_when_it_rounds_to_the_printed_digits() {
        let row = |printed, x| Row::number("", "", printed, x).agrees();
        assert!(row("0.0955", 0.095_458) && row("6.5", 6.5) && row("1.684", 1.683_772));
        assert!(!row("0.0955", 0.095_44) && !row("6.5", 6.44) && !row("1.684", 1.684_6));
    }

    #[test]
    fn all_printed_numbers_are_reproduced() {
        let rows = rows(&Paper::compute().unwrap());
        assert_eq!(rows.len(), 13);
        assert!(rows.iter().all(Row::agrees), "{rows:#?}");
    }
}
