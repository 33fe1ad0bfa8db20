//! `rangelab figure`: a figure of a paper, computed, with what holds of what is claimed about it.

mod picture;
mod table;

use clap::{Args, ValueEnum};
use rangelab::study::figures::plan::FigurePlan;
use rangelab::study::figures::report::FigureReport;
use rangelab::study::figures::{FIGURES, SEED, figure};

use super::failure::Failure;
use super::output::Output;
use super::text::wrapped;
use super::workers::{Jobs, Threads};

const EXAMPLES: &str = "\
Examples:
  rangelab figure                                    which figures there are
  rangelab figure tracking-2                         what is claimed, what is found, what holds
  rangelab figure tracking-2 -o figure.svg           the figure; also .png, .csv, .json
  rangelab figure tracking-3 --trials 10000 --seed 2 > claims.txt

A claim holds, or does not, where its number is clear of the target by three standard errors; else it is not decided at \
this number of trials. Pictures and tables hold the scenarios and the command. Trial i always gets the same random \
numbers: the result does not depend on the number of threads. Ctrl-C stops and writes nothing.";

/// Longest line of a text.
const LINE: usize = 100;

/// Compute a figure of a paper and check what is claimed about it, or list the figures
#[derive(Args)]
#[command(after_help = EXAMPLES)]
pub struct FigureCommand {
    /// Name of the figure; without it, they are listed
    #[arg(value_name = "NAME")]
    name: Option<String>,

    /// Number of trials [default: as many as in the paper, or in half a minute]
    #[arg(long, value_name = "COUNT")]
    trials: Option<usize>,

    /// Seed of the random numbers
    #[arg(long, value_name = "NUMBER", default_value_t = SEED)]
    seed: u64,

    #[command(flatten)]
    threads: Threads,

    /// text: claims and verdicts; json and csv: every number; svg, png [default: as the file ends, or text]
    #[arg(long, value_enum, help_heading = "Output")]
    format: Option<FigureFormat>,

    #[command(flatten)]
    output: Output,
}

#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
enum FigureFormat {
    Text,
    Json,
    Csv,
    Svg,
    Png,
}

impl FigureCommand {
    pub fn execute(&self) -> Result<(), Failure> {
        let Some(name) = &self.name else { return self.output.write(&list()) };
        let report = self.report(name)?;
        match self.format() {
            FigureFormat::Text => self.output.write(&table::text(&report)),
            FigureFormat::Json => self.output.write(&report.to_json()),
            FigureFormat::Csv => self.output.write(&report.to_csv()),
            FigureFormat::Svg => self.output.write(&picture::svg(&report)),
            FigureFormat::Png => self.output.write_bytes(&picture::png(&report)?),
        }
    }

    fn report(&self, name: &str) -> Result<FigureReport, Failure> {
        let about = |error| Failure::about(name, &error);
        let figure = figure(name).map_err(|error| Failure::Usage(error.to_string()))?;
        let plan = FigurePlan::new(figure, self.trials.unwrap_or(figure.trials), self.seed).map_err(about)?;
        let mut sum = plan.start();
        let jobs =
            Jobs { count: plan.jobs(), job: |index| plan.job(index), merge: |block| sum.merge(&block) };
        jobs.run(name, self.threads.count())?;
        plan.report(&sum).map_err(about)
    }

    /// What was asked for, or what the name of the file says.
    fn format(&self) -> FigureFormat {
        let ending = || FigureFormat::from_str(self.output.extension()?, true).ok();
        self.format.or_else(ending).unwrap_or(FigureFormat::Text)
    }
}

fn list() -> String {
    let width = FIGURES.iter().map(|figure| figure.name.len()).max().unwrap_or(0);
    let entries = FIGURES.iter().map(|figure| {
        let lines = wrapped(figure.statement, LINE - width - 2);
        let first = format!("{:<width$}  {}: {}\n", figure.name, figure.paper(), figure.title);
        lines.iter().fold(first, |entry, line| entry + &format!("{:width$}  {line}\n", ""))
    });
    entries.collect::<Vec<_>>().join("\n")
}
