//! The page on which a scene is looked at: HTTP and WebSocket on one address of this machine.
//!
//! The page, its style and its script are part of the program; no request reads a file. Each request must name the
//! token that is part of the address, and a host that nobody else's name can stand for (`guard.rs`). A page opens a
//! WebSocket, whose messages are those of a [`Session`](crate::live::Session) (`socket.rs`).
//!
//! One thread serves all: it waits for sockets, and other threads render.
//!
//! Knows nothing of scenes, pictures and the terminal.

mod guard;
mod pages;
mod socket;

use std::io;
use std::net::{IpAddr, SocketAddr, TcpListener};
use std::sync::Arc;

use crate::live::Studio;

use guard::Guard;

/// A place at which a page is served.
pub struct Site {
    listener: TcpListener,
    address: SocketAddr,
    guard: Guard,
}

/// Why there is no page.
#[derive(Debug, thiserror::Error)]
pub enum SiteError {
    /// The address cannot be had.
    #[error("cannot listen on {address}: {source}")]
    Listen {
        /// Which.
        address: SocketAddr,
        /// Why.
        source: io::Error,
    },
    /// The system has no random numbers, so no token can be made.
    #[error("no random numbers for the token of the address: {0}")]
    Token(String),
    /// What carries the page does not start, or fails.
    #[error("the page cannot be served: {0}")]
    Serve(#[from] io::Error),
}

impl Site {
    /// Listens on an address of this machine; port 0 is any that is free.
    ///
    /// # Errors
    /// If another program has the port, or the machine does not have the address.
    pub fn listen(address: IpAddr, port: u16) -> Result<Self, SiteError> {
        let address = SocketAddr::new(address, port);
        let failed = |source| SiteError::Listen { address, source };
        let listener = TcpListener::bind(address).map_err(failed)?;
        let address = listener.local_addr().map_err(failed)?;
        listener.set_nonblocking(true).map_err(failed)?;
        let mut token = [0; 16];
        getrandom::fill(&mut token).map_err(|error| SiteError::Token(error.to_string()))?;
        Ok(Self { listener, address, guard: Guard::new(token, address.ip()) })
    }

    /// Where it listens.
    #[must_use]
    pub fn address(&self) -> SocketAddr {
        self.address
    }

    /// The address of the page, token included, for a browser on this machine.
    #[must_use]
    pub fn url(&self) -> String {
        let shown = match self.address.ip() {
            // What listens everywhere is reached here by the loopback address.
            IpAddr::V4(all) if all.is_unspecified() => IpAddr::from([127, 0, 0, 1]),
            IpAddr::V6(all) if all.is_unspecified() => IpAddr::from([0, 0, 0, 0, 0, 0, 0, 1]),
            address => address,
        };
        format!("http://{}/{}/", SocketAddr::new(shown, self.address.port()), self.guard.token())
    }

    /// Serves the page for as long as the process lives.
    ///
    /// # Errors
    /// If the system does not let it.
    pub fn serve(self, studio: Arc<Studio>) -> Result<(), SiteError> {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build()?;
        runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(self.listener)?;
            axum::serve(listener, pages::router(self.guard, studio)).await
        })?;
        Ok(())
    }
}
