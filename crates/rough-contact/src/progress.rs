//! Progress on standard error: a bar on a terminal, one line per step elsewhere, nothing with --quiet.

use crate::outcome::tell;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;

pub(crate) struct ProgressDisplay {
    bar: Option<ProgressBar>,
    lines: bool,
    total: usize,
    done: usize,
}

impl ProgressDisplay {
    /// Expects `total` steps; 0 if their number is not known.
    pub(crate) fn new(quiet: bool, total: usize) -> Self {
        let terminal = std::io::stderr().is_terminal();
        let bar = (!quiet && terminal).then(|| {
            let target = ProgressDrawTarget::stderr_with_hz(10);
            ProgressBar::with_draw_target(Some(total as u64), target).with_style(style(total))
        });
        Self { bar, lines: !quiet && !terminal, total, done: 0 }
    }

    /// Expects `total` further steps.
    pub(crate) fn restart(&mut self, total: usize) {
        self.total = total;
        self.done = 0;
        if let Some(bar) = &self.bar {
            bar.set_style(style(total));
            bar.set_length(total as u64);
            bar.set_position(0);
        }
    }

    pub(crate) fn working_on(&mut self, what: &str) {
        if let Some(bar) = &self.bar {
            bar.set_message(what.to_owned());
        } else if self.lines && self.total == 0 {
            tell(what);
        }
    }

    /// Where an iteration stands; on a terminal only, where it does not stay.
    pub(crate) fn iterating(&mut self, what: impl Fn() -> String) {
        if let Some(bar) = &self.bar {
            bar.set_message(what());
        }
    }

    pub(crate) fn step(&mut self, what: &str) {
        self.done += 1;
        if let Some(bar) = &self.bar {
            bar.set_message(what.to_owned());
            bar.inc(1);
        } else if self.lines {
            tell(&format!("{}/{} {what}", self.done, self.total));
        }
    }
}

impl Drop for ProgressDisplay {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn style(total: usize) -> ProgressStyle {
    let template = match total {
        0 => "{spinner} {msg} [{elapsed}]",
        _ => "{bar:24} {pos}/{len} {msg} [{elapsed}]",
    };
    ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar())
}
