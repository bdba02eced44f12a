//! TOML text as a tree of values.

use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

use super::fault::{Fault, Located};
use super::node::{Entry, Node, Value};

/// The tree of a TOML file.
pub(super) fn parse(text: &str) -> Result<Node, Located> {
    match DeTable::parse(text) {
        Ok(table) => Ok(Node { span: table.span(), value: fields(table.get_ref()) }),
        Err(error) => Err(Located {
            span: error.span().unwrap_or(0..text.len()),
            fault: Fault::Syntax { language: "TOML", message: error.message().to_owned() },
        }),
    }
}

fn fields(table: &DeTable<'_>) -> Value {
    let entry = |(key, value): (&Spanned<_>, &Spanned<DeValue<'_>>)| Entry {
        key: String::from(AsRef::<str>::as_ref(key.get_ref())),
        key_span: key.span(),
        node: node(value),
    };
    Value::Table(table.iter().map(entry).collect())
}

fn node(value: &Spanned<DeValue<'_>>) -> Node {
    let span = value.span();
    let value = match value.get_ref() {
        DeValue::String(text) => Value::Text(text.clone().into_owned()),
        DeValue::Integer(number) => Value::Number(integer(number)),
        DeValue::Float(number) => Value::Number(number.as_str().parse().unwrap_or(f64::NAN)),
        DeValue::Boolean(flag) => Value::Flag(*flag),
        DeValue::Datetime(_) => Value::Date,
        DeValue::Array(items) => Value::List(items.iter().map(node).collect()),
        DeValue::Table(table) => fields(table),
    };
    Node { value, span }
}

/// Decimal digits are read as a double at once: no number of them overflows.
fn integer(number: &DeInteger<'_>) -> f64 {
    if number.radix() == 10 {
        return number.as_str().parse().unwrap_or(f64::NAN);
    }
    #[expect(clippy::cast_precision_loss, reason = "numbers of a file are doubles")]
    i128::from_str_radix(number.as_str(), number.radix()).map_or(f64::NAN, |n| n as f64)
}
