"""The controls that scripts add to a page: flip, play, sort, and a picture's pixels."""

import re
import struct
import time
import zlib

from questions import ask, visit


def check_controls(page, file, findings):
    """Flips a pair, moves a series on, sorts a table, where the page has them."""
    where = f"{file.parent.name}, controls"
    visit(page, file.as_uri())
    ask(page, "unfold()")  # what is folded takes no keys
    press = "[...document.querySelectorAll('{0} button')].find((one) => one.textContent === '{1}')?.click()"
    shown = "[...document.querySelectorAll('.in-one-place > figure')].findIndex((one) => !one.classList.contains('behind'))"
    if page.run("!!document.querySelector('[aria-label=\"Compare the two pictures\"]')"):
        seen = []
        for _ in range(3):
            page.run(press.format("[aria-label=\"Compare the two pictures\"]", "flip"))
            seen.append(page.run(shown))
        if seen != [0, 1, 0]:
            findings.add(where, f"expected flip to show pictures 0, 1, 0, found {seen}")
    if page.run("!!document.querySelector('[data-series] .player input')"):
        page.run("document.querySelector('[data-series] .player input').focus()")
        page.press("End")
        if not page.run("!document.querySelector('[data-series] > figure:last-of-type').classList.contains('behind')"):
            findings.add(where, "the slider's end does not show the last picture")
    if page.run("!!document.querySelector('svg [data-visit]')"):
        visits = "[...document.querySelector('svg:has([data-visit])').querySelectorAll('[data-visit]:not(.ahead)')].map((mark) => Number(mark.dataset.visit))"
        every = page.run(visits)
        page.run("document.querySelector('figure:has(svg [data-visit]) .player input').focus()")
        for key, last in (("Home", 1), ("ArrowRight", 2), ("End", max(every))):
            page.press(key)
            if page.run(visits) != [visit for visit in every if visit <= last]:
                findings.add(where, f"{key}: expected the visits up to {last}, found {page.run(visits)}")
    if page.run("!!document.querySelector('button.sort')"):
        column = "[...document.querySelector('table:has(.sort)').tBodies[0].rows].map((row) => row.cells[0].textContent)"
        before = page.run(column)
        page.run("document.querySelector('button.sort').click()")
        if sorted(page.run(column)) != sorted(before) or page.run("document.querySelector('button.sort').closest('th').ariaSort") != "ascending":
            findings.add(where, "sorting changes a table's rows")
    if page.run("!!document.querySelector('.controls > input[type=search]')"):
        page.run("(() => { const words = document.querySelector('.controls > input[type=search]'); words.scrollIntoView(); words.focus(); })()")
        for letter in "zz":
            page.press(letter)
        if left := page.run("[...document.querySelector('.controls:has(> input[type=search]) + .scroll').querySelectorAll('tbody > tr:not([hidden])')].length"):
            findings.add(where, f"expected no row with 'zz', found {left}")
    if page.run("!!document.querySelector('figure.chart svg [data-method]')"):
        page.run("document.querySelector('figure.chart:has(svg [data-method]) svg').focus()")
        page.press("ArrowRight")
        mark = page.run("document.querySelector('figure.chart svg [data-method]').dataset.method")
        if mark not in (told := page.run("document.querySelector('output.mark').textContent")):
            findings.add(where, f"expected a chart's mark to name {mark}, found {told}")
    for case in page.run("[...document.querySelectorAll('section.case:not(:has(.thumbnail svg))')].map(({ id }) => id)"):
        findings.add(where, f"the case {case} has no thumbnail")
    findings.add(where, page.complaints())


def png_pixel(path, column, row):
    """Three bytes of a PNG of 8 bits a colour without alpha, as the lab writes them (PNG, second edition, section 9)."""
    data, at, packed = path.read_bytes(), 8, b""
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, _, depth, color = struct.unpack(">IIBB", body[:10])
            assert (depth, color) == (8, 2), f"{path}: expected 8 bits and RGB, found {depth} and {color}"
        elif kind == b"IDAT":
            packed += body
        at += 12 + length
    lines, stride = zlib.decompress(packed), 3 * width
    before = bytearray(stride)
    for y in range(row + 1):
        kind, line = lines[y * (stride + 1)], bytearray(lines[y * (stride + 1) + 1:(y + 1) * (stride + 1)])
        for i in range(stride):
            left, up, corner = (line[i - 3] if i >= 3 else 0), before[i], (before[i - 3] if i >= 3 else 0)
            paeth = min((left, up, corner), key=lambda one: abs(left + up - corner - one))
            line[i] = (line[i] + (0, left, up, (left + up) // 2, paeth)[kind]) % 256
        before = line
    return before[3 * column:3 * column + 3]


def check_lightbox(page, file, findings):
    """Opens a picture and points at a pixel near its top: are the values that are told those of the file?"""
    where = f"{file.parent.name}, a picture's values"
    visit(page, file.as_uri())
    if not page.run("!!document.querySelector('figure > a[data-values]')"):
        return
    page.click(*ask(page, "middle_of('figure > a[data-values] > img')"))
    told = None
    for _ in range(50):  # the values are read
        x, y, width, height = page.run("(({ x, y, width, height }) => [x, y, width, height])(document.querySelector('.lightbox img').getBoundingClientRect())")
        page.move(x + width / 3, y + min(height / 3, 60))
        told = re.fullmatch(r"pixel \((\d+), (\d+)\): red, green, blue (\S+), (\S+), (\S+)", page.run("document.querySelector('.lightbox [role=status]').textContent"))
        if told:
            break
        time.sleep(0.1)
    else:
        return findings.add(where, "no values are told")
    values = [float(one) for one in told.groups()[2:]]
    picture = file.parent / page.run("document.querySelector('figure > a[data-values]').getAttribute('href')")
    for value, byte in zip(values, png_pixel(picture, int(told[1]), int(told[2]))):
        shown = byte / 255 / 12.92 if byte < 11 else ((byte / 255 + 0.055) / 1.055) ** 2.4  # sRGB
        if abs(min(1, value) - shown) > 0.01 + max(values) / 256:
            findings.add(where, f"expected {shown:.4f} at {told[1]}, {told[2]} of {picture.name}, found {value}")
    page.press("Escape")
    findings.add(where, page.complaints())
