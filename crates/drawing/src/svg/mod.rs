//! SVG files.

mod path;
mod place;
mod shape;
mod style;

use std::collections::HashMap;

use kurbo::{Affine, Point};
use roxmltree::{Document, Node, ParsingOptions};

use self::place::{Size, length, page, transform, viewport};
use self::style::Style;
use crate::curve::Curve;
use crate::error::{DrawingError, XmlError};
use crate::sheet::{Sheet, Strand, is_one_of};
use crate::source::{Reason, Source};

/// The namespaces of SVG itself, and of the program that calls groups layers.
const SVG: &str = "http://www.w3.org/2000/svg";
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";
const XLINK: &str = "http://www.w3.org/1999/xlink";

/// The shapes that a file may draw, those that are used again counted each time.
const MOST_ELEMENTS: usize = 100_000;

/// Groups within groups.
const DEEPEST: usize = 64;

/// What the parser may make of a file.
const MOST_NODES: u32 = 2_000_000;

/// Coordinates beyond this are in no drawing, and products of three of them stay finite.
const LARGEST: f64 = 1e100;

/// The curves of a file, on these layers only if any are named; y counts upwards.
pub(super) fn read(bytes: &[u8], layers: &[&str]) -> Result<Sheet, DrawingError> {
    let text = std::str::from_utf8(bytes)
        .map_err(|e| DrawingError::NotText { offset: e.valid_up_to() })?;
    let options = ParsingOptions { allow_dtd: true, nodes_limit: MOST_NODES, ..Default::default() };
    let document =
        Document::parse_with_options(text, options).map_err(|e| DrawingError::Xml(XmlError(e)))?;
    let root = document.root_element();
    if root.tag_name().name() != "svg" {
        return Err(DrawingError::NotSvg { found: root.tag_name().name().to_owned() });
    }
    let lines = Lines::of(text);
    let (map, size, unit) = page(root, lines.at(root))?;
    let named = root.descendants().filter_map(|node| Some((node.attribute("id")?, node)));
    let mut reader = Reader {
        lines,
        names: named.collect(),
        layers,
        sheet: Sheet::new(unit),
        is_styled: false,
        drawn: 0,
    };
    for sheet in style::sheets(&document) {
        reader.sheet.aside.note(sheet, "", Reason::StyleSheet);
        reader.is_styled = true;
    }
    let state = State {
        map,
        size,
        layer: "",
        is_layer: false,
        style: Style::default().within(root),
        has_class: root.has_attribute("class"),
        depth: 0,
    };
    reader.children(root, &state)?;
    Ok(reader.sheet)
}

/// Where lines begin.
struct Lines(Vec<usize>);

impl Lines {
    fn of(text: &str) -> Self {
        Self(text.match_indices('\n').map(|(at, _)| at).collect())
    }

    /// The line of an element, from 1.
    fn at(&self, node: Node<'_, '_>) -> usize {
        let start = node.range().start;
        self.0.partition_point(|newline| *newline < start) + 1
    }
}

/// What an element has from those around it.
#[derive(Clone)]
struct State<'a> {
    map: Affine,
    /// What percentages are of.
    size: Size,
    layer: &'a str,
    /// Whether the layer is called so, and not only a group with a name.
    is_layer: bool,
    style: Style,
    /// Whether a style sheet could have more to say of it.
    has_class: bool,
    depth: usize,
}

struct Reader<'a, 'input> {
    lines: Lines,
    names: HashMap<&'a str, Node<'a, 'input>>,
    layers: &'a [&'a str],
    sheet: Sheet,
    /// Whether there is a style sheet.
    is_styled: bool,
    drawn: usize,
}

impl<'a, 'input> Reader<'a, 'input> {
    fn children(&mut self, node: Node<'a, 'input>, state: &State<'a>) -> Result<(), DrawingError> {
        let inside = |child: &Node<'_, '_>| {
            let space = child.tag_name().namespace();
            child.is_element() && space.is_none_or(|space| space == SVG)
        };
        node.children().filter(inside).try_for_each(|child| self.element(child, state))
    }

    fn element(&mut self, node: Node<'a, 'input>, state: &State<'a>) -> Result<(), DrawingError> {
        let line = self.lines.at(node);
        self.drawn += 1;
        if self.drawn > MOST_ELEMENTS {
            return Err(DrawingError::TooManyEntities { most: MOST_ELEMENTS });
        }
        if state.depth >= DEEPEST {
            return Err(DrawingError::TooDeep { line, deepest: DEEPEST });
        }
        let mut state = State { depth: state.depth + 1, ..state.clone() };
        state.map *= transform(node, line)?;
        state.style = state.style.within(node);
        state.has_class |= node.has_attribute("class");
        match node.tag_name().name() {
            "g" | "a" | "switch" => {
                state.enter(node);
                self.children(node, &state)
            }
            "svg" => {
                let size = state.size.inner(node, line)?;
                let at = Size::at(node, state.size, line)?;
                state.map *= Affine::translate(at) * viewport(node, size, line)?;
                state.size = size.of_view(node, line)?;
                self.children(node, &state)
            }
            "use" => self.again(node, &state),
            "path" | "rect" | "circle" | "ellipse" | "line" | "polyline" | "polygon" => {
                self.shape(node, &state)
            }
            // Neither drawn nor missed.
            "defs" | "symbol" | "clipPath" | "mask" | "pattern" | "marker" | "linearGradient"
            | "radialGradient" | "filter" | "metadata" | "title" | "desc" | "style" | "script"
            | "view" | "cursor" => Ok(()),
            other => {
                self.sheet.know(state.layer);
                self.sheet.aside.note(other, state.layer, Reason::NoCurve);
                Ok(())
            }
        }
    }

    fn shape(&mut self, node: Node<'a, 'input>, state: &State<'a>) -> Result<(), DrawingError> {
        let (kind, line) = (node.tag_name().name(), self.lines.at(node));
        let layer = state.layer;
        self.sheet.know(layer);
        let asked = self.layers.is_empty() || is_one_of(layer, self.layers);
        let reason = if asked { state.style.reason() } else { Some(Reason::OtherLayer) };
        if let Some(reason) = reason {
            self.sheet.aside.note(kind, layer, reason);
            return Ok(());
        }
        let strands = match kind {
            "path" => path::strands(node.attribute("d").unwrap_or(""), line)?,
            _ => shape::curves(node, state.size, line)?.into_iter().collect(),
        };
        if strands.is_empty() {
            self.sheet.aside.note(kind, layer, Reason::NoSize);
            return Ok(());
        }
        if self.is_styled && state.has_class {
            self.sheet.aside.note("class", layer, Reason::Class);
        }
        let source = self.sheet.sources.len();
        for curves in strands {
            let curves: Vec<Curve> = curves.iter().map(|curve| curve.mapped(state.map)).collect();
            let fits = |point: &Point| point.x.abs() <= LARGEST && point.y.abs() <= LARGEST;
            if !curves.iter().all(|curve| curve.samples().iter().all(fits)) {
                let kind = kind.to_owned();
                return Err(DrawingError::OutOfRange { kind, line });
            }
            self.sheet.strands.push(Strand { source, curves });
        }
        self.sheet.sources.push(Source {
            kind: kind.to_owned(),
            name: node.attribute("id").map(str::to_owned),
            layer: layer.to_owned(),
            line,
        });
        Ok(())
    }

    /// Draws what is elsewhere in the file.
    fn again(&mut self, node: Node<'a, 'input>, state: &State<'a>) -> Result<(), DrawingError> {
        let line = self.lines.at(node);
        let link = node.attribute("href").or_else(|| node.attribute((XLINK, "href")));
        let name = link.and_then(|link| link.strip_prefix('#'));
        let Some(&target) = name.and_then(|name| self.names.get(name)) else {
            let name = link.unwrap_or("").to_owned();
            return Err(DrawingError::NoSuchElement { name, line });
        };
        let mut state = state.clone();
        state.map *= Affine::translate(Size::at(node, state.size, line)?);
        if target.tag_name().name() != "symbol" {
            return self.element(target, &state);
        }
        let size = state.size.inner(node, line)?;
        state.map *= viewport(target, size, line)?;
        state.size = size.of_view(target, line)?;
        if state.depth >= DEEPEST {
            return Err(DrawingError::TooDeep { line, deepest: DEEPEST });
        }
        state.depth += 1;
        self.children(target, &state)
    }
}

impl<'a> State<'a> {
    /// Takes the name of a group, if it has one; within a layer that is called so, other groups
    /// are part of it.
    fn enter(&mut self, node: Node<'a, '_>) {
        let is_layer = node.attribute((INKSCAPE, "groupmode")) == Some("layer");
        if is_layer || !self.is_layer {
            let label = node.attribute((INKSCAPE, "label")).filter(|_| is_layer);
            self.layer = label.or_else(|| node.attribute("id")).unwrap_or(self.layer);
            self.is_layer |= is_layer;
        }
    }
}

/// The length in an attribute of an element, if it has it.
fn attribute(
    node: Node<'_, '_>,
    name: &str,
    whole: Option<f64>,
    line: usize,
) -> Result<Option<f64>, DrawingError> {
    node.attribute(name).map(|text| length(text, whole, line)).transpose()
}
