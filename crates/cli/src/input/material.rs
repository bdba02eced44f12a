//! Names of materials, and the one that an unknown name may stand for.

use clench::contact::Material;

use super::fault::ContactFault;

/// The names of the known materials.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    Material::ALL.into_iter().map(|material| material.name)
}

/// The fault that no material is called `name`.
pub(super) fn unknown(name: &str) -> ContactFault {
    ContactFault::UnknownMaterial { found: name.to_owned(), nearest: nearest(name) }
}

/// The known name that differs least from `name`, if most of it is the same: case does not count.
fn nearest(name: &str) -> Option<&'static str> {
    let written: Vec<char> = name.to_lowercase().chars().collect();
    let longest = names().map(str::len).max().unwrap_or(0);
    // Whatever is twice as long as any name is none of them.
    if written.len() > 2 * longest {
        return None;
    }
    let (changes, nearest) = names().map(|known| (changes(&written, known), known)).min()?;
    (2 * changes < nearest.len()).then_some(nearest)
}

/// How many characters have to be put in, left out or replaced to get from one name to another.
fn changes(written: &[char], known: &str) -> usize {
    let mut row: Vec<usize> = (0..=written.len()).collect();
    for (i, letter) in known.chars().enumerate() {
        let mut before = std::mem::replace(&mut row[0], i + 1);
        for (j, &found) in written.iter().enumerate() {
            let replaced = before + usize::from(found != letter);
            before = row[j + 1];
            row[j + 1] = replaced.min(before + 1).min(row[j] + 1);
        }
    }
    row[written.len()]
}

#[cfg(test)]
mod tests {
    use super::nearest;

    #[test]
    fn a_name_that_is_nearly_right_is_recognized() {
        for (written, known) in [
            ("aluminium 6061", Some("aluminum 6061")),
            ("Steel", Some("steel")),
            ("tool-steel", Some("tool steel")),
            ("PTFE", Some("ptfe")),
            ("unobtainium", None),
            ("", None),
        ] {
            assert_eq!(nearest(written), known, "{written}");
        }
        assert_eq!(nearest(&"steel".repeat(1000)), None);
    }
}
