#!/usr/bin/env python3
"""Checks that include lines keep to the layers of docs/architecture.md.

A folder may include itself and what RULES names, and a third party's headers only where OWNERS
allows. Prints a line for every breach; exits 1 if there is one. Checks itself first.
"""

import pathlib
import re
import sys

COMMON = ["common/model", "common/geometry", "common/planning"]
ALL_COMMON = COMMON + ["common/io", "common/runtime", "common/transport"]
RULES = {
    "common/model": [],
    "common/geometry": ["common/model"],
    "common/planning": ["common/model", "common/geometry"],
    "common/io": COMMON,
    "common/runtime": COMMON + ["common/io"],
    "common/transport": COMMON + ["common/io", "common/runtime"],
    "worker": ALL_COMMON,
    "coordinator": ALL_COMMON,
    "discovery": ALL_COMMON,
    # What a fleet manager links: nothing of the planner.
    "client/fleet": ALL_COMMON,
    "client/example": ALL_COMMON + ["client/fleet"],
    "client": ALL_COMMON + ["worker", "coordinator", "client/fleet"],
}

# Third parties' headers, and the folders that may include them.
OWNERS = {
    r"fastdds/|fastrtps/|fastcdr/|.*PubSubTypes\.h|accord\.h|fleet\.h": ["common/transport"],
    r"google/protobuf/|.*\.pb\.h|openssl/": ["common/io/wire"],
    r"fcl/|ccd/": ["common/geometry"],
    r"yaml-cpp/|tinyxml2\.h|assimp/": ["common/io"],
    r"sqlite3": ["coordinator/journal"],
    r"CLI/": ["client", "common/runtime/command_line"],
    r"prometheus/|CivetServer\.h|civetweb\.h": ["common/runtime/metrics"],
}
# Of these, none may appear in a header: it would reach whoever includes that header.
SOURCES_ONLY = (r"fastdds/|fastrtps/|fastcdr/|.*PubSubTypes\.h|accord\.h|fleet\.h|google/protobuf/|.*\.pb\.h|openssl/"
                r"|prometheus/|CivetServer\.h|civetweb\.h|sqlite3")
# But for the headers of these folders, which only their own files and their parents' sources may
# include.
PRIVATE = ["common/transport/dds/"]

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


def folder_of(path):
    """The layer that a path belongs to, None if it is none of ours. Inner folders come first."""
    return next((folder for folder in RULES if path.startswith(folder + "/")), None)


def breaches_of_line(path, included):
    folder = folder_of(path)
    target = folder_of(included)
    if target and target != folder and target not in RULES[folder]:
        yield f"{folder} must not include {target}"
    for pattern, owners in OWNERS.items():
        if re.match(pattern, included) and not any(path.startswith(owner) for owner in owners):
            yield f"only {', '.join(owners)} may include it"
    private = next((p for p in PRIVATE if path.startswith(p)), None)
    if re.match(SOURCES_ONLY, included) and path.endswith(".h") and not private:
        yield "not in a header: it stays inside sources"
    for inner in PRIVATE:
        parent = inner.rstrip("/").rpartition("/")[0]
        of_parent = path.startswith(parent + "/") and path.endswith(".cpp")
        if included.startswith(inner) and private != inner and not of_parent:
            yield f"{inner} is private"


def breaches(path, text):
    for number, line in enumerate(text.splitlines(), 1):
        if match := INCLUDE.match(line):
            for reason in breaches_of_line(path, match[2]):
                yield f"{path}:{number}: #include {match[2]}: {reason}"


def self_test():
    bad = [
        ("common/model/a.h", '#include "common/geometry/b.h"'),
        ("common/planning/a.cpp", '#include "common/io/b.h"'),
        ("common/io/a.cpp", '#include "common/runtime/b.h"'),
        ("worker/a.cpp", '#include "coordinator/b.h"'),
        ("client/fleet/a.cpp", '#include "client/engine/b.h"'),
        ("client/fleet/a.cpp", '#include "worker/b.h"'),
        ("client/example/a.cpp", '#include "client/files.h"'),
        ("coordinator/a.cpp", '# include "worker/b.h"'),
        ("coordinator/a.cpp", "#include <fastdds/dds/topic.hpp>"),
        ("common/transport/a.h", "#include <fastdds/dds/topic.hpp>"),
        ("common/transport/a.h", '#include "accordPubSubTypes.h"'),
        ("common/transport/fleet/a.h", '#include "fleet.h"'),
        ("common/transport/a.h", '#include "common/transport/dds/b.h"'),
        ("worker/a.cpp", '#include "common/transport/dds/b.h"'),
        ("common/io/a.cpp", '#include "accord.pb.h"'),
        ("common/io/wire/a.h", '#include "accord.pb.h"'),
        ("common/transport/a.cpp", '#include "accord.pb.h"'),
        ("common/model/a.cpp", "#include <fcl/fcl.h>"),
        ("common/runtime/a.cpp", '#include "common/transport/b.h"'),
        ("common/runtime/metrics.h", "#include <prometheus/registry.h>"),
        ("worker/main/main.cpp", "#include <CLI/CLI.hpp>"),
        ("coordinator/a.cpp", "#include <sqlite3.h>"),
        ("coordinator/journal/a.h", "#include <sqlite3.h>"),
    ]
    good = [
        ("common/planning/a.cpp", '#include "common/geometry/b.h"'),
        ("client/a.cpp", '#include "coordinator/b.h"'),
        ("client/a.cpp", '#include "client/fleet/b.h"'),
        ("client/example/a.cpp", '#include "client/fleet/b.h"'),
        ("common/transport/a.cpp", "#include <fastdds/dds/topic.hpp>"),
        ("common/transport/a.cpp", '#include "common/transport/dds/b.h"'),
        ("common/transport/dds/a.h", "#include <fastdds/dds/topic.hpp>"),
        ("common/io/wire/a.cpp", '#include "accord.pb.h"'),
        ("coordinator/journal/a.cpp", "#include <sqlite3.h>"),
        ("worker/a.cpp", "#include <vector>"),
        ("common/runtime/a.cpp", '#include "common/io/b.h"'),
        ("common/runtime/metrics.cpp", "#include <prometheus/registry.h>"),
    ]
    for path, line in bad:
        assert list(breaches(path, line)), f"not noticed: {path}: {line}"
    for path, line in good:
        assert not list(breaches(path, line)), f"wrongly noticed: {path}: {line}"


def main():
    self_test()
    root = pathlib.Path(__file__).resolve().parents[2]
    files = sorted({f for folder in RULES for f in (root / folder).rglob("*")
                    if f.suffix in (".h", ".cpp")})
    assert files, "no sources found"
    found = [b for f in files for b in breaches(str(f.relative_to(root)), f.read_text())]
    print("\n".join(found) or f"{len(files)} files keep to the layers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
