//! Time of one field of 128 x 128 points at 8 anchors x 5 sensors on one thread, natively and in WebAssembly, in one run.
//!
//! `cargo bench --bench field`; the WebAssembly column appears as in the bench `track`.
#![allow(clippy::disallowed_methods, reason = "a bench needs a clock")]

mod field_case;

use std::path::Path;
use std::process::Command;
use std::time::Instant;

const PASSES: usize = 60;

fn main() {
    let wasm = wasm();
    if wasm.is_none() {
        println!("no WebAssembly column: compile the example track_wasm first (see the bench `track`)");
    }
    println!(
        "{:<24} {:>10} {:>8} {:>10} {:>8} {:>6}",
        "one field", "native ms", "target", "wasm ms", "target", "ratio"
    );
    for (index, name) in ["raw", "projected", "next anchor"].into_iter().enumerate() {
        let native = native(index);
        print!("{name:<24} {native:>10.2} {:>8}", "12");
        match wasm.as_ref().and_then(|wasm| wasm.get(index)) {
            Some(ms) => println!(" {ms:>10.2} {:>8} {:>6.2}", "20", ms / native),
            None => println!(),
        }
    }
}

/// Milliseconds: the fastest of some passes, the one that a busy machine disturbed least.
fn native(case: usize) -> f64 {
    let time = |_| {
        let start = Instant::now();
        std::hint::black_box(field_case::pass(case));
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..PASSES).map(time).fold(f64::INFINITY, f64::min)
}

fn wasm() -> Option<Vec<f64>> {
    let target = std::env::current_exe().ok()?.ancestors().nth(3)?.to_path_buf();
    let module = target.join("wasm32-unknown-unknown/wasm/examples/track_wasm.wasm");
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("crate/benches/field.mjs");
    let output = Command::new("node").arg(script).arg(module).output().ok()?;
    output.status.success().then(|| {
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        text.lines().filter_map(|line| line.parse().ok()).collect()
    })
}
