//! The lines of text STL files: facets, each of the same seven lines.

use super::super::fault::MeshFault;

/// What a line of a facet has: words, then so many numbers.
struct Expected {
    words: &'static [&'static str],
    numbers: usize,
    in_words: &'static str,
}

const VERTEX: Expected = Expected {
    words: &["vertex"],
    numbers: 3,
    in_words: "`vertex` and three finite numbers of single precision",
};

const FACET: [Expected; 7] = [
    Expected {
        words: &["facet", "normal"],
        numbers: 3,
        in_words: "`facet normal` and three finite numbers, or `endsolid`",
    },
    Expected { words: &["outer", "loop"], numbers: 0, in_words: "`outer loop`" },
    VERTEX,
    VERTEX,
    VERTEX,
    Expected { words: &["endloop"], numbers: 0, in_words: "`endloop`, as a facet is a triangle" },
    Expected { words: &["endfacet"], numbers: 0, in_words: "`endfacet`" },
];

/// Checks the lines of a file: facets one after the other, in one or more solids, the last of
/// which ends.
pub(super) fn check(text: &str) -> Result<(), MeshFault> {
    let mut next = 0;
    let mut last = (1, "");
    for (line, found) in (1..).zip(text.lines()).filter(|(_, line)| !line.trim().is_empty()) {
        last = (line, found);
        if next == 0 && is_around(found) {
            continue;
        }
        let expected = &FACET[next];
        if !expected.is(found) {
            let (found, expected) = (found.trim().to_owned(), expected.in_words.into());
            return Err(MeshFault::Line { line, found, expected });
        }
        next = (next + 1) % FACET.len();
    }
    let (line, found) = last;
    if next == 0 && begins(found, "endsolid") {
        return Ok(());
    }
    Err(MeshFault::CutOff { line, expected: FACET[next].in_words })
}

/// Whether a line starts or ends a solid.
pub(super) fn is_around(line: &str) -> bool {
    begins(line, "solid") || begins(line, "endsolid")
}

/// Whether this is the first word of a line, in upper or lower case.
pub(super) fn begins(line: &str, word: &str) -> bool {
    line.split_whitespace().next().is_some_and(|found| found.eq_ignore_ascii_case(word))
}

impl Expected {
    fn is(&self, line: &str) -> bool {
        let words: Vec<&str> = line.split_whitespace().collect();
        let Some((words, numbers)) = words.split_at_checked(self.words.len()) else { return false };
        let same = words.iter().zip(self.words).all(|(one, other)| one.eq_ignore_ascii_case(other));
        let is_finite = |word: &&str| word.parse().is_ok_and(f32::is_finite);
        same && numbers.len() == self.numbers && numbers.iter().all(is_finite)
    }
}
