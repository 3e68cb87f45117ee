//! Names of parts: the names of their files, in the main file's folder or in the gallery, and of their fields
//! in the whole scenario.

/// Sections of a scenario whose entries have unique names in the whole scenario.
pub const SECTIONS: [&str; 8] = ["bodies", "loops", "forces", "drives", "sensors", "controllers", "wires", "limits"];

/// Prefix of the name of a file in the gallery.
pub const GALLERY: &str = "gallery:";

/// Extensions of part files; a name without one of them is in the gallery.
const ENDINGS: [&str; 3] = [".yaml", ".yml", ".json"];

/// Returns the name of the file of a part that the file `from` names: a bare name is in the gallery, any
/// other name is a path.
pub fn of_part(from: &str, part: &str) -> String {
    let is_path = part.contains(['/', '\\']) || ENDINGS.iter().any(|ending| part.ends_with(ending));
    if is_path { from_folder_of(from, part) } else { format!("{GALLERY}parts/{part}.yaml") }
}

/// Returns the name of the file that the file `from` names by a path relative to its own folder.
pub fn from_folder_of(from: &str, path: &str) -> String {
    if is_absolute(path) {
        return path.to_owned();
    }
    let (root, from) = match from {
        from if from.starts_with('/') => from.split_at(1),
        from if from.starts_with(GALLERY) => from.split_at(GALLERY.len()),
        from => ("", from),
    };
    let folder = from.rsplit_once('/').map_or("", |(folder, _)| folder);
    let mut segments: Vec<&str> = Vec::new();
    for segment in folder.split('/').chain(path.split('/')) {
        match (segment, segments.last()) {
            ("" | ".", _) => {}
            ("..", Some(&last)) if last != ".." => drop(segments.pop()),
            _ => segments.push(segment),
        }
    }
    format!("{root}{}", segments.join("/"))
}

/// Returns the name of a file for an error: its path relative to the folder of the main file.
pub fn beside(main: &str, file: &str) -> String {
    match main.rfind(['/', '\\']) {
        Some(end) if !is_absolute(file) => format!("{}{file}", &main[..=end]),
        _ => file.to_owned(),
    }
}

/// Returns the name of the main file as a part would write it.
pub fn of_main(main: &str) -> String {
    main.rsplit(['/', '\\']).next().unwrap_or_default().to_owned()
}

/// Returns whether a path is absolute: in the gallery, from the root, or on a drive `C:`.
fn is_absolute(path: &str) -> bool {
    path.starts_with('/') || path.starts_with(GALLERY) || path.as_bytes().get(1) == Some(&b':')
}

/// Returns the field of an error, as written in the part's file.
pub fn in_part(field: &str, prefix: &str) -> String {
    let own = |section: &str, rest: &str| {
        let named = SECTIONS.contains(&section).then(|| rest.strip_prefix(prefix)).flatten();
        named.map(|rest| format!("{section}.{rest}"))
    };
    field.split_once('.').and_then(|(section, rest)| own(section, rest)).unwrap_or_else(|| field.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bare_name_is_one_of_the_gallery_and_a_path_begins_at_the_file_that_names_it() {
        assert_eq!(of_part("ship.yaml", "crane"), "gallery:parts/crane.yaml");
        assert_eq!(of_part("ship.yaml", "crane.yaml"), "crane.yaml");
        assert_eq!(of_part("ship.yaml", "./cranes//crane"), "cranes/crane");
        assert_eq!(of_part("cranes/crane.yaml", "../hooks/hook.json"), "hooks/hook.json");
        assert_eq!(of_part("crane.yaml", "../../hook.yml"), "../../hook.yml");
        assert_eq!(of_part("../cranes/crane.yaml", "../../hook.yml"), "../../hook.yml");
        assert_eq!(of_part("gallery:parts/hull.yaml", "hook"), "gallery:parts/hook.yaml");
        assert_eq!(from_folder_of("gallery:parts/hull.yaml", "../hydro/a.json"), "gallery:hydro/a.json");
        assert_eq!(from_folder_of("parts/hull.yaml", "/data/a.json"), "/data/a.json");
        assert_eq!(from_folder_of("/data/hull.yaml", "../a.json"), "/a.json");
        assert_eq!(from_folder_of("/data/ships/hull.yaml", "../a.json"), "/data/a.json");
        assert_eq!(from_folder_of("C:/data/hull.yaml", "a.json"), "C:/data/a.json");
    }

    #[test]
    fn an_error_shows_a_file_by_the_path_to_the_main_one() {
        assert_eq!(beside("/home/anne/ship.yaml", "cranes/a.yaml"), "/home/anne/cranes/a.yaml");
        assert_eq!(beside("ship.yaml", "cranes/a.yaml"), "cranes/a.yaml");
        assert_eq!(beside("/home/anne/ship.yaml", "gallery:parts/a.yaml"), "gallery:parts/a.yaml");
        assert_eq!(of_main("C:\\ships\\ship.yaml"), "ship.yaml");
    }
}
