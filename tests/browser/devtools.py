"""A client of Chromium's DevTools protocol through two pipes (--remote-debugging-pipe): no network, no package.

The protocol: https://chromedevtools.github.io/devtools-protocol. Each message is JSON and ends in a zero byte.
"""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import threading
import time


# Of two that start at once one ends without a word, now and then.
starts_alone = threading.Lock()


class Browser:
    """A headless Chromium with a profile of its own, which ends with the `with` block."""

    def __init__(self, program, seconds_to_answer=60):
        self.seconds_to_answer = seconds_to_answer
        with starts_alone:
            self._start(program)

    def _start(self, program):
        self.profile = tempfile.mkdtemp(prefix="raylab-browser-")
        from_us, self.to_browser = os.pipe()
        self.from_browser, to_us = os.pipe()

        def pipes_as_3_and_4():  # where Chromium expects them; first out of the way of each other
            reading, writing = os.dup(from_us), os.dup(to_us)
            os.dup2(reading, 3)
            os.dup2(writing, 4)

        options = ["--headless=new", "--remote-debugging-pipe", "--user-data-dir=" + self.profile, "--no-first-run",
                   "--disable-gpu", "--disable-dev-shm-usage", "--disable-extensions", "--hide-scrollbars",
                   "--disable-background-networking", "--disable-component-update", "--force-color-profile=srgb",
                   "--enable-unsafe-swiftshader",  # WebGL without a graphics card
                   "--disable-ipc-flooding-protection"]  # nobody steps as fast as a test does
        if os.geteuid() == 0:
            options.append("--no-sandbox")  # Chromium's sandbox refuses to be started by root
        self.process = subprocess.Popen([program, *options, "about:blank"], preexec_fn=pipes_as_3_and_4,
                                        close_fds=False, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(from_us)
        os.close(to_us)
        self.unread = b""
        self.last_id = 0
        self.events = []
        self.send("Browser.getVersion")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        try:
            self.send("Browser.close")
            self.process.wait(10)
        except (OSError, RuntimeError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()
        shutil.rmtree(self.profile, ignore_errors=True)

    def send(self, method, session=None, **parameters):
        """Sends a command and returns its result; events that arrive before are kept in `events`."""
        self.last_id += 1
        message = {"id": self.last_id, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to_browser, data):]
        end = time.monotonic() + self.seconds_to_answer
        while True:
            answer = self._next_message(end, method)
            if answer.get("id") != self.last_id:
                self.events.append(answer)
            elif "error" in answer:
                raise RuntimeError(f"{method}: {answer['error']['message']}")
            else:
                return answer["result"]

    def wait_for_event(self, method, session):
        """Returns the parameters of the next such event, which may have arrived already."""
        end = time.monotonic() + self.seconds_to_answer
        while True:
            for i, event in enumerate(self.events):
                if event.get("method") == method and event.get("sessionId") == session:
                    return self.events.pop(i)["params"]
            self.events.append(self._next_message(end, method))

    def take_events(self, session):
        """All events of a page that arrived since the last call."""
        taken = [event for event in self.events if event.get("sessionId") == session]
        self.events = [event for event in self.events if event.get("sessionId") != session]
        return taken

    def _next_message(self, end, waiting_for):
        while b"\0" not in self.unread:
            ready, _, _ = select.select([self.from_browser], [], [], max(0, end - time.monotonic()))
            if not ready:
                raise RuntimeError(f"expected an answer to {waiting_for} within {self.seconds_to_answer} s, found none")
            data = os.read(self.from_browser, 1 << 20)
            if not data:
                raise RuntimeError(f"expected an answer to {waiting_for}, found the end of Chromium")
            self.unread += data
        message, _, self.unread = self.unread.partition(b"\0")
        return json.loads(message)


class Page:
    """A tab: what a reader sees, presses and hears of."""

    def __init__(self, browser, width=1280, height=800):
        self.browser = browser
        target = browser.send("Target.createTarget", url="about:blank")["targetId"]
        self.target = target
        self.session = browser.send("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log"):
            self.send(domain + ".enable")
        self.resize(width, height)

    def send(self, method, **parameters):
        return self.browser.send(method, self.session, **parameters)

    def resize(self, width, height):
        self.send("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def prefer(self, scheme="light", motion="reduce", media=""):
        features = [{"name": "prefers-color-scheme", "value": scheme}, {"name": "prefers-reduced-motion", "value": motion}]
        self.send("Emulation.setEmulatedMedia", media=media, features=features)

    def open(self, address):
        """Opens an address and waits until it is loaded."""
        self.browser.take_events(self.session)
        answer = self.send("Page.navigate", url=address)
        if "errorText" in answer:
            raise RuntimeError(f"{address}: {answer['errorText']}")
        if "loaderId" in answer:  # absent where only the part behind # is another
            self.browser.wait_for_event("Page.loadEventFired", self.session)

    def run(self, script):
        """The value of a JavaScript expression, which may be a promise."""
        answer = self.send("Runtime.evaluate", expression=script, awaitPromise=True, returnByValue=True, userGesture=True)
        if "exceptionDetails" in answer:
            details = answer["exceptionDetails"]
            raise RuntimeError(details.get("exception", {}).get("description", details["text"]) + "\nin: " + script[:200])
        return answer["result"].get("value")

    def press(self, key):
        """Presses and releases a key, named as in KeyboardEvent.key."""
        text = key if len(key) == 1 else "\r" if key == "Enter" else ""
        code = {"Enter": 13, "Tab": 9, "Escape": 27, " ": 32, "Home": 36, "End": 35, "ArrowLeft": 37, "ArrowUp": 38,
                "ArrowRight": 39, "ArrowDown": 40}.get(key, ord(key.upper()) if len(key) == 1 else 0)
        self.send("Input.dispatchKeyEvent", type="keyDown", key=key, text=text, windowsVirtualKeyCode=code)
        self.send("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=code)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.send("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def move(self, x, y):
        self.send("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)

    def complaints(self):
        """What the console says: errors, warnings, exceptions."""
        self.run("0")  # so that everything before has arrived
        said = []
        for event in self.browser.take_events(self.session):
            parameters = event["params"]
            if event["method"] == "Runtime.exceptionThrown":
                details = parameters["exceptionDetails"]
                said.append(details.get("exception", {}).get("description", details["text"]))
            elif event["method"] == "Runtime.consoleAPICalled" and parameters["type"] in ("error", "warning", "assert"):
                said.append(" ".join(str(value.get("value", value.get("description"))) for value in parameters["args"]))
            elif event["method"] == "Log.entryAdded" and parameters["entry"]["level"] in ("error", "warning"):
                said.append(parameters["entry"]["text"] + " " + parameters["entry"].get("url", ""))
        return said

    def screenshot(self, path, whole_page=False):
        data = self.send("Page.captureScreenshot", format="png", captureBeyondViewport=whole_page)
        with open(path, "wb") as file:
            file.write(base64.b64decode(data["data"]))

    def pdf(self):
        return base64.b64decode(self.send("Page.printToPDF", printBackground=True, preferCSSPageSize=True)["data"])

    def close(self):
        self.browser.send("Target.closeTarget", targetId=self.target)
