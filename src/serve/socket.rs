//! A WebSocket and the session behind it: commands in, updates out.
//!
//! A page says `drawn` when it has shown an update, and gets the next one then: the newest, so that a page that is
//! slow, or far away, skips pictures, and none wait in between.

use std::sync::Arc;

use axum::extract::ws::{CloseFrame, Message, WebSocket, close_code};
use tokio::sync::Notify;

use crate::live::{Seen, Studio};

/// What a page says when it is ready for the next update.
const DRAWN: &str = "drawn";

/// Serves a page until it is closed.
pub(super) async fn run(mut socket: WebSocket, studio: Arc<Studio>) {
    let news = Arc::new(Notify::new());
    let waker = Arc::clone(&news);
    let session = match studio.open(move || waker.notify_one()) {
        Ok(session) => session,
        Err(error) => return close(socket, &error.to_string()).await,
    };
    if socket.send(Message::text(session.greeting())).await.is_err() {
        return;
    }
    let mut seen = Seen::default();
    let mut is_ready = true;
    loop {
        tokio::select! {
            message = socket.recv() => match message {
                Some(Ok(Message::Text(text))) if text == DRAWN => is_ready = true,
                Some(Ok(Message::Text(text))) => {
                    if let Err(error) = session.tell(&text) {
                        return close(socket, &error.to_string()).await;
                    }
                }
                Some(Ok(Message::Ping(_) | Message::Pong(_))) => {}
                Some(Ok(Message::Binary(_))) => return close(socket, "not a command: bytes").await,
                Some(Ok(Message::Close(_)) | Err(_)) | None => return,
            },
            () = news.notified(), if is_ready => {
                if let Some(update) = session.update(&mut seen) {
                    is_ready = false;
                    if socket.send(Message::binary(update)).await.is_err() {
                        return;
                    }
                }
            }
        }
    }
}

/// Closes a socket, and says why.
async fn close(mut socket: WebSocket, reason: &str) {
    /// Longer reasons do not fit into a frame.
    const LONGEST: usize = 123;
    let mut reason = reason.to_owned();
    while reason.len() > LONGEST {
        reason.pop();
    }
    let frame = CloseFrame { code: close_code::POLICY, reason: reason.into() };
    // Who has gone need not be told.
    let _ = socket.send(Message::Close(Some(frame))).await;
}
