"""A Docker engine to test with: the one that answers, else one of our own, in a network namespace
with bridges but no way out of the machine, by ../shared/tools/docker-engine."""

import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[3]
TOOL = ROOT.parent / "shared/tools/docker-engine"
SOCKET = f"unix://{os.environ.get('TMPDIR', '/tmp')}/accord-docker/docker.sock"
# What the bridges' own rules are changed from, where the engine has a namespace of its own.
NAMESPACE = "accord-docker"


def _answers(host):
    environment = {**os.environ, **({"DOCKER_HOST": host} if host else {})}
    return subprocess.run(["docker", "info"], env=environment, check=False, timeout=60,
                          capture_output=True).returncode == 0


class Engine:
    """Where docker and docker-compose are to look: `environment`. `is_ours`: started for the tests,
    so that its network may be tampered with."""

    def __init__(self):
        self.environment = dict(os.environ)
        self.is_ours = False
        self._starts = False

    def why_not(self):
        """Why there is none; empty where there is one, or one can be started."""
        missing = [name for name in ("docker", "docker-compose") if not shutil.which(name)]
        if missing:
            return f"not installed: {', '.join(missing)}"
        if _answers(None):
            return ""
        if not TOOL.exists():
            return f"no Docker engine answers, and there is no {TOOL} to start one with"
        if os.geteuid() != 0:
            return "no Docker engine answers, and to start one takes root"
        if not shutil.which("dockerd"):
            return "no Docker engine answers, and dockerd is not installed"
        self.environment["DOCKER_HOST"] = SOCKET
        self.is_ours = True
        return ""

    def start_to_build(self):
        """With the machine's own network, for packages."""
        self._start("build")

    def start_to_run(self):
        """With bridges."""
        self._start("net")

    def stop(self):
        if self._starts:
            subprocess.run([TOOL, "stop"], check=False)

    def ensure_base(self, root):
        """The base image, made of a root folder where no registry is reachable: `root()` gives it."""
        name = "debian:bookworm-slim"
        if not self.is_ours or self.has_image(name):
            return
        with tempfile.TemporaryFile() as archive:
            subprocess.run(["tar", "-C", root(), "-c", "."], check=True, stdout=archive)
            archive.seek(0)
            self.docker("import", "-", name, stdin=archive)

    def has_image(self, name):
        return self.docker("image", "inspect", name, check=False).returncode == 0

    def docker(self, *arguments, check=True, **options):
        result = subprocess.run(["docker", *map(str, arguments)], env=self.environment, check=False,
                                stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
        if check and result.returncode != 0:
            raise RuntimeError(f"docker {arguments[0]}: {result.stdout}{result.stderr}")
        return result

    def _start(self, mode):
        if not self.is_ours:
            return
        self._starts = True
        subprocess.run([TOOL, mode], check=True, stdout=sys.stderr)
