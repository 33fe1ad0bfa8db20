//! The order of the house: which module may name which.

use crate::source::paths;

/// From the ground up: a module names its own floor and those below. What is on no floor is a door.
const FLOORS: [&[&str]; 5] = [
    &["error"],
    &["math"],
    &["model"],
    &["localize", "track", "inertial", "anchorless", "bounds", "simulate"],
    &["study", "place"],
];
const ESTIMATORS: [&str; 4] = ["localize", "track", "inertial", "anchorless"];
const DOORS: [&str; 6] = ["lib.rs", "main.rs", "cli", "benches", "examples", "prelude.rs"];
/// What `crate::error` lends to the root, so that everyone says `crate::Error`, and the exported macro of `model`, which
/// the language puts there.
const ROOT_NAMES: [&str; 4] = ["Error", "Problem", "Result", "with_dimension"];
/// The one file that may name `libm`.
const FLOAT: &str = "crate/math/float.rs";
/// The one folder of the page that may import WebAssembly.
const ENGINE: &str = "web/page/src/engine/";
/// What the files of a folder never name: the numbers know no files, clock, threads, window or browser; the scene knows
/// no estimators, and the facade of the estimators draws nothing.
const FOREIGN: [(&str, &[&str]); 4] = [
    ("crate/", &OUTSIDE),
    (
        "web/scene/",
        &[
            "rangelab",
            "rangelab_track",
            "rangelab_explore",
            "rangelab_localize",
            "rangelab_indoor",
            "rangelab_anchorless",
            "rangelab_figures",
            "rangelab_wasm_shared",
        ],
    ),
    ("web/wasm/", &["rangelab_scene", "wgpu"]),
    ("web/viser/", &["rangelab_scene", "wgpu", "libm", "wasm_bindgen"]),
];
const OUTSIDE: [&str; 9] =
    ["libm", "wasm_bindgen", "js_sys", "web_sys", "wgpu", "std::fs", "std::thread", "std::time", "std::env"];

/// What the file at `path` (from the repository root) breaks, one sentence each.
pub fn broken_rules(path: &str, source: &str) -> Vec<String> {
    let paths = paths(source);
    let mut broken: Vec<String> = paths.iter().filter_map(|named| foreign(path, named)).collect();
    if let Some(inner) = path.strip_prefix("crate/") {
        let own = module(inner);
        if floor(own).is_none() && !DOORS.contains(&own) {
            broken.push(format!("{own} has no floor: give it one in tests/layout/rules.rs"));
        }
        broken.extend(paths.iter().filter_map(|named| broken_in_crate(inner, named)));
    }
    broken.iter().map(|sentence| format!("{path}: {sentence}")).collect()
}

/// What is foreign to the folder of the file at `path`; doors of the crate may use the outside.
fn foreign(path: &str, named: &[String]) -> Option<String> {
    let (folder, foreign) = FOREIGN.iter().find(|(folder, _)| path.starts_with(folder))?;
    let inner = &path[folder.len()..];
    let named = named.join("::");
    let found = foreign.iter().find(|name| format!("{named}::").starts_with(&format!("{name}::")))?;
    let allowed =
        *folder == "crate/" && (DOORS.contains(&module(inner)) || path == FLOAT && *found == "libm");
    (!allowed).then(|| format!("names {named}, foreign to {folder}"))
}

/// `inner` is the file's path inside crate/, `named` a path it names. Doors may name everything.
fn broken_in_crate(inner: &str, named: &[String]) -> Option<String> {
    let own = module(inner);
    let own_floor = floor(own)?;
    let other = top_module(inner, named)?;
    if ROOT_NAMES.contains(&other) || other == own {
        return None;
    }
    let Some(other_floor) = floor(other) else {
        return Some(format!("names crate::{other}: name the module it comes from"));
    };
    let sentence = if other_floor > own_floor {
        "which is above it"
    } else if ESTIMATORS.contains(&own) && other == "simulate" {
        "but an estimator cannot see the truth"
    } else if own == "bounds" && ESTIMATORS.contains(&other) {
        "but the ruler does not know what it measures"
    } else {
        return None;
    };
    Some(format!("{own} names {other} ({}), {sentence}", named.join("::")))
}

/// The top module that a path in the file at `inner` leads to, if it leaves its own.
fn top_module<'a>(inner: &str, named: &'a [String]) -> Option<&'a str> {
    if named[0] == "crate" {
        return named.get(1).map(String::as_str);
    }
    let depth = inner.trim_end_matches("/mod.rs").split('/').count();
    let supers = named.iter().take_while(|segment| *segment == "super").count();
    // In an inline module one more `super` is still inside, so only the name of a floor counts.
    named.get(supers).map(String::as_str).filter(|name| supers >= depth && floor(name).is_some())
}

/// The first folder or file name, without its ending where it is a module.
fn module(inner: &str) -> &str {
    let first = inner.split('/').next().unwrap_or(inner);
    if DOORS.contains(&first) { first } else { first.trim_end_matches(".rs") }
}

fn floor(module: &str) -> Option<usize> {
    FLOORS.iter().position(|floor| floor.contains(&module))
}

/// What the manifest at `path` depends on and must not.
pub fn broken_dependencies(path: &str, manifest: &str) -> Vec<String> {
    let forbidden: &[&str] =
        if path.starts_with("web/scene/") { &["rangelab"] } else { &["rangelab-scene", "wgpu"] };
    let dependencies = manifest.lines().skip_while(|line| !line.contains("dependencies]"));
    let names = |line: &&str| {
        forbidden.iter().any(|package| {
            let key = line.split(['=', '.']).next().unwrap_or("").trim();
            key == *package || line.contains(&format!("package = \"{package}\""))
        })
    };
    dependencies.filter(names).map(|line| format!("{path}: must not depend on this: {line}")).collect()
}

/// Lines of the page at `path` that import a WebAssembly module; only the engine may.
pub fn broken_imports(path: &str, source: &str) -> Vec<String> {
    if path.starts_with(ENGINE) {
        return Vec::new();
    }
    let imports = |line: &&str| line.contains("/wasm/") && (line.contains("import") || line.contains("from"));
    source
        .lines()
        .filter(imports)
        .map(|line| format!("{path}: only {ENGINE} imports modules: {line}"))
        .collect()
}
