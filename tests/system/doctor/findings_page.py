#!/usr/bin/env python3
"""Checks that docs/operations.md has a row for each code that accord doctor may print, in the same
order, and names no other one. Prints what differs; exits 1 if there is something."""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[3]


def codes_of_program(text):
    names = re.search(r"name_of\(Concern.*?kNames\{(.*?)\};", text, re.DOTALL)[1]
    return re.findall(r'"([a-z-]+)"', names)


def section(page, heading):
    return re.search(rf"^## {heading}\n(.*?)(?=^## )", page, re.DOTALL | re.MULTILINE)[1]


def differences(program, page):
    codes = codes_of_program(program)
    rows = re.findall(r"^\| `([a-z-]+)` \|", section(page, "Finding out what is wrong"), re.MULTILINE)
    if rows != codes:
        yield f"the table's codes are {rows}, the program's {codes}"
    for row in re.findall(r"`accord doctor`[^|]*: (`[a-z-]+`(?:, `[a-z-]+`)*)",
                          section(page, "Troubleshooting")):
        for code in re.findall(r"`([a-z-]+)`", row):
            if code not in codes:
                yield f"Troubleshooting names {code}, which is no code"


def self_test(program, page):
    assert list(differences(program.replace('"cluster"', '"clusters"'), page)), "a new code"
    assert list(differences(program, page.replace("| `cluster` |", "| `clusters` |"))), "another row"
    assert list(differences(program, page.replace("doctor`: `shm-stale`", "doctor`: `shm-old`")))


def main():
    program = (ROOT / "client/doctor/finding.cpp").read_text()
    page = (ROOT / "docs/operations.md").read_text()
    found = list(differences(program, page))
    print("\n".join(found) or "docs/operations.md has the codes of accord doctor")
    if not found:
        self_test(program, page)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
