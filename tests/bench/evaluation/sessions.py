"""On what machine, with what version and by what command an evaluation's rows came to be.

Kept beside the CSV, in NAME.about.json: a list, since an evaluation may be interrupted and go on.
"""
import datetime
import json
import os
import pathlib
import platform
import re
import shlex
import subprocess


def _output(*command):
    try:
        return subprocess.run(command, capture_output=True, text=True, check=True,
                              timeout=20).stdout.strip()
    except (OSError, subprocess.SubprocessError):
        return ""


def _processor():
    try:
        found = re.search(r"^model name\s*: (.*)$", pathlib.Path("/proc/cpuinfo").read_text(),
                          re.MULTILINE)
    except OSError:
        found = None
    return found.group(1) if found else platform.processor() or platform.machine()


def _memory():
    return f"{os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 2**30:.1f} GiB"


def _commit(folder):
    commit = _output("git", "-C", str(folder), "rev-parse", "--short=12", "HEAD")
    changed = _output("git", "-C", str(folder), "status", "--porcelain", "--untracked-files=no")
    return commit + (", with changes" if commit and changed else "")


def _compiler(accord):
    """Of the build folder that the program lies in, as CMake has noted it."""
    for folder in list(accord.resolve().parents)[:3]:
        for noted in sorted(folder.glob("CMakeFiles/*/CMakeCXXCompiler.cmake")):
            values = dict(re.findall(r'set\((CMAKE_CXX_COMPILER_(?:ID|VERSION)) "(.*?)"\)',
                                     noted.read_text()))
            kind = re.search(r"CMAKE_BUILD_TYPE:\w+=(\w*)", (folder / "CMakeCache.txt").read_text())
            return " ".join(filter(None, (*values.values(), kind and f"({kind.group(1)})")))
    return ""


def now(accord, command):
    """The session that begins: a dict of texts, in the order in which they are shown."""
    accord = pathlib.Path(accord)
    return {
        "date": datetime.datetime.now().astimezone().isoformat(timespec="seconds"),
        "machine": f"{_processor()}, {os.cpu_count()} cores, {_memory()}",
        "system": platform.platform(),
        "accord": _output(str(accord), "--version"),
        "commit": _commit(accord.resolve().parent),
        "compiler": _compiler(accord),
        "command": shlex.join(map(str, command)),
    }


def path_of(csv_path):
    return csv_path.with_suffix(".about.json")


def read(csv_path):
    """The sessions of a CSV file; none where nobody noted any."""
    path = path_of(csv_path)
    return json.loads(path.read_text()) if path.exists() else []


def add(csv_path, session):
    path_of(csv_path).write_text(json.dumps(read(csv_path) + [session], indent=1) + "\n")
