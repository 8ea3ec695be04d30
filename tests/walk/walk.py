#!/usr/bin/env -S python3 -B
"""Walks through a solved scene in a headless Chromium, from a file:   walk.py RAYLAB SCENE ARTEFACTS

It presses the page's keys, moves its mouse and slider, asks what is drawn, and measures the script of a frame. Exit code
77: there is no Chromium.
"""

import shutil
import statistics
import subprocess
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "browser"))
from devtools import Browser, Page  # noqa: E402

LARGEST_PAGE = 2_000_000  # bytes, as of every page of the book
MOST_SCRIPT = 2.0  # milliseconds a frame, in the median: other programs may interrupt a frame

# The mean brightness of what is drawn, and a number that changes with any pixel.
LOOK = """new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => {
  const seen = document.createElement("canvas"), drawn = document.querySelector("canvas");
  seen.width = 160; seen.height = 100;
  const paper = seen.getContext("2d");
  paper.drawImage(drawn, 0, 0, 160, 100);
  let sum = 0, mark = 0;
  paper.getImageData(0, 0, 160, 100).data.forEach((value, i) => { sum += value; mark = (mark * 31 + value + i) % 2147483647; });
  done([sum / 64000, mark]);
})))"""

KEY = "dispatchEvent(new KeyboardEvent('{kind}', {{code: '{code}', key: '{key}', bubbles: true}}))"


def press(page, key, code=""):
    for kind in ("keydown", "keyup"):
        page.run(KEY.format(kind=kind, code=code, key=key))


def drag(page):
    for kind, x in (("mousePressed", 600), ("mouseMoved", 700), ("mouseReleased", 700)):
        page.send("Input.dispatchMouseEvent", type=kind, x=x, y=400, button="left", clickCount=1)


def hold(page, code, frames):
    """Holds a key down until so many frames were drawn."""
    page.run(KEY.format(kind="keydown", code=code, key=""))
    page.run(f"new Promise((done) => {{ const end = walk.measured.frames + {frames};"
             "const wait = () => walk.measured.frames < end ? requestAnimationFrame(wait) : done(); wait(); })")
    page.run(KEY.format(kind="keyup", code=code, key=""))


def check(page, artefacts):
    """Yields what is wrong."""
    page.screenshot(artefacts / "start.png")
    brightness, start = page.run(LOOK)
    if not 20 < brightness < 240:
        yield f"expected a picture, found a mean of {brightness:.1f} of 255"
    ways = {"p": lambda: press(page, "p"), "l": lambda: press(page, "l"), "a drag": lambda: drag(page),
            "walking": lambda: hold(page, "KeyW", 3), "turning": lambda: hold(page, "ArrowLeft", 3)}
    before = start
    for name, way in ways.items():
        way()
        _, now = page.run(LOOK)
        if now == before:
            yield f"expected another picture after {name}, found the same"
        before = now
        if name == "l":
            page.screenshot(artefacts / "patches.png")
    for name, undo in {"the start": "r", "no patches": "p", "no mesh": "l"}.items():
        press(page, undo)
    if page.run(LOOK)[1] != start:
        yield "expected the first picture again after r, p and l, found another"
    page.run("exposure.value = 2; exposure.dispatchEvent(new Event('input'))")
    if not page.run(LOOK)[0] > 1.1 * brightness:
        yield "expected a brighter picture two stops up"
    hold(page, "ArrowLeft", 100)
    script = page.run("walk.measured.script")
    median = statistics.median(script)
    print(f"script of {len(script)} frames: {median:.2f} ms in the median, {statistics.mean(script):.2f} in the mean")
    if not median <= MOST_SCRIPT:
        yield f"expected at most {MOST_SCRIPT} ms of script a frame, found {median:.2f}"
    # Reading what was drawn, as LOOK does, stalls; readers do not.
    yield from (one for one in page.complaints() if "GPU stall due to ReadPixels" not in one)


def main():
    raylab, scene, artefacts = sys.argv[1], sys.argv[2], Path(sys.argv[3])
    chromium = shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")
    if chromium is None:
        print("skipped: nobody walks, since there is no Chromium")
        sys.exit(77)
    artefacts.mkdir(parents=True, exist_ok=True)
    file = artefacts / "walk.html"
    subprocess.run([raylab, "radiosity", scene, "--patches", "1000", "--exposure", "1", "--walk", file], check=True,
                   stdout=subprocess.DEVNULL)
    print(f"{file.stat().st_size} bytes")
    found = [] if file.stat().st_size <= LARGEST_PAGE else [f"expected at most {LARGEST_PAGE} bytes"]
    with Browser(chromium) as browser:
        page = Page(browser)
        page.open(file.as_uri())
        found += check(page, artefacts)
    for one in found:
        print(f"✗ {one}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
