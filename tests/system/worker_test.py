#!/usr/bin/env python3
"""Runs the built `accord-worker` (environment variable ACCORD_WORKER) as a person would: what it says
of how it was told what to do, and of how it does."""

import json
import os
import pathlib
import random
import re
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.error
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[2]
WORKER = os.environ.pop("ACCORD_WORKER", str(ROOT / "build/bin/accord-worker"))

ENDED, BUG, USAGE, BAD_FILE, UNAVAILABLE = range(5)


def worker(*arguments, variables=None):
    return subprocess.run([WORKER, *map(str, arguments)], stdin=subprocess.DEVNULL, text=True,
                          capture_output=True, timeout=60, check=False,
                          env={**os.environ, **(variables or {})})


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def status_of(port, path):
    """The status of an answer, None where nobody answers."""
    try:
        with urllib.request.urlopen(f"http://127.0.0.1:{port}{path}", timeout=5) as answer:
            return answer.status
    except urllib.error.HTTPError as error:
        return error.code
    except OSError:
        return None


class WorkerTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def file(self, text):
        path = self.folder / "worker.yaml"
        path.write_text(text)
        return path

    def start(self, *arguments):
        """A worker on 127.0.0.1, in a domain and a cluster of its own."""
        process = subprocess.Popen(
            [WORKER, "--transport", "udp", "--interface", "127.0.0.1",
             "--domain", str(random.randint(1, 200)), "--cluster", f"test-{os.getpid()}",
             *map(str, arguments)], stderr=subprocess.PIPE, text=True)
        self.addCleanup(process.stderr.close)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def await_status(self, port, path, status):
        end = time.monotonic() + 30
        while status_of(port, path) != status:
            self.assertLess(time.monotonic(), end, f"{path} does not answer {status}")
            time.sleep(0.05)


class Configuration(WorkerTest):
    def test_help_says_every_setting_with_default_and_names(self):
        result = worker("--help")
        self.assertEqual(ENDED, result.returncode)
        self.assertEqual("", result.stderr)
        for words in ("--threads N", "[default: one for each core; in the file: threads; ACCORD_THREADS]",
                      "--transport WORD", "shm, udp or both",
                      "[default: both; in the file: dds.transport; ACCORD_DDS_TRANSPORT]",
                      "--config FILE", "Exit codes:"):
            self.assertIn(words, result.stdout)

    def test_wrong_flags_are_all_named(self):
        result = worker("--thread", 3, "--domain", 500, "--log", "loud")
        self.assertEqual(USAGE, result.returncode)
        self.assertEqual("", result.stdout)
        self.assertEqual(
            ['--thread: unknown flag; did you mean "--threads"?',
             '--domain: expected a whole number from 0 to 232, not "500"',
             '--log: expected debug, info, warning, error or off, not "loud"',
             "Run accord-worker --help for more information."], result.stderr.splitlines())

    def test_wrong_variables_are_named(self):
        result = worker(variables={"ACCORD_THREADS": "0"})
        self.assertEqual(USAGE, result.returncode)
        self.assertIn('ACCORD_THREADS: expected a whole number from 1 to 1024, not "0"',
                      result.stderr)

    def test_a_wrong_file_is_named_with_its_lines(self):
        path = self.file("threads: many\ndds:\n  domian: 3\n  cluster: a b\n")
        result = worker("--config", path)
        self.assertEqual(BAD_FILE, result.returncode)
        self.assertEqual(
            [f'{path}:1: threads: expected a whole number from 1 to 1024, not "many"',
             f'{path}:3: dds.domian: unknown key in dds; did you mean "domain"?',
             f"{path}:4: dds.cluster: expected 1 to 64 letters, digits, '-', '_' and '.', not "
             '"a b"'], result.stderr.splitlines())

    def test_a_file_that_is_not_there_is_named(self):
        result = worker("--config", self.folder / "no.yaml")
        self.assertEqual(BAD_FILE, result.returncode)
        self.assertIn("no such file", result.stderr)


class Running(WorkerTest):
    def test_logs_lines_of_json_and_ends_when_asked_to(self):
        port = free_port()
        path = self.file(f"log: {{format: json}}\nmetrics: {{port: {port}}}\n")
        process = self.start("--config", path, "--threads", 1)
        self.await_status(port, "/healthz", 200)
        process.send_signal(signal.SIGTERM)
        _, errors = process.communicate(timeout=60)
        self.assertEqual(ENDED, process.returncode)
        records = [json.loads(line) for line in errors.splitlines()]
        self.assertTrue(records)
        for record in records:
            self.assertEqual("accord-worker", record["process"])
            self.assertEqual("info", record["level"])
            self.assertRegex(record["time"], r"^\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d\.\d{3}Z$")
        self.assertEqual(f"metrics at http://127.0.0.1:{port}/metrics", records[0]["message"])
        self.assertRegex(records[1]["message"], "^worker [0-9a-f]+ with 1 threads")
        self.assertIn(records[1]["worker"], records[1]["message"])
        self.assertEqual("ended", records[-1]["message"])

    def test_is_healthy_but_not_ready_without_a_coordinator(self):
        port = free_port()
        self.start("--log", "off", "--metrics", port)
        self.await_status(port, "/metrics", 200)
        self.await_status(port, "/healthz", 200)
        self.await_status(port, "/readyz", 503)

    def test_says_so_where_its_port_is_taken(self):
        with socket.socket() as taken:
            taken.bind(("127.0.0.1", 0))
            taken.listen()
            port = taken.getsockname()[1]
            process = self.start("--metrics", port)
            _, errors = process.communicate(timeout=60)
        self.assertEqual(UNAVAILABLE, process.returncode)
        self.assertRegex(errors, re.escape(f"cannot bind to 127.0.0.1:{port}"))


if __name__ == "__main__":
    unittest.main()
