"""Browser(): a headless Chromium, driven through a pipe by its DevTools protocol; it opens local pages alone."""
import base64
import json
import os
import shutil
import struct
import subprocess
import tempfile
import time
import zlib


class Browser:
    def __enter__(self):
        self.profile = tempfile.mkdtemp()
        theirs_in, self.requests = os.pipe()
        self.answers, theirs_out = os.pipe()

        def connect():
            """Chromium reads requests from descriptor 3 and answers on 4: copies, as the pipes may have these numbers."""
            read, write = os.dup2(theirs_in, 20), os.dup2(theirs_out, 21)
            os.dup2(read, 3), os.dup2(write, 4)

        self.process = subprocess.Popen(
            ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--no-first-run", "--hide-scrollbars",
             "--disable-background-networking", f"--user-data-dir={self.profile}", "--remote-debugging-pipe"],
            preexec_fn=connect, close_fds=False, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(theirs_in), os.close(theirs_out)
        self.received, self.number, self.session = b"", 0, None
        target = self.ask("Target.createTarget", url="about:blank")["targetId"]
        self.session = self.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait(20)
        shutil.rmtree(self.profile, ignore_errors=True)

    def answer(self):
        while b"\0" not in self.received:
            part = os.read(self.answers, 1 << 16)
            if not part:
                raise EOFError("chromium has ended")
            self.received += part
        message, self.received = self.received.split(b"\0", 1)
        return json.loads(message)

    def ask(self, method, **params):
        self.number += 1
        request = {"id": self.number, "method": method, "params": params}
        if self.session:
            request["sessionId"] = self.session
        os.write(self.requests, json.dumps(request).encode() + b"\0")
        while (message := self.answer()).get("id") != self.number:
            pass
        if "error" in message:
            raise RuntimeError(f"{method}: {message['error']}")
        return message["result"]

    def open(self, path, width, scheme="light"):
        """Shows a page as on a screen of that many pixels, that of a phone below 600."""
        self.ask("Emulation.setDeviceMetricsOverride", width=width, height=800, deviceScaleFactor=1, mobile=width < 600)
        self.ask("Emulation.setEmulatedMedia", features=[{"name": "prefers-color-scheme", "value": scheme}])
        self.ask("Page.navigate", url="about:blank")
        file, _, anchor = str(path).partition("#")
        self.ask("Page.navigate", url=f"file://{os.path.realpath(file)}{'#' if anchor else ''}{anchor}")
        while self.run("document.readyState") != "complete":
            time.sleep(0.01)

    def run(self, script):
        """The value of a JavaScript expression in the page."""
        result = self.ask("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(result["exceptionDetails"])
        return result["result"].get("value")

    def picture(self, x, y, width, height):
        """A part of the page as PNG."""
        clip = {"x": x, "y": y, "width": width, "height": height, "scale": 1}
        return base64.b64decode(self.ask("Page.captureScreenshot", captureBeyondViewport=True, clip=clip)["data"])


def pixels(png):
    """Rows of (red, green, blue)."""
    at, data, channels, width = 8, b"", 0, 0
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at:at + 8])
        part = png[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, _, depth, colours = struct.unpack(">IIBB", part[:10])
            channels = {2: 3, 6: 4}[colours]
            assert depth == 8
        elif kind == b"IDAT":
            data += part
        at += length + 12
    raw, stride, before, rows = zlib.decompress(data), width * channels, bytearray(width * channels), []
    for start in range(0, len(raw), stride + 1):
        row = bytearray(raw[start + 1:start + 1 + stride])
        for i in range(stride):
            left, up = row[i - channels] if i >= channels else 0, before[i]
            corner = before[i - channels] if i >= channels else 0
            guess = left + up - corner
            nearest = min((left, up, corner), key=lambda each: abs(guess - each))
            row[i] = row[i] + (0, left, up, (left + up) // 2, nearest)[raw[start]] & 255
        rows.append([tuple(row[i:i + 3]) for i in range(0, stride, channels)])
        before = row
    return rows
