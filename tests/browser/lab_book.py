#!/usr/bin/env python3
"""Opens every page of a lab book in Chromium, as readers and lecturers do:   lab_book.py BOOK ARTEFACTS [RAYLAB]

Exit code 77: there is no Chromium. RAYLAB is the program whose `tree` the picked pixels are compared with.
"""

import glob
import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from urllib.parse import unquote, urlsplit

from devtools import Browser, Page

HERE = Path(__file__).resolve().parent
SCREENS = [(1280, 800), (1920, 1080), (390, 844)]
SMALLEST_TEXT = 11  # pixels
LECTURE = (1920, 1080)


class Findings:
    """What is wrong, each with its page."""

    def __init__(self):
        self.count = 0

    def add(self, where, what):
        for one in what if isinstance(what, list) else [what]:
            self.count += 1
            print(f"✗ {where}: {one}")


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


def ask(page, question):
    return page.run("browser_test." + question)


def visit(page, address):
    page.open(address)
    page.run((HERE / "in_page.js").read_text())


def check_screens(page, file, findings):
    visit(page, file.as_uri())
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


def pages_of(pdf):
    return len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf))


def check_lecture(page, file, artefacts, findings):
    """From the first step to the last, each of them looked at; then printed."""
    where = f"{file.parent.name}, lecture"
    page.resize(*LECTURE)
    page.open("about:blank")  # so that the address is followed as a reader's is who comes by a link
    visit(page, file.as_uri() + "#slide-1")
    slides = page.run("document.querySelectorAll('.slide').length")
    if slides < 2:
        return findings.add(where, f"expected slides, found {slides}")
    findings.add(where, [f"not loaded: {one}" for one in ask(page, "pictures_loaded(document.querySelector('.deck'))")])
    shown, steps, step = set(), 0, ask(page, "step()")
    while True:
        slide = step.split()[0]
        if slide not in shown:
            shown.add(slide)
            if page.run("location.hash") != "#" + slide:
                findings.add(where, f"{slide} has the address {page.run('location.hash')}")
        steps += 1
        page.press("ArrowRight")
        next_step = ask(page, "step()")
        if next_step != step and next_step.split()[0] == slide:
            step = next_step
            continue
        if next_step != step:
            page.press("ArrowLeft")  # complete, as it was left
        findings.add(f"{where}, {slide}", ask(page, "slide_faults()"))
        if next_step == step:
            break
        page.press("ArrowRight")
        step = next_step
    if len(shown) != slides:
        findings.add(where, f"expected to step through {slides} slides, found {len(shown)}")
    page.screenshot(artefacts / f"{file.parent.name}_last_slide.png")
    (artefacts / f"{file.parent.name}_slides.pdf").write_bytes(pdf := page.pdf())
    if pages_of(pdf) != slides:
        findings.add(where, f"expected {slides} printed pages, found {pages_of(pdf)}")
    page.press("Home")
    if page.run("location.hash") != "#slide-1":
        findings.add(where, "Home does not lead to the first slide")
    page.press("Escape")
    if page.run("in_lecture()"):
        findings.add(where, "Escape does not end it")
    findings.add(where, page.complaints())
    print(f"  {file.parent.name}: {slides} slides, {steps} steps")


def tree_of(raylab, command, artefacts):
    """The nodes that the page's own command writes, with --json in place of its output file."""
    words = command.split()
    words = [raylab] + words[1:words.index("-o")] + ["--json", str(artefacts / "tree.json")]
    subprocess.run(words, check=True, capture_output=True, cwd=HERE.parent.parent, timeout=60)
    return json.loads((artefacts / "tree.json").read_text())["nodes"]


def check_pixels(page, file, raylab, artefacts, findings):
    """Clicks a pixel, goes on by an arrow key, and compares with `raylab tree`."""
    visit(page, file.as_uri())
    if not raylab or not page.run("!!document.querySelector('figure[data-trees]')"):
        return
    where = f"{file.parent.name}, a pixel"
    page.click(*ask(page, "middle_of('figure[data-trees] img')"))
    for key in ("ArrowRight", "ArrowDown"):
        for _ in range(50):  # the trees are read
            if picked := ask(page, "picked()"):
                break
            time.sleep(0.1)
        else:
            return findings.add(where, "nothing is shown")
        nodes = tree_of(raylab, picked["command"], artefacts)
        rays = [i for i, node in enumerate(nodes) if node["ray"] and node["kind"] != "shadow"]
        heaviest = sorted(sorted(rays, key=lambda i: -nodes[i]["throughput"])[:15])
        if [ray["node"] for ray in picked["rays"]] != heaviest:
            findings.add(where, f"expected the nodes {heaviest}, found {[ray['node'] for ray in picked['rays']]}")
            continue
        for ray in picked["rays"]:
            node = nodes[ray["node"]]
            if ray["object"] != node["object"] or abs(ray["throughput"] - node["throughput"]) > 1e-5 * node["throughput"]:
                findings.add(where, f"expected {node['object']} {node['throughput']}, found {ray}")
        print(f"  {file.parent.name}: the {len(heaviest)} rays of {picked['command'].split('--pixel ')[1].split()[0]}")
        page.press(key)
    page.screenshot(artefacts / f"{file.parent.name}_pixel.png")
    findings.add(where, page.complaints())


def check_controls(page, file, artefacts, findings):
    """Flips a pair, moves a series on, sorts a table, where the page has them."""
    where = f"{file.parent.name}, controls"
    page.resize(*SCREENS[0])
    visit(page, file.as_uri())
    press = "[...document.querySelectorAll('{0} button')].find((one) => one.textContent === '{1}')?.click()"
    shown = "[...document.querySelectorAll('.in-one-place > figure')].findIndex((one) => !one.classList.contains('behind'))"
    if page.run("!!document.querySelector('[aria-label=\"Compare the two pictures\"]')"):
        seen = []
        for _ in range(3):
            page.run(press.format("[aria-label=\"Compare the two pictures\"]", "flip"))
            seen.append(page.run(shown))
        if seen != [0, 1, 0]:
            findings.add(where, f"expected flip to show pictures 0, 1, 0, found {seen}")
    if page.run("!!document.querySelector('.player input')"):
        page.run("document.querySelector('.player input').focus()")
        page.press("End")
        if not page.run("!document.querySelector('[data-series] > figure:last-of-type').classList.contains('behind')"):
            findings.add(where, "the slider's end does not show the last picture")
    if page.run("!!document.querySelector('button.sort')"):
        column = "[...document.querySelector('table:has(.sort)').tBodies[0].rows].map((row) => row.cells[0].textContent)"
        before = page.run(column)
        page.run("document.querySelector('button.sort').click()")
        if sorted(page.run(column)) != sorted(before) or page.run("document.querySelector('button.sort').closest('th').ariaSort") != "ascending":
            findings.add(where, "sorting changes a table's rows")
    findings.add(where, page.complaints())


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
    findings, links_of, anchors_of = Findings(), {}, {}
    axe = axe_script(artefacts)
    with Browser(program) as browser:
        page = Page(browser)
        page.prefer()
        for file in files:
            begun = time.monotonic()
            check_screens(page, file, findings)
            links_of[file], anchors_of[file] = ask(page, "links()"), set(ask(page, "anchors()"))
            page.resize(*SCREENS[0])
            page.screenshot(artefacts / f"{file.parent.name}_{file.stem}.png", whole_page=True)
            if axe:
                check_contrast(page, file, axe, findings)
            if page.run("document.body.classList.contains('lesson')"):
                check_controls(page, file, artefacts, findings)
                check_lecture(page, file, artefacts, findings)
                check_pixels(page, file, raylab, artefacts, findings)
            print(f"{file.parent.name}/{file.name}: {time.monotonic() - begun:.1f} s")
        check_links(links_of, anchors_of, findings)
        check_search(page, book, findings)
    print(f"{len(files)} pages, {findings.count} findings; screenshots: {artefacts}")
    return 1 if findings.count else 0


if __name__ == "__main__":
    sys.exit(main())
