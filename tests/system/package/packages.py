"""The Debian packages of the build: made by cpack of what is built, nothing of it anew."""

import os
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[3]
BUILD = pathlib.Path(os.environ.get("ACCORD_BUILD", ROOT / "build"))
PROGRAMS = ("accord", "accord-fleet", "accord-coordinator", "accord-worker", "accord-discovery")


def make(folder):
    """Packages by their names, as files in the folder."""
    before = _ages()
    folder.mkdir()
    made = subprocess.run(
        ["cpack", "-G", "DEB", "-B", folder],
        cwd=BUILD, check=False, text=True, capture_output=True, stdin=subprocess.DEVNULL)
    if made.returncode != 0:
        raise AssertionError(f"cpack: exit code {made.returncode}\n{made.stdout}{made.stderr}")
    if _ages() != before:
        raise AssertionError("making packages has built the programs anew")
    return {file.name.split("_")[0]: file for file in folder.glob("*.deb")}


def field(package, name):
    return _output("dpkg-deb", "--field", package, name).strip()


def files(package):
    """Paths of a package's files, folders left out."""
    lines = _output("dpkg-deb", "--contents", package).splitlines()
    return {line.split()[5].lstrip(".") for line in lines if not line.startswith("d")}


def unpack(package, folder):
    _output("dpkg-deb", "--extract", package, folder)


def _ages():
    return {name: (BUILD / "bin" / name).stat().st_mtime_ns for name in PROGRAMS}


def _output(*command):
    return subprocess.run(command, check=True, text=True, capture_output=True).stdout
