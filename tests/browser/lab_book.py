#!/usr/bin/env -S python3 -B
"""Opens every page of a lab book in Chromium, as readers and lecturers do:   lab_book.py BOOK ARTEFACTS [RAYLAB]

Exit code 77: there is no Chromium. RAYLAB is the program whose `tree` the picked pixels are compared with.
"""

import glob
import os
import queue
import shutil
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from urllib.parse import unquote, urlsplit

from controls import check_controls, check_lightbox
from devtools import Browser, Page
from lesson import check_deck, check_lecture, check_pixels, pages_of
from questions import HERE, Findings, ask, visit

SCREENS = [(1280, 800), (1920, 1080), (390, 844)]
SMALLEST_TEXT = 11  # pixels
PARTS = 3  # of the pages, of which a run reads one closely
BROWSERS = 2  # at a time: each waits for its pages most of the time


def read_closely(files):
    """The pages whose colours, prints, controls and lectures are looked at in this run; `raylab test --all` takes all."""
    if "RAYLAB_TEST_ALL" in os.environ:
        return set(files)
    return set(files[int(os.environ.get("RAYLAB_TEST_ROUND", 0)) % PARTS :: PARTS])  # see tests/rotating.h


def axe_script(artefacts):
    """axe-core's text; None, and the reason is printed, where it is not there and cannot be fetched."""
    script = artefacts / "node_modules/axe-core/axe.min.js"
    if not script.exists():
        for name in ("package.json", "package-lock.json"):
            shutil.copy(HERE / name, artefacts)
        try:
            subprocess.run(["npm", "ci", "--ignore-scripts", "--no-audit", "--no-fund"], cwd=artefacts, check=True, timeout=40,
                           capture_output=True)
        except (OSError, subprocess.SubprocessError) as problem:
            print(f"skipped: contrast by axe-core, since `npm ci` failed ({problem})")
            return None
    return script.read_text()


def check_screens(page, file, findings):
    visit(page, file.as_uri())
    ask(page, "unfold()")
    findings.add(f"{file.parent.name}/{file.name}", [f"not loaded: {one}" for one in ask(page, "pictures_loaded()")])
    for width, height in SCREENS:
        where = f"{file.parent.name}/{file.name} at {width} pixels"
        page.resize(width, height)
        findings.add(where, ask(page, "overflow()"))
        findings.add(where, ask(page, f"small_text({SMALLEST_TEXT})"))
        if width >= 1280:
            findings.add(where, ask(page, f"small_labels({SMALLEST_TEXT})"))
        findings.add(where, page.complaints())


def check_contrast(page, file, axe, findings):
    page.resize(*SCREENS[0])
    visit(page, file.as_uri())
    page.run(axe + "\n;0")
    for scheme in ("light", "dark"):
        page.prefer(scheme)
        findings.add(f"{file.parent.name}/{file.name}, {scheme}", ask(page, "contrast()"))
    page.prefer()


def check_print(page, file, findings):
    """On paper tables keep their heads, and the front page's cards share pages."""
    where = f"{file.parent.name}/{file.name}, printed"
    visit(page, file.as_uri())
    page.prefer(media="print")
    findings.add(where, [f"no head: {one}" for one in ask(page, "hidden_heads()")])
    page.prefer()
    cards = page.run("document.querySelectorAll('.card').length")
    if cards and pages_of(page.pdf()) > cards / 3:
        findings.add(where, f"expected at least three cards a page, found {pages_of(page.pdf())} pages for {cards}")


def check_links(links_of, anchors_of, findings):
    for file, links in links_of.items():
        for link in links:
            parts = urlsplit(link)
            if parts.scheme != "file":
                continue
            target = Path(unquote(parts.path))
            if not target.exists():
                findings.add(file, f"a link to {target}, which is not there")
            elif target in anchors_of and parts.fragment and unquote(parts.fragment) not in anchors_of[target]:
                findings.add(file, f"a link to #{parts.fragment} of {target}, where it is not")


def check_search(page, book, findings):
    visit(page, (book / "index.html").as_uri())
    page.press("/")
    for letter in "recursion":
        page.press(letter)
    for _ in range(50):
        if found := page.run("[...document.querySelectorAll('.found a')].map((link) => link.getAttribute('href'))"):
            break
        time.sleep(0.1)
    if not any(link.startswith("07_recursion/index.html") for link in found):
        findings.add("search", f"expected chapter 07 for 'recursion', found {found}")
    findings.add("search", page.complaints())


def check_page(page, file, closely, axe, raylab, artefacts, findings):
    """What one page shows, on every screen; closely: all that it does, too. Its links, and what can be linked to."""
    begun = time.monotonic()
    check_screens(page, file, findings)
    links, anchors = ask(page, "links()"), set(ask(page, "anchors()"))
    page.resize(*SCREENS[0])
    page.screenshot(artefacts / f"{file.parent.name}_{file.stem}.png", whole_page=True)
    if closely and axe:
        check_contrast(page, file, axe, findings)
    if closely:
        check_print(page, file, findings)
    if closely and page.run("document.body.classList.contains('lesson')"):
        page.resize(*SCREENS[0])
        check_controls(page, file, findings)
        check_lightbox(page, file, findings)
        check_pixels(page, file, raylab, artefacts, findings)
        check_lecture(page, file, artefacts, findings)
    print(f"{file.parent.name}/{file.name}: {time.monotonic() - begun:.1f} s")
    return links, anchors


def main():
    book, artefacts = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    raylab = sys.argv[3] if len(sys.argv) > 3 else None
    program = shutil.which("chromium")
    if not program:
        print("skipped: expected chromium, found none (./raylab test installs it)")
        return 77
    artefacts.mkdir(parents=True, exist_ok=True)
    files = [Path(name) for name in sorted(glob.glob(str(book / "*.html")) + glob.glob(str(book / "*/index.html")))]
    if not files:
        print(f"expected a lab book in {book}, found none")
        return 1
    findings = Findings()
    axe = axe_script(artefacts)
    closely = read_closely(files)
    waiting, seen = queue.SimpleQueue(), {}
    for file in files:
        waiting.put(file)

    def check_waiting(_):  # one browser's part
        with Browser(program) as browser:
            page = Page(browser)
            page.prefer()
            while True:
                try:
                    file = waiting.get_nowait()
                except queue.Empty:
                    return
                seen[file] = check_page(page, file, file in closely, axe, raylab, artefacts, findings)

    with ThreadPoolExecutor(BROWSERS) as threads:
        list(threads.map(check_waiting, range(BROWSERS)))
    check_links({file: links for file, (links, _) in seen.items()}, {file: anchors for file, (_, anchors) in seen.items()}, findings)
    with Browser(program) as browser:
        check_search(Page(browser), book, findings)
        if raylab:
            check_deck(Page(browser), book, raylab, artefacts, findings)
    print(f"{len(files)} pages, {len(closely)} of them closely, {findings.count} findings; screenshots: {artefacts}")
    return 1 if findings.count else 0


if __name__ == "__main__":
    sys.exit(main())
