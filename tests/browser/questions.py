"""What the tests ask of a page, and where they write down what is wrong."""

from pathlib import Path

HERE = Path(__file__).resolve().parent


class Findings:
    """What is wrong, each with its page."""

    def __init__(self):
        self.count = 0

    def add(self, where, what):
        for one in what if isinstance(what, list) else [what]:
            self.count += 1
            print(f"✗ {where}: {one}")


def ask(page, question):
    return page.run("browser_test." + question)


def visit(page, address):
    page.open(address)
    page.run((HERE / "in_page.js").read_text())
