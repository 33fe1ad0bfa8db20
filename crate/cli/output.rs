//! Where data go: stdout, or a file.

use std::fmt::Display;
use std::fs;
use std::io::{self, IsTerminal, Write};
use std::path::PathBuf;

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
        let end = if text.ends_with('\n') { "" } else { "\n" };
        self.write_parts(&[text.as_bytes(), end.as_bytes()])
    }

    /// Writes what is no text, but not into a terminal.
    pub fn write_bytes(&self, bytes: &[u8]) -> Result<(), Failure> {
        if self.output.is_none() && io::stdout().is_terminal() {
            return Err(Failure::Usage("a picture is no text: name a file for it with -o".to_owned()));
        }
        self.write_parts(&[bytes])
    }

    fn write_parts(&self, parts: &[&[u8]]) -> Result<(), Failure> {
        match &self.output {
            None => write(io::stdout().lock(), parts).map_err(|error| Failure::writing("stdout", &error)),
            Some(path) => fs::File::create(path)
                .and_then(|file| write(file, parts))
                .map_err(|error| Failure::writing(path.display(), &error)),
        }
    }
}

fn write(target: impl Write, parts: &[&[u8]]) -> io::Result<()> {
    let mut target = io::BufWriter::new(target);
    for part in parts {
        target.write_all(part)?;
    }
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
