//! The entities of a DXF file, and the blocks that they are gathered in.

use std::collections::HashMap;

use kurbo::Point;

use super::pairs::Record;
use crate::error::DrawingError;

/// An entity, with the records that belong to it: the vertices of a polyline.
#[derive(Clone, Debug)]
pub(super) struct Entity<'a> {
    pub(super) record: &'a Record<'a>,
    pub(super) parts: &'a [Record<'a>],
}

/// Entities with a name, which may be put into the drawing anywhere and often.
#[derive(Debug)]
pub(super) struct Block<'a> {
    pub(super) name: &'a str,
    /// The point that comes to the place of the block.
    pub(super) base: Point,
    pub(super) entities: Vec<Entity<'a>>,
}

/// All blocks of a file.
#[derive(Debug)]
pub(super) struct Blocks<'a>(HashMap<String, Block<'a>>);

impl<'a> Blocks<'a> {
    pub(super) fn of(records: &'a [Record<'a>]) -> Result<Self, DrawingError> {
        let mut blocks = HashMap::new();
        let mut rest = section(records, "BLOCKS");
        while let Some(start) = rest.iter().position(|record| record.kind == "BLOCK") {
            let inside = &rest[start + 1..];
            let end = inside.iter().position(|record| record.kind == "ENDBLK");
            let (inside, after) = inside.split_at(end.unwrap_or(inside.len()));
            let record = &rest[start];
            let name = record.text(2).unwrap_or("");
            let base = Point::new(record.number_or(10, 0.0)?, record.number_or(20, 0.0)?);
            let block = Block { name, base, entities: gathered(inside) };
            blocks.insert(name.to_ascii_uppercase(), block);
            rest = after;
        }
        Ok(Self(blocks))
    }

    pub(super) fn find(&self, name: &str) -> Option<&Block<'a>> {
        self.0.get(&name.to_ascii_uppercase())
    }
}

/// The entities of a section.
pub(super) fn entities<'a>(records: &'a [Record<'a>], name: &str) -> Vec<Entity<'a>> {
    gathered(section(records, name))
}

/// The records of a section, without its head and its end.
fn section<'a>(records: &'a [Record<'a>], name: &str) -> &'a [Record<'a>] {
    let is_head = |record: &Record<'_>| record.kind == "SECTION" && record.text(2) == Some(name);
    let Some(head) = records.iter().position(is_head) else { return &[] };
    let inside = &records[head + 1..];
    let end = inside.iter().position(|record| record.kind == "ENDSEC");
    &inside[..end.unwrap_or(inside.len())]
}

/// Each entity with what follows it up to the end of its sequence.
fn gathered<'a>(records: &'a [Record<'a>]) -> Vec<Entity<'a>> {
    let mut entities = Vec::new();
    let mut rest = records;
    while let [record, after @ ..] = rest {
        let belongs = |part: &Record<'_>| matches!(part.kind, "VERTEX" | "ATTRIB" | "SEQEND");
        let count = after.iter().take_while(|part| belongs(part)).count();
        let (parts, after) = after.split_at(count);
        entities.push(Entity { record, parts });
        rest = after;
    }
    entities
}
