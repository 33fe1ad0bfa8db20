//! The layout of the repository: the floors and fences of its modules, the map in its README, the size of its files.
//! Each rule is also given a spoiled source that it must reject.

mod map;
mod rules;
mod source;

use std::path::Path;
use std::process::Command;

const LONGEST: usize = 400;
const MEDIAN: usize = 150;
const CODE: [&str; 9] = ["rs", "ts", "js", "mjs", "svelte", "css", "html", "wgsl", "py"];
const SCRIPTS: [&str; 5] = ["web/serve", "web/build", "tests/run", "tests/support/setup", ".ci/run"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(file: &str) -> String {
    std::fs::read_to_string(root().join(file)).unwrap_or_else(|error| panic!("{file}: {error}"))
}

/// The files of the repository: what git tracks and what it would add, as far as they are on disk.
fn files() -> Vec<String> {
    let output = Command::new("git")
        .current_dir(root())
        .args(["ls-files", "--cached", "--others", "--exclude-standard"])
        .output()
        .expect("git runs");
    assert!(output.status.success(), "git ls-files: {}", String::from_utf8_lossy(&output.stderr));
    let listed = String::from_utf8(output.stdout).expect("file names are UTF-8");
    let files: Vec<String> =
        listed.lines().filter(|file| root().join(file).is_file()).map(str::to_owned).collect();
    assert!(files.iter().any(|file| file == "crate/lib.rs"), "git lists no crate/lib.rs");
    files
}

fn has_extension(file: &str, extension: &str) -> bool {
    Path::new(file).extension().is_some_and(|found| found == extension)
}

fn ends_in(file: &str, endings: &[&str]) -> bool {
    Path::new(file).extension().is_some_and(|ending| endings.iter().any(|wanted| ending == *wanted))
}

fn assert_none(broken: &[String]) {
    assert!(broken.is_empty(), "\n{}\n", broken.join("\n"));
}

#[test]
fn modules_keep_to_their_floors_and_fences() {
    let sources = files().into_iter().filter(|file| has_extension(file, "rs"));
    assert_none(&sources.flat_map(|file| rules::broken_rules(&file, &read(&file))).collect::<Vec<_>>());
}

#[test]
fn packages_keep_to_their_fences() {
    let manifests: Vec<String> = files()
        .into_iter()
        .filter(|file| file.starts_with("web/") && file.ends_with("/Cargo.toml"))
        .collect();
    assert!(
        manifests.len() > 3,
        "the scene and the modules of the engine have manifests, found {manifests:?}"
    );
    assert_none(
        &manifests.iter().flat_map(|file| rules::broken_dependencies(file, &read(file))).collect::<Vec<_>>(),
    );
}

#[test]
fn only_the_engine_of_the_page_imports_webassembly() {
    let in_page = |file: &String| file.starts_with("web/page/src/");
    let sources = files()
        .into_iter()
        .filter(in_page)
        .filter(|file| has_extension(file, "ts") || has_extension(file, "svelte"));
    assert_none(&sources.flat_map(|file| rules::broken_imports(&file, &read(&file))).collect::<Vec<_>>());
}

#[test]
fn the_map_in_the_readme_is_the_disk() {
    assert_none(&map::differences(&read("README.md"), &files()));
}

#[test]
fn files_are_short() {
    let is_code = |file: &&String| ends_in(file, &CODE) || SCRIPTS.contains(&file.as_str());
    let files = files();
    let sizes: Vec<_> = files.iter().filter(is_code).map(|file| (read(file).lines().count(), file)).collect();
    let too_long = sizes.iter().filter(|(lines, _)| *lines > LONGEST);
    assert_none(
        &too_long
            .map(|(lines, file)| format!("{file}: {lines} lines, at most {LONGEST}"))
            .collect::<Vec<_>>(),
    );
    let mut in_crate: Vec<usize> =
        sizes.iter().filter(|(_, file)| file.starts_with("crate/")).map(|(lines, _)| *lines).collect();
    in_crate.sort_unstable();
    let median = in_crate[in_crate.len() / 2];
    println!(
        "crate/: {} files, median {median} lines, longest {}",
        in_crate.len(),
        in_crate[in_crate.len() - 1]
    );
    assert!(median <= MEDIAN, "the median file of crate/ has {median} lines, at most {MEDIAN}");
}

/// A path, a source that breaks a rule there, and a word of the sentence that must come back.
const SPOILED: [(&str, &str, &str); 18] = [
    ("crate/math/pose.rs", "use crate::model::anchors::Anchors;", "above"),
    ("crate/model/motion.rs", "use crate::{math::pose, track::kalman};", "above"),
    ("crate/track/kalman.rs", "use crate::study::metrics;", "above"),
    ("crate/error.rs", "use crate::math::linalg;", "above"),
    ("crate/bounds/fisher.rs", "use crate::place::Placement;", "above"),
    ("crate/track/kalman.rs", "use crate::simulate::random;", "truth"),
    ("crate/track/kalman.rs", "use super::super::simulate::random;", "truth"),
    ("crate/localize/mod.rs", "use super::{math, simulate};", "truth"),
    ("crate/inertial/kalman.rs", "fn f() { crate::simulate::trajectory(); }", "truth"),
    ("crate/bounds/fisher.rs", "pub use crate::{model, track::{filter::Step as S}};", "ruler"),
    ("crate/track/kalman.rs", "use crate::Simulation;", "name the module"),
    ("crate/track/kalman.rs", "use crate::*;", "name the module"),
    ("crate/gossip/mod.rs", "", "no floor"),
    ("crate/model/motion.rs", "let s = libm::sin(1.0);", "foreign"),
    ("crate/study/monte_carlo.rs", "use std::{thread, iter};", "foreign"),
    ("web/scene/lib.rs", "use rangelab::track::KalmanFilter;", "foreign"),
    ("web/wasm/track/lib.rs", "use rangelab_scene::Scene;", "foreign"),
    ("web/viser/bindings/run.rs", "let s = libm::sin(1.0);", "foreign"),
];

#[test]
fn spoiled_sources_are_rejected() {
    for (path, source, word) in SPOILED {
        let broken = rules::broken_rules(path, source);
        assert!(broken.len() == 1 && broken[0].contains(word), "{path}: {source}\n{broken:?}");
    }
}

#[test]
fn sound_sources_are_accepted() {
    let sound = [
        ("crate/math/float.rs", "pub fn sin(x: f64) -> f64 { libm::sin(x) }"),
        (
            "crate/track/kalman.rs",
            "use crate::{Error, math::pose::Pose}; use super::filter; // crate::simulate\n",
        ),
        (
            "crate/track/unitary.rs",
            "use crate::track::projection; use super::super::model::Ranges; pub(crate) fn f() {}",
        ),
        (
            "crate/bounds/field.rs",
            "use crate::model::NormalEquations; mod tests { use super::super::fisher; }",
        ),
        ("crate/study/metrics.rs", "use crate::{bounds, simulate, track};"),
        ("crate/lib.rs", "pub use crate::simulate::simulate; mod study;"),
        ("crate/main.rs", "use rangelab::study; use std::{fs, thread};"),
        ("web/wasm/track/lib.rs", "use rangelab::track;"),
    ];
    for (path, source) in sound {
        assert_none(&rules::broken_rules(path, source));
    }
}

#[test]
fn spoiled_packages_and_imports_are_rejected() {
    let package = |lines: &str| format!("[package]\nname = \"rangelab-scene\"\n[dependencies]\n{lines}\n");
    assert_none(&rules::broken_dependencies("web/scene/Cargo.toml", &package("wgpu = \"30\"")));
    for spoiled in
        ["rangelab = { path = \"../..\" }", "estimators = { package = \"rangelab\", path = \"../..\" }"]
    {
        assert_eq!(
            rules::broken_dependencies("web/scene/Cargo.toml", &package(spoiled)).len(),
            1,
            "{spoiled}"
        );
    }
    assert_eq!(rules::broken_dependencies("web/wasm/track/Cargo.toml", &package("wgpu = \"30\"")).len(), 1);
    let import = "const scene = await import(\"../wasm/scene-webgl/rangelab_scene.js\");";
    assert_none(&rules::broken_imports("web/page/src/engine/scene.ts", import));
    assert_eq!(rules::broken_imports("web/page/src/labs/track/Track.svelte", import).len(), 1);
}

#[test]
fn spoiled_maps_are_rejected() {
    let files: Vec<String> =
        ["README.md", "crate/math/pose.rs", "tests/run", "web/serve"].map(String::from).into();
    let readme = |tree: &str| format!("# x\n\n## Map\n\n```text\n{tree}\n```\n");
    let tree = "crate/  numbers\n  math/  rotations\n    pose.rs  SE(D)\ntests/  evidence\nweb/  seen";
    assert_none(&map::differences(&readme(tree), &files));
    let spoiled =
        [tree.replace("math/", "maths/"), tree.replace("tests/  evidence\n", ""), format!("{tree}\n  page/")];
    for (tree, differences) in spoiled.iter().zip([3, 1, 1]) {
        assert_eq!(map::differences(&readme(tree), &files).len(), differences, "{tree}");
    }
    assert_eq!(map::differences("# x\n", &files).len(), 1);
}
