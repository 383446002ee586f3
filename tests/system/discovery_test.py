#!/usr/bin/env python3
"""Runs the built `accord-discovery` as a person would, with a coordinator and a worker that find each
other by it alone, and asks each of them how it is with `accord health`.

Environment variables: ACCORD, ACCORD_COORDINATOR, ACCORD_WORKER, ACCORD_DISCOVERY are the binaries,
build/bin/... unless told."""

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
import urllib.request

from binaries import ROOT, binary

ACCORD = binary("ACCORD", "bin/accord")
COORDINATOR = binary("ACCORD_COORDINATOR", "bin/accord-coordinator")
WORKER = binary("ACCORD_WORKER", "bin/accord-worker")
DISCOVERY = binary("ACCORD_DISCOVERY", "bin/accord-discovery")

ENDED, BUG, USAGE, BAD_FILE, UNAVAILABLE = range(5)
SOLVED, NO_SERVICE = 0, 6


def free_udp_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class DiscoveryTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.port = free_udp_port()
        self.domain = random.randint(1, 200)

    def start(self, binary, name, *arguments):
        """Its log is NAME.log, and the port of its metrics in NAME.port."""
        with (self.folder / f"{name}.log").open("w") as log:
            process = subprocess.Popen(
                [binary, "--domain", str(self.domain), "--metrics", "any",
                 "--metrics-port-file", self.folder / f"{name}.port", *map(str, arguments)],
                stderr=log)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start_server(self):
        return self.start(DISCOVERY, "server", "--listen", f"127.0.0.1:{self.port}")

    def asking(self):
        return ["--transport", "udp", "--interface", "127.0.0.1", "--discovery", "server",
                "--address", f"127.0.0.1:{self.port}", "--cluster", f"test-{os.getpid()}"]

    def log(self, name):
        return (self.folder / f"{name}.log").read_text()

    def health(self, name, *more):
        return subprocess.run([ACCORD, "health", "--metrics-port-file",
                               self.folder / f"{name}.port", *more],
                              capture_output=True, text=True, timeout=60, check=False)

    def wait_until(self, holds, what):
        end = time.monotonic() + 30
        while not holds():
            self.assertLess(time.monotonic(), end, what)
            time.sleep(0.05)

    def metrics(self, name):
        port = (self.folder / f"{name}.port").read_text().strip()
        with urllib.request.urlopen(f"http://127.0.0.1:{port}/metrics", timeout=5) as answer:
            return answer.read().decode()

    def await_well(self, name, *more):
        self.wait_until(lambda: self.health(name, *more).returncode == 0,
                        f"{name} is not well: {self.log(name)}")


class Serving(DiscoveryTest):
    def test_brings_processes_together_that_ask_it(self):
        self.start_server()
        self.await_well("server")
        self.start(COORDINATOR, "coordinator", *self.asking())
        self.start(WORKER, "worker", "--threads", 1, *self.asking())
        self.await_well("worker", "--ready")
        self.assertRegex(self.metrics("server"), r"(?m)^accord_discovery_participants [2-9]")
        submit = subprocess.run(
            [ACCORD, "submit", ROOT / "scenes/mixed-floor.yaml", "--quiet",
             "--domain", str(self.domain), *self.asking()],
            capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(SOLVED, submit.returncode, submit.stderr)
        for who in (f"accord/test-{os.getpid()}/[0-9]+/worker/", f"accord-fleet/test-{os.getpid()}/"):
            self.assertRegex(self.log("server"), f"{who}.* has come")
        self.assertNotIn("not Accord's", self.log("server"))

    def test_sees_who_goes(self):
        self.start_server()
        self.await_well("server")
        worker = self.start(WORKER, "worker", *self.asking())
        self.wait_until(lambda: "/worker/" in self.log("server"), "the worker has not come")
        worker.kill()
        self.wait_until(lambda: re.search("/worker/.* has gone", self.log("server")),
                        "the worker has not gone")
        self.assertRegex(self.metrics("server"), r"(?m)^accord_discovery_participants 0")

    def test_ends_when_asked_to(self):
        server = self.start_server()
        self.await_well("server")
        server.send_signal(signal.SIGTERM)
        self.assertEqual(ENDED, server.wait(timeout=30))
        self.assertIn("ended", self.log("server"))
        answer = self.health("server")
        self.assertEqual(NO_SERVICE, answer.returncode)
        self.assertIn("nobody answers at 127.0.0.1:", answer.stderr)


class Health(DiscoveryTest):
    def test_of_a_worker_without_a_coordinator_is_well_but_not_ready(self):
        self.start(WORKER, "worker", *self.asking())
        self.await_well("worker")
        answer = self.health("worker", "--ready")
        self.assertEqual(NO_SERVICE, answer.returncode)
        self.assertRegex(answer.stderr, "^accord: not ready")

    def test_of_a_process_that_hangs_is_not_well(self):
        worker = self.start(WORKER, "worker", *self.asking())
        self.await_well("worker")
        worker.send_signal(signal.SIGSTOP)
        began = time.monotonic()
        answer = self.health("worker")
        self.assertEqual(NO_SERVICE, answer.returncode)
        self.assertIn("no answer from 127.0.0.1:", answer.stderr)
        self.assertLess(time.monotonic() - began, 8)

    def test_asks_for_a_place_to_ask(self):
        answer = subprocess.run([ACCORD, "health"], capture_output=True, text=True, timeout=60,
                                check=False)
        self.assertEqual(NO_SERVICE, answer.returncode)
        self.assertEqual("accord: expected the port of its metrics, or the file where it is "
                         "written\n", answer.stderr)


class Starting(DiscoveryTest):
    def run_server(self, *arguments):
        return subprocess.run([DISCOVERY, *map(str, arguments)], capture_output=True, text=True,
                              timeout=60, check=False)

    def test_names_wrong_flags(self):
        result = self.run_server("--listen", "here", "--id", 256, "--address", "10.0.0.1")
        self.assertEqual(USAGE, result.returncode)
        for line in ("--listen: expected an IPv4 address, with or without a port, as in "
                     '10.0.0.7:11811, not "here"',
                     '--id: expected a whole number from 0 to 255, not "256"',
                     "--address: unknown flag"):
            self.assertIn(line, result.stderr)

    def test_says_so_where_it_cannot_listen(self):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as taken:
            taken.bind(("127.0.0.1", 0))
            port = taken.getsockname()[1]
            result = self.run_server("--listen", f"127.0.0.1:{port}", "--domain", self.domain)
        self.assertEqual(UNAVAILABLE, result.returncode)
        self.assertIn("DDS could not serve", result.stderr)


if __name__ == "__main__":
    unittest.main()
