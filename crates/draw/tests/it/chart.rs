//! Charts: where their points stand, what their keys say, what they refuse.

use clench_draw::{
    Band, Chart, ChartAxis, ChartMark, Color, Curve, DrawError, Input, LineStyle, Tick, Veil,
};

use crate::paper::grasp;
use crate::svg::{apart, assert_well_formed, labels};

/// Five units by two, with ticks at 0, 2 and 5 and at 0 and 2, in units of these lengths.
fn axes([x, y]: [f64; 2]) -> Result<[ChartAxis; 2], DrawError> {
    let ticks = |values: &[f64], unit: f64| {
        values.iter().map(|&at| Tick { at: at * unit, label: format!("{at}") }).collect()
    };
    Ok([
        ChartAxis::new("place", [0.0, 5.0 * x])?.with_ticks(ticks(&[0.0, 2.0, 5.0], x))?,
        ChartAxis::new("stiffness", [0.0, 2.0 * y])?.with_ticks(ticks(&[0.0, 2.0], y))?,
    ])
}

fn curve(label: &str, line: LineStyle, pieces: &[&[[f64; 2]]]) -> Curve {
    let pieces = pieces.iter().map(|piece| piece.to_vec()).collect();
    Curve { label: label.into(), color: Color::BLUE, line, pieces }
}

fn mark(point: [f64; 2], label: &str) -> ChartMark {
    let meaning = "the highest".into();
    ChartMark { point, label: label.into(), meaning, color: Color::BLUE }
}

/// A chart with everything that a chart can have, in units of these lengths.
pub(crate) fn chart([x, y]: [f64; 2]) -> Result<Chart, DrawError> {
    let at = |place: f64, value: f64| [place * x, value * y];
    let steps = [at(0.0, 0.5), at(2.0, 1.0)];
    let flat = [at(2.0, 1.5), at(5.0, 1.5)];
    let rise = [at(0.0, 0.25), at(5.0, 1.25)];
    let band = Band {
        label: "between".into(),
        color: Color::GREEN,
        pieces: vec![vec![[0.0, 0.25 * y, 0.5 * y], [2.0 * x, 0.5 * y, y]]],
    };
    Chart::new(axes([x, y])?)
        .titled("Title <&>")
        .with_band(band)?
        .with_curve(curve("jumps", LineStyle::Plain, &[&steps, &flat]))?
        .with_curve(curve("rises", LineStyle::Broad, &[&rise]))?
        .with_veil(Veil { label: "not here".into(), spans: vec![[0.0, 2.0 * x]] })?
        .with_mark(mark(at(2.0, 1.5), "first"))?
        .with_mark(mark(at(2.1, 1.5), "second"))?
        .with_mark(mark(at(5.0, 1.25), "last"))?
        .with_part(&grasp(1.0))
}

#[test]
fn a_chart_stands_where_a_ruler_puts_it() -> Result<(), DrawError> {
    // 580 by 340 for 5 by 2: 116 and 170 a unit, from the lower left corner at (0, 0).
    let svg = chart([1.0, 1.0])?.figure().to_svg();
    assert!(svg.contains("<path d=\"M0 -85L232 -170\" fill=\"none\" stroke=\"#0b4f8a\""), "{svg}");
    assert!(svg.contains("<path d=\"M232 -255L580 -255\""), "the second piece");
    assert!(svg.contains("<path d=\"M0 -42.5L232 -85L232 -170L0 -85Z\""), "the band");
    assert!(svg.contains("<path d=\"M0 0L232 0L232 -340L0 -340Z\""), "the veil");
    assert!(svg.contains("<path d=\"M232 0L232 -340\""), "the line of a tick");
    assert!(svg.contains("<circle cx=\"580\" cy=\"-212.5\""), "a mark");
    // The broad curve lies under the plain one, though it was added after it.
    let start = |path: &str| svg.find(path).expect("a curve");
    assert!(start("<path d=\"M0 -42.5L580 -212.5\"") < start("<path d=\"M0 -85L232 -170\""));
    // The veil lies over both.
    assert!(start("<path d=\"M0 -85L232 -170\"") < start("<path d=\"M0 0L232 0L232 -340"));
    Ok(())
}

#[test]
fn a_key_names_everything_once() -> Result<(), DrawError> {
    let svg = chart([1.0, 1.0])?.figure().to_svg();
    for name in ["jumps", "rises", "between", "not here", "place", "stiffness"] {
        assert_eq!(svg.matches(&format!(">{name}</text>")).count(), 1, "{name}");
    }
    assert_eq!(svg.matches(">the highest</text>").count(), 3, "one for each mark");
    let plain = Chart::new(axes([1.0, 1.0])?);
    let nameless = ChartMark { meaning: String::new(), ..mark([1.0, 1.0], "m") };
    assert!(plain.with_mark(nameless)?.figure().to_svg().contains(">m</text>"));
    Ok(())
}

#[test]
fn names_of_marks_cover_neither_one_another_nor_the_part() -> Result<(), DrawError> {
    let names = labels(&chart([1.0, 1.0])?.figure().to_svg());
    for mark in ["first", "second", "last"] {
        let (_, area) = names.iter().find(|(name, _)| name == mark).expect("the mark's name");
        for (other, taken) in names.iter().filter(|(name, _)| name != mark) {
            assert!(apart(*area, *taken), "{mark} {area:?} on {other} {taken:?}");
        }
        assert!(area[2] < 614.0, "{mark} reaches into the column: {area:?}");
    }
    Ok(())
}

#[test]
fn a_unit_of_either_axis_changes_no_byte() -> Result<(), DrawError> {
    let reference = chart([1.0, 1.0])?.figure().to_svg();
    let (small, large) = (2.0_f64.powi(-900), 2.0_f64.powi(900));
    for unit in [[small, large], [large, small]] {
        assert_eq!(chart(unit)?.figure().to_svg(), reference);
    }
    Ok(())
}

#[test]
fn an_axis_of_any_range_has_ticks_of_its_own() -> Result<(), DrawError> {
    let shown = |range: [f64; 2]| -> Result<String, DrawError> {
        let axes = [ChartAxis::new("x", [0.0, 1.0])?, ChartAxis::new("y", range)?];
        Ok(Chart::new(axes).figure().to_svg())
    };
    for value in [">−1</text>", ">−0.5</text>", ">0</text>", ">0.5</text>", ">1</text>"] {
        assert!(shown([-1.0, 1.0])?.contains(value), "{value}");
    }
    for range in [[0.0, 5e-324], [1e9, 1e9 + 1e-6], [-8e307, 8e307], [-1e-300, 0.0]] {
        assert_well_formed(&shown(range)?);
    }
    Ok(())
}

#[test]
fn an_axis_refuses_ranges_and_ticks_that_are_none() {
    let fault = |low: f64, high: f64| ChartAxis::new("x", [low, high]).err();
    let input = Input::AxisRange;
    let infinite = |index, value| Some(DrawError::NotFinite { input, index, value });
    assert_eq!(fault(f64::NEG_INFINITY, 0.0), infinite(0, f64::NEG_INFINITY));
    assert_eq!(fault(0.0, f64::INFINITY), infinite(1, f64::INFINITY));
    assert_eq!(fault(-1e308, 1e308), infinite(2, f64::INFINITY));
    let not_ascending = |low, high| Some(DrawError::NotAscending { input, index: 0, low, high });
    assert_eq!(fault(1.0, 1.0), not_ascending(1.0, 1.0));
    assert_eq!(fault(2.0, 1.0), not_ascending(2.0, 1.0));
    let ticked = |at: f64| {
        let ticks = [0.5, at].map(|at| Tick { at, label: "t".into() });
        ChartAxis::new("x", [0.0, 1.0]).and_then(|axis| axis.with_ticks(ticks.to_vec())).err()
    };
    let (input, index, low, high) = (Input::Tick, 1, 0.0, 1.0);
    let value = f64::INFINITY;
    assert_eq!(ticked(value), Some(DrawError::NotFinite { input, index, value }));
    let value = 1.5;
    assert_eq!(ticked(value), Some(DrawError::OutOfRange { input, index, value, low, high }));
    assert_eq!(ticked(1.0), None);
}

#[test]
fn a_chart_refuses_what_its_axes_do_not_show() -> Result<(), DrawError> {
    let chart = chart([1.0, 1.0])?;
    let out = |input, index, value, high| {
        Some(DrawError::OutOfRange { input, index, value, low: 0.0, high })
    };
    let with_curve = |pieces: &[&[[f64; 2]]]| {
        chart.clone().with_curve(curve("", LineStyle::Plain, pieces)).err()
    };
    let input = Input::Curve(2);
    let good: &[[f64; 2]] = &[[0.0, 0.0], [5.0, 2.0]];
    assert_eq!(with_curve(&[good]), None);
    assert_eq!(with_curve(&[good, &[[1.0, 1.0], [1.0, 2.5]]]), out(input, 3, 2.5, 2.0));
    assert_eq!(with_curve(&[&[[-1.0, 1.0], [1.0, 1.0]]]), out(input, 0, -1.0, 5.0));
    let value = f64::INFINITY;
    let infinite = DrawError::NotFinite { input, index: 1, value };
    assert_eq!(with_curve(&[&[[1.0, 1.0], [1.0, value]]]), Some(infinite));
    let few = DrawError::TooFewPoints { input, found: 1, needed: 2 };
    assert_eq!(with_curve(&[good, &[[1.0, 1.0]]]), Some(few));

    let with_band = |piece: &[[f64; 3]]| {
        let pieces = vec![piece.to_vec()];
        chart.clone().with_band(Band { label: String::new(), color: Color::INK, pieces }).err()
    };
    let input = Input::Band(1);
    let inside_out = DrawError::NotAscending { input, index: 1, low: 1.0, high: 0.5 };
    assert_eq!(with_band(&[[0.0, 1.0, 1.0], [1.0, 1.0, 0.5]]), Some(inside_out));
    assert_eq!(with_band(&[[0.0, -1.0, 1.0], [1.0, 1.0, 1.0]]), out(input, 0, -1.0, 2.0));
    assert_eq!(with_band(&[]), Some(DrawError::TooFewPoints { input, found: 0, needed: 2 }));

    let with_veil = |low: f64, high: f64| {
        chart.clone().with_veil(Veil { label: String::new(), spans: vec![[low, high]] }).err()
    };
    let input = Input::Veil(1);
    assert_eq!(with_veil(1.0, 6.0), out(input, 0, 6.0, 5.0));
    let empty = DrawError::NotAscending { input, index: 0, low: 1.0, high: 1.0 };
    assert_eq!(with_veil(1.0, 1.0), Some(empty));

    let marked = chart.clone().with_mark(mark([1.0, 3.0], "m")).err();
    assert_eq!(marked, out(Input::ChartMark, 3, 3.0, 2.0));
    let mut part = grasp(1.0);
    part.outline.clear();
    let few = DrawError::TooFewPoints { input: Input::Outline, found: 0, needed: 3 };
    assert_eq!(chart.with_part(&part).err(), Some(few));
    Ok(())
}
