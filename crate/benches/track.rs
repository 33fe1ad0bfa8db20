//! Time of one predict + update of every tracker, natively and in WebAssembly, in one run.
//!
//! `cargo bench --bench track` prints the native column (`-- 0` its first line alone, for a profiler); the ratio to WebAssembly appears where Node is installed and
//! the same code was compiled for it before:
//! `cargo build --example track_wasm --no-default-features --target wasm32-unknown-unknown --profile wasm`.
#![allow(clippy::disallowed_methods, reason = "a bench needs a clock")]

mod cases;

use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Instant;

use cases::{CASES, Case, Running};

const BATCH_NS: f64 = 50_000.0;
const BATCHES: usize = 1000;

fn main() {
    if let Some(number) = std::env::args().nth(1).and_then(|argument| argument.parse::<usize>().ok()) {
        println!("{}: {:.0} ns a step", CASES[number].name, native(&CASES[number]));
        return;
    }
    let native: Vec<f64> = CASES.iter().map(native).collect();
    let wasm = wasm();
    if wasm.is_none() {
        println!(
            "no WebAssembly column: compile the example track_wasm first (see this bench's first lines)"
        );
    }
    println!(
        "{:<36} {:>9} {:>9} {:>8} {:>9} {:>6}",
        "one step", "ranges", "native us", "target", "wasm us", "ratio"
    );
    for (index, case) in CASES.iter().enumerate() {
        let ranges = case.size[0] * case.size[1];
        let us = native[index] / 1000.0;
        let target = case.target.map_or(String::new(), |target| format!("{target:.1}"));
        print!("{:<36} {ranges:>9} {us:>9.3} {target:>8}", case.name);
        match wasm.as_ref().and_then(|wasm| wasm.get(index)) {
            Some(ns) => print!(" {:>9.3} {:>6.2}", ns / 1000.0, ns / native[index]),
            None => print!(" {:>9} {:>6}", "", ""),
        }
        if ranges > 1000 {
            print!("  {:.2} ns per range", native[index] / ranges as f64);
        }
        println!();
    }
}

/// Nanoseconds a step: the fastest of many short batches, the one that a busy machine disturbed least.
fn native(case: &Case) -> f64 {
    let mut running = Running::new(case);
    let mut time = |count: usize| {
        let start = Instant::now();
        std::hint::black_box(running.steps(count));
        start.elapsed().as_nanos() as f64
    };
    time(20);
    let mut count = 1;
    while time(count) < BATCH_NS {
        count *= 2;
    }
    (0..BATCHES).map(|_| time(count) / count as f64).fold(f64::INFINITY, f64::min)
}

/// The same cases in Node; `None` without Node or without the module.
fn wasm() -> Option<Vec<f64>> {
    let module = module()?;
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("crate/benches/track.mjs");
    let output = Command::new("node").arg(script).arg(module).output().ok()?;
    assert!(output.status.success(), "node: {}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).ok()?.lines().map(|line| line.parse().ok()).collect()
}

/// `target/wasm32-unknown-unknown/wasm/examples/track_wasm.wasm` beside this program's `target/release/deps`.
fn module() -> Option<PathBuf> {
    let target = std::env::current_exe().ok()?.ancestors().nth(3)?.to_path_buf();
    let module = target.join("wasm32-unknown-unknown/wasm/examples/track_wasm.wasm");
    module.exists().then_some(module)
}
