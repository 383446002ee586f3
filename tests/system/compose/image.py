"""The image that the tests run: deploy/Dockerfile's, but for what it is built from. Its stage `build`
is left out, which would compile everything anew: in its place is the package of this build folder.

    image.py [--whole]   builds it as `accord-test`; --whole: by deploy/Dockerfile as it is
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile

import engine

IMAGE = "accord-test"
DOCKERFILE = engine.ROOT / "deploy/Dockerfile"
BUILD = pathlib.Path(os.environ.get("ACCORD_BUILD", engine.ROOT / "build"))
STAGE = re.compile(r"^FROM \$\{BASE\} AS build\n.*?(?=^FROM )", re.M | re.S)


def without_compiling(dockerfile):
    text, replaced = STAGE.subn("FROM ${BASE} AS build\nCOPY *.deb /packages/\n\n", dockerfile)
    if replaced != 1:
        raise RuntimeError(f"{DOCKERFILE} has no stage `build`")
    return text


def build(docker, whole=False):
    if whole:
        docker("build", "--network", "host", "--tag", IMAGE, "--file", DOCKERFILE, engine.ROOT)
        return
    with tempfile.TemporaryDirectory() as work, tempfile.TemporaryDirectory() as folder:
        subprocess.run(["cpack", "-G", "DEB", "-B", work, "-D", f"CPACK_OUTPUT_FILE_PREFIX={folder}"],
                       cwd=BUILD, check=True, capture_output=True)
        text = without_compiling(DOCKERFILE.read_text())
        (pathlib.Path(folder) / "Dockerfile").write_text(text)
        docker("build", "--network", "host", "--tag", IMAGE, folder)


def make(machine, whole=False):
    """The image, in the engine of that machine, which has to be started to build."""
    machine.ensure_base(debian_root)
    build(machine.docker, whole)


def debian_root():
    folder = BUILD / "debian-root"
    subprocess.run([engine.ROOT / "tests/support/debian_root", folder], check=True,
                   stdout=sys.stderr)
    return folder


if __name__ == "__main__":
    MACHINE = engine.Engine()
    if WHY := MACHINE.why_not():
        sys.exit(f"image.py: {WHY}")
    MACHINE.start_to_build()
    make(MACHINE, whole="--whole" in sys.argv[1:])
