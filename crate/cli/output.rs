//! Where data go: stdout, or a file.

use std::borrow::Cow;
use std::fmt::Display;
use std::fs;
use std::io::{self, IsTerminal, Write};
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
    /// How the name of the file ends, if there is one.
    pub fn extension(&self) -> Option<&str> {
        self.output.as_ref()?.extension()?.to_str()
    }

    /// Writes a text that ends with a line feed, which is added where it is missing.
    pub fn write(&self, text: &str) -> Result<(), Failure> {
        self.output.as_ref().map_or_else(|| print(text), |path| save(path, text))
    }

    /// Writes what is no text, but not into a terminal.
    pub fn write_bytes(&self, bytes: &[u8]) -> Result<(), Failure> {
        match &self.output {
            Some(path) => save_bytes(path, bytes),
            None if io::stdout().is_terminal() => {
                Err(Failure::Usage("a picture is no text: name a file for it with -o".to_owned()))
            }
            None => print_bytes(bytes),
        }
    }
}

/// Writes a text to stdout, with a line feed at its end.
pub fn print(text: &str) -> Result<(), Failure> {
    print_bytes(&ended(text))
}

/// Writes a text to a file, with a line feed at its end.
pub fn save(path: &Path, text: &str) -> Result<(), Failure> {
    save_bytes(path, &ended(text))
}

fn print_bytes(bytes: &[u8]) -> Result<(), Failure> {
    write(io::stdout().lock(), bytes).map_err(|error| Failure::writing("stdout", &error))
}

fn save_bytes(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    fs::File::create(path)
        .and_then(|file| write(file, bytes))
        .map_err(|error| Failure::writing(path.display(), &error))
}

fn ended(text: &str) -> Cow<'_, [u8]> {
    if text.ends_with('\n') { text.as_bytes().into() } else { format!("{text}\n").into_bytes().into() }
}

fn write(mut target: impl Write, bytes: &[u8]) -> io::Result<()> {
    target.write_all(bytes)?;
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
