//! Facts of a Rust file, read from its tokens: comments and strings cannot mislead them.

use std::str::FromStr;

use proc_macro2::{Delimiter, Group, Ident, TokenStream, TokenTree};

/// A number this small needs a name that says where it comes from.
const SMALL_NUMBER: f64 = 1e-4;
/// A number with this exponent does too, whatever stands in front.
const SMALL_EXPONENT: i32 = -5;

/// What the rules ask about a file.
#[derive(Debug, Default)]
pub(super) struct Facts {
    /// Every function with a body, in tests too.
    pub(super) functions: Vec<Function>,
    /// Small numbers and `EPSILON` outside constants and tests: line and text.
    pub(super) small_numbers: Vec<(usize, String)>,
    /// `unwrap` and the panicking macros outside tests: line and text.
    pub(super) hopes: Vec<(usize, String)>,
    /// Lines of `pub use ...::*`.
    pub(super) open_reexports: Vec<usize>,
}

/// A function with a body.
#[derive(Debug)]
pub(super) struct Function {
    /// Its name.
    pub(super) name: String,
    /// The line of `fn`.
    pub(super) line: usize,
    /// Lines from `fn` to the closing brace, both counted.
    pub(super) lines: usize,
    /// Lines between the braces.
    pub(super) body_lines: usize,
    /// The tokens of the body, one space apart.
    pub(super) body: String,
}

/// What holds for the tokens that are read.
#[derive(Debug, Clone, Copy, Default)]
struct Place {
    in_test: bool,
    in_constant: bool,
}

impl Facts {
    /// Reads a file; when it is not Rust, the line where that shows.
    pub(super) fn read(text: &str) -> Result<Self, usize> {
        let tokens = TokenStream::from_str(text).map_err(|error| error.span().start().line)?;
        let mut facts = Self::default();
        facts.walk(tokens, Place::default());
        Ok(facts)
    }

    /// Reads one level of brackets and, by recursion, those inside. An item ends at `;` or at its
    /// braces; a test attribute and a constant reach that far.
    fn walk(&mut self, tokens: TokenStream, mut outer: Place) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut place = outer;
        let mut rest = &*tokens;
        while let Some((first, after)) = rest.split_first() {
            let previous = tokens.len().checked_sub(rest.len() + 1).map(|index| &tokens[index]);
            rest = after;
            match first {
                TokenTree::Punct(mark) if mark.as_char() == '#' => {
                    if let Some(attribute) = Attribute::read(after) {
                        place.in_test |= attribute.is_test;
                        outer.in_test |= attribute.is_test && attribute.is_inner;
                        rest = &after[attribute.tokens..];
                    }
                }
                TokenTree::Punct(mark) if mark.as_char() == ';' => place = outer,
                TokenTree::Punct(mark) if mark.as_char() == '.' => self.note_unwrap(after, place),
                TokenTree::Literal(literal) if is_small(&literal.to_string()) => {
                    self.note_number(literal.span().start().line, &literal.to_string(), place);
                }
                TokenTree::Punct(_) | TokenTree::Literal(_) => {}
                TokenTree::Ident(word) => {
                    place.in_constant |= starts_constant(word, previous, after);
                    self.note_word(word, after, place);
                }
                TokenTree::Group(group) => {
                    self.walk(group.stream(), place);
                    if group.delimiter() == Delimiter::Brace && !place.in_constant {
                        place = outer;
                    }
                }
            }
        }
    }

    fn note_word(&mut self, word: &Ident, after: &[TokenTree], place: Place) {
        let line = word.span().start().line;
        match word.to_string().as_str() {
            "fn" => self.functions.extend(function(line, after)),
            "pub" if is_open_reexport(after) => self.open_reexports.push(line),
            "EPSILON" => self.note_number(line, "EPSILON", place),
            name @ ("panic" | "todo" | "unimplemented") if is_mark(after.first(), '!') => {
                self.note_hope(line, format!("{name}!"), place);
            }
            _ => {}
        }
    }

    fn note_unwrap(&mut self, after: &[TokenTree], place: Place) {
        if let [TokenTree::Ident(method), TokenTree::Group(arguments), ..] = after
            && method == "unwrap"
            && arguments.stream().is_empty()
        {
            self.note_hope(method.span().start().line, ".unwrap()".to_owned(), place);
        }
    }

    fn note_number(&mut self, line: usize, text: &str, place: Place) {
        if !place.in_test && !place.in_constant {
            self.small_numbers.push((line, text.to_owned()));
        }
    }

    fn note_hope(&mut self, line: usize, text: String, place: Place) {
        if !place.in_test {
            self.hopes.push((line, text));
        }
    }
}

/// An attribute after its `#`.
struct Attribute {
    /// How many tokens follow the `#`.
    tokens: usize,
    /// Whether it stands on all that surrounds it.
    is_inner: bool,
    /// Whether what it stands on is compiled for tests only.
    is_test: bool,
}

impl Attribute {
    fn read(after: &[TokenTree]) -> Option<Self> {
        let is_inner = is_mark(after.first(), '!');
        let before = usize::from(is_inner);
        let TokenTree::Group(group) = after.get(before)? else {
            return None;
        };
        let text = group.stream().to_string().replace(' ', "");
        let is_test = text == "cfg(test)" || text == "test";
        Some(Self { tokens: before + 1, is_inner, is_test })
    }
}

/// Whether `const` opens a constant: not a function, a block, a pointer, nor a generic parameter.
fn starts_constant(word: &Ident, previous: Option<&TokenTree>, after: &[TokenTree]) -> bool {
    let opens_item = !['<', ',', '*'].iter().any(|mark| is_mark(previous, *mark));
    let is_named = matches!(after, [TokenTree::Ident(_), colon, ..] if is_mark(Some(colon), ':'));
    word == "const" && opens_item && is_named
}

/// The function whose `fn` stands in `line`; nothing for a type, or a declaration without a body.
fn function(line: usize, after: &[TokenTree]) -> Option<Function> {
    let (TokenTree::Ident(name), signature) = after.split_first()? else {
        return None;
    };
    let body = signature.iter().take_while(|token| !is_mark(Some(token), ';')).find_map(braces)?;
    let (open, close) = (body.span_open().start().line, body.span_close().start().line);
    Some(Function {
        name: name.to_string(),
        line,
        lines: close - line + 1,
        body_lines: (close - open).saturating_sub(1),
        body: body.stream().to_string(),
    })
}

fn braces(token: &TokenTree) -> Option<&Group> {
    match token {
        TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => Some(group),
        _ => None,
    }
}

/// Whether `use ...::*;` follows, after an optional `(crate)`, at any depth of braces.
fn is_open_reexport(after: &[TokenTree]) -> bool {
    let restricted = usize::from(matches!(after.first(), Some(TokenTree::Group(_))));
    let [TokenTree::Ident(keyword), path @ ..] = &after[restricted..] else {
        return false;
    };
    let end = path.iter().position(|token| is_mark(Some(token), ';')).unwrap_or(path.len());
    keyword == "use" && path[..end].iter().any(has_star)
}

fn has_star(token: &TokenTree) -> bool {
    match token {
        TokenTree::Group(group) => group.stream().into_iter().any(|inner| has_star(&inner)),
        other => is_mark(Some(other), '*'),
    }
}

fn is_mark(token: Option<&TokenTree>, mark: char) -> bool {
    matches!(token, Some(TokenTree::Punct(punct)) if punct.as_char() == mark)
}

/// Whether a literal is a number so small that it must be a tolerance, or another magic number.
fn is_small(literal: &str) -> bool {
    let starts_as_number = literal.starts_with(|first: char| first.is_ascii_digit());
    if !starts_as_number || literal.starts_with("0x") {
        return false;
    }
    let plain = literal.replace('_', "").to_lowercase();
    let plain = plain.trim_end_matches("f64").trim_end_matches("f32");
    let exponent = plain.split_once('e').and_then(|(_, digits)| digits.parse::<i32>().ok());
    let value = plain.parse::<f64>().unwrap_or(f64::INFINITY);
    value != 0.0
        && (value < SMALL_NUMBER || exponent.is_some_and(|exponent| exponent <= SMALL_EXPONENT))
}

#[cfg(test)]
mod tests {
    use super::Facts;

    fn numbers(text: &str) -> Vec<(usize, String)> {
        Facts::read(text).unwrap().small_numbers
    }

    fn hopes(text: &str) -> Vec<(usize, String)> {
        Facts::read(text).unwrap().hopes
    }

    #[test]
    fn a_small_number_is_found_however_it_is_written() {
        for number in ["1e-9", "2.5E-5", "1e-12_f64", "0.000_01", "0.00001f32", "100e-6"] {
            let text = format!("fn f(x: f64) -> bool {{\n    x < {number}\n}}\n");
            assert_eq!(numbers(&text), [(2, number.to_owned())]);
        }
    }

    #[test]
    fn numbers_of_ordinary_size_and_zero_are_not_found() {
        let text = "fn f() { g(0.0, 0, 0.5, 1e-3, 1e5, 3, 0x1e, 0b1, 1e300, 0e-9, \"1e-9\") }";
        assert_eq!(numbers(text), []);
    }

    #[test]
    fn a_machine_epsilon_is_found() {
        let text = "fn f(x: f64) -> bool { x < 4.0 * f64::EPSILON }";
        assert_eq!(numbers(text), [(1, "EPSILON".to_owned())]);
    }

    #[test]
    fn a_small_number_inside_a_macro_is_found() {
        assert_eq!(numbers("fn f() { check!(x < 1e-9); }"), [(1, "1e-9".to_owned())]);
    }

    #[test]
    fn a_constant_may_be_small() {
        let text = "pub const A: f64 = 8.0 * f64::EPSILON;
            impl T { const B: [f64; 2] = { [1e-9, 1e-9] }; }";
        assert_eq!(numbers(text), []);
    }

    #[test]
    fn a_constant_ends_where_it_ends() {
        let after = "const A: f64 = 1.0;\nconst fn f() -> f64 { 1e-9 }";
        assert_eq!(numbers(after), [(2, "1e-9".to_owned())]);
        let parameter = "fn f<const N: usize, const M: usize>(a: *const f64) -> f64 { 1e-9 }";
        assert_eq!(numbers(parameter), [(1, "1e-9".to_owned())]);
    }

    #[test]
    fn a_test_may_be_small_and_what_follows_it_may_not() {
        let text = "#[cfg(test)]\nmod tests { fn f() { g(1e-9); } }\nfn h() { g(1e-8); }\n";
        assert_eq!(numbers(text), [(3, "1e-8".to_owned())]);
        let text = "#[cfg(test)]\nuse a::b;\nfn h() { g(1e-8); }\n";
        assert_eq!(numbers(text), [(3, "1e-8".to_owned())]);
        assert_eq!(numbers("#![cfg(test)]\nfn h() { g(1e-8); }\nfn i() { g(1e-8); }"), []);
    }

    #[test]
    fn other_configurations_are_no_tests() {
        let text = "#[cfg(not(test))]\nfn h() { g(1e-8); }\n";
        assert_eq!(numbers(text), [(2, "1e-8".to_owned())]);
    }

    #[test]
    fn hopes_are_found_in_code() {
        let text = "fn f() {\n x.unwrap();\n panic!(\"no\");\n todo!();\n unimplemented!()\n}";
        let expected = [(2, ".unwrap()"), (3, "panic!"), (4, "todo!"), (5, "unimplemented!")];
        assert_eq!(hopes(text), expected.map(|(line, text)| (line, text.to_owned())));
    }

    #[test]
    fn hopes_in_comments_strings_and_tests_are_not_found() {
        let text =
            "/// x.unwrap()\nfn f() { g(\".unwrap()\"); x.unwrap_or(1); h.panic; } // todo!()
            #[test]\nfn t() { x.unwrap(); }";
        assert_eq!(hopes(text), []);
    }

    #[test]
    fn open_reexports_are_found_at_any_depth() {
        let text = "pub use a::*;\nuse b::*;\npub(crate) use c::{d, e::*};\npub use f::{g, h};\n";
        assert_eq!(Facts::read(text).unwrap().open_reexports, [1, 3]);
    }

    #[test]
    fn a_function_is_measured_from_its_name_to_its_last_brace() {
        let text = "trait T { fn declared(&self); }\n\n\
            fn f(\n    x: fn(f64) -> f64,\n) {\n    a();\n\n    b();\n}\n";
        let functions = Facts::read(text).unwrap().functions;
        let [f] = functions.as_slice() else { panic!("{functions:?}") };
        assert_eq!((&*f.name, f.line, f.lines, f.body_lines), ("f", 3, 7, 3));
    }

    #[test]
    fn a_body_does_not_depend_on_spaces_and_comments() {
        let body = |text| Facts::read(text).unwrap().functions.remove(0).body;
        assert_eq!(body("fn f() { a(1,2); }"), body("fn g() {\n    // why\n    a( 1, 2 );\n}"));
    }

    #[test]
    fn a_file_that_is_not_rust_tells_where() {
        assert_eq!(Facts::read("fn f() {\n    g(]\n}").unwrap_err(), 2);
    }
}
