#!/usr/bin/env python3
"""Checks that docs/operations.md#containers has the variables that deploy/'s compose files take from the
environment, and no others, with the defaults that they have there.

Prints a line for every difference; exits 1 if there is one. Checks itself first.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = ROOT / "docs/operations.md"
FILES = sorted((ROOT / "deploy").glob("docker-compose*.yml"))


def taken(text):
    """By name: the defaults of a compose file's variables; an empty one where it has to be given."""
    out = {}
    for name, mark, rest in re.findall(r"\$\{(\w+)(:-|:\?)([^}]*)\}", text):
        out.setdefault(name, set()).add(rest if mark == ":-" else "")
    return out


def documented(page):
    """Names in the section, and the defaults that its table has."""
    section = re.search(r"(?ms)^## Containers$(.*?)(?=^## )", page)[1]
    defaults = {}
    for row in re.findall(r"(?m)^\| (`\w+`.*)$", section):
        names, values = (cell.strip() for cell in row.split("|")[:2])
        names = re.findall(r"`(\w+)`", names)
        values = values.split(", ") if len(names) > 1 else [values]
        defaults.update(zip(names, values, strict=True))
    return set(re.findall(r"`((?:ACCORD|COMPOSE)_\w+)`", section)), defaults


def differences(page, texts):
    names, defaults = documented(page)
    there = {}
    for text in texts:
        for name, values in taken(text).items():
            there.setdefault(name, set()).update(values)
    for name in sorted(there.keys() ^ (names - {"COMPOSE_PROFILES"})):
        yield f"{name} is not both in a compose file and on the page"
    for name, value in sorted(defaults.items()):
        plain = there.get(name, set()) - {"../scenes"}  # of which the page says what it is
        if plain and value not in plain:
            yield f"{name} is {' or '.join(sorted(plain))} by default, not {value}"


def self_test(page, texts):
    for wrong in (page.replace("`ACCORD_IMAGE`", "`ACCORD_IMAGES`"),
                  page.replace("| `ACCORD_NETWORK` | 172.30.213 |", "| `ACCORD_NETWORK` | 10.0.0 |"),
                  page.replace("256m |", "255m |")):
        assert wrong != page and list(differences(wrong, texts)), "a difference was not noticed"
    assert list(differences(page, [*texts, "${ACCORD_OTHER:-1}"])), "a variable was not noticed"


def main():
    page, texts = PAGE.read_text(), [file.read_text() for file in FILES]
    found = list(differences(page, texts))
    if not found:
        self_test(page, texts)
    print("\n".join(found) or f"{PAGE.name} has the variables of {len(FILES)} compose files")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
