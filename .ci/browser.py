"""A headless Chromium, driven by chromedriver: what the looks at pages share."""

import base64
import json
import subprocess
import sys
import tempfile
import time
import urllib.error
import urllib.request
from contextlib import contextmanager

PORT = 9515
OPTIONS = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]


def call(method, path, body=None):
    data = json.dumps(body).encode() if body is not None else None
    headers = {"Content-Type": "application/json"}
    request = urllib.request.Request(f"http://127.0.0.1:{PORT}{path}", data, headers, method=method)
    with urllib.request.urlopen(request, timeout=60) as answer:
        return json.load(answer)["value"]


def wait_for_driver():
    for _ in range(100):
        try:
            if call("GET", "/status")["ready"]:
                return
        except (urllib.error.URLError, ConnectionError):
            pass
        time.sleep(0.1)
    sys.exit("chromedriver does not answer")


class Browser:
    """A session of the browser."""

    def __init__(self, session):
        self.session = session

    def post(self, path, body):
        return call("POST", f"/session/{self.session}/{path}", body)

    def devtools(self, command, **parameters):
        return self.post("goog/cdp/execute", {"cmd": command, "params": parameters})

    def open(self, address):
        self.post("url", {"url": address})

    def run(self, script, *arguments):
        """What a script, the body of a function, returns."""
        return self.post("execute/sync", {"script": script, "args": list(arguments)})

    def look_as(self, width, height, medium="screen", scheme="light"):
        """Takes a size of the window, a medium and a colour scheme."""
        self.devtools(
            "Emulation.setDeviceMetricsOverride",
            width=width,
            height=height,
            deviceScaleFactor=1,
            mobile=False,
        )
        features = [{"name": "prefers-color-scheme", "value": scheme}]
        self.devtools("Emulation.setEmulatedMedia", media=medium, features=features)

    def picture(self, width, height):
        """A screenshot of the page from its top left corner, as PNG."""
        clip = {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}
        picture = self.devtools(
            "Page.captureScreenshot", format="png", captureBeyondViewport=True, clip=clip
        )
        return base64.b64decode(picture["data"])

    def console(self):
        """The messages since the last call."""
        return [message["message"] for message in self.post("se/log", {"type": "browser"})]


@contextmanager
def browser():
    with tempfile.TemporaryDirectory() as profile:
        driver = subprocess.Popen(["chromedriver", f"--port={PORT}"], stdout=subprocess.DEVNULL)
        try:
            wait_for_driver()
            options = {"args": [*OPTIONS, f"--user-data-dir={profile}"]}
            wanted = {"goog:chromeOptions": options, "goog:loggingPrefs": {"browser": "ALL"}}
            body = {"capabilities": {"alwaysMatch": wanted}}
            session = call("POST", "/session", body)["sessionId"]
            yield Browser(session)
            call("DELETE", f"/session/{session}")
        finally:
            driver.terminate()
            driver.wait()
