"""Chromium without a screen, over its own pipe (--remote-debugging-pipe): JSON messages that end in a zero byte. Needs nothing but Python."""

import base64
import json
import os
import select
import subprocess
import tempfile
import time
from pathlib import Path

from waits import Waits

FLAGS = ["--headless", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--hide-scrollbars", "--force-device-scale-factor=1",
         "--remote-debugging-pipe", "--no-first-run", "--disable-background-networking", "--force-color-profile=srgb"]


class Page(Waits):
    """A page of the size. `complaints`: errors and warnings of its console so far, and requests to the network."""

    def __init__(self, width, height, program="chromium"):
        self.folder = tempfile.TemporaryDirectory(prefix="perimpact-chromium-", ignore_cleanup_errors=True)
        read_here, write_there = os.pipe()
        read_there, write_here = os.pipe()

        def pipes():  # Chromium reads commands from 3 and writes to 4
            ends = os.dup(read_there), os.dup(write_there)
            os.dup2(ends[0], 3)
            os.dup2(ends[1], 4)

        self.process = subprocess.Popen([program, *FLAGS, f"--user-data-dir={self.folder.name}", f"--window-size={width},{height}", "about:blank"],
                                        preexec_fn=pipes, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(read_there)
        os.close(write_there)
        self.commands, self.answers = write_here, read_here
        self.number, self.buffer, self.complaints, self.session = 0, b"", [], None
        target = next(each for each in self.ask("Target.getTargets")["targetInfos"] if each["type"] == "page")
        self.session = self.ask("Target.attachToTarget", targetId=target["targetId"], flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.ask(f"{domain}.enable")
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def close(self):
        try:
            self.session = None
            self.ask("Browser.close")
        except (OSError, RuntimeError):
            pass
        self.process.wait(30)
        self.folder.cleanup()

    def message(self, seconds):
        """The next one, or nothing within that time."""
        end = time.monotonic() + seconds
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.answers], [], [], max(0.0, end - time.monotonic()))
            if not ready:
                return None
            chunk = os.read(self.answers, 1 << 20)
            if not chunk:
                raise RuntimeError("Chromium has ended")
            self.buffer += chunk
        text, self.buffer = self.buffer.split(b"\0", 1)
        reported = json.loads(text)
        what, about = reported.get("method"), reported.get("params", {})
        if what == "Runtime.exceptionThrown":
            self.complaints.append(about["exceptionDetails"].get("exception", {}).get("description", about["exceptionDetails"]["text"]))
        elif what == "Runtime.consoleAPICalled" and about["type"] in ("error", "warning", "assert"):
            self.complaints.append(" ".join(str(each.get("value", each.get("description"))) for each in about["args"]))
        elif what == "Log.entryAdded" and about["entry"]["level"] in ("error", "warning"):
            self.complaints.append(about["entry"]["text"])
        elif what == "Network.requestWillBeSent" and about["request"]["url"].split(":")[0] not in ("file", "data", "blob"):
            self.complaints.append("asks for " + about["request"]["url"])
        return reported

    def ask(self, method, **parameters):
        self.number += 1
        command = {"id": self.number, "method": method, "params": parameters}
        if self.session:
            command["sessionId"] = self.session
        os.write(self.commands, json.dumps(command).encode() + b"\0")
        while True:
            reported = self.message(120)
            if reported is None:
                raise RuntimeError(f"Chromium does not answer {method}")
            if reported.get("id") == self.number:
                if "error" in reported:
                    raise RuntimeError(f"{method}: {reported['error']['message']}")
                return reported["result"]

    def open(self, file):
        self.ask("Page.navigate", url=Path(file).resolve().as_uri())

    def value(self, expression):
        reported = self.ask("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in reported:
            raise RuntimeError(f"{expression}: {reported['exceptionDetails']}")
        return reported["result"].get("value")

    def press(self, key, code=None):
        text = {"text": key} if len(key) == 1 else {}
        numbers = {"ArrowLeft": 37, "ArrowRight": 39, "Home": 36, "End": 35, " ": 32}
        about = {"key": key, "code": code or ("Space" if key == " " else key), "windowsVirtualKeyCode": numbers.get(key, ord(key[0].upper()))}
        self.ask("Input.dispatchKeyEvent", type="keyDown", **about, **text)
        self.ask("Input.dispatchKeyEvent", type="keyUp", **about)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def downloads(self, folder):
        """Where files that the page saves come to."""
        self.ask("Browser.setDownloadBehavior", behavior="allow", downloadPath=str(folder))

    def paper(self, path, landscape=False):
        """Prints to PDF, A4."""
        answer = self.ask("Page.printToPDF", landscape=landscape, printBackground=True, paperWidth=8.27, paperHeight=11.69)
        Path(path).write_bytes(base64.b64decode(answer["data"]))

    def picture(self, path, width=None, height=None):
        """Of all that is seen, or of its upper left corner."""
        # one more turn of the screen first: what was asked to be drawn is
        self.value("new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(true))))")
        clip = {"clip": {"x": 0, "y": 0, "width": width, "height": height, "scale": 1}} if width else {}
        Path(path).write_bytes(base64.b64decode(self.ask("Page.captureScreenshot", format="png", **clip)["data"]))
