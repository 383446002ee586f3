"""The service on the hosts of a network: a coordinator, workers, and fleet managers that submit."""

import functools
import json
import os
import pathlib
import re
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[3]


def _binary(variable, name):
    # Else the services would take it for a setting.
    return os.environ.pop(variable, str(ROOT / "build/bin" / name))


ACCORD = _binary("ACCORD", "accord")
COORDINATOR = _binary("ACCORD_COORDINATOR", "accord-coordinator")
DISCOVERY = _binary("ACCORD_DISCOVERY", "accord-discovery")
WORKER = _binary("ACCORD_WORKER", "accord-worker")


def scene(name):
    """One of ours by its name, or any by the path of its file."""
    return name if isinstance(name, pathlib.Path) else ROOT / "scenes" / f"{name}.yaml"


def canonical(plan):
    """A plan without what it took to make it."""
    plan = dict(plan)
    del plan["planning_time"]
    plan["statistics"] = {name: value for name, value in plan["statistics"].items()
                          if not name.endswith("_time")}
    return plan


def planned_here(name):
    """The plan that one process makes."""
    result = subprocess.run([ACCORD, "plan", scene(name), "--json", "--quiet"], check=True,
                            text=True, capture_output=True, timeout=120)
    return canonical(json.loads(result.stdout))


class Process:
    """One of the service, or of those who ask it."""

    def __init__(self, start, folder, command):
        """start(command, **options) gives a Popen. What it says is in the folder."""
        self.began = time.monotonic()
        self.name = pathlib.Path(command[0]).name
        self._output, self._log = (folder / f"{len(list(folder.iterdir()))}.{kind}"
                                   for kind in ("output", "log"))
        with self._output.open("w") as output, self._log.open("w") as log:
            self._process = start(command, stdout=output, stderr=log)

    @property
    def log(self):
        return self._log.read_text()

    @property
    def output(self):
        return self._output.read_text()

    def await_log(self, pattern, within=60):
        """Waits until it says so."""
        end = time.monotonic() + within
        while not re.search(pattern, self.log):
            if time.monotonic() > end:
                raise AssertionError(f"{self.name} has not said within {within} s: {pattern}\n"
                                     f"{self.log}")
            time.sleep(0.01)

    def end(self, within):
        """Its exit code, and how long it took (s)."""
        try:
            code = self._process.wait(within)
        except subprocess.TimeoutExpired:
            raise AssertionError(f"{self.name} has not ended within {within} s") from None
        return code, time.monotonic() - self.began

    def terminate(self):
        self._process.terminate()

    def kill(self):
        self._process.kill()
        self._process.wait()


class Service:
    def __init__(self, start, folder, flags):
        """start(host, command, **options) gives a Popen; flags(host) are for all that run there."""
        self._start = start
        self._folder = folder
        self._flags = flags
        self._processes = []

    def coordinator(self, host, journal, *more):
        return self._run(host, COORDINATOR, "--journal", journal, *more)

    def worker(self, host):
        return self._run(host, WORKER, "--threads", "1")

    def discovery(self, host, *more):
        return self._run(host, DISCOVERY, *more, flags=False)

    def submit(self, host, name, *more):
        return self._run(host, ACCORD, "submit", scene(name), "--json", *more)

    def logs(self):
        return "\n".join(f"{process.name}:\n{process.log}" for process in self._processes)

    def stop(self):
        for process in self._processes:
            process.kill()

    def _run(self, host, *command, flags=True):
        process = Process(functools.partial(self._start, host), self._folder,
                          [*command, *(self._flags(host) if flags else ())])
        self._processes.append(process)
        return process
