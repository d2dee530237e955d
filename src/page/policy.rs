//! What pages may load and run, as their content security policies say it.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

/// Of a file: it loads nothing, and runs the script whose hash this is.
pub(super) fn file_policy(script: &str) -> String {
    let hash = STANDARD.encode(Sha256::digest(script));
    format!(
        "default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-{hash}'"
    )
}

/// Of a page that is served: it loads its own files, and speaks with its own host, a name and a port, by WebSocket too.
/// Nobody may frame it.
pub(crate) fn served_policy(host: Option<&str>) -> String {
    let socket = host.map(|host| format!(" ws://{host}")).unwrap_or_default();
    format!(
        "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; \
         connect-src 'self'{socket}; base-uri 'none'; form-action 'none'; frame-ancestors 'none'"
    )
}
