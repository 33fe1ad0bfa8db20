//! The one place where errors are printed.

use std::fmt::{self, Display};
use std::io::{self, Write};
use std::process::ExitCode;

use rangelab::Error;

/// Problems named in one sentence; `rangelab validate` lists the rest.
const PROBLEMS_NAMED: usize = 3;

/// Why the program ends without having done what was asked.
#[derive(Debug)]
pub enum Failure {
    /// The command line or the data are wrong; exit code 2.
    Usage(String),
    /// Anything else; exit code 1.
    Other(String),
    /// Ctrl-C; exit code 130, as shells give it.
    Cancelled {
        /// How far it had come.
        percent: usize,
    },
    /// Whoever read the output has seen enough; no error.
    ReaderGone,
}

impl Failure {
    /// An error of the library about the data of `origin`.
    pub fn about(origin: impl Display, error: &Error) -> Self {
        let sentence = format!("{origin}: {}", sentence(error));
        match error {
            Error::Unobservable { .. }
            | Error::TooFew { .. }
            | Error::PairTooFew { .. }
            | Error::Degenerate { .. }
            | Error::NotPositiveDefinite { .. }
            | Error::NoConvergence { .. } => Self::Other(sentence),
            _ => Self::Usage(sentence),
        }
    }

    /// An error of the operating system while `name` was written.
    pub fn writing(name: impl Display, error: &io::Error) -> Self {
        match error.kind() {
            io::ErrorKind::BrokenPipe => Self::ReaderGone,
            _ => Self::Other(format!("{name} cannot be written: {error}")),
        }
    }

    /// Prints the sentence, if there is one, and gives the exit code.
    pub fn report(&self) -> ExitCode {
        let code = match self {
            Self::Usage(_) => 2,
            Self::Other(_) => 1,
            Self::Cancelled { .. } => 130,
            Self::ReaderGone => return ExitCode::SUCCESS,
        };
        // If stderr is closed too, the exit code is all that is left to say.
        let _ = writeln!(io::stderr(), "rangelab: {self}");
        ExitCode::from(code)
    }
}

impl Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Usage(sentence) | Self::Other(sentence) => f.write_str(sentence),
            Self::Cancelled { percent } => write!(f, "cancelled at {percent} %, nothing is written"),
            Self::ReaderGone => f.write_str("the reader of the output is gone"),
        }
    }
}

fn sentence(error: &Error) -> String {
    match error {
        Error::Invalid { document, problems } if problems.len() > PROBLEMS_NAMED => {
            let first =
                Error::Invalid { document, problems: problems[..PROBLEMS_NAMED].to_vec() }.to_string();
            let named = first.split_once("; ").map_or("", |(_, named)| named);
            format!(
                "the {document} has {} problems; {named}; the rest by `rangelab validate`",
                problems.len()
            )
        }
        _ => error.to_string(),
    }
}
