"""What a lesson's page can do: its lecture from the first step to the last, and its pixels."""

import json
import re
import subprocess
import time

from questions import HERE, ask, visit

LECTURE = (1920, 1080)


def pages_of(pdf):
    return len(re.findall(rb"/Type\s*/Page\b(?!s)", pdf))


def check_visits(page, where, visits, findings):
    """A ray's way is built up from nothing to all that it visits, in the order of the numbers; #slide-N.K is a step of it."""
    drawn = page.run("[...document.querySelectorAll('.slide:not(:has(.enlarged)):has(svg [data-visit])')].map(({ id }) => id)")
    for slide in drawn:
        seen = [sum(drawing.values()) for drawing in visits[slide]]
        marks = page.run(f"document.querySelectorAll('#{slide} [data-visit]').length")
        if seen[0] != 0 or seen != sorted(seen) or seen[-1] != marks or len(set(seen)) < min(marks, 5):
            findings.add(f"{where}, {slide}", f"expected to build up {marks} marks from none, found {seen}")
    for slide in drawn[:1]:
        page.run(f"location.hash = '#{slide}.3'")
        if (found := ask(page, "visits_shown()")) != visits[slide][2]:
            findings.add(f"{where}, {slide}.3", f"expected {visits[slide][2]}, found {found}")


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
    for scheme in ("light", "dark"):
        page.prefer(scheme)
        findings.add(f"{where}, {scheme}", ask(page, "slide_contrast()"))
    page.prefer()
    shown, steps, step, visits = set(), 0, ask(page, "step()"), {}
    while True:
        slide = step.split()[0]
        visits.setdefault(slide, []).append(ask(page, "visits_shown()"))
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
            if (there := ask(page, "step()")) != step:
                findings.add(f"{where}, {slide}", f"expected to come back to {step}, found {there}")
        findings.add(f"{where}, {slide}", ask(page, "slide_faults()"))
        if next_step == step:
            break
        page.press("ArrowRight")
        step = next_step
    check_visits(page, where, visits, findings)
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
    if page.run("in_lecture() || !!document.querySelector('.deck')"):
        findings.add(where, "Escape does not end it")
    findings.add(where, page.complaints())
    print(f"  {file.parent.name}: {slides} slides, {steps} steps")


def check_deck(page, book, raylab, artefacts, findings):
    """A chapter as one file, opened where nothing is beside it: a lecture with all its pictures, and the lesson behind it."""
    folder = artefacts / "deck"
    folder.mkdir(exist_ok=True)
    deck = folder / "slides.html"
    subprocess.run([raylab, "slides", "08", "--book", book, "-o", deck], check=True, capture_output=True, timeout=60)
    page.resize(*LECTURE)
    visit(page, deck.as_uri())
    where = "raylab slides 08"
    if not page.run("in_lecture()") or page.run("location.hash") != "#slide-1":
        findings.add(where, f"expected a lecture at #slide-1, found {page.run('location.hash')}")
    findings.add(where, [f"not loaded: {one[:60]}" for one in ask(page, "pictures_loaded()")])
    for link in ask(page, "links()"):
        if link.split("#")[0] != deck.as_uri() and not link.startswith(("data:", "https://")):
            findings.add(where, f"it needs {link}")
    page.press("End")
    last = page.run("document.querySelector('.slide:last-child').id")
    if page.run("location.hash").split(".")[0] != "#" + last:
        findings.add(where, f"expected the last slide {last}, found {page.run('location.hash')}")
    page.press("Escape")
    if not page.run("document.querySelector('main .part').checkVisibility({ visibilityProperty: true })"):
        findings.add(where, "the lesson is not behind it")
    findings.add(where, page.complaints())


def tree_of(raylab, command):
    """The nodes that the page's own command writes, with --json in place of its output file."""
    words = command.split()
    words = [raylab] + words[1:words.index("-o")] + ["--json", "-"]
    tree = subprocess.run(words, check=True, capture_output=True, cwd=HERE.parent.parent, timeout=60).stdout
    return json.loads(tree)["nodes"]


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
        nodes = tree_of(raylab, picked["command"])
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
