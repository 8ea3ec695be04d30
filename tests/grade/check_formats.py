#!/usr/bin/env python3
"""check_formats.py FOLDER: validates the results FOLDER/OUTCOME.FORMAT against what each format says of itself.

The schemas are validated first: by the examples of the formats' own documentation, and by broken results, which they
have to refuse.
"""
import json
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

import jsonschema

schemas = pathlib.Path(__file__).parent / "schemas"


def refuse_constant(name):
    raise ValueError(f"JSON has no {name}")


def read_json(text):
    return json.loads(text, parse_constant=refuse_constant)


def is_valid(kind, value):
    schema = json.loads((schemas / f"{kind}.schema.json").read_text())
    return sorted(error.message for error in jsonschema.Draft7Validator(schema).iter_errors(value))


def junit_faults(text):
    """The rules of junit-10.xsd for what the lab writes."""
    allowed = {
        "testsuites": (set(), {"testsuite"}),
        "testsuite": ({"name", "tests", "failures", "errors", "skipped", "time", "timestamp", "hostname"},
                      {"properties", "testcase", "system-out", "system-err"}),
        "properties": (set(), {"property"}),
        "property": ({"name", "value"}, set()),
        "testcase": ({"name", "classname", "time"}, {"failure", "error", "skipped", "system-out", "system-err"}),
        "failure": ({"message", "type"}, set()),
        "error": ({"message", "type"}, set()),
        "skipped": ({"message"}, set()),
        "system-out": (set(), set()),
        "system-err": (set(), set()),
    }
    root = xml.fromstring(text.encode())
    faults = [] if root.tag == "testsuites" else [f"the root is {root.tag}"]
    for element in root.iter():
        attributes, children = allowed.get(element.tag, (set(), set()))
        if element.tag not in allowed:
            faults.append(f"an element {element.tag}")
        faults += [f"{element.tag} lacks {name}" for name in attributes - set(element.keys())]
        faults += [f"{element.tag} has {name}" for name in set(element.keys()) - attributes]
        faults += [f"{child.tag} in {element.tag}" for child in element if child.tag not in children]
    for suite in root.iter("testsuite"):
        for name, count in (("tests", len(suite.findall("testcase"))),
                            ("failures", len(suite.findall("testcase/failure"))),
                            ("errors", len(suite.findall("testcase/error")))):
            if suite.get(name) != str(count):
                faults.append(f"{name} is {suite.get(name)}, of {count}")
        if not re.fullmatch(r"\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d", suite.get("timestamp", "")):
            faults.append("the timestamp")
    return faults


def tap_faults(text):
    lines = text.splitlines()
    faults = [] if lines[0] == "TAP version 14" else ["the first line"]
    plan = re.fullmatch(r"1\.\.(\d+)", lines[1])
    faults += [] if plan else ["the plan"]
    tests, in_yaml = 0, False
    for line in lines[2:]:
        if in_yaml:
            in_yaml = line != "  ..."
            faults += [] if line.startswith("  ") or not line else [f"in a block: {line}"]
        elif line == "  ---":
            in_yaml = True
        elif found := re.fullmatch(r"(not )?ok (\d+) - ([^#\\]|\\.)*", line):
            tests += 1
            faults += [] if int(found[2]) == tests else [f"number {found[2]}"]
        elif not line.startswith(("# ", "Bail out!")):
            faults.append(f"a line: {line}")
    return faults + ([] if plan and int(plan[1]) == tests else [f"{tests} tests"])


def faults_of(kind, text):
    if re.search("[\0-\x08\x0b-\x1f\x7f-\x9f]", text):
        return ["control characters"]
    if kind == "text":
        return []
    if kind == "junit":
        return junit_faults(text)
    if kind == "tap":
        return tap_faults(text)
    if kind == "autolab":
        return is_valid(kind, [read_json(line) for line in text.splitlines()])
    return is_valid(kind, read_json(text))


def complain(where, faults):
    for fault in faults:
        print(f"{where}: {fault}")
    return len(faults)


count = 0
for example in schemas.glob("*.example.json"):
    count += complain(example.name, is_valid(example.name.split(".")[0], json.loads(example.read_text())))
count += complain("junit.example.xml", junit_faults((schemas / "junit.example.xml").read_text()))
count += complain("tap.example.txt", tap_faults((schemas / "tap.example.txt").read_text()))
for broken in schemas.glob("*.broken.json"):
    for number, value in enumerate(json.loads(broken.read_text())):
        if not is_valid(broken.name.split(".")[0], value):
            count += complain(f"{broken.name} {number}", ["it is taken"])
results = sorted(pathlib.Path(sys.argv[1]).iterdir())
for result in results:
    try:
        faults = faults_of(result.suffix[1:], result.read_text())
    except Exception as error:  # text that is no JSON, XML or UTF-8 at all
        faults = [repr(error)]
    count += complain(result.name, faults)
print(f"{len(results)} results, {count} faults")
sys.exit(1 if count or not results else 0)
