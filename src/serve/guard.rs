//! Who may ask: whoever knows the token, by an address that no other site's name can stand for.
//!
//! A page of another site can send requests to this machine from the browser of its user. Three things keep it out. It
//! does not know the token. The host that it names is its own (a name that its owner lets stand for this machine's
//! address, which is called DNS rebinding), while here a host must be `localhost` or an address in digits, which cannot
//! be made to stand for another. And its origin, which browsers tell, is not this page.

use std::net::IpAddr;

/// What requests are held to.
#[derive(Clone, Debug)]
pub(super) struct Guard {
    token: String,
    /// Whether other machines may ask.
    is_open: bool,
}

/// Why a request is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub(super) enum Refusal {
    #[error(
        "the host of this request is no address of this page: use the address that srt has printed"
    )]
    Host,
    #[error("this request comes from another site")]
    Origin,
    #[error("the address lacks the token: use the address that srt has printed, to its end")]
    Token,
}

impl Guard {
    /// A guard with a token, of a page that listens on an address.
    pub(super) fn new(token: [u8; 16], address: IpAddr) -> Self {
        let token = token.iter().map(|byte| format!("{byte:02x}")).collect();
        Self { token, is_open: !address.is_loopback() }
    }

    /// The token in digits.
    pub(super) fn token(&self) -> &str {
        &self.token
    }

    /// Checks a request by its path, its host and its origin.
    ///
    /// Returns the path behind the token, without the slash between them; `None` if there is no such slash.
    pub(super) fn admit<'a>(
        &self,
        path: &'a str,
        host: Option<&str>,
        origin: Option<&str>,
    ) -> Result<Option<&'a str>, Refusal> {
        let host = host.filter(|host| self.is_host(host)).ok_or(Refusal::Host)?;
        if origin.is_some_and(|origin| origin.strip_prefix("http://") != Some(host)) {
            return Err(Refusal::Origin);
        }
        let path = path.strip_prefix('/').unwrap_or(path);
        let (token, rest) = match path.split_once('/') {
            Some((token, rest)) => (token, Some(rest)),
            None => (path, None),
        };
        if self.is_token(token) { Ok(rest) } else { Err(Refusal::Token) }
    }

    /// Whether a host, with or without a port, cannot be a name of another site.
    fn is_host(&self, host: &str) -> bool {
        let name = match host.rsplit_once(':') {
            Some((name, port)) if port.bytes().all(|byte| byte.is_ascii_digit()) => name,
            _ => host,
        };
        if name.eq_ignore_ascii_case("localhost") {
            return true;
        }
        let digits = name.strip_prefix('[').and_then(|inner| inner.strip_suffix(']'));
        let address = digits.unwrap_or(name).parse::<IpAddr>();
        address.is_ok_and(|address| self.is_open || address.is_loopback())
    }

    /// Compares all digits, however early one differs, so that the time tells nothing.
    fn is_token(&self, token: &str) -> bool {
        let differences = self.token.bytes().zip(token.bytes()).map(|(a, b)| a ^ b);
        token.len() == self.token.len() && differences.fold(0, |sum, one| sum | one) == 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TOKEN: &str = "000102030405060708090a0b0c0d0e0f";

    fn guard(address: [u8; 4]) -> Guard {
        let token: [u8; 16] = std::array::from_fn(|i| i as u8);
        Guard::new(token, address.into())
    }

    #[test]
    fn the_token_opens_and_nothing_else_does() {
        let guard = guard([127, 0, 0, 1]);
        assert_eq!(guard.token(), TOKEN);
        let admit = |path: &str| {
            let admitted = guard.admit(path, Some("127.0.0.1:8000"), None);
            admitted.map(|rest| rest.map(str::to_owned))
        };
        assert_eq!(admit(&format!("/{TOKEN}/")), Ok(Some(String::new())));
        assert_eq!(admit(&format!("/{TOKEN}/view.js")), Ok(Some("view.js".to_owned())));
        assert_eq!(admit(&format!("/{TOKEN}")), Ok(None));
        for path in ["", "/", "/view.js", &format!("/{}/", &TOKEN[1..]), &format!("/{TOKEN}0/")] {
            assert_eq!(admit(path), Err(Refusal::Token), "{path}");
        }
    }

    #[test]
    fn names_of_other_sites_are_no_hosts() {
        let path = format!("/{TOKEN}/");
        let (closed, open) = (guard([127, 0, 0, 1]), guard([0, 0, 0, 0]));
        let admits = |guard: &Guard, host| guard.admit(&path, Some(host), None).is_ok();
        for host in ["127.0.0.1:8000", "127.0.0.1", "localhost:1", "LOCALHOST", "[::1]:80", "[::1]"]
        {
            assert!(admits(&closed, host) && admits(&open, host), "{host}");
        }
        for host in ["192.168.1.7:8000", "[fe80::1]:80"] {
            assert!(!admits(&closed, host) && admits(&open, host), "{host}");
        }
        for host in ["", "example.org", "example.org:8000", "127.0.0.1.example.org", "localhost.a"]
        {
            assert!(!admits(&closed, host) && !admits(&open, host), "{host}");
        }
        assert_eq!(closed.admit(&path, None, None), Err(Refusal::Host));
    }

    #[test]
    fn other_origins_are_refused() {
        let guard = guard([127, 0, 0, 1]);
        let path = format!("/{TOKEN}/socket");
        let admit = |origin| guard.admit(&path, Some("127.0.0.1:8000"), Some(origin));
        assert!(admit("http://127.0.0.1:8000").is_ok());
        for origin in ["http://example.org", "https://127.0.0.1:8000", "http://127.0.0.1:9", "null"]
        {
            assert_eq!(admit(origin), Err(Refusal::Origin), "{origin}");
        }
    }
}
