//! `srt view`, asked as a browser would: pages by HTTP, a picture that refines by WebSocket.

#![allow(clippy::unwrap_used, reason = "a panic is a failed test")]

mod arguments;
mod ending;
mod looking;
mod requests;
mod saving;
mod support;
