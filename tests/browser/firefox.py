"""Firefox on a screen of Xvfb, over Marionette, its own remote protocol: `length:[0, number, command, parameters]` on a socket.

With --headless instead of Xvfb, Firefox 153 has no WebGL without a graphics card ("Exhausted GL driver options"). Needs nothing but Python."""

import base64
import json
import os
import socket
import subprocess
import tempfile
import time
from pathlib import Path

from waits import Waits

# WebGL without a graphics card; nothing is asked from outside
PREFERENCES = {"webgl.force-enabled": True, "webgl.disable-fail-if-major-performance-caveat": True, "gfx.webrender.software": True,
               "browser.shell.checkDefaultBrowser": False, "datareporting.policy.dataSubmissionEnabled": False, "toolkit.telemetry.enabled": False,
               "app.normandy.enabled": False, "app.update.auto": False, "extensions.update.enabled": False, "browser.safebrowsing.malware.enabled": False,
               "browser.safebrowsing.phishing.enabled": False, "network.captive-portal-service.enabled": False, "network.connectivity-service.enabled": False,
               "browser.download.folderList": 2, "browser.download.useDownloadDir": True, "browser.download.always_ask_before_handling_new_types": False,
               "ui.systemUsesDarkTheme": 0, "layout.css.prefers-color-scheme.content-override": 1}
# What the page says on its console: kept by the page itself, for Marionette has no events
LISTENER = """window.complaints = [];
for (const kind of ['error', 'warn', 'assert']) console[kind] = (...about) => window.complaints.push(about.join(' '));
addEventListener('error', each => window.complaints.push(each.message));
addEventListener('unhandledrejection', each => window.complaints.push(String(each.reason)));"""


class Page(Waits):
    """A page of the size; files that it saves come to `downloads`."""

    def __init__(self, width, height, downloads, program="firefox-esr"):
        self.folder = tempfile.TemporaryDirectory(prefix="perimpact-firefox-", ignore_cleanup_errors=True)
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            port = free.getsockname()[1]
        preferences = {**PREFERENCES, "marionette.port": port, "browser.download.dir": str(downloads)}
        (Path(self.folder.name) / "user.js").write_text("".join(f"user_pref({json.dumps(name)}, {json.dumps(value)});\n" for name, value in preferences.items()))
        read_here, write_there = os.pipe()
        self.screen = subprocess.Popen(["Xvfb", "-displayfd", str(write_there), "-screen", "0", "1920x1400x24", "-nolisten", "tcp"], pass_fds=[write_there],
                                       stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(write_there)
        with os.fdopen(read_here) as number:
            display = number.readline().strip()
        if not display:
            raise RuntimeError("Xvfb does not start")
        environment = {**os.environ, "DISPLAY": f":{display}", "LIBGL_ALWAYS_SOFTWARE": "1"}
        self.process = subprocess.Popen([program, "--marionette", "--no-remote", "--profile", self.folder.name, f"--width={width}", f"--height={height}"],
                                        env=environment, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.number, self.buffer = 0, b""
        begin = time.monotonic()
        while True:
            try:
                self.socket = socket.create_connection(("127.0.0.1", port), 120)
                break
            except OSError:
                if time.monotonic() - begin > 60 or self.process.poll() is not None:
                    raise RuntimeError("Firefox does not start")
                time.sleep(0.1)
        self.message()  # its greeting
        self.about = self.ask("WebDriver:NewSession", capabilities={"alwaysMatch": {"acceptInsecureCerts": True}})["capabilities"]

    def close(self):
        try:
            self.ask("Marionette:Quit", flags=["eForceQuit"])
        except (OSError, RuntimeError):
            pass
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        self.socket.close()
        self.screen.terminate()
        self.screen.wait()
        self.folder.cleanup()

    def message(self):
        while True:
            head, mark, rest = self.buffer.partition(b":")
            if mark and len(rest) >= int(head):
                self.buffer = rest[int(head):]
                return json.loads(rest[: int(head)])
            chunk = self.socket.recv(1 << 20)
            if not chunk:
                raise RuntimeError("Firefox has ended")
            self.buffer += chunk

    def ask(self, command, **parameters):
        self.number += 1
        text = json.dumps([0, self.number, command, parameters]).encode()
        self.socket.sendall(b"%d:" % len(text) + text)
        _, number, fault, answer = self.message()
        if number != self.number or fault:
            raise RuntimeError(f"{command}: {fault}")
        return answer

    def resize(self, width, height):
        """The page itself, without the frame of the window."""
        off = self.value("[outerWidth - innerWidth, outerHeight - innerHeight]")
        self.ask("WebDriver:SetWindowRect", width=width + off[0], height=height + off[1])

    def open(self, file):
        self.ask("WebDriver:Navigate", url=Path(file).resolve().as_uri())
        self.value(f"(() => {{ {LISTENER} }})()")

    @property
    def complaints(self):
        return self.value("window.complaints")

    def value(self, expression):
        return self.ask("WebDriver:ExecuteAsyncScript", script=f"Promise.resolve({expression}).then(arguments[0], fault => arguments[0]('fault: ' + fault))", args=[],
                        newSandbox=False, sandbox=None, scriptTimeout=120000)["value"]

    def press(self, key):
        keys = {"ArrowLeft": "\ue012", "ArrowRight": "\ue014", "Home": "\ue011", "End": "\ue010"}
        value = keys.get(key, key)
        self.ask("WebDriver:PerformActions", actions=[{"type": "key", "id": "keyboard", "actions": [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]}])

    def picture(self, path):
        Path(path).write_bytes(base64.b64decode(self.ask("WebDriver:TakeScreenshot", full=False)["value"]))

    def paper(self, path, landscape=False):
        """Prints to PDF, A4."""
        answer = self.ask("WebDriver:Print", orientation="landscape" if landscape else "portrait", background=True, page={"width": 21.0, "height": 29.7})
        Path(path).write_bytes(base64.b64decode(answer["value"]))
