"""A clean Debian 12 to install packages on: tests/support/debian_root, and over it a layer that takes
what is changed and goes away with the process. Takes root.
"""

import ctypes
import os
import pathlib
import shutil
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
CANNOT = 77  # of debian_root
CLONE_NEWNS = 0x00020000


class Unavailable(Exception):
    """Why this machine cannot have such a root."""


class DebianRoot:
    def __init__(self, base=ROOT / "build/debian-12"):
        _make(base)
        _have_own_mounts()
        self._folder = tempfile.TemporaryDirectory(prefix="accord-root-", dir=base.parent)
        self.path = pathlib.Path(self._folder.name) / "root"
        self._lay_over(base)
        for kind, place in (("proc", "proc"), ("tmpfs", "dev/shm"), ("tmpfs", "tmp")):
            _run("mount", "-t", kind, "-o", "mode=1777" if kind == "tmpfs" else "defaults",
                 "accord-test", self.path / place)
        for file in ("resolv.conf", "hosts"):
            shutil.copyfile(pathlib.Path("/etc") / file, self.path / "etc" / file)

    def remove(self):
        _run("umount", "--recursive", self.path)
        self._folder.cleanup()

    def inside(self, path):
        """Where a path of the root is from outside."""
        return self.path / str(path).lstrip("/")

    def command(self, *command, user="root", folder="/"):
        """What runs a command inside, as that user, with none of this process's environment."""
        return ["env", "--ignore-environment", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL=C",
                "DEBIAN_FRONTEND=noninteractive", "chroot", str(self.path), "setpriv",
                f"--reuid={user}", f"--regid={user}", "--init-groups", "--pdeathsig=KILL",
                "env", f"--chdir={folder}", *map(str, command)]

    def run(self, *command, user="root", within=300):
        """Its output; AssertionError with all that it said where it fails."""
        result = subprocess.run(self.command(*command, user=user), check=False, text=True,
                                capture_output=True, stdin=subprocess.DEVNULL, timeout=within)
        if result.returncode != 0:
            raise AssertionError(f"{' '.join(map(str, command))}: exit code {result.returncode}\n"
                                 f"{result.stdout}{result.stderr}")
        return result.stdout

    def install(self, *packages):
        """With all that they depend on. A package is a name, or a file of this machine."""
        files = self.inside("/root")
        names = []
        for package in packages:
            if isinstance(package, pathlib.Path):
                shutil.copy(package, files)
                names.append(f"/root/{package.name}")
            else:
                names.append(package)
        return self.run("apt-get", "install", "--yes", "--no-install-recommends", *names)

    def clear_shared_memory(self):
        """Of what killed processes have left there."""
        for file in self.inside("/dev/shm").iterdir():
            file.unlink()

    def _lay_over(self, base):
        parts = {name: self.path.parent / name for name in ("root", "changes", "work")}
        for part in parts.values():
            part.mkdir()
        try:
            _run("mount", "-t", "overlay", "accord-test", "-o",
                 f"lowerdir={base},upperdir={parts['changes']},workdir={parts['work']}", self.path)
        except Unavailable:  # below is an overlay itself: then a copy
            _run("cp", "--archive", f"{base}/.", self.path)
            _run("mount", "--bind", self.path, self.path)


def _make(base):
    made = subprocess.run([ROOT / "tests/support/debian_root", base], check=False, text=True,
                          capture_output=True)
    if made.returncode == CANNOT:
        raise Unavailable(made.stderr.strip())
    if made.returncode != 0:
        raise AssertionError(f"debian_root: exit code {made.returncode}\n{made.stderr}")


def _have_own_mounts():
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNS) != 0:
        raise Unavailable(f"no mounts of its own: {os.strerror(ctypes.get_errno())}")
    _run("mount", "--make-rprivate", "/")


def _run(*command):
    result = subprocess.run([str(word) for word in command], check=False, text=True,
                            capture_output=True)
    if result.returncode != 0:
        raise Unavailable(f"{command[0]}: {result.stderr.strip()}")
