//! A folder with a scene, `srt view` of it, and a page that looks.

use std::fs;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use srt::image_io::{Format, decode, rgba_bytes};
use tempfile::TempDir;
use tungstenite::client::IntoClientRequest;
use tungstenite::{Message, WebSocket};

/// A scene of every kind of ray; small and quick.
pub(crate) const SCENE: &str = "sce1.0
eyepos 0 -6 2.5
eyedir 0 1 -0.35
eyeup 0 0 1
wdist 1
fovy_deg 45
nx 40
ny 30
max_recursion 2
aasample 3
background 0.4 0.6 0.9
triangle -9 -9 0  9 -9 0  0 9 0
{
cp 0.3 0.3 0.3
ball 0.8 -1.5 0 0.8
}
{
translate 1.6 0.4 1
object_phong generate:torus-knot:1000
}
{
translate 0 -2 4
arealight 0.7 0.8 0.8 0.8
}
end
";

/// Longer than anything takes on a slow machine that is busy.
const TOO_LONG: Duration = Duration::from_secs(120);

/// A folder with `scene.sce` in it.
pub(crate) fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scene.sce"), SCENE).unwrap();
    folder
}

pub(crate) fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(assert_cmd::cargo::cargo_bin!("srt"));
    command.args(arguments).current_dir(folder).env_remove("NO_COLOR");
    command
}

/// The pixels of the picture that `srt scene.sce` renders, as screens take them.
pub(crate) fn rendered(folder: &Path, scene: &str, options: &[&str]) -> Vec<u8> {
    let arguments = [&[scene, "rendered.png", "--quiet"], options].concat();
    assert!(command(folder, &arguments).status().unwrap().success(), "{arguments:?}");
    let file = fs::read(folder.join("rendered.png")).unwrap();
    rgba_bytes(&decode(&file, Format::Png).unwrap())
}

/// `srt view scene.sce`, killed at the end.
pub(crate) struct Server {
    pub(crate) child: Child,
    /// `127.0.0.1:PORT`.
    pub(crate) host: String,
    pub(crate) token: String,
}

impl Server {
    pub(crate) fn start(folder: &Path, options: &[&str]) -> Self {
        let arguments = [&["view", "scene.sce", "--quiet"], options].concat();
        let mut child = command(folder, &arguments).stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let address = line.trim().strip_prefix("http://").unwrap().strip_suffix('/').unwrap();
        let (host, token) = address.split_once('/').unwrap();
        Self { host: host.to_owned(), token: token.to_owned(), child }
    }

    /// The status, the head and the body of the answer to a request for a path behind the token.
    pub(crate) fn get(&self, path: &str) -> Answer {
        self.ask("GET", &format!("/{}/{path}", self.token), &[("Host", &self.host)])
    }

    pub(crate) fn ask(&self, method: &str, path: &str, headers: &[(&str, &str)]) -> Answer {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(TOO_LONG)).unwrap();
        let headers: String =
            headers.iter().map(|(name, value)| format!("{name}: {value}\r\n")).collect();
        let request = format!("{method} {path} HTTP/1.1\r\n{headers}Connection: close\r\n\r\n");
        stream.write_all(request.as_bytes()).unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        Answer { status, head: head.to_lowercase(), body: body.to_owned() }
    }

    /// Opens a page's socket, with its origin.
    pub(crate) fn connect(&self, origin: Option<&str>) -> Result<Page, String> {
        let url = format!("ws://{}/{}/socket", self.host, self.token);
        let mut request = url.into_client_request().unwrap();
        if let Some(origin) = origin {
            request.headers_mut().insert("Origin", origin.parse().unwrap());
        }
        let stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(TOO_LONG)).unwrap();
        let (socket, _) =
            tungstenite::client(request, stream).map_err(|error| error.to_string())?;
        Ok(Page { socket, pictures: Vec::new(), id: 0 })
    }

    /// Opens a page that looks.
    pub(crate) fn look(&self) -> Page {
        let mut page = self.connect(Some(&format!("http://{}", self.host))).unwrap();
        let greeting = page.socket.read().unwrap().into_text().unwrap();
        let greeting: Value = serde_json::from_str(&greeting).unwrap();
        assert!(greeting["greeting"]["structures"].as_array().unwrap().len() >= 5, "{greeting}");
        page
    }

    /// The seconds of processor time that the process has used.
    pub(crate) fn processor_seconds(&self) -> f64 {
        let stat = fs::read_to_string(format!("/proc/{}/stat", self.child.id())).unwrap();
        let fields: Vec<&str> = stat.rsplit(')').next().unwrap().split_whitespace().collect();
        // User and system time, in ticks of a hundredth of a second, as Linux has it everywhere.
        [11, 12].iter().map(|&i: &usize| fields[i].parse::<f64>().unwrap()).sum::<f64>() / 100.0
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It may have ended.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

pub(crate) struct Answer {
    pub(crate) status: u16,
    /// In lower case.
    pub(crate) head: String,
    pub(crate) body: String,
}

/// Whether an update has a picture of the first structure.
pub(crate) fn has_picture(report: &Value) -> bool {
    report["lanes"][0]["picture_bytes"].as_u64().is_some_and(|bytes| bytes > 0)
}

/// A page that looks, and what it shows.
pub(crate) struct Page {
    pub(crate) socket: WebSocket<TcpStream>,
    /// For each structure the pixels that were sent last.
    pub(crate) pictures: Vec<Vec<u8>>,
    id: u64,
}

impl Page {
    /// Sends a command.
    pub(crate) fn tell(&mut self, command: Value) {
        self.id += 1;
        let message = serde_json::json!({"id": self.id, "do": command});
        self.socket.send(Message::text(message.to_string())).unwrap();
    }

    /// The next update; the picture changes if it has another.
    #[track_caller]
    pub(crate) fn next(&mut self) -> Value {
        loop {
            let message = match self.socket.read() {
                Ok(message) => message,
                Err(error) => panic!("no update comes: {error}"),
            };
            let Message::Binary(bytes) = message else { continue };
            let (length, rest) = bytes.split_first_chunk().unwrap();
            let (json, mut pixels) = rest.split_at(u32::from_le_bytes(*length) as usize);
            let report: Value = serde_json::from_slice(json).unwrap();
            let lanes = report["lanes"].as_array().unwrap();
            self.pictures.resize(lanes.len(), Vec::new());
            for (lane, picture) in lanes.iter().zip(&mut self.pictures) {
                let size = lane["picture_bytes"].as_u64().unwrap() as usize;
                let (own, others) = pixels.split_at(size);
                if size > 0 {
                    own.clone_into(picture);
                }
                pixels = others;
            }
            assert!(pixels.is_empty(), "bytes behind the pictures");
            self.socket.send(Message::text("drawn")).unwrap();
            return report;
        }
    }

    /// Updates until one is as wanted, which answers the last command.
    #[track_caller]
    pub(crate) fn until(&mut self, what: &str, wanted: impl Fn(&Value) -> bool) -> Value {
        let start = Instant::now();
        loop {
            let report = self.next();
            if report["answers"].as_u64() == Some(self.id) && wanted(&report) {
                return report;
            }
            assert!(start.elapsed() < TOO_LONG, "never {what}: {report}");
        }
    }

    /// The finished picture of the first structure.
    #[track_caller]
    pub(crate) fn finished(&mut self) -> Vec<u8> {
        self.until("finished", |report| report["complete"] == true);
        self.pictures[0].clone()
    }
}
