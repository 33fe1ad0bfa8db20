//! How far a long command has come.

use indicatif::{ProgressBar, ProgressStyle};

/// Drawn on stderr, and only where that is a terminal.
pub fn progress(parts: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} %, {eta} left")
        .expect("the template of the progress bar is right");
    ProgressBar::new(parts as u64).with_style(style)
}
