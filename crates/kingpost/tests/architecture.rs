//! Checks that imports follow the rules of ARCHITECTURE.md.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn read(path: impl AsRef<Path>) -> String {
    fs::read_to_string(path.as_ref()).unwrap_or_else(|error| panic!("{}: {error}", path.as_ref().display()))
}

/// Module names in the first column of the table under a heading, in order.
fn order_under(heading: &str) -> Vec<String> {
    let text = read(root().join("ARCHITECTURE.md"));
    let section = text.split(heading).nth(1).expect("the heading is there");
    section
        .lines()
        .skip_while(|line| !line.starts_with("| `"))
        .take_while(|line| line.starts_with("| `"))
        .map(|line| line.split('`').nth(1).expect("a name in backticks").trim_end_matches('/').to_owned())
        .collect()
}

fn files_below(folder: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            found.extend(files_below(&path, ending));
        } else if path.to_string_lossy().ends_with(ending) {
            found.push(path);
        }
    }
    found
}

/// Returns the layer of a module of an element: `elements/ropes/fields` belongs to `scenario/schema`,
/// `elements/ropes/assembly` to `scenario/assembly`, and the physics of the element to `elements`.
fn floor(module: Vec<String>) -> Vec<String> {
    let on = match module.get(2).map(String::as_str) {
        Some("fields") if module[0] == "elements" => "schema",
        Some("assembly") if module[0] == "elements" => "assembly",
        _ => return module,
    };
    let lead = ["scenario", on].map(str::to_owned).into_iter();
    lead.chain([module[1].clone()]).chain(module.into_iter().skip(3)).collect()
}

/// Returns the first path component below `folder`, without its extension; for the engine, the one of the
/// module's layer.
fn module_of(path: &Path, folder: &Path) -> String {
    let relative = path.strip_prefix(folder).expect("below the folder").with_extension("");
    let segments = relative.iter().map(|segment| segment.to_string_lossy().into_owned()).collect();
    let first = floor(segments).swap_remove(0);
    first.split('.').next().unwrap_or_default().to_owned()
}

/// Checks that every file below `folder` keeps the order of modules under a heading; `imports` finds the
/// modules that a file's text names.
fn hold_to_order(heading: &str, folder: &str, ending: &str, imports: impl Fn(&str, usize) -> BTreeSet<String>) {
    let (order, folder) = (order_under(heading), root().join(folder));
    let place_of = |name: &str, path: &Path| {
        let place = order.iter().position(|m| m == name);
        place.unwrap_or_else(|| panic!("{}: ARCHITECTURE.md does not name {name}", path.display()))
    };
    let mut seen = BTreeSet::new();
    for path in files_below(&folder, ending) {
        let module = module_of(&path, &folder);
        if ["lib", "__init__", "__main__"].contains(&module.as_str())
            || path.components().any(|c| c.as_os_str() == "pkg")
        {
            continue;
        }
        let depth = path.strip_prefix(&folder).expect("below the folder").components().count() - 1;
        for used in imports(&read(&path), depth) {
            let after = place_of(&used, &path) > place_of(&module, &path);
            assert!(!after, "{} imports {used}, which comes after {module}", path.display());
        }
        seen.insert(module);
    }
    // A compiled module has no file here.
    let written = order.into_iter().filter(|name| !name.starts_with('_')).collect();
    assert_eq!(seen, written, "ARCHITECTURE.md names modules that are gone");
}

fn word(text: &str) -> String {
    text.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect()
}

/// `crate::module` in code, comments left out.
fn rust_imports(code: &str, _depth: usize) -> BTreeSet<String> {
    let lines = code.lines().filter(|line| !line.trim_start().starts_with("//"));
    lines.flat_map(|line| line.split("crate::").skip(1).map(word).collect::<Vec<_>>()).collect()
}

/// `from .module import` and `from . import module`; one dot more in a folder.
fn python_imports(code: &str, depth: usize) -> BTreeSet<String> {
    let package = format!("from {}", ".".repeat(depth + 1));
    let mut found = BTreeSet::new();
    for rest in code.lines().filter_map(|line| line.trim_start().strip_prefix(&package)) {
        match rest.strip_prefix(" import ") {
            Some(names) => {
                found.extend(names.split(',').map(|name| word(name.trim())).filter(|n| !n.starts_with("__")))
            }
            None if !rest.starts_with('.') => {
                found.insert(word(rest));
            }
            None => {}
        }
    }
    found
}

/// `from '../folder/file'`, or `from './folder/file'` at the top.
fn typescript_imports(code: &str, depth: usize) -> BTreeSet<String> {
    let up = if depth == 0 { "from './" } else { "from '../" };
    code.lines().filter_map(|line| line.split(up).nth(1)).map(word).filter(|name| !name.is_empty()).collect()
}

#[test]
fn every_module_of_the_engine_imports_only_those_before_it() {
    hold_to_order("## The engine's modules", "crates/kingpost/src", ".rs", rust_imports);
}

#[test]
fn lib_rs_lists_the_modules_in_reading_order() {
    let lib = read(root().join("crates/kingpost/src/lib.rs"));
    let listed: Vec<String> = lib.lines().filter_map(|line| line.strip_prefix("pub mod ")).map(word).collect();
    assert_eq!(listed, order_under("## The engine's modules"));
}

#[test]
fn every_module_of_the_python_package_imports_only_those_before_it() {
    hold_to_order("## The Python package's modules", "python/kingpost", ".py", python_imports);
}

#[test]
fn every_folder_of_the_app_imports_only_those_before_it() {
    hold_to_order("## The app's folders", "web/src", ".ts", typescript_imports);
}

/// Names of the kinds of element: public types of `elements/` that implement the contract.
fn kinds_of_element() -> BTreeSet<String> {
    let mut kinds = BTreeSet::new();
    for path in files_below(&root().join("crates/kingpost/src/elements"), ".rs") {
        for line in read(&path).lines().filter(|line| line.starts_with("impl<S: Scalar> Element<S> for ")) {
            kinds.insert(word(line.split(" for ").nth(1).expect("a type")));
        }
    }
    kinds
}

#[test]
fn no_module_after_the_builder_names_a_kind_of_element() {
    let kinds = kinds_of_element();
    assert!(kinds.len() > 15 && kinds.contains("Motor") && kinds.contains("Hull"), "{kinds:?}");
    let source = root().join("crates/kingpost/src");
    for folder in ["plant", "results", "simulation", "analysis", "batch", "ledger", "state.rs"] {
        let place = source.join(folder);
        let files = if place.is_dir() { files_below(&place, ".rs") } else { vec![place] };
        for path in files {
            for line in read(&path).lines().filter(|line| !line.trim_start().starts_with("//")) {
                let words: BTreeSet<&str> = line.split(|c: char| !c.is_alphanumeric() && c != '_').collect();
                let named = kinds.iter().find(|kind| words.contains(kind.as_str()));
                assert!(named.is_none(), "{} names {}", path.display(), named.map_or("", |kind| kind));
            }
        }
    }
}

/// Roles answer what others ask of an element: what it supports, what floats, where it stands. Only the room of a kind knows its
/// own kind, and the assembly of a kind that names another by its name in the file.
#[test]
fn no_code_outside_the_rooms_asks_an_element_for_its_kind() {
    let source = root().join("crates/kingpost/src");
    let elsewhere = files_below(&source, ".rs").into_iter().filter(|path| !path.starts_with(source.join("elements")));
    for path in elsewhere {
        let code = read(&path);
        let asks = code.lines().find(|line| line.contains("of_kind") || line.contains("as_any"));
        assert!(asks.is_none(), "{}: {}", path.display(), asks.unwrap_or_default());
    }
}

#[test]
fn the_engine_has_no_clock_no_output_and_no_input() {
    let source = root().join("crates/kingpost/src");
    for path in files_below(&source, ".rs") {
        let code = read(&path);
        for line in code.lines().filter(|line| !line.trim_start().starts_with("//")) {
            for forbidden in [
                "std::time",
                "std::fs",
                "std::io",
                "std::thread",
                "std::env",
                "print!",
                "println!",
                "eprint!",
                "dbg!",
                "HashMap",
                "std::net",
                "std::process",
            ] {
                assert!(!line.contains(forbidden), "{}: {forbidden}", path.display());
            }
        }
    }
}

/// A module that has a folder starts in the folder's `mod.rs`, not in a file of its name next to the folder.
#[test]
fn a_module_with_a_folder_starts_in_its_mod_rs() {
    for path in files_below(&root().join("crates"), ".rs") {
        let folder = path.with_extension("");
        assert!(!folder.is_dir(), "{}: belongs into {}/mod.rs", path.display(), folder.display());
    }
}

/// Returns the types that a file of the engine defines, without `type Output` and similar ones inside an
/// `impl`.
fn types_in(code: &str) -> BTreeSet<String> {
    let defined = |line: &str| {
        let line = line.strip_prefix("pub").map_or(line, |rest| rest.trim_start_matches(|c| c != ' ').trim_start());
        ["struct ", "enum ", "trait ", "type "].iter().find_map(|kind| line.strip_prefix(kind)).map(word)
    };
    code.lines().filter_map(defined).collect()
}

/// A type of the schema and the type that is built from it share a name; no other two types do.
#[test]
fn two_types_of_the_engine_share_a_name_only_where_one_is_built_from_the_schema_of_the_other() {
    let source = root().join("crates/kingpost/src");
    let mut files = BTreeMap::<String, Vec<String>>::new();
    for path in files_below(&source, ".rs") {
        let place = path.strip_prefix(&source).expect("below the folder").to_string_lossy().into_owned();
        types_in(&read(&path)).into_iter().for_each(|name| files.entry(name).or_default().push(place.clone()));
    }
    assert!(files.len() > 500 && files["Rope"].len() == 2, "{}", files.len());
    for (name, files) in files {
        let of_schema =
            files.iter().filter(|file| file.starts_with("scenario/schema/") || file.contains("/fields")).count();
        assert!(files.len() == 1 || (files.len(), of_schema) == (2, 1), "{name}: {files:?}");
    }
}

/// The path of a module, from `src` or from where a `use` stands.
type ModulePath = Vec<String>;

/// The paths of a `use`: `a::{b, c::d}` is `a::b` and `a::c::d`.
fn paths_of_use(tree: &str) -> Vec<String> {
    let Some((stem, inside)) = tree.trim().split_once('{') else {
        return vec![tree.split(" as ").next().unwrap_or_default().trim().to_owned()];
    };
    let (mut depth, mut parts) = (0, vec![String::new()]);
    for c in inside.trim_end().strip_suffix('}').expect("braces in pairs").chars() {
        depth += i32::from(c == '{') - i32::from(c == '}');
        match parts.last_mut() {
            Some(part) if depth > 0 || c != ',' => part.push(c),
            _ => parts.push(String::new()),
        }
    }
    let named = parts.iter().filter(|part| !part.trim().is_empty());
    named.flat_map(|part| paths_of_use(&format!("{}{}", stem.trim(), part.trim()))).collect()
}

/// A path from `src`, of one that is written in a module.
fn from_source(module: &ModulePath, path: &str) -> ModulePath {
    path.split("::").map(str::trim).filter(|segment| !segment.is_empty()).fold(module.clone(), |mut at, segment| {
        match segment {
            "crate" => at.clear(),
            "super" => drop(at.pop()),
            "self" => {}
            name => at.push(name.to_owned()),
        }
        at
    })
}

/// The paths that a module's code names: those of its `use`, and others that begin with `crate` or `super`.
fn named_paths(module: &ModulePath, code: &str) -> [Vec<ModulePath>; 2] {
    let code = code.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
    let lines: Vec<&str> = code.lines().filter(|line| !line.trim_start().starts_with("//")).collect();
    let code = lines.join("\n");
    let begins = |at: usize| {
        code[..at]
            .rsplit('\n')
            .next()
            .is_some_and(|line| ["", "pub"].contains(&line.trim().split('(').next().unwrap_or_default()))
    };
    let uses = code.match_indices("use ").filter(|(at, _)| begins(*at));
    let uses = uses.filter_map(|(at, _)| code[at + 4..].split_once(';')).flat_map(|(tree, _)| paths_of_use(tree));
    let is_path = |c: &char| c.is_alphanumeric() || *c == '_' || *c == ':';
    let within = ["crate::", "super::"].into_iter().flat_map(|start| code.match_indices(start));
    let within = within.filter(|(at, _)| !code[..*at].chars().next_back().is_some_and(|c| is_path(&c)));
    let within = within.map(|(at, _)| code[at..].chars().take_while(is_path).collect::<String>());
    [uses.map(|path| from_source(module, &path)).collect(), within.map(|path| from_source(module, &path)).collect()]
}

/// The module that a path leads to, through what modules on the way take from others.
fn home(
    mut path: ModulePath,
    modules: &BTreeMap<ModulePath, String>,
    taken: &BTreeMap<ModulePath, ModulePath>,
) -> ModulePath {
    for _ in 0..10 {
        let depth = (0..=path.len()).rev().find(|&n| modules.contains_key(&path[..n])).unwrap_or_default();
        let Some(source) = path.get(..=depth).and_then(|item| taken.get(item)) else { return path[..depth].to_vec() };
        path = source.iter().chain(&path[depth + 1..]).cloned().collect();
    }
    path
}

/// Finds which files or folders use which others in the folder that contains both.
fn uses_beside() -> BTreeMap<ModulePath, BTreeMap<String, BTreeSet<String>>> {
    let source = root().join("crates/kingpost/src");
    let module = |path: PathBuf| {
        let place = path.strip_prefix(&source).expect("below the folder").with_extension("");
        let segments = place.iter().map(|segment| segment.to_string_lossy().into_owned());
        (segments.filter(|segment| segment != "mod" && segment != "lib").collect::<ModulePath>(), read(&path))
    };
    let modules: BTreeMap<ModulePath, String> = files_below(&source, ".rs").into_iter().map(module).collect();
    let paths: Vec<_> = modules.iter().map(|(module, code)| (module, named_paths(module, code))).collect();
    let mut taken = BTreeMap::new();
    for (module, [uses, _]) in &paths {
        let entry = |path: &ModulePath| Some(([module.as_slice(), &[path.last()?.clone()]].concat(), path.clone()));
        taken.extend(uses.iter().filter_map(entry).filter(|(item, path)| item != path));
    }
    let mut found = BTreeMap::<_, BTreeMap<_, BTreeSet<_>>>::new();
    for (module, [uses, within]) in paths {
        for home in uses.into_iter().chain(within).map(|path| home(path, &modules, &taken)) {
            let (module, home) = (floor(module.clone()), floor(home));
            let shared = module.iter().zip(&home).take_while(|(a, b)| a == b).count();
            if let (Some(own), Some(other)) = (module.get(shared), home.get(shared)) {
                let folder = found.entry(module[..shared].to_vec()).or_default();
                folder.entry(own.clone()).or_default().insert(other.clone());
            }
        }
    }
    found
}

/// A folder's `mod.rs` does not count: it names the files of the folder, and they can use its contents.
#[test]
fn files_of_a_folder_have_no_circular_dependencies() {
    let found = uses_beside();
    assert!(found[&vec!["dynamics".to_owned()]]["loads"].contains("temporary_constraint"), "{found:?}");
    assert!(found[&vec!["scenario".to_owned()]]["assembly"].contains("error"), "by way of what mod.rs takes");
    for (folder, mut uses) in found {
        while let Some(done) = uses.iter().find(|(_, used)| !used.iter().any(|name| uses.contains_key(name))) {
            let done = done.0.clone();
            uses.remove(&done);
        }
        assert!(uses.is_empty(), "{}: {uses:?}", folder.join("/"));
    }
}

#[test]
fn the_engine_depends_on_no_view() {
    let manifest = read(root().join("crates/kingpost/Cargo.toml"));
    for view in ["pyo3", "wasm-bindgen", "kingpost-py", "kingpost-wasm"] {
        assert!(!manifest.contains(view), "the engine names {view}");
    }
}

#[test]
fn files_and_bindings_stay_small() {
    let crates = root().join("crates");
    for path in files_below(&crates, ".rs").iter().filter(|path| !path.to_string_lossy().contains("/target/")) {
        let lines = read(path).lines().count();
        assert!(lines <= 450, "{} has {lines} lines", path.display());
    }
    // The one for Python has three classes: a scenario that is built, one simulation, and many that a controller steps.
    for (binding, most) in [("kingpost-py", 780), ("kingpost-wasm", 500)] {
        let sources = files_below(&crates.join(binding).join("src"), ".rs");
        let lines: usize = sources.iter().map(|path| read(path).lines().count()).sum();
        assert!(lines <= most, "{binding} has {lines} lines: only conversions and the boundary belong there");
    }
}

/// Whether code has a literal with a negative exponent, such as 1e-9.
fn has_small_literal(code: &str) -> bool {
    let bytes = code.as_bytes();
    (1..bytes.len().saturating_sub(2)).any(|i| {
        bytes[i] == b'e' && bytes[i + 1] == b'-' && bytes[i - 1].is_ascii_digit() && bytes[i + 2].is_ascii_digit()
    })
}

/// A tolerance without a scale or a reason often fails far from the case for which it was chosen.
#[test]
fn each_small_constant_has_a_comment_with_its_scale_or_reason() {
    let folder = root().join("crates/kingpost/src");
    let mut bare = Vec::new();
    for path in files_below(&folder, ".rs") {
        let text = read(&path);
        let lines: Vec<&str> = text.lines().take_while(|line| !line.contains("#[cfg(test)]")).collect();
        for (i, line) in lines.iter().enumerate() {
            let code = line.split("//").next().unwrap_or_default();
            let above = lines[..i].iter().rev().find(|line| !line.trim_start().starts_with("const "));
            let says = line.contains("//") || above.is_some_and(|line| line.trim_start().starts_with("//"));
            // A default of a field has the field's documentation, a row of a table the table's.
            let is_row = code.trim().trim_end_matches(',').replace('_', "").parse::<f64>().is_ok();
            if has_small_literal(code) && !says && !is_row && !code.contains("literal(") {
                bare.push(format!("{}:{}: {}", path.display(), i + 1, line.trim()));
            }
        }
    }
    assert!(bare.is_empty(), "without a comment:\n{}", bare.join("\n"));
}
