//! `rough-contact app`: the page in a browser, with this program as its engine.

use crate::args::CommonOptions;
use crate::outcome::{self, Failure, Reply, tell};
use crate::serve::Site;
use clap::Args;
use serde_json::json;
use std::net::{Ipv4Addr, TcpListener};
use std::process::{Command, Stdio};

#[derive(Args)]
pub(crate) struct App {
    /// Print the address only, and open no browser
    #[arg(long)]
    no_open: bool,
}

impl App {
    /// Serves the page on the loopback address until it is ended.
    pub(crate) fn run(&self, common: &CommonOptions) -> Result<Reply, Failure> {
        let refused = |e: std::io::Error| {
            let message = format!("no port of 127.0.0.1 can be listened to: {e}");
            Failure::incomplete("io", message)
        };
        let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, 0)).map_err(refused)?;
        let port = listener.local_addr().map_err(refused)?.port();
        let site = Site::new(port, secret()?, common.threads(), common.quiet);
        let address = site.address();
        if common.json {
            outcome::show(&format!("{}\n", json!({ "address": address })));
        } else {
            outcome::show(&format!("{address}\n"));
        }
        if !common.quiet {
            tell(
                "The page at this address computes with this program, on this machine only. Ctrl-C ends it.",
            );
        }
        if !self.no_open && !open(&address) {
            tell("rough-contact: no browser could be opened; open the address above in one");
        }
        site.serve(&listener)
    }
}

/// 128 bits that nobody can guess.
fn secret() -> Result<String, Failure> {
    let mut bytes = [0; 16];
    getrandom::fill(&mut bytes).map_err(|e| {
        Failure::incomplete("io", format!("the system gives no random numbers: {e}"))
    })?;
    Ok(format!("{:032x}", u128::from_ne_bytes(bytes)))
}

/// Opens the address as the system opens one. True if that could be started.
fn open(address: &str) -> bool {
    let mut command = if cfg!(target_os = "macos") {
        Command::new("open")
    } else if cfg!(windows) {
        // `start` would have the shell read the address.
        let mut command = Command::new("rundll32");
        command.arg("url.dll,FileProtocolHandler");
        command
    } else {
        Command::new("xdg-open")
    };
    command.arg(address).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::null());
    command.spawn().is_ok()
}
