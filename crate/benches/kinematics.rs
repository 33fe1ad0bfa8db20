//! Time of one estimate of relative kinematics, ten nodes and 100 stamps, natively and in WebAssembly, in one run.
//!
//! `cargo bench --bench kinematics`; the WebAssembly column appears as in the bench `track`.
#![allow(clippy::disallowed_methods, reason = "a bench needs a clock")]

mod kinematics_case;

use std::path::Path;
use std::process::Command;
use std::time::Instant;

use kinematics_case::KinematicsCase;
use rangelab::model::kinematics::settings::KinematicsName;

const PASSES: usize = 100;

fn main() {
    let case = KinematicsCase::new();
    let wasm = wasm();
    for (index, name) in KinematicsName::ALL.into_iter().enumerate() {
        print!("{:<36} {:>8.3} ms native", name.label(), native(&case, name));
        if let Some(&[ms, value]) = wasm.get(index) {
            print!(", {ms:>8.3} ms in WebAssembly");
            assert_eq!(value.to_bits(), case.run(name).to_bits(), "{name}: the same bits");
        }
        println!();
    }
    println!("target of maximum likelihood: 5 ms");
    if wasm.is_empty() {
        println!("no WebAssembly: compile the example track_wasm first (see the bench `track`)");
    }
}

/// Milliseconds: the fastest of some passes, the one that a busy machine disturbed least.
fn native(case: &KinematicsCase, name: KinematicsName) -> f64 {
    let time = |_| {
        let start = Instant::now();
        std::hint::black_box(case.run(name));
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..PASSES).map(time).fold(f64::INFINITY, f64::min)
}

/// For each estimator the time, and what was computed; none where there is no module.
fn wasm() -> Vec<[f64; 2]> {
    let Some(target) =
        std::env::current_exe().ok().and_then(|path| Some(path.ancestors().nth(3)?.to_path_buf()))
    else {
        return Vec::new();
    };
    let module = target.join("wasm32-unknown-unknown/wasm/examples/track_wasm.wasm");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("crate/benches/kinematics.mjs");
    let count = KinematicsName::ALL.len().to_string();
    let Ok(output) = Command::new("node").arg(script).arg(module).arg(count).output() else {
        return Vec::new();
    };
    let text = String::from_utf8_lossy(&output.stdout);
    let numbers: Vec<f64> = text.lines().filter_map(|line| line.parse().ok()).collect();
    numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect()
}
