//! The text of a file, or of standard input.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use crate::failure::Failure;

/// The name that stands for standard input.
const STANDARD_INPUT: &str = "-";

/// The size of the largest file, as that of a drawing: the tree of its values takes up to eighty
/// times as much memory.
const LARGEST_FILE: u64 = 1 << 25;

/// The name and the text of a file, without a byte-order mark.
pub(super) fn text_of(path: &Path) -> Result<(String, String), Failure> {
    let (name, bytes) = if path == Path::new(STANDARD_INPUT) {
        ("standard input".to_owned(), limited(io::stdin().lock()))
    } else {
        (path.display().to_string(), File::open(path).and_then(limited))
    };
    let bytes = bytes.map_err(|source| Failure::Unreadable { name: name.clone(), source })?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(Failure::TooLarge { name, most: LARGEST_FILE });
    }
    let text = String::from_utf8(bytes).map_err(|e| Failure::NotText {
        name: name.clone(),
        offset: e.utf8_error().valid_up_to(),
    })?;
    let text = text.strip_prefix('\u{feff}').map_or_else(|| text.clone(), str::to_owned);
    Ok((name, text))
}

/// All bytes, or one more than are allowed: pipes and devices do not say how many they have.
fn limited(source: impl Read) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    source.take(LARGEST_FILE + 1).read_to_end(&mut bytes)?;
    Ok(bytes)
}
