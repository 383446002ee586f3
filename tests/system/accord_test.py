#!/usr/bin/env python3
"""Runs the built `accord` (environment variable ACCORD) on scenes, as a person would."""

import json
import math
import os
import pathlib
import pty
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "scenes"
ACCORD = os.environ.get("ACCORD", str(ROOT / "build/bin/accord"))

SOLVED, BUG, USAGE, BAD_INPUT, INFEASIBLE, TIMEOUT = range(6)

# Two discs in a corridor with a bay in which one can let the other pass.
TWO_CARTS = """\
accord: scene/1
name: two-carts
clearance: 0.05
environment:
  bounds: [[-5, -1], [5, 3]]
  obstacles:
    - {box: [4, 2], at: [-3, 2]}
    - {box: [4, 2], at: [3, 2]}
models:
  agv: {disk: 0.3, speed: 1.0}
robots:
  - {name: a, model: agv, start: [-4, 0], goal: [4, 0]}
  - {name: b, model: agv, start: [4, 0], goal: [-4, 0]}
"""


def accord(*arguments, timeout=240):
    return subprocess.run([ACCORD, *map(str, arguments)], stdin=subprocess.DEVNULL, text=True,
                          capture_output=True, timeout=timeout, check=False)


class SystemTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def scene(self, text=TWO_CARTS, name="scene.yaml"):
        path = self.folder / name
        path.write_text(text)
        return path

    def plan(self, scene, *options):
        """Plans the scene and returns the path of the plan."""
        path = self.folder / f"{pathlib.Path(scene).stem}.json"
        self.assert_exit(SOLVED, accord("plan", scene, "-o", path, "--quiet", *options))
        return path

    def assert_exit(self, code, result):
        self.assertEqual(code, result.returncode,
                         f"{result.args}\n{result.stdout}\n{result.stderr}")


class PlanAndVerify(SystemTest):
    def test_scenes_are_planned_and_proved(self):
        for name in ("adaptive-mobile", "low-manipulator-02", "high-manipulator-2"):
            with self.subTest(name):
                scene = SCENES / f"{name}.yaml"
                result = accord("verify", scene, self.plan(scene))
                self.assert_exit(SOLVED, result)
                self.assertIn("free of collisions at every instant", result.stdout)

    def test_the_summary_says_what_was_planned(self):
        result = accord("plan", self.scene())
        self.assert_exit(SOLVED, result)
        for words in ("solved", "makespan", "sum of costs", "conflicts", "between robots"):
            self.assertIn(words, result.stdout)
        self.assertEqual("", result.stderr, "no progress unless on a terminal")

    def test_the_log_tells_of_each_subproblem_on_stderr(self):
        scene = self.scene()
        options = ("plan", scene, "-o", self.folder / "plan.json", "--quiet", "--log")
        told = accord(*options, "debug")
        self.assert_exit(SOLVED, told)
        self.assertEqual(told.stdout, "")
        self.assertRegex(told.stderr, r"conflict at [0-9.]+ s, window .*: a, b: [a-z-]+ \(")
        self.assertEqual(accord(*options, "warning").stderr, "")
        self.assert_exit(USAGE, accord(*options, "loudly"))

    def test_json_is_the_plan_that_is_written(self):
        scene = self.scene()
        path = self.folder / "plan.json"
        result = accord("plan", scene, "--json", "-o", path)
        self.assert_exit(SOLVED, result)
        self.assertEqual(path.read_text(), result.stdout)
        plan = json.loads(result.stdout)
        self.assertEqual("plan/1", plan["accord"])
        self.assertEqual("solved", plan["status"])
        self.assertEqual(["a", "b"], [robot["name"] for robot in plan["robots"]])
        for robot in plan["robots"]:
            self.check_contract(robot, plan["makespan"])

    def check_contract(self, robot, makespan):
        """What docs/formats.md promises of a disc's path, checked without Accord's help."""
        waypoints = robot["waypoints"]
        self.assertEqual(0, waypoints[0]["t"])
        for before, after in zip(waypoints, waypoints[1:]):
            duration = after["t"] - before["t"]
            self.assertGreater(duration, 0)
            self.assertLessEqual(math.dist(before["q"], after["q"]), duration * (1 + 1e-6))
        self.assertLessEqual(waypoints[-1]["t"], makespan)
        segments = robot["segments"]
        self.assertEqual(0, segments[0]["from"])
        for before, after in zip(segments, segments[1:]):
            self.assertEqual(before["to"], after["from"])
        for segment in segments:
            self.assertIn(robot["name"], segment["robots"])

    def test_robots_that_are_where_they_should_be(self):
        scene = self.scene(TWO_CARTS.replace("goal: [4, 0]", "goal: [-4, 0]")
                           .replace("start: [4, 0], goal: [-4, 0]", "start: [4, 0], goal: [4, 0]"))
        self.assert_exit(SOLVED, accord("verify", scene, self.plan(scene)))

    def test_a_dash_is_standard_output(self):
        scene = self.scene()
        for options in (("-o", "-"), ("-o", "-", "--json"), ("-o", "-", "--quiet")):
            with self.subTest(options):
                result = accord("plan", scene, *options)
                self.assert_exit(SOLVED, result)
                self.assertEqual("solved", json.loads(result.stdout)["status"])
        result = accord("render", scene, "-o", "-")
        self.assert_exit(SOLVED, result)
        self.assertTrue(result.stdout.startswith("<svg"))

    def test_a_plan_for_a_scene_of_another_name_is_worth_a_note(self):
        plan = self.plan(self.scene())
        other = self.scene(TWO_CARTS.replace("name: two-carts", "name: three-carts"), "other.yaml")
        for arguments in (("verify", other, plan),
                          ("render", other, plan, "-o", self.folder / "picture.svg")):
            with self.subTest(arguments):
                result = accord(*arguments)
                self.assert_exit(SOLVED, result)
                self.assertRegex(result.stderr, 'note: .*"two-carts".*"three-carts"')
        self.assertEqual("", accord("verify", other, plan, "--quiet").stderr)

    def test_info_says_what_is_in_a_scene(self):
        result = accord("info", SCENES / "adaptive-mobile.yaml")
        self.assert_exit(SOLVED, result)
        for words in ("adaptive-mobile, planar", "25 boxes", "16 with 32 degrees", "makespan"):
            self.assertIn(words, result.stdout)


class ExitCodes(SystemTest):
    def test_usage(self):
        for arguments in ((), ("fly",), ("plan",), ("plan", "x.yaml", "--seed", "soon"),
                          ("plan", "x.yaml", "--solvers", "magic"), ("render", "x.yaml"),
                          ("plan", "x.yaml", "--workers", "0"), ("verify", "x.yaml")):
            with self.subTest(arguments):
                result = accord(*arguments)
                self.assert_exit(USAGE, result)
                self.assertTrue(result.stderr)

    def test_values_that_options_do_not_take(self):
        solver = "prioritized-query"
        for option, value in (
                ("--timeout", "nan"), ("--timeout", "inf"), ("--timeout", "-1"),
                ("--seed", "-1"), ("--seed", "18446744073709551616"), ("--seed", "0x10"),
                ("--seed", "1e3"), ("--seed", ""), ("--workers", "0x1"),
                ("--solvers", f"{solver},"), ("--solvers", f"{solver},{solver}"),
                ("--solvers", ""), ("--output", "")):
            with self.subTest(f"{option}={value}"):
                for arguments in ((option, value), (f"{option}={value}",)):
                    result = accord("plan", self.scene(), *arguments)
                    self.assert_exit(USAGE, result)
                    self.assertIn(option, result.stderr)
        self.assert_exit(USAGE, accord("render", self.scene(), "-o", ""))

    def test_seeds_are_plain_decimal_numbers(self):
        for text, seed in (("0", 0), ("010", 10), ("18446744073709551615", 2**64 - 1)):
            with self.subTest(text):
                result = accord("plan", self.scene(), "--json", "--seed", text)
                self.assert_exit(SOLVED, result)
                self.assertEqual(seed, json.loads(result.stdout)["seed"])

    def test_a_list_of_solvers_is_one_word(self):
        result = accord("plan", "--solvers", "prioritized-query,decoupled-prm", self.scene())
        self.assert_exit(SOLVED, result)

    def test_a_command_that_does_not_exist(self):
        for arguments in (("bogus",), ("bogus", "x.yaml", "-o", "y"), ("bogus", "info", "x.yaml")):
            with self.subTest(arguments):
                result = accord(*arguments)
                self.assert_exit(USAGE, result)
                self.assertIn('there is no command "bogus"', result.stderr)
                for command in ("plan", "verify", "info", "render"):
                    self.assertIn(command, result.stderr)

    def test_output_that_would_overwrite_what_is_read(self):
        scene = self.scene()
        plan = self.plan(scene)
        link = self.folder / "link"
        link.symlink_to(scene)
        for arguments in (("plan", scene, "-o", scene), ("plan", scene, "-o", link),
                          ("plan", link, "-o", scene), ("render", scene, "-o", scene),
                          ("render", scene, plan, "-o", plan)):
            with self.subTest(arguments):
                result = accord(*arguments)
                self.assert_exit(USAGE, result)
                self.assertIn("the same file", result.stderr)
        self.assertEqual(TWO_CARTS, scene.read_text())
        self.assert_exit(SOLVED, accord("verify", scene, plan))

    def test_standard_output_that_is_full(self):
        scene = self.scene()
        plan = self.plan(scene)
        for arguments in (("plan", scene), ("plan", scene, "--json"), ("plan", scene, "-o", "-"),
                          ("info", scene), ("verify", scene, plan), ("render", scene, "-o", "-"),
                          ("plan", SCENES / "adaptive-mobile.yaml", "--json"), ("--help",)):
            with self.subTest(arguments), open("/dev/full", "w", encoding="ascii") as full:
                result = subprocess.run([ACCORD, *map(str, arguments)], stdout=full, text=True,
                                        stderr=subprocess.PIPE, timeout=240, check=False)
                self.assert_exit(BAD_INPUT, result)
                self.assertIn("standard output: cannot be written", result.stderr)

    def test_help_is_no_failure(self):
        for arguments in (("--help",), ("plan", "--help"), ("--version",)):
            result = accord(*arguments)
            self.assert_exit(SOLVED, result)
            self.assertTrue(result.stdout)

    def test_missing_files(self):
        scene = self.scene()
        for arguments in (("plan", "nowhere.yaml"), ("info", "nowhere.yaml"),
                          ("verify", scene, "nowhere.json"),
                          ("render", "nowhere.yaml", "-o", self.folder / "x.svg")):
            with self.subTest(arguments):
                result = accord(*arguments)
                self.assert_exit(BAD_INPUT, result)
                self.assertIn("nowhere", result.stderr)

    def test_output_that_cannot_be_written(self):
        result = accord("render", self.scene(), "-o", self.folder / "no" / "such" / "folder.svg")
        self.assert_exit(BAD_INPUT, result)
        self.assertIn("folder.svg", result.stderr)

    def test_plan_files_that_are_none(self):
        scene = self.scene()
        for text in ("", "{", "[]", '{"accord": "plan/2"}', '{"accord": "plan/1"}'):
            with self.subTest(text):
                broken = self.folder / "broken.json"
                broken.write_text(text)
                result = accord("verify", scene, broken)
                self.assert_exit(BAD_INPUT, result)
                self.assertIn("broken.json", result.stderr)

    def test_infeasible(self):
        walled = TWO_CARTS.replace("  obstacles:\n", "  obstacles:\n    - {box: [1, 2], at: [0, 0]}\n")
        result = accord("plan", self.scene(walled))
        self.assert_exit(INFEASIBLE, result)
        self.assertRegex(result.stderr, r'^infeasible: .*"a"')

    def test_timeout(self):
        result = accord("plan", SCENES / "fleet-1000.yaml", "--timeout", "0.01", "--json")
        self.assert_exit(TIMEOUT, result)
        plan = json.loads(result.stdout)
        self.assertEqual("timeout", plan["status"])
        self.assertRegex(plan["message"], r'^the deadline passed .*"r\d+"')

    def test_a_plan_whose_segments_leave_a_gap(self):
        scene = self.scene()
        plan = json.loads(self.plan(scene).read_text())
        plan["robots"][1]["segments"][0]["from"] = 0.5
        path = self.folder / "gap.json"
        path.write_text(json.dumps(plan))
        result = accord("verify", scene, path)
        self.assert_exit(INFEASIBLE, result)
        self.assertRegex(result.stdout, r'^refuted: "b", segment 0: it begins at t = 0\.500 s')

    def test_a_picture_of_a_plan_for_other_robots(self):
        plan = self.plan(self.scene())
        other = self.scene(TWO_CARTS.replace("name: b", "name: c"), "other.yaml")
        picture = self.folder / "picture.svg"
        result = accord("render", other, plan, "-o", picture)
        self.assert_exit(BAD_INPUT, result)
        self.assertIn('no robot "c"', result.stderr)
        self.assertFalse(picture.exists())

    def test_a_refuted_plan(self):
        scene = self.scene()
        plan = json.loads(self.plan(scene).read_text())
        for robot in plan["robots"]:  # both straight through each other
            robot["waypoints"] = [{"t": 0, "q": robot["waypoints"][0]["q"]},
                                  {"t": 8.1, "q": robot["waypoints"][-1]["q"]}]
        path = self.folder / "head-on.json"
        path.write_text(json.dumps(plan))
        result = accord("verify", scene, path)
        self.assert_exit(INFEASIBLE, result)
        self.assertRegex(result.stdout, r'^refuted: "a" and "b" collide at t = 3\.\d+ s near \(')


class Signals(SystemTest):
    """SIGINT, SIGTERM and SIGHUP end any command with an exit code and a word, never silently."""

    LARGE = SCENES / "fleet-1000.yaml"

    def start(self, *arguments, sighup=signal.SIG_DFL):
        program = subprocess.Popen([ACCORD, *map(str, arguments)], stdin=subprocess.DEVNULL,
                                   text=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   preexec_fn=lambda: signal.signal(signal.SIGHUP, sighup))
        self.addCleanup(program.communicate)
        self.addCleanup(program.kill)
        return program

    def assert_cancelled(self, program):
        stdout, stderr = program.communicate(timeout=60)
        self.assertEqual(TIMEOUT, program.returncode, stderr)
        self.assertRegex(stderr, "(?m)^cancelled: ")
        return stdout

    @staticmethod
    def status(program):
        return pathlib.Path(f"/proc/{program.pid}/status").read_text()

    def handles(self, program, number):
        """Whether the program has come far enough to handle the signal itself."""
        caught = int(re.search(r"SigCgt:\s*([0-9a-f]+)", self.status(program))[1], 16)
        return caught >> (number - 1) & 1

    def wait_until(self, condition):
        deadline = time.monotonic() + 60
        while not condition():
            self.assertLess(time.monotonic(), deadline)
            time.sleep(0.001)

    def wait_for_a_conflict(self, program):
        """Until its log tells how one was resolved."""
        self.assertTrue(any("conflict at" in line for line in iter(program.stderr.readline, "")))

    def test_while_a_large_scene_is_planned(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            with self.subTest(number.name):
                program = self.start("plan", self.LARGE, "--json", "--log", "debug")
                self.wait_for_a_conflict(program)
                program.send_signal(number)
                plan = json.loads(self.assert_cancelled(program))
                self.assertEqual("cancelled", plan["status"])
                self.assertEqual([], plan["robots"])

    def test_before_the_scene_is_read(self):
        for command in (("plan",), ("info",), ("render", "-o", self.folder / "picture.svg")):
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                with self.subTest(f"{command[0]} {number.name}"):
                    program = self.start(*command, self.LARGE)
                    self.wait_until(lambda: self.handles(program, number))
                    program.send_signal(number)
                    self.assert_cancelled(program)
        self.assertEqual([], list(self.folder.iterdir()), "nothing is left behind")

    def test_while_the_plan_waits_for_its_reader(self):
        pipe = self.folder / "pipe"
        os.mkfifo(pipe)
        program = self.start("plan", self.scene(), "-o", pipe)
        # Reading and planning keep it busy; their threads are gone when it sleeps by itself.
        self.wait_until(lambda: re.search(r"State:\s*S[^$]*Threads:\s*1\n", self.status(program)))
        program.send_signal(signal.SIGTERM)
        self.assert_cancelled(program)

    def test_nohup_is_respected(self):
        program = self.start("plan", self.LARGE, "--log", "debug", sighup=signal.SIG_IGN)
        self.wait_for_a_conflict(program)
        program.send_signal(signal.SIGHUP)
        self.wait_for_a_conflict(program)
        program.send_signal(signal.SIGTERM)
        self.assert_cancelled(program)


class Terminals(SystemTest):
    """Progress is for people who watch a terminal, and only for them."""

    def shown(self, *arguments):
        """What the command writes to the terminal that is its standard error."""
        ours, theirs = pty.openpty()
        with subprocess.Popen([ACCORD, *map(str, arguments)], stdin=subprocess.DEVNULL,
                              stdout=subprocess.DEVNULL, stderr=theirs) as program:
            os.close(theirs)
            shown = b""
            try:
                while part := os.read(ours, 4096):
                    shown += part
            except OSError:  # how Linux says that the other side is closed
                pass
            os.close(ours)
        self.assertEqual(SOLVED, program.returncode)
        return shown.decode()

    def test_show_progress_and_then_an_empty_line(self):
        shown = self.shown("plan", SCENES / "fleet-0250.yaml")
        self.assertIn("paths of single robots", shown)
        self.assertIn("conflicts: ", shown)
        self.assertIn("proving the plan", shown)
        self.assertNotIn("\n", shown)
        self.assertTrue(shown.endswith("\r\x1b[K"))

    def test_show_nothing_where_quiet_is_asked_for(self):
        self.assertEqual("", self.shown("plan", SCENES / "fleet-0250.yaml", "--quiet"))
        self.assertEqual("", self.shown("plan", self.scene(), "--quiet"))


class SamePlan(SystemTest):
    """Scene, seed and limits decide the plan, whatever the number of workers."""

    @staticmethod
    def without_times(path):
        """The file's text without wall-clock times: planning_time, and statistics named *_time."""
        return re.sub(r'"(\w+_time)":\s*[-+.e\d]+', r'"\1": 0', path.read_text())

    def test_for_any_number_of_workers_in_every_scene(self):
        scenes = sorted(SCENES.glob("*.yaml"))
        self.assertGreater(len(scenes), 40)
        for scene in scenes:
            texts = [self.without_times(self.plan(scene, "--workers", workers))
                     for workers in (1, 2, 3, 8)]
            with self.subTest(scene.stem):
                for text in texts[1:]:
                    self.assertEqual(texts[0], text)

    def test_from_run_to_run(self):
        scene = SCENES / "random-crossing-0032.yaml"
        self.assertEqual(self.without_times(self.plan(scene, "--seed", 7)),
                         self.without_times(self.plan(scene, "--seed", 7)))


class BadScenes(SystemTest):
    """Every fault is one line that names the file, the line and what is wrong."""

    def check(self, text, line, *words):
        scene = self.scene(text)
        result = accord("plan", scene)
        self.assert_exit(BAD_INPUT, result)
        place = f"{scene}:{line}:" if line else f"{scene}:"
        lines = [entry for entry in result.stderr.splitlines() if entry.startswith(place)]
        self.assertTrue(lines, result.stderr)
        for word in words:
            self.assertIn(word, "\n".join(lines))

    def test_a_key_that_nobody_knows(self):
        self.check(TWO_CARTS.replace("clearance:", "clearence:"), 3, "clearence")

    def test_a_model_that_is_not_there(self):
        self.check(TWO_CARTS.replace("name: b, model: agv", "name: b, model: agw"), 13, "agw")

    def test_a_start_inside_an_obstacle(self):
        self.check(TWO_CARTS.replace("start: [-4, 0]", "start: [-4, 1.5]"), 12, '"a"')

    def test_a_goal_of_the_wrong_dimension(self):
        self.check(TWO_CARTS.replace("goal: [4, 0]", "goal: [4, 0, 0]"), 12, "goal")

    def test_two_robots_of_one_name(self):
        self.check(TWO_CARTS.replace("name: b", "name: a"), 13, "a")

    def test_no_yaml_at_all(self):
        self.check("{{{", 0)


class Pictures(SystemTest):
    SVG = "{http://www.w3.org/2000/svg}"

    def elements(self, path, tag):
        return list(xml.etree.ElementTree.parse(path).getroot().iter(self.SVG + tag))

    def test_of_a_scene_and_its_plan(self):
        scene = self.scene()
        picture = self.folder / "picture.svg"
        self.assert_exit(SOLVED, accord("render", scene, "-o", picture))
        alone = self.elements(picture, "path")
        self.assertEqual(2 + 2 * 3, len(self.elements(picture, "circle")),
                         "two starts and two goals, these with an area, an edge and an outline")
        self.assert_exit(SOLVED, accord("render", scene, self.plan(scene), "-o", picture))
        self.assertEqual(len(alone) + 2, len(self.elements(picture, "path")), "two ways")

    def test_of_every_kind_of_scene(self):
        for name in ("mixed-cell", "carts-6", "drones-12", "high-manipulator-4", "fleet-1000"):
            with self.subTest(name):
                picture = self.folder / f"{name}.svg"
                self.assert_exit(SOLVED, accord("render", SCENES / f"{name}.yaml", "-o", picture))
                self.assertTrue(self.elements(picture, "text"))


if __name__ == "__main__":
    sys.exit(unittest.main())
