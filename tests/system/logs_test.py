#!/usr/bin/env python3
"""What the logs of a real coordinator and real workers on 127.0.0.1 say: from a plan, by its request's
id, to the tasks that made each stretch of it, to the worker of each and that worker's own lines; and
that each line says what it is about, in the fields that docs/operations.md lists.

ACCORD, ACCORD_COORDINATOR and ACCORD_WORKER are the binaries, build/bin/... unless told."""

import json
import os
import pathlib
import random
import re
import subprocess
import tempfile
import time
import unittest

from binaries import ROOT, binary

SCENES = ROOT / "scenes"


ACCORD = binary("ACCORD", "bin/accord")
COORDINATOR = binary("ACCORD_COORDINATOR", "bin/accord-coordinator")
WORKER = binary("ACCORD_WORKER", "bin/accord-worker")

ALWAYS = {"time", "level", "process", "message"}


def documented_lines():
    """By what a message begins with: its process, its level and the fields that the page lists."""
    page = (ROOT / "docs/operations.md").read_text()
    section = re.search(r"(?ms)^## Log$(.*?)(?=^## )", page)[1]
    out = {}
    for row in re.findall(r"(?m)^\| `.*` \| accord-.*$", section):
        words, process, level, fields = (cell.strip() for cell in row.strip("|").split("|"))
        for message in re.findall(r"`([^`]+)`", words):
            out[process, message] = (level, set(re.findall(r"`(\w+)`", fields)))
    return out


class LogTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        settings = {"DDS_DOMAIN": random.randint(1, 200), "DDS_TRANSPORT": "udp",
                    "DDS_CLUSTER": f"test-{random.getrandbits(48):x}", "DDS_INTERFACES": "127.0.0.1"}
        self.environment = {**os.environ,
                            **{f"ACCORD_{name}": str(value) for name, value in settings.items()}}

    def start(self, name, *command):
        """A service whose log goes to NAME.log."""
        with (self.folder / f"{name}.log").open("w") as log:
            process = subprocess.Popen(
                [*map(str, command), "--log", "debug", "--log-format", "json"],
                env=self.environment, stdin=subprocess.DEVNULL, stderr=log)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start_service(self, workers, *arguments):
        coordinator = self.start("coordinator", COORDINATOR, *arguments)
        return coordinator, [self.start(f"worker-{i}", WORKER, "--threads", 1)
                             for i in range(workers)]

    def await_lines(self, name, message, count=1):
        end = time.monotonic() + 30
        while sum(line["message"].startswith(message) for line in self.lines(name)) < count:
            self.assertLess(time.monotonic(), end, f"{name} has not said: {message}")
            time.sleep(0.05)

    def lines(self, name):
        text = (self.folder / f"{name}.log").read_text()
        return [json.loads(line) for line in text.splitlines(keepends=True) if line.endswith("\n")]

    def accord(self, *arguments):
        return subprocess.run([ACCORD, *map(str, arguments)], env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=60, check=False)

    def plan(self, request, scene):
        path = self.folder / f"{request}.json"
        result = self.accord("submit", SCENES / scene, "--id", request, "--quiet", "-o", path)
        self.assertEqual(0, result.returncode, result.stderr)
        return json.loads(path.read_text())


def having(lines, message, **fields):
    """Those that begin so and have these fields."""
    return [line for line in lines if line["message"].startswith(message)
            and all(line.get(key) == value for key, value in fields.items())]


class Correlation(LogTest):
    def one(self, lines, message, **fields):
        found = having(lines, message, **fields)
        self.assertEqual(1, len(found), f"{message} {fields}: {found}")
        return found[0]

    def test_goes_from_a_plan_to_each_task_that_made_it_and_to_its_workers_own_lines(self):
        self.start_service(2)
        self.await_lines("coordinator", "worker takes tasks", 2)
        plan = self.plan("depot-7", "adaptive-mobile.yaml")
        self.plan("depot-8", "adaptive-mobile.yaml")  # whose lines are not to be taken for these
        coordinator = self.lines("coordinator")
        workers = {}  # by id: its lines
        for name in ("worker-0", "worker-1"):
            lines = self.lines(name)
            workers[lines[0]["worker"]] = lines
        begin = self.one(coordinator, "planning begins", request="depot-7")

        made, used = {}, set()  # by subproblem: who was planned together; and the workers
        for robot in plan["robots"]:
            for segment in robot["segments"]:
                line = self.one(coordinator, "segment of the plan", request="depot-7",
                                robot=robot["name"], **{"from": segment["from"]})
                self.assertEqual((segment["to"], segment["solver"]), (line["to"], line["solver"]))
                number = line["subproblem"]
                robots = frozenset(segment["robots"])
                self.assertEqual(robots, made.setdefault(number, robots), number)

                attempts = having(coordinator, "attempt at a subproblem", request="depot-7",
                                  subproblem=number)
                self.assertEqual(["exhausted"] * (len(attempts) - 1),
                                 [attempt["outcome"] for attempt in attempts[:-1]])
                self.assertEqual(segment["solver"], attempts[-1]["solver"])
                for attempt in attempts:
                    used.add(attempt["worker"])
                    self.check_task(begin, attempt, coordinator, workers[attempt["worker"]])
        self.assertGreater(sum(len(robots) > 1 for robots in made.values()), 1)
        self.assertEqual(workers.keys(), used)

    def check_task(self, begin, attempt, coordinator, worker):
        """A task's lines, here and there, tell the same."""
        task = {"request": "depot-7", "task": attempt["task"], "worker": attempt["worker"]}
        self.assertEqual(begin["tasks"], task["task"].rpartition("-")[0])
        assigned = having(coordinator, "task assigned", **task)[-1]
        ended = self.one(coordinator, "task ended", **task)
        done = self.one(worker, "task done", **task, epoch=assigned["epoch"])
        self.assertEqual(1, len(having(worker, "task begins", **task, epoch=assigned["epoch"])))
        for line in (ended, done):
            self.assertEqual((attempt["outcome"], attempt["seconds"]),
                             (line["outcome"], line["seconds"]))


class Fields(LogTest):
    def check(self, name):
        """All lines of a log: their fields, and that none is about something it has no field of."""
        documented = documented_lines()
        seen = set()
        for line in self.lines(name):
            self.assertLessEqual(ALWAYS, line.keys())
            known = [key for key in documented
                     if key[0] == line["process"] and line["message"].startswith(key[1])]
            if known:
                key = max(known, key=lambda one: len(one[1]))
                level, fields = documented[key]
                self.assertLessEqual(fields, line.keys(), line)
                self.assertIn(line["level"], level.split(" or "), line)
                seen.add(key[1])
            if "task" in line or "subproblem" in line:
                self.assertIn("request", line, line)
            if line["process"] == "accord-worker" and line["message"] not in ("ended",):
                self.assertIn("worker", line, line)
        return seen

    def test_say_what_each_line_is_about(self):
        coordinator, workers = self.start_service(2, "--max-robots", 32)
        self.await_lines("coordinator", "worker takes tasks", 2)
        self.plan("depot-7", "adaptive-mobile.yaml")
        large = self.accord("submit", SCENES / "random-crossing-0300.yaml", "--id", "large-1")
        self.assertEqual(3, large.returncode, large.stderr)
        endless = subprocess.Popen(
            [ACCORD, "submit", SCENES / "low-mobile-32.yaml", "--method", "composite-prm", "--id",
             "endless-1", "--quiet"], env=self.environment, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
        self.addCleanup(endless.wait)
        self.addCleanup(endless.kill)
        self.await_lines("coordinator", "planning begins", 2)
        # 32 paths of robots alone, then one task for whoever gets it.
        while len(assigned := having(self.lines("coordinator"), "task assigned",
                                     request="endless-1")) < 33:
            time.sleep(0.05)
        victim = next(i for i in (0, 1)
                      if self.lines(f"worker-{i}")[0]["worker"] == assigned[-1]["worker"])
        workers[victim].kill()
        self.await_lines("coordinator", "task given out anew")
        workers[1 - victim].terminate()
        self.await_lines("coordinator", "worker takes no more tasks")
        self.accord("cancel", "endless-1")
        self.await_lines("coordinator", "plan handed out", 2)
        workers[1 - victim].wait(30)
        coordinator.terminate()
        coordinator.wait(30)

        seen = self.check("coordinator") | self.check("worker-0") | self.check("worker-1")
        rare = {message for _, message in documented_lines()} - seen
        self.assertEqual({"worker refused", "worker distrusted", "task given up", "result dropped",
                          "its resolution does not hold", "task handed back", "task refused",
                          "task failed", "internal error", "asked how it stands",
                          "worker has left"} - seen, rare)
        lines = self.lines("coordinator")
        for request in ("depot-7", "endless-1", "large-1"):  # whoever names one has it as a field
            for line in lines:
                if re.search(rf"\b{request}\b", line["message"]):
                    self.assertEqual(request, line.get("request"), line)
        lost = having(lines, "worker lost")[0]
        self.assertEqual(assigned[-1]["worker"], lost["worker"])
        self.assertEqual(workers[victim].pid, lost["pid"])
        self.assertEqual(assigned[-1]["task"], having(lines, "task given out anew")[0]["task"])
        rejected = having(lines, "rejected", request="large-1")[0]
        self.assertEqual(("too_large", "scene_text"), (rejected["reason"], rejected["field"]))

    def test_tell_no_tasks_unless_asked_to(self):
        with (self.folder / "quiet.log").open("w") as log:
            quiet = subprocess.Popen([COORDINATOR, "--log-format", "json"], env=self.environment,
                                     stdin=subprocess.DEVNULL, stderr=log)
        self.addCleanup(quiet.wait)
        self.addCleanup(quiet.kill)
        self.start("worker-0", WORKER, "--threads", 1)
        self.plan("depot-7", "adaptive-mobile.yaml")
        lines = self.lines("quiet")
        self.assertEqual(["accepted", "plan handed out", "planned", "planning begins"],
                         sorted(line["message"].split(":")[0] for line in lines
                                if "request" in line))
        self.assertFalse([line for line in lines if "task" in line or line["level"] == "debug"])


if __name__ == "__main__":
    unittest.main()
