//! Where data go: stdout, or a file.

use std::fmt::Display;
use std::fs;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};
use rangelab::model::run::Run;

use super::failure::Failure;

#[derive(Args)]
#[command(next_help_heading = "Output")]
pub struct Output {
    /// Write to this file instead of stdout
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
}

/// How a run is written. Variants without help of their own keep the help of the commands on one page.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum RunFormat {
    Json,
    Csv,
}

impl Output {
    /// Writes a text that ends with a line feed, which is added where it is missing.
    pub fn write(&self, text: &str) -> Result<(), Failure> {
        self.output.as_ref().map_or_else(|| print(text), |path| save(path, text))
    }
}

/// Writes a text to stdout, with a line feed at its end.
pub fn print(text: &str) -> Result<(), Failure> {
    write(io::stdout().lock(), text).map_err(|error| Failure::writing("stdout", &error))
}

/// Writes a text to a file, with a line feed at its end.
pub fn save(path: &Path, text: &str) -> Result<(), Failure> {
    fs::File::create(path)
        .and_then(|file| write(file, text))
        .map_err(|error| Failure::writing(path.display(), &error))
}

fn write(target: impl Write, text: &str) -> io::Result<()> {
    let end = if text.ends_with('\n') { "" } else { "\n" };
    let mut target = io::BufWriter::new(target);
    target.write_all(text.as_bytes())?;
    target.write_all(end.as_bytes())?;
    target.flush()
}

/// A run in the form that was asked for.
pub fn run_text(run: &Run, format: RunFormat) -> String {
    match format {
        RunFormat::Json => run.to_json(),
        RunFormat::Csv => run.to_csv(),
    }
}

/// A failure that names the estimators that stopped early; their run holds what they did until then.
pub fn completed(origin: impl Display, run: &Run) -> Result<(), Failure> {
    let stopped = run.estimators.iter().filter_map(|estimator| {
        let failure = estimator.failure.as_ref()?;
        Some(format!("{} stopped at step {}: {}", estimator.name, failure.step, failure.message))
    });
    let stopped: Vec<String> = stopped.collect();
    if stopped.is_empty() { Ok(()) } else { Err(Failure::Other(format!("{origin}: {}", stopped.join("; ")))) }
}
