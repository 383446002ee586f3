#!/usr/bin/env python3
"""Runs the commands that watch and steer a service, and the example of a fleet manager, against real
processes on 127.0.0.1: ACCORD, ACCORD_COORDINATOR, ACCORD_WORKER and FLEET_MANAGER_EXAMPLE."""

import bisect
import fcntl
import json
import os
import pathlib
import pty
import random
import re
import select
import shutil
import signal
import struct
import subprocess
import tempfile
import termios
import time
import unittest

from binaries import ROOT, binary

SCENES = ROOT / "scenes"


ACCORD = binary("ACCORD", "bin/accord")
COORDINATOR = binary("ACCORD_COORDINATOR", "bin/accord-coordinator")
WORKER = binary("ACCORD_WORKER", "bin/accord-worker")
EXAMPLE = binary("FLEET_MANAGER_EXAMPLE", "examples/fleet_manager_example")

DONE, BUG, USAGE, BAD_INPUT, INFEASIBLE, TIMEOUT, NO_SERVICE = range(7)

# One solver for 32 robots at once, which takes hours.
ENDLESS = (SCENES / "low-mobile-32.yaml", "--method", "composite-prm")


class ServiceTest(unittest.TestCase):
    """Each in a domain and a cluster of its own."""

    def setUp(self):
        settings = {"DOMAIN": random.randint(1, 200), "CLUSTER": f"test-{random.getrandbits(48):x}",
                    "TRANSPORT": "udp", "INTERFACES": "127.0.0.1"}
        self.environment = {**os.environ, "TERM": "xterm",
                            **{f"ACCORD_DDS_{name}": str(value) for name, value in settings.items()}}

    def start(self, *command, **options):
        options = {"stdin": subprocess.DEVNULL, "stdout": subprocess.PIPE,
                   "stderr": subprocess.PIPE, "text": True, **options}
        process = subprocess.Popen([*map(str, command)], env=self.environment, **options)
        self.addCleanup(self.stop, process)
        return process

    @staticmethod
    def stop(process):
        process.kill()
        process.wait()
        for stream in (process.stdout, process.stderr):
            if stream:
                stream.close()

    def coordinator(self, *arguments):
        return self.start(COORDINATOR, "--log", "off", *arguments, stdout=subprocess.DEVNULL,
                          stderr=subprocess.DEVNULL)

    def workers(self, count):
        return [self.start(WORKER, "--log", "off", "--threads", 1, stdout=subprocess.DEVNULL,
                           stderr=subprocess.DEVNULL) for _ in range(count)]

    def accord(self, *arguments):
        return subprocess.run([ACCORD, *map(str, arguments)], env=self.environment, text=True,
                              stdin=subprocess.DEVNULL, capture_output=True, timeout=60,
                              check=False)

    def assert_exit(self, code, result):
        self.assertEqual(code, result.returncode,
                         f"{result.args}\n{result.stdout}\n{result.stderr}")

    def line(self, process, pattern):
        """The first line of those that are still to come that has the pattern."""
        seen = []
        for line in iter(process.stdout.readline, ""):
            seen.append(line)
            if re.search(pattern, line):
                return line
        raise AssertionError(f"it ended without {pattern}:\n{''.join(seen)}")

    def await_workers(self, count):
        end = time.monotonic() + 30
        while len(self.accord("workers", "--json").stdout.splitlines()) != count:
            self.assertLess(time.monotonic(), end)


class Watch(ServiceTest):
    def test_shows_a_request_from_its_begin_to_its_end(self):
        self.coordinator()
        watch = self.start(ACCORD, "watch")
        self.line(watch, r"^service present=true .*accepting=true$")
        self.workers(2)
        for _ in range(2):
            self.line(watch, r"Z worker worker=[0-9a-f]{16} .* threads=1 busy=0 standing=welcome$")
        submission = self.accord("submit", SCENES / "adaptive-mobile.yaml", "--id", "depot-7",
                                 "--quiet")
        self.assert_exit(DONE, submission)
        self.line(watch, r"^\S+Z request id=depot-7 phase=(queued|initial_paths) ")
        end = self.line(watch, r" request id=depot-7 .*outcome=")
        self.assertRegex(end, r"phase=finished .*robots=16 .*conflicts_found=24 "
                              r".*outcome=solved makespan=32\.0")
        watch.send_signal(signal.SIGTERM)
        self.assertEqual("", watch.communicate(timeout=30)[1])
        self.assertEqual(DONE, watch.returncode)

    def test_speaks_json(self):
        self.coordinator()
        watch = self.start(ACCORD, "watch", "--json")
        first = json.loads(watch.stdout.readline())
        self.assertEqual(("service", True, 0), (first["kind"], first["present"], first["workers"]))
        self.workers(1)
        worker = json.loads(self.line(watch, '"kind": "worker"'))
        self.assertEqual(("welcome", 1), (worker["standing"], worker["threads"]))

    def test_shows_all_of_it_once(self):
        self.coordinator()
        self.workers(2)
        self.await_workers(2)
        self.assert_exit(DONE, self.accord("submit", SCENES / "peer-inlet.yaml", "--id", "before",
                                           "--quiet"))
        result = self.accord("watch", "--once")
        self.assert_exit(DONE, result)
        self.assertRegex(result.stdout, r"(?m)^host +version +uptime +workers")
        self.assertRegex(result.stdout, r"(?m)^before +finished .* solved$")
        self.assertEqual(2, len(re.findall("(?m)welcome$", result.stdout)), result.stdout)
        kinds = [json.loads(line)["kind"] for line in
                 self.accord("watch", "--once", "--json").stdout.splitlines()]
        self.assertEqual(["service", "worker", "worker", "request"], kinds)

    def test_goes_on_when_the_service_goes_and_comes_back(self):
        first = self.coordinator()
        watch = self.start(ACCORD, "watch")
        self.line(watch, f"^service present=true .*process={first.pid} ")
        first.send_signal(signal.SIGTERM)
        first.wait(30)
        self.line(watch, " service present=false ")
        second = self.coordinator()
        self.line(watch, f" service present=true .*process={second.pid} ")

    def test_draws_on_a_terminal_and_leaves_it_as_it_was(self):
        self.coordinator()
        self.workers(1)
        ours, theirs = pty.openpty()
        self.addCleanup(os.close, ours)

        def resize(height, width):
            fcntl.ioctl(ours, termios.TIOCSWINSZ, struct.pack("HHHH", height, width, 0, 0))

        def read_until(pattern):
            shown = ""
            end = time.monotonic() + 30
            while not re.search(pattern, shown):
                self.assertLess(time.monotonic(), end, repr(shown[-2000:]))
                if select.select([ours], [], [], 1)[0]:
                    shown += os.read(ours, 65536).decode()
            return shown

        resize(24, 100)
        watch = self.start(ACCORD, "watch", stdout=theirs)
        os.close(theirs)
        self.assertTrue(read_until("welcome").startswith("\x1b[?1049h\x1b[?25l"))
        self.start(ACCORD, "submit", *ENDLESS, "--id", "the-long-one", "--quiet")
        read_until(r"the-long-one +(initial_paths|conflicts) ")
        resize(9, 30)
        read_until(r"\x1b\[J")  # what was on its way
        read_until(r"\x1b\[J")
        frame = read_until(r"\x1b\[J").rsplit("\x1b[H", 1)[1]
        lines = re.split(r"\r*\n", re.sub(r"\x1b\[[KJ]", "", frame))
        self.assertLessEqual(len(lines), 9, lines)
        self.assertLessEqual(max(map(len, lines)), 30, lines)
        self.assertTrue(any(line.startswith("the-l") for line in lines), lines)
        watch.send_signal(signal.SIGTSTP)  # Ctrl-Z: the terminal is the shell's meanwhile
        read_until(r"\x1b\[\?25h\x1b\[\?1049l$")
        os.waitpid(watch.pid, os.WUNTRACED)  # until it has stopped, as a shell does
        watch.send_signal(signal.SIGCONT)
        read_until(r"\x1b\[\?1049h\x1b\[\?25l.*\x1b\[H")
        watch.send_signal(signal.SIGINT)
        shown = read_until(r"\x1b\[\?1049l(.*\n)+")
        self.assertIn("\x1b[?25h\x1b[?1049l", shown)
        self.assertEqual(DONE, watch.wait(30))

    def test_is_ended_by_a_second_signal_with_the_terminal_put_right(self):
        ours, theirs = pty.openpty()
        self.addCleanup(os.close, ours)
        watch = self.start(ACCORD, "watch", stdout=theirs)  # there is no service
        os.close(theirs)
        shown = b""
        while b"no service" not in shown:
            shown += os.read(ours, 65536)
        watch.send_signal(signal.SIGSTOP)  # so that it cannot heed the first one alone
        watch.send_signal(signal.SIGTERM)
        watch.send_signal(signal.SIGINT)
        watch.send_signal(signal.SIGCONT)
        self.assertEqual(TIMEOUT, watch.wait(30))
        try:
            while part := os.read(ours, 65536):
                shown += part
        except OSError:  # how Linux says that the other side is closed
            pass
        self.assertIn(b"\x1b[?25h\x1b[?1049l", shown)


    def test_knows_what_waited_before_a_restart(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        journal = ("--journal", pathlib.Path(folder.name, "journal.db"), "--max-planning", 1)
        first = self.coordinator(*journal)
        watch = self.start(ACCORD, "watch")
        for name, phase in (("planned", "initial_paths"), ("waits", "queued")):
            self.start(ACCORD, "submit", *ENDLESS, "--id", name, "--quiet")
            self.line(watch, f"request id={name} phase={phase} ")
        first.kill()
        first.wait()
        self.coordinator(*journal)
        shown = self.accord("watch", "--once", "--json", "--patience", 30).stdout
        requests = {line["id"]: line["phase"] for line in map(json.loads, shown.splitlines())
                    if line["kind"] == "request"}
        self.assertEqual({"planned": "initial_paths", "waits": "queued"}, requests)


class Delegation(ServiceTest):
    """What asks a service is in accord-fleet, beside accord."""

    def test_keeps_dds_out_of_what_plans_here(self):
        self.environment["LD_TRACE_LOADED_OBJECTS"] = "1"  # as ldd does
        self.assertNotIn("fastrtps", self.accord().stdout)

    def test_names_the_program_that_is_missing(self):
        with tempfile.TemporaryDirectory() as folder:
            alone = shutil.copy(ACCORD, folder)
            result = subprocess.run([alone, "watch"], text=True, capture_output=True, timeout=60,
                                    check=False)
            self.assert_exit(BAD_INPUT, result)
            self.assertEqual(f"accord: cannot start {folder}/accord-fleet: No such file or "
                             "directory\n", result.stderr)

    def test_hands_the_command_line_on(self):
        help_text = self.accord("cancel", "--help")
        self.assert_exit(DONE, help_text)
        self.assertIn("Usage: accord cancel [OPTIONS] ID...", help_text.stdout)
        result = self.accord("workers", "--domain", "many")
        self.assert_exit(USAGE, result)
        self.assertIn("--domain: expected a whole number", result.stderr)


class NoService(ServiceTest):
    def test_is_said_and_has_an_exit_code(self):
        for command in (("watch",), ("watch", "--once"), ("workers",), ("cancel", "a")):
            with self.subTest(command):
                result = self.accord(*command, "--patience", 0.3)
                self.assert_exit(NO_SERVICE, result)
                self.assertEqual("", result.stdout)
                self.assertIn("no service has answered within 0.3 s; is a coordinator running in "
                              "the same domain and cluster?", result.stderr)


class Cancel(ServiceTest):
    def test_ends_what_is_planned_and_what_waits(self):
        self.coordinator("--max-planning", 1)
        self.workers(1)
        watch = self.start(ACCORD, "watch")
        submissions = []
        for name, phase in (("long", "(initial_paths|conflicts)"), ("waits", "queued")):
            submissions.append(self.start(ACCORD, "submit", *ENDLESS, "--id", name, "--quiet"))
            self.line(watch, f"request id={name} phase={phase} ")
        result = self.accord("cancel", "long", "waits")
        self.assert_exit(DONE, result)
        self.assertEqual(["long: cancelled", "waits: cancelled"],
                         sorted(result.stdout.splitlines()))
        for submission in submissions:
            self.assertEqual(TIMEOUT, submission.wait(30))
        self.line(watch, "request id=.* outcome=cancelled ")

    def test_says_what_had_ended_before_and_what_nobody_knows(self):
        self.coordinator()
        self.workers(1)
        self.assert_exit(DONE, self.accord("submit", SCENES / "peer-inlet.yaml", "--id", "before",
                                           "--quiet"))
        result = self.accord("cancel", "before")
        self.assert_exit(DONE, result)
        self.assertEqual("before: had ended before: solved\n", result.stdout)
        result = self.accord("cancel", "before", "nobodys")
        self.assert_exit(BAD_INPUT, result)
        self.assertEqual("before: had ended before: solved\n", result.stdout)
        self.assertEqual('accord: nobodys: unknown_request: there is no request "nobodys"\n',
                         result.stderr)


class Workers(ServiceTest):
    def test_are_listed(self):
        self.coordinator()
        result = self.accord("workers")
        self.assert_exit(DONE, result)
        self.assertRegex(result.stdout, "^no workers; start accord-worker")
        self.assertEqual("", self.accord("workers", "--json").stdout)
        processes = self.workers(2)
        self.await_workers(2)
        workers = [json.loads(line) for line in
                   self.accord("workers", "--json").stdout.splitlines()]
        self.assertEqual(sorted(process.pid for process in processes),
                         [worker["process"] for worker in workers])
        table = self.accord("workers").stdout.splitlines()
        self.assertRegex(table[0], "^worker +host +process +version +threads +busy +standing$")
        self.assertEqual(3, len(table))
        processes[0].kill()
        self.await_workers(1)


class Example(ServiceTest):
    """A fleet manager in a hundred lines."""

    SCENE = SCENES / "peer-inlet.yaml"

    def drive(self, *arguments):
        return self.start(EXAMPLE, *arguments)

    def test_drives_its_robots_along_the_plan(self):
        self.coordinator()
        self.workers(1)
        plan = json.loads(self.accord("plan", self.SCENE, "--json", "--quiet").stdout)
        example = self.drive(self.SCENE, 1000)
        output, errors = example.communicate(timeout=60)
        self.assertEqual(DONE, example.returncode, errors)
        self.assertRegex(output, r"(?m)^example-\d+: \d+\.\d\d s, finished, 2 of 2 robots planned")
        seen = re.findall(r"(?m)^ *(\d+\.\d\d) s  (\S+)  (.*)$", output)
        self.assertEqual(len(plan["robots"]), len({name for _, name, _ in seen}))
        for robot in plan["robots"]:
            said = [(float(t), [float(x) for x in at.split()])
                    for t, name, at in seen if name == robot["name"]]
            self.assertAlmostEqual(plan["makespan"], said[-1][0], places=2)
            for t, at in said[:-1]:
                for number, expected in zip(at, self.along(robot["waypoints"], t), strict=True):
                    self.assertAlmostEqual(expected, number, places=3)
            for number, expected in zip(said[-1][1], robot["waypoints"][-1]["q"], strict=True):
                self.assertAlmostEqual(expected, number, places=3)

    @staticmethod
    def along(waypoints, t):
        after = bisect.bisect_right([waypoint["t"] for waypoint in waypoints], t)
        if after == len(waypoints):
            return waypoints[-1]["q"]
        a, b = waypoints[after - 1], waypoints[after]
        share = (t - a["t"]) / (b["t"] - a["t"])
        return [x + share * (y - x) for x, y in zip(a["q"], b["q"], strict=True)]

    def test_cancels_what_is_not_planned_yet_when_interrupted(self):
        self.coordinator()  # and nobody who plans
        example = self.drive(self.SCENE)
        self.line(example, "initial_paths")
        example.send_signal(signal.SIGINT)
        output, _ = example.communicate(timeout=60)
        self.assertEqual(TIMEOUT, example.returncode)
        self.assertRegex(output, "(?m)^cancelled: ")

    def test_halts_its_robots_when_interrupted(self):
        self.coordinator()
        self.workers(1)
        example = self.drive(self.SCENE, 0.1)
        self.line(example, r"^ *0\.00 s ")
        example.send_signal(signal.SIGINT)
        output, _ = example.communicate(timeout=60)
        self.assertEqual(TIMEOUT, example.returncode)
        self.assertRegex(output, r"(?m)^halted at \d+\.\d\d s")

    def test_says_that_there_is_no_scene(self):
        example = self.drive(SCENES / "nothing.yaml")
        self.assertEqual(BAD_INPUT, example.wait(60))


if __name__ == "__main__":
    unittest.main()
