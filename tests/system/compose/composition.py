"""deploy/docker-compose.yml as the cases of this folder use it: a project of its own for each test,
with no demo unless it asks for one."""

import atexit
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/system/hosts"))
import service  # noqa: E402: planned_here and canonical are the same for hosts and containers

SOLVED = 0
# Takes long enough that something can happen meanwhile, and has work for any number of workers.
LONG = "arm-cells-128"
IMAGE = "accord-test"
READ = "import sys, urllib.request as u; print(u.urlopen(sys.argv[1], timeout=5).read().decode())"


@functools.cache
def scenes():
    """The folder of scenes that the containers see: ours, and LONG."""
    folder = pathlib.Path(tempfile.mkdtemp(prefix="accord-scenes-"))
    atexit.register(shutil.rmtree, folder)
    shutil.copytree(ROOT / "scenes", folder, dirs_exist_ok=True)
    subprocess.run([ROOT / "scenes/generate", *LONG.rsplit("-", 1), "-o", folder], check=True,
                   capture_output=True)
    folder.chmod(0o755)
    return folder


@functools.cache
def planned_here(name):
    """The plan that one process makes."""
    return service.planned_here(scenes() / f"{name}.yaml")


class Case(unittest.TestCase):
    OVERLAYS = ()  # "shm": deploy/docker-compose.shm.yml
    VARIABLES = {}

    def setUp(self):
        self.project = f"accord-test-{os.getpid()}"
        files = ["docker-compose.yml", *(f"docker-compose.{name}.yml" for name in self.OVERLAYS)]
        self._command = ["docker-compose", "--project-name", self.project]
        for file in files:
            self._command += ["--file", str(ROOT / "deploy" / file)]
        self.variables = {**os.environ, "ACCORD_IMAGE": IMAGE, "COMPOSE_PROFILES": "",
                             "ACCORD_DDS_CLUSTER": self.project,
                             "ACCORD_SCENES": str(scenes()), **self.VARIABLES}
        self.addCleanup(self.compose, "down", "--volumes", "--timeout", "1", "--remove-orphans")

    def compose(self, *arguments, check=True, **options):
        result = subprocess.run([*self._command, *map(str, arguments)], env=self.variables,
                                check=False, capture_output=True, text=True, timeout=180, **options)
        if check and result.returncode != 0:
            self.fail(f"docker-compose {' '.join(map(str, arguments))}: {result.stdout}"
                      f"{result.stderr}\n{self.logs()}")
        return result.stdout

    def up(self, workers, *more):
        self.compose("up", "--detach", "--no-build", "--scale", f"worker={workers}", *more)

    def logs(self, *services):
        return self.compose("logs", "--no-color", *services, check=False)

    def containers(self, name):
        return self.compose("ps", "--quiet", name).split()

    def inspect(self, container, template):
        return self.docker("inspect", "--format", template, container).strip()

    def crash(self, container):
        """Its process dies as if of a fault: the engine was not asked to end it."""
        os.kill(int(self.inspect(container, "{{.State.Pid}}")), 9)

    def wait_until(self, holds, what, within=60):
        end = time.monotonic() + within
        while not holds():
            if time.monotonic() > end:
                self.fail(f"not within {within} s: {what}\n{self.logs()}")
            time.sleep(0.1)

    def await_log(self, name, pattern, times=1):
        self.wait_until(lambda: len(re.findall(pattern, self.logs(name))) >= times,
                        f"{name} has not said {times} times: {pattern}")

    def await_well(self):
        """All containers, by their own health checks."""
        def are_well():
            ids = self.compose("ps", "--quiet").split()
            return all(self.inspect(each, "{{.State.Health.Status}}") == "healthy" for each in ids)
        self.wait_until(are_well, "all containers are healthy")

    def submit(self, name):
        """A client in a container of its own; see end_of()."""
        return subprocess.Popen(
            [*self._command, "run", "--rm", "-T", "demo", "accord", "submit",
             f"/srv/scenes/{name}.yaml", "--json", "--patience", "60"],
            env=self.variables, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.PIPE, text=True)

    def end_of(self, submission, within=120):
        """The plan that a submission came to."""
        output, errors = submission.communicate(timeout=within)
        self.assertEqual(SOLVED, submission.returncode, f"{errors}\n{self.logs()}")
        return service.canonical(json.loads(output))

    def assert_plans(self, *names):
        for name in names:
            self.assert_ends_planned(name, self.submit(name))

    def assert_ends_planned(self, name, submission):
        self.assertEqual(planned_here(name), self.end_of(submission), name)

    def solvers(self):
        """The containers of workers that have solved tasks."""
        return [worker for worker in self.containers("worker") if self.tasks_of(worker) > 0]

    def tasks_of(self, worker):
        """How many tasks a worker's container has done."""
        return sum(float(value) for value in re.findall(
            r'(?m)^accord_worker_tasks_total\{[^}]*outcome="done"[^}]*\} (\S+)$',
            self.metrics_of(worker)))

    def metrics_of(self, container):
        port = self.docker("exec", container, "cat", "/tmp/accord-metrics-port").strip()
        return self.in_network_of(container, sys.executable, "-c", READ,
                                  f"http://127.0.0.1:{port}/metrics")

    def in_network_of(self, container, *command):
        return subprocess.run(
            ["nsenter", "--target", self.inspect(container, "{{.State.Pid}}"), "--net", *command],
            check=True, capture_output=True, text=True, timeout=60).stdout

    def docker(self, *arguments):
        return subprocess.run(["docker", *arguments], check=True, env=self.variables,
                              capture_output=True, text=True, timeout=60).stdout
