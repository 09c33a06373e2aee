//! How a command can fail, and how failures are reported.

use coulter::case::CaseError;
use coulter::printed::plain;
use miette::{GraphicalReportHandler, GraphicalTheme};
use std::io::{IsTerminal, Write};

/// Why a command failed.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The case file is wrong.
    #[error(transparent)]
    Case(#[from] CaseError),
    /// The request is wrong in another way; says what to do instead.
    #[error("{0}")]
    Request(String),
    /// The request was right, but the physics failed.
    #[error("{0}")]
    Physics(String),
    /// A signal stopped the program.
    #[error("{message}")]
    Stopped {
        /// Number of the signal.
        signal: i32,
        /// What was written, and how to continue.
        message: String,
    },
    /// The first of several processes reports the failure; this one has its exit code.
    #[error("another process of the run has failed")]
    Elsewhere(u8),
}

impl Failure {
    /// 1 if the physics failed, 2 if the request was wrong, 128 and the number of the signal if it was
    /// stopped by one.
    fn exit_code(&self) -> u8 {
        match self {
            Self::Physics(_) => 1,
            Self::Stopped { signal, .. } => u8::try_from(128 + signal).unwrap_or(130),
            Self::Case(_) | Self::Request(_) => 2,
            Self::Elsewhere(code) => *code,
        }
    }

    /// The failure without a message, for a process that is not the first of several: they all fail alike.
    pub(super) fn unsaid(self) -> Self {
        Self::Elsewhere(self.exit_code())
    }

    /// Reports the failure on standard error.
    pub(super) fn report(&self) -> u8 {
        let text = match self {
            // Its texts are plain already; colours are ours.
            Self::Case(error) => render(error, is_colourful()),
            Self::Request(message) | Self::Physics(message) => format!("error: {}\n", plain(message)),
            Self::Stopped { message, .. } => format!("{}\n", plain(message)),
            Self::Elsewhere(_) => String::new(),
        };
        let _ = std::io::stderr().lock().write_all(text.as_bytes());
        self.exit_code()
    }
}

/// Whether to use colours: on a terminal that supports them, unless <https://no-color.org> says otherwise.
fn is_colourful() -> bool {
    let is_plain = std::env::var_os("TERM").is_some_and(|name| name == "dumb")
        || std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    std::io::stderr().is_terminal() && !is_plain
}

/// Every problem with its line, and a count, as the command prints them.
#[must_use]
pub fn problems_text(error: &CaseError) -> String {
    render(error, false)
}

fn render(error: &CaseError, colour: bool) -> String {
    let theme = if colour { GraphicalTheme::unicode() } else { GraphicalTheme::unicode_nocolor() };
    let handler = GraphicalReportHandler::new_themed(theme).with_width(110).with_links(false);
    let mut text = String::new();
    for problem in &error.problems {
        if handler.render_report(&mut text, problem).is_err() {
            text.push_str(&format!("  {}\n  help: {}\n", problem.message, problem.cure));
        }
        text.push('\n');
    }
    if error.unseen > 0 {
        text.push_str(&format!("… and {} more\n\n", error.unseen));
    }
    let count = match error.problems.len() + error.unseen {
        1 => "one problem".to_owned(),
        many => format!("{many} problems"),
    };
    text.push_str(&format!("{count} in {}; nothing was run\n", error.name));
    text
}
