//! Runs the built `rangelab` and looks at all it gives back.

use std::io::Write;
use std::path::PathBuf;
use std::process::{Command, Output, Stdio};

/// What came back.
#[derive(Debug)]
pub struct Outcome {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Outcome {
    fn of(output: Output) -> Self {
        let text = |bytes| String::from_utf8(bytes).expect("UTF-8");
        let code = output.status.code().expect("an exit code, no signal");
        Self { code, stdout: text(output.stdout), stderr: text(output.stderr) }
    }

    /// The data of a command that went well.
    #[track_caller]
    pub fn data(self) -> String {
        assert!(self.code == 0 && self.stderr.is_empty(), "{} {}", self.code, self.stderr);
        self.stdout
    }

    /// No data, one line on stderr that holds `words`.
    #[track_caller]
    pub fn failed(&self, code: i32, words: &str) {
        let one_line = self.stderr.lines().count() == 1 && self.stderr.starts_with("rangelab: ");
        assert!(one_line && self.stderr.contains(words), "{words:?} expected: {}", self.stderr);
        assert!(self.code == code && self.stdout.is_empty(), "{} {}", self.code, self.stdout);
    }

    /// [`Outcome::failed`] with the code of wrong usage or data.
    #[track_caller]
    pub fn refused(&self, words: &str) {
        self.failed(2, words);
    }
}

pub fn rangelab(arguments: &[&str]) -> Outcome {
    rangelab_with("", arguments)
}

/// With a text on stdin.
pub fn rangelab_with(input: &str, arguments: &[&str]) -> Outcome {
    let mut child = command(arguments).stdin(Stdio::piped()).spawn().expect("rangelab starts");
    let mut stdin = child.stdin.take().expect("a pipe");
    let input = input.to_owned();
    // Both ends may be longer than a pipe. A command that does not read its input closes it: no matter.
    let writer = std::thread::spawn(move || drop(stdin.write_all(input.as_bytes())));
    let output = child.wait_with_output().expect("rangelab ends");
    writer.join().expect("the writer ends");
    Outcome::of(output)
}

/// With a reader of stdout that is gone before anything is written.
pub fn rangelab_unread(arguments: &[&str]) -> Outcome {
    let mut child = command(arguments).stdin(Stdio::null()).spawn().expect("rangelab starts");
    drop(child.stdout.take());
    Outcome::of(child.wait_with_output().expect("rangelab ends"))
}

/// An empty folder for a test.
pub fn folder(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn command(arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_rangelab"));
    command.args(arguments).stdout(Stdio::piped()).stderr(Stdio::piped());
    command
}
