//! What a request gets: the page and its two files, the WebSocket, or a refusal.

use std::sync::Arc;

use axum::Router;
use axum::extract::ws::WebSocketUpgrade;
use axum::extract::{FromRequestParts, Request, State};
use axum::http::{HeaderMap, HeaderName, HeaderValue, Method, StatusCode, header};
use axum::response::{Html, IntoResponse, Response};
use maud::PreEscaped;

use crate::live::Studio;
use crate::page::{Page, Parts, served_policy};

use super::guard::Guard;
use super::socket;

/// The longest message that a page sends: commands are a few dozen bytes.
const LONGEST_MESSAGE: usize = 4096;

const SCRIPT: &str = "text/javascript; charset=utf-8";

/// The content of the page.
const CONTENT: &str = include_str!("page/view.html");

/// The files beside the page: their names behind the token, their types, their bytes.
const FILES: [(&str, &str, &str); 6] = [
    ("view.css", "text/css; charset=utf-8", include_str!("page/view.css")),
    ("view.js", SCRIPT, include_str!("page/view.js")),
    ("page.js", SCRIPT, include_str!("page/page.js")),
    ("hands.js", SCRIPT, include_str!("page/hands.js")),
    ("choices.js", SCRIPT, include_str!("page/choices.js")),
    ("figures.js", SCRIPT, include_str!("page/figures.js")),
];

/// The path of the WebSocket behind the token.
const SOCKET: &str = "socket";

struct Shared {
    guard: Guard,
    studio: Arc<Studio>,
}

/// What answers requests.
pub(super) fn router(guard: Guard, studio: Arc<Studio>) -> Router {
    Router::new().fallback(answer).with_state(Arc::new(Shared { guard, studio }))
}

async fn answer(State(shared): State<Arc<Shared>>, request: Request) -> Response {
    let headers = request.headers();
    let host = text(headers, &header::HOST);
    let origin = text(headers, &header::ORIGIN);
    let host_for_policy = host.map(str::to_owned);
    let response = match shared.guard.admit(request.uri().path(), host, origin) {
        Err(refusal) => plain(StatusCode::FORBIDDEN, &refusal.to_string()),
        Ok(_) if request.method() != Method::GET => {
            plain(StatusCode::METHOD_NOT_ALLOWED, "a page is read, by GET")
        }
        Ok(Some(SOCKET)) => return upgrade(request, Arc::clone(&shared.studio)).await,
        Ok(Some("")) => Html(page()).into_response(),
        Ok(rest) => match FILES.iter().find(|(name, ..)| rest == Some(name)) {
            Some((_, kind, bytes)) => ([(header::CONTENT_TYPE, *kind)], *bytes).into_response(),
            None => plain(StatusCode::NOT_FOUND, "there is no such page"),
        },
    };
    with_policy(response, host_for_policy.as_deref().unwrap_or_default())
}

/// The page itself.
fn page() -> String {
    let parts = Parts::Beside { style: "view.css", script: "view.js" };
    Page { title: "srt view", parts }.with(PreEscaped(CONTENT.to_owned()))
}

/// A header as text.
fn text<'a>(headers: &'a HeaderMap, name: &HeaderName) -> Option<&'a str> {
    headers.get(name).and_then(|value| value.to_str().ok())
}

async fn upgrade(request: Request, studio: Arc<Studio>) -> Response {
    let (mut parts, _) = request.into_parts();
    match WebSocketUpgrade::from_request_parts(&mut parts, &()).await {
        Ok(upgrade) => upgrade
            .max_message_size(LONGEST_MESSAGE)
            .max_frame_size(LONGEST_MESSAGE)
            .on_upgrade(|socket| socket::run(socket, studio)),
        Err(refusal) => refusal.into_response(),
    }
}

fn plain(status: StatusCode, text: &str) -> Response {
    let kind = [(header::CONTENT_TYPE, "text/plain; charset=utf-8")];
    (status, kind, format!("{text}\n")).into_response()
}

/// A page may load its own files and its own WebSocket, nothing else; nobody may frame or keep it, and nobody is told
/// its address.
fn with_policy(mut response: Response, host: &str) -> Response {
    // The host was admitted, or is not repeated: it holds no more than a name and a port.
    let is_plain =
        host.bytes().all(|byte| byte.is_ascii_alphanumeric() || b".:[]-".contains(&byte));
    let content = served_policy(Some(host).filter(|host| is_plain && !host.is_empty()));
    let headers = response.headers_mut();
    if let Ok(content) = HeaderValue::from_str(&content) {
        headers.insert(header::CONTENT_SECURITY_POLICY, content);
    }
    for (name, value) in [
        (header::CACHE_CONTROL, "no-store"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (HeaderName::from_static("cross-origin-opener-policy"), "same-origin"),
        (HeaderName::from_static("cross-origin-resource-policy"), "same-origin"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}
