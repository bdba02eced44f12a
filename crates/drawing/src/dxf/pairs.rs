//! The text of a DXF file: pairs of a code and a value, gathered into records.

use crate::error::DrawingError;

/// Numbers beyond this are in no drawing, and products of three of them stay finite.
const LARGEST: f64 = 1e100;

/// A value with its code.
#[derive(Clone, Copy, Debug)]
struct Pair<'a> {
    code: i32,
    value: &'a str,
    line: usize,
}

/// The text of a value, and where it is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Value<'a> {
    pub(super) text: &'a str,
    pub(super) line: usize,
}

/// What begins with the code 0: a section, an entry of a table, an entity.
#[derive(Clone, Debug)]
pub(super) struct Record<'a> {
    pub(super) kind: &'a str,
    /// The line of its name, from 1.
    pub(super) line: usize,
    pairs: Vec<Pair<'a>>,
}

/// The records of a text, up to that of its end.
pub(super) fn records(text: &str) -> Result<Vec<Record<'_>>, DrawingError> {
    let mut lines = text.lines().zip(1..);
    let mut records: Vec<Record<'_>> = Vec::new();
    let mut last = 1;
    loop {
        let Some((code, line)) = lines.next() else {
            return Err(DrawingError::CutOff { line: last });
        };
        let Ok(code) = code.trim().parse::<i32>() else {
            return Err(DrawingError::GroupCode { line, found: code.trim().to_owned() });
        };
        let Some((value, line)) = lines.next() else {
            return Err(DrawingError::CutOff { line });
        };
        last = line;
        match (code, records.last_mut()) {
            (0, _) if value.trim() == "EOF" => return Ok(records),
            (0, _) => records.push(Record { kind: value.trim(), line, pairs: Vec::new() }),
            // Only comments may come before the first record.
            (999, _) => {}
            (_, Some(record)) => record.pairs.push(Pair { code, value, line }),
            (_, None) => {
                return Err(DrawingError::GroupCode { line: line - 1, found: value.to_owned() });
            }
        }
    }
}

impl<'a> Record<'a> {
    /// The first value with this code.
    pub(super) fn text(&self, code: i32) -> Option<&'a str> {
        self.pairs.iter().find(|pair| pair.code == code).map(|pair| pair.value.trim())
    }

    /// The value with this code that follows the value `name` with code 9.
    pub(super) fn variable(&self, name: &str, code: i32) -> Option<Value<'a>> {
        let mut pairs =
            self.pairs.iter().skip_while(|pair| pair.code != 9 || pair.value.trim() != name);
        let value = pairs.nth(1).filter(|pair| pair.code == code)?;
        Some(Value { text: value.value.trim(), line: value.line })
    }

    /// The number with this code, or another one if there is none.
    pub(super) fn number_or(&self, code: i32, default: f64) -> Result<f64, DrawingError> {
        Ok(self.number(code)?.unwrap_or(default))
    }

    /// The number with this code, which has to be there.
    pub(super) fn needed(&self, code: i32) -> Result<f64, DrawingError> {
        self.number(code)?.ok_or_else(|| DrawingError::MissingValue {
            kind: self.kind.to_owned(),
            line: self.line,
            code,
        })
    }

    /// The numbers with this code.
    pub(super) fn numbers(&self, code: i32) -> Result<Vec<f64>, DrawingError> {
        self.pairs.iter().filter(|pair| pair.code == code).map(Pair::number).collect()
    }

    /// The flags with this code: none if there are none, or no number.
    pub(super) fn flags(&self, code: i32) -> i64 {
        self.text(code).and_then(|text| text.parse().ok()).unwrap_or(0)
    }

    /// The values of those of `codes` that follow each one of the first of them, up to the next.
    pub(super) fn groups<const N: usize>(
        &self,
        codes: [i32; N],
    ) -> Result<Vec<[Option<f64>; N]>, DrawingError> {
        let mut groups: Vec<[Option<f64>; N]> = Vec::new();
        for pair in &self.pairs {
            let Some(i) = codes.iter().position(|code| *code == pair.code) else { continue };
            if i == 0 {
                groups.push([None; N]);
            }
            if let Some(group) = groups.last_mut() {
                group[i] = Some(pair.number()?);
            }
        }
        Ok(groups)
    }

    fn number(&self, code: i32) -> Result<Option<f64>, DrawingError> {
        self.pairs.iter().find(|pair| pair.code == code).map(Pair::number).transpose()
    }
}

impl Pair<'_> {
    fn number(&self) -> Result<f64, DrawingError> {
        let number = self.value.trim().parse().ok();
        number.filter(|number: &f64| number.abs() <= LARGEST).ok_or_else(|| {
            let (line, found) = (self.line, self.value.trim().to_owned());
            DrawingError::NotANumber { line, found }
        })
    }
}
