//! DXF files in text form.

mod blocks;
mod entity;
mod pairs;
mod tables;

use kurbo::Affine;

use self::blocks::{Blocks, Entity, entities};
use self::pairs::{Value, records};
use self::tables::{CONTINUOUS, Tables};
use crate::error::DrawingError;
use crate::sheet::{Sheet, Strand, is_one_of};
use crate::source::{Reason, Source};
use crate::unit::Unit;

/// What a binary file begins with.
const BINARY: &[u8] = b"AutoCAD Binary DXF";

/// The entities that a file may draw, those of its blocks counted each time.
const MOST_ENTITIES: usize = 100_000;

/// Blocks within blocks.
const DEEPEST: usize = 16;

/// The units of `$INSUNITS` in which no part is drawn.
const ASTRONOMICAL: [(u8, &str); 4] =
    [(17, "gigameters"), (18, "astronomical units"), (19, "light years"), (20, "parsecs")];

/// The curves of a file, on these layers only if any are named.
pub(super) fn read(bytes: &[u8], layers: &[&str]) -> Result<Sheet, DrawingError> {
    if bytes.starts_with(BINARY) {
        return Err(DrawingError::BinaryDxf);
    }
    if bytes.starts_with(b"AC10") {
        return Err(DrawingError::Dwg);
    }
    let text = text(bytes);
    let records = records(text.trim_start_matches('\u{feff}'))?;
    let tables = Tables::of(&records);
    let blocks = Blocks::of(&records)?;
    let mut reader = Reader {
        tables: &tables,
        blocks: &blocks,
        layers,
        sheet: Sheet::new(tables.unit.map_or(Ok(None), unit)?),
        within: Vec::new(),
        drawn: 0,
    };
    let frame = Frame { map: Affine::IDENTITY, layer: None, line_type: CONTINUOUS };
    for entity in entities(&records, "ENTITIES") {
        reader.entity(&entity, &frame)?;
    }
    Ok(reader.sheet)
}

/// The text of the bytes; what is no UTF-8 is from before it, and one letter per byte.
fn text(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.to_owned(),
        Err(_) => bytes.iter().copied().map(char::from).collect(),
    }
}

/// The unit that `$INSUNITS` names; none if it is left open, by 0.
fn unit(variable: Value<'_>) -> Result<Option<Unit>, DrawingError> {
    let number = variable.text.parse::<i64>().ok();
    let is = |known: u8| number == Some(i64::from(known));
    if is(0) {
        return Ok(None);
    }
    if let Some(unit) = Unit::all().find(|unit| is(unit.number())) {
        return Ok(Some(unit));
    }
    let named = ASTRONOMICAL.iter().find(|(known, _)| is(*known)).map(|(_, name)| *name);
    let (line, found) = (variable.line, variable.text.to_owned());
    Err(DrawingError::UnitNumber { line, found, named })
}

/// How a block is put into the drawing.
struct Frame<'a> {
    map: Affine,
    /// The layer of the block's place, which what is on layer 0 of the block takes.
    layer: Option<&'a str>,
    /// The line type of the block's place, for what is drawn by block.
    line_type: &'a str,
}

struct Reader<'a> {
    tables: &'a Tables<'a>,
    blocks: &'a Blocks<'a>,
    layers: &'a [&'a str],
    sheet: Sheet,
    /// The names of the blocks that the reader is in.
    within: Vec<&'a str>,
    drawn: usize,
}

impl<'a> Reader<'a> {
    fn entity(&mut self, entity: &Entity<'a>, frame: &Frame<'a>) -> Result<(), DrawingError> {
        self.drawn += 1;
        if self.drawn > MOST_ENTITIES {
            return Err(DrawingError::TooManyEntities { most: MOST_ENTITIES });
        }
        let record = entity.record;
        let own = record.text(8).unwrap_or("0");
        let layer = if own == "0" { frame.layer.unwrap_or(own) } else { own };
        self.sheet.know(layer);
        let aside = |sheet: &mut Sheet, reason| sheet.aside.note(record.kind, layer, reason);
        if record.kind == "INSERT" {
            return match self.place_hidden(entity, layer) {
                Some(reason) => {
                    aside(&mut self.sheet, reason);
                    Ok(())
                }
                None => self.insert(entity, layer, frame),
            };
        }
        match entity::curves(entity)? {
            None => aside(&mut self.sheet, Reason::NoCurve),
            Some(_) if !self.asked_for(layer) => aside(&mut self.sheet, Reason::OtherLayer),
            Some(curves) => match (self.hidden(entity, layer, frame), curves) {
                (Some(reason), _) => aside(&mut self.sheet, reason),
                (None, entity::Curves::OffPlane) => aside(&mut self.sheet, Reason::OffPlane),
                (None, entity::Curves::InPlane(curves)) => {
                    let curves = curves.iter().map(|curve| curve.mapped(frame.map)).collect();
                    self.sheet.strands.push(Strand { source: self.sheet.sources.len(), curves });
                    self.sheet.sources.push(Source {
                        kind: record.kind.to_owned(),
                        name: record.text(5).map(str::to_owned),
                        layer: layer.to_owned(),
                        line: record.line,
                    });
                }
            },
        }
        Ok(())
    }

    /// Why a block is not drawn at a place on this layer, if it is not: that the layer is off, or
    /// of a broken line, is of no matter to what is on others.
    fn place_hidden(&self, place: &Entity<'a>, layer: &str) -> Option<Reason> {
        hidden_itself(place).or_else(|| {
            let is_frozen = self.layers.is_empty() && self.tables.freezes(layer);
            is_frozen.then_some(Reason::Hidden)
        })
    }

    /// Why an entity on this layer that could be part of the outline is none, if it is none.
    fn hidden(&self, entity: &Entity<'a>, layer: &str, frame: &Frame<'a>) -> Option<Reason> {
        hidden_itself(entity).or_else(|| {
            if self.layers.is_empty() && self.tables.hides(layer) {
                return Some(Reason::Hidden);
            }
            let line_type = self.tables.line_type(entity.record.text(6), layer, frame.line_type);
            self.tables.is_broken(line_type).then_some(Reason::Broken)
        })
    }

    fn asked_for(&self, layer: &str) -> bool {
        self.layers.is_empty() || is_one_of(layer, self.layers)
    }

    /// Draws a block, as often as its place says.
    fn insert(
        &mut self,
        entity: &Entity<'a>,
        layer: &'a str,
        frame: &Frame<'a>,
    ) -> Result<(), DrawingError> {
        let record = entity.record;
        let name = record.text(2).unwrap_or("");
        let at = |name: &str| (name.to_owned(), record.line);
        let Some(block) = self.blocks.find(name) else {
            let (name, line) = at(name);
            return Err(DrawingError::NoSuchBlock { name, line });
        };
        if self.within.contains(&block.name) {
            let (name, line) = at(name);
            return Err(DrawingError::RecursiveBlock { name, line });
        }
        if self.within.len() >= DEEPEST {
            let (name, line) = at(name);
            return Err(DrawingError::BlockTooDeep { name, line, deepest: DEEPEST });
        }
        let Some(places) = entity::places(record, block.base)? else {
            self.sheet.aside.note(record.kind, layer, Reason::OffPlane);
            return Ok(());
        };
        let line_type = self.tables.line_type(record.text(6), layer, frame.line_type);
        self.within.push(block.name);
        for place in places {
            let frame = Frame { map: frame.map * place, layer: Some(layer), line_type };
            self.drawn += 1;
            if self.drawn > MOST_ENTITIES {
                return Err(DrawingError::TooManyEntities { most: MOST_ENTITIES });
            }
            for entity in &block.entities {
                self.entity(entity, &frame)?;
            }
        }
        self.within.pop();
        Ok(())
    }
}

/// Why an entity is not seen whatever its layer, if it is not.
fn hidden_itself(entity: &Entity<'_>) -> Option<Reason> {
    let record = entity.record;
    if record.flags(67) == 1 {
        Some(Reason::Paper)
    } else {
        (record.flags(60) == 1).then_some(Reason::Hidden)
    }
}
