//! Guards the bits: nothing in the dependency graph may switch on a feature that replaces libm by the platform's own
//! functions or brings kernels chosen at run time. Cargo unifies features, so one careless dev-dependency is enough.

use std::process::Command;

/// Package and feature, each of which changes the last bits of a result on some machine.
const FORBIDDEN: [(&str, &str); 4] =
    [("num-traits", "std"), ("nalgebra", "std"), ("nalgebra", "matrixmultiply"), ("simba", "std")];

/// Lines of `cargo tree --edges features --prefix none` that name a forbidden feature.
fn forbidden_features(tree: &str) -> Vec<&str> {
    let names = |line: &str| {
        FORBIDDEN
            .iter()
            .any(|(package, feature)| line.starts_with(&format!("{package} feature \"{feature}\"")))
    };
    tree.lines().filter(|line| names(line)).collect()
}

fn check(arguments: &[&str]) {
    let output = Command::new(env!("CARGO"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .args(["tree", "--locked", "--edges", "features", "--prefix", "none"])
        .args(arguments)
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "cargo tree {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    let tree = String::from_utf8(output.stdout).expect("cargo writes UTF-8");
    assert!(
        tree.contains("nalgebra feature \"libm-force\""),
        "cargo tree {arguments:?} shows no nalgebra:\n{tree}"
    );
    let found = forbidden_features(&tree);
    assert!(found.is_empty(), "cargo tree {arguments:?} shows {found:?}");
}

#[test]
fn the_whole_workspace_with_all_features_and_dev_dependencies_keeps_the_bits() {
    check(&["--workspace", "--all-features"]);
}

#[test]
fn the_crate_alone_keeps_the_bits() {
    check(&["--package", "rangelab"]);
}

#[test]
fn the_python_module_keeps_the_bits() {
    check(&["--package", "rangelab-python"]);
}

#[test]
fn the_browser_modules_keep_the_bits() {
    let modules = [
        "rangelab-track",
        "rangelab-explore",
        "rangelab-localize",
        "rangelab-indoor",
        "rangelab-anchorless",
        "rangelab-figures",
    ];
    for package in modules {
        check(&["--package", package, "--target", "wasm32-unknown-unknown"]);
    }
}

#[test]
fn a_spoiled_graph_is_rejected() {
    let clean = "nalgebra feature \"libm-force\"\nnum-traits feature \"libm\"\nhalf feature \"num-traits\"\nserde feature \"std\"\n";
    assert!(forbidden_features(clean).is_empty());
    for (package, feature) in FORBIDDEN {
        let spoiled = format!("{clean}{package} feature \"{feature}\" (*)\n");
        assert_eq!(forbidden_features(&spoiled).len(), 1, "{spoiled}");
    }
}
