#!/usr/bin/env python3
"""Runs `accord replay` (environment variable ACCORD) on recorded tasks, which a helper writes
(TASK_RECORD_SAMPLES), sound and damaged."""

import os
import pathlib
import random
import signal
import subprocess
import tempfile
import time
import unittest

ACCORD, SAMPLES = os.environ["ACCORD"], os.environ["TASK_RECORD_SAMPLES"]
SOLVED, BUG, USAGE, BAD_INPUT, INFEASIBLE, TIMEOUT = range(6)


def replay(*arguments):
    return subprocess.run([ACCORD, "replay", *map(str, arguments)], stdin=subprocess.DEVNULL,
                          capture_output=True, timeout=60, check=False)


class Replay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        subprocess.run([SAMPLES, cls.folder], check=True)

    def run_on(self, name, *options):
        result = replay(self.folder / name, *options)
        return result.returncode, result.stdout.decode(), result.stderr.decode()

    def test_says_what_a_task_is_and_what_became_of_it(self):
        code, out, err = self.run_on("solved.task")
        self.assertEqual((SOLVED, ""), (code, err))
        for line in (r"scene +test", r"task +2 robots, from start to goal", r"robots +r0, r1",
                     r"window +from 0.000 s to 12.000 s, looks ahead to 60.000 s",
                     r"outsiders +none", r"solvers +lockstep-query, .*composite-prm",
                     r'kept because +"three workers were lost with it"',
                     r"outcome +solved by [a-z-]+, and the resolution holds",
                     r"effort +\d+ searches, \d+ expansions", r"took +\d+\.\d+ s"):
            self.assertRegex(out, rf"(?m)^{line}")

    def test_takes_a_robot_on_its_own(self):
        code, out, _ = self.run_on("alone.task")
        self.assertEqual(SOLVED, code)
        self.assertRegex(out, r"(?m)^task +a robot on its own$")
        self.assertRegex(out, r"(?m)^outcome +solved by straight, ")

    def test_tells_of_robots_and_solvers_where_asked(self):
        _, _, err = self.run_on("solved.task", "--log", "debug")
        self.assertRegex(err, r"r0: from \(-5, 0\) to \(5, 0\), arrives at 12.000 s so far and stays")
        self.assertRegex(err, r"prioritized-query: solved \(")

    def test_exhausted_is_no_plan(self):
        code, out, err = self.run_on("exhausted.task")
        self.assertEqual((INFEASIBLE, ""), (code, err))
        self.assertIn("exhausted", out)

    def test_ends_when_time_runs_out(self):
        code, out, _ = self.run_on("endless.task", "--timeout", "0.3")
        self.assertEqual(TIMEOUT, code)
        self.assertIn("stopped before it was solved", out)

    def test_ends_when_it_is_interrupted(self):
        with subprocess.Popen([ACCORD, "replay", self.folder / "endless.task"],
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stdout.readline()
            time.sleep(0.3)
            process.send_signal(signal.SIGINT)
            process.communicate(timeout=30)
            self.assertEqual(TIMEOUT, process.returncode)

    def test_explains_what_is_no_record(self):
        (self.folder / "scene.yaml").write_text("accord: scene/1\n")
        (self.folder / "empty").write_bytes(b"")
        for name, words in (("scene.yaml", "scene.yaml: not a recorded task"),
                            ("empty", "empty: not a recorded task"),
                            ("nowhere.task", "nowhere.task"), (".", "")):
            with self.subTest(name):
                code, out, err = self.run_on(name)
                self.assertEqual((BAD_INPUT, ""), (code, out))
                self.assertIn(words, err)
                self.assertEqual(1, len(err.splitlines()), err)

    def test_explains_an_unknown_solver(self):
        code, _, err = self.run_on("unknown.task")
        self.assertEqual(BAD_INPUT, code)
        self.assertIn('unknown.task: hierarchy: no solver "magic"', err)

    def test_needs_a_file(self):
        self.assertEqual(USAGE, replay().returncode)

    def test_a_damaged_file_is_explained_or_replayed_but_never_crashes(self):
        sound = (self.folder / "alone.task").read_bytes()
        rng = random.Random(4)
        damaged = [sound[:size] for size in rng.sample(range(len(sound)), 40)]
        for _ in range(160):
            changed = bytearray(sound)
            for _ in range(rng.randint(1, 3)):
                changed[rng.randrange(len(changed))] = rng.randrange(256)
            damaged.append(bytes(changed))
        path = self.folder / "damaged.task"
        for number, content in enumerate(damaged):
            path.write_bytes(content)
            result = replay(path, "--timeout", "2")
            with self.subTest(number):
                self.assertIn(result.returncode, (SOLVED, BAD_INPUT, INFEASIBLE, TIMEOUT),
                              result.stderr)
                if result.returncode == BAD_INPUT:
                    self.assertTrue(result.stderr.decode().startswith(f"{path}: "))
        path.unlink()


if __name__ == "__main__":
    unittest.main()
