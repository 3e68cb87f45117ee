//! Names of fields and variants in a file.

use syn::{Attribute, ExprPath, Ident, LitStr, Result, Token};

/// Units with capitals: in lower case, and with their capitals.
const CAPITAL_UNITS: [(&str, &str); 4] = [("n", "N"), ("pa", "Pa"), ("w", "W"), ("hz", "Hz")];

/// Names and conditions from a field's serde attributes.
#[derive(Default)]
pub struct SerdeNames {
    /// Its name in a file.
    pub rename: Option<String>,
    /// Function that returns whether the field is omitted on writing.
    pub skip_if: Option<ExprPath>,
    /// Whether the field is not part of a file.
    pub absent: bool,
    /// `Some` if the field has a default, with the function that returns it.
    pub default: Option<Option<ExprPath>>,
}

impl SerdeNames {
    pub fn of(attributes: &[Attribute]) -> Result<Self> {
        let mut found = Self::default();
        for attribute in attributes.iter().filter(|attribute| attribute.path().is_ident("serde")) {
            attribute.parse_nested_meta(|meta| {
                found.absent |= meta.path.is_ident("skip");
                let value: Option<LitStr> = meta.input.peek(Token![=]).then(|| meta.value()?.parse()).transpose()?;
                if meta.path.is_ident("rename") {
                    found.rename = value.as_ref().map(LitStr::value);
                }
                if meta.path.is_ident("skip_serializing_if") {
                    found.skip_if = value.as_ref().map(LitStr::parse).transpose()?;
                }
                if meta.path.is_ident("default") {
                    found.default = Some(value.as_ref().map(LitStr::parse).transpose()?);
                }
                Ok(())
            })?;
        }
        Ok(found)
    }

    /// Returns the name of the field in a file.
    pub fn in_files(&self, ident: &Ident) -> String {
        self.rename.clone().unwrap_or_else(|| ident.to_string())
    }
}

/// Returns the name of a field in a file, with the capitals of its units.
pub fn name_in_files(name: &str) -> String {
    let capital = |part| CAPITAL_UNITS.iter().find(|(lower, _)| *lower == part).map_or(part, |(_, unit)| *unit);
    name.split('_').map(capital).collect::<Vec<_>>().join("_")
}

/// Returns the name of a variant in a file: snake case, by serde's rule.
pub fn snake_case(variant: &str) -> String {
    let mut name = String::new();
    for (at, letter) in variant.char_indices() {
        if letter.is_uppercase() && at > 0 {
            name.push('_');
        }
        name.push(letter.to_ascii_lowercase());
    }
    name
}
