//! When runs may go side by side: everything but the numbers of the mechanics is the same.

use crate::elements::hull::Hull;
use crate::elements::of_kind;
use crate::simulation::Setup;

/// A setup without its real numbers, but with those that are no scalar: settings, the times and
/// histories of drives, and all of the water.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub(super) struct Structure {
    /// The setup as text, real numbers left out; names, kinds, indices and counts stand.
    shape: String,
    settings: String,
    histories: String,
    hulls: String,
}

impl Structure {
    pub(super) fn of(setup: &Setup) -> Self {
        let histories: Vec<_> = setup.elements.iter().map(|element| element.next_edge_s(0.0, &[])).collect();
        Self {
            shape: without_numbers(&format!("{setup:?}")),
            settings: format!("{:?}", setup.settings),
            histories: format!("{histories:?}"),
            hulls: format!("{:?}", of_kind::<f64, Hull>(&setup.elements).collect::<Vec<_>>()),
        }
    }
}

/// Leaves out what is written as a real number; whole numbers, and what stands in quotes, stay.
fn without_numbers(text: &str) -> String {
    let mut shape = String::with_capacity(text.len());
    let mut quoted = false;
    let mut rest = text;
    while let Some(c) = rest.chars().next() {
        let word = rest.len() - rest.trim_start_matches(is_part_of_a_word).len();
        if quoted || word == 0 {
            quoted ^= c == '"';
            shape.push(c);
            rest = &rest[c.len_utf8()..];
            continue;
        }
        if !is_real(&rest[..word]) {
            shape.push_str(&rest[..word]);
        }
        rest = &rest[word..];
    }
    shape
}

fn is_part_of_a_word(c: char) -> bool {
    c.is_alphanumeric() || matches!(c, '.' | '-' | '+' | '_')
}

/// How Rust writes an f64 for debugging: with a point or an exponent, or not a number.
fn is_real(word: &str) -> bool {
    word.parse::<f64>().is_ok() && word.parse::<i128>().is_err()
}

#[cfg(test)]
mod tests {
    use super::without_numbers;

    #[test]
    fn real_numbers_go_and_all_else_stays() {
        let text = r#"Node { name: "arm 1.5", parent: Some(1), mass: 2.5e-7, x: [-0.0, 1e20, inf], edges_m: 3 }"#;
        let shape = r#"Node { name: "arm 1.5", parent: Some(1), mass: , x: [, , ], edges_m: 3 }"#;
        assert_eq!(without_numbers(text), shape);
    }
}
