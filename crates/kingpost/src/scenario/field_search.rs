//! Search for the full path of a field, for errors about a field's name without its path.

use serde_json::Value;

/// Largest number of paths that are suggested: if more fields have the name, none is suggested.
const MOST_PLACES: usize = 3;

/// Returns the paths of the fields with this name, with or without its unit: `duration` finds
/// `simulation.duration_s`. Empty if there are too many.
pub(super) fn paths_of(whole: &Value, name: &str) -> Vec<String> {
    let mut found = Vec::new();
    if !name.is_empty() {
        collect(whole, name, "", &mut found);
    }
    if found.len() > MOST_PLACES { Vec::new() } else { found }
}

fn collect(value: &Value, name: &str, path: &str, found: &mut Vec<String>) {
    let Value::Object(fields) = value else { return };
    for (field, inside) in fields {
        let path = if path.is_empty() { field.clone() } else { format!("{path}.{field}") };
        let unit = field.strip_prefix(name);
        if unit.is_some_and(|unit| unit.is_empty() || unit.starts_with('_')) {
            found.push(path);
        } else {
            collect(inside, name, &path, found);
        }
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn a_name_without_its_path_finds_the_fields_that_have_it() {
        let whole = json!({"simulation": {"duration_s": 5.0, "step_s": 0.1}, "bodies": {"ship": {"mass_kg": 1.0}}});
        assert_eq!(paths_of(&whole, "duration_s"), ["simulation.duration_s"]);
        assert_eq!(paths_of(&whole, "mass"), ["bodies.ship.mass_kg"]);
        assert!(paths_of(&whole, "step_size").is_empty() && paths_of(&whole, "").is_empty());
    }

    #[test]
    fn a_name_of_many_fields_finds_none() {
        let bodies: Vec<_> = (0..4).map(|i| (format!("b{i}"), json!({"mass_kg": 1.0}))).collect();
        let whole = json!({"bodies": bodies.into_iter().collect::<serde_json::Map<_, _>>()});
        assert!(paths_of(&whole, "mass_kg").is_empty());
    }
}
