#!/usr/bin/env python3
"""The disk that holds the journal is full: a coordinator and a worker on 127.0.0.1, the journal on a
file system of 1 MiB that the test fills and empties. What is asked for meanwhile is refused with the
reason, what had been accepted is planned and kept, and there is room again when there is.

Environment variables: ACCORD, ACCORD_COORDINATOR, ACCORD_WORKER are the binaries, build/bin/... unless
told. Takes root; where it cannot be had, all is skipped.
"""

import ctypes
import json
import os
import pathlib
import random
import subprocess
import tempfile
import unittest

import service

SOLVED, REFUSED = 0, 3  # of `accord submit`
UNAVAILABLE = 4  # of a service
CLONE_NEWNS = 0x00020000


def mount_disk(folder):
    """A file system of 1 MiB, which goes with this process. Why there is none, or None."""
    if os.geteuid() != 0:
        return "mounting a small disk takes root"
    libc = ctypes.CDLL(None, use_errno=True)
    if libc.unshare(CLONE_NEWNS) != 0:
        return f"no mounts of its own: {os.strerror(ctypes.get_errno())}"
    for command in (("mount", "--make-rprivate", "/"),
                    ("mount", "-t", "tmpfs", "-o", "size=1m", "accord-test", folder)):
        result = subprocess.run(command, text=True, capture_output=True, check=False)
        if result.returncode != 0:
            return result.stderr.strip()
    return None


class FullDisk(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.disk = self.folder / "disk"
        self.disk.mkdir()
        why_not = mount_disk(self.disk)
        if why_not:
            self.skipTest(why_not)
        self.addCleanup(subprocess.run, ["umount", "--lazy", self.disk], check=True)
        flags = ["--transport", "udp", "--interface", "127.0.0.1", "--domain",
                 str(random.randint(1, 200)), "--cluster", f"test-{os.getpid()}"]
        self.service = service.Service(self.start, self.folder, lambda host: flags)
        self.addCleanup(self.service.stop)

    @staticmethod
    def start(host, command, **options):
        return subprocess.Popen(["setpriv", "--pdeathsig", "KILL", *map(str, command)],
                                stdin=subprocess.DEVNULL, **options)

    def coordinator(self):
        return self.service.coordinator("here", self.disk / "journal.db")

    def fill(self):
        with (self.disk / "ballast").open("wb", buffering=0) as ballast:
            for size in (4096, 1):
                try:
                    while ballast.write(bytes(size)) == size:
                        pass
                except OSError:
                    continue

    def make_room(self):
        (self.disk / "ballast").unlink()

    def submit(self, name, request_id):
        return self.service.submit("here", name, "--id", request_id)

    def planned(self, submission):
        code, _ = submission.end(within=60)
        self.assertEqual(SOLVED, code, self.service.logs())
        return json.loads(submission.output)

    def assert_refused(self, request_id):
        submission = self.submit("peer-inlet", request_id)
        code, _ = submission.end(within=60)
        self.assertEqual(REFUSED, code, self.service.logs())
        self.assertEqual("", submission.output)
        self.assertRegex(submission.log, "^rejected: .*the disk is full")

    def start_service(self):
        coordinator = self.coordinator()
        worker = self.service.worker("here")
        worker.await_log("works for coordinator")
        return coordinator, worker

    def start_planning(self):
        """The service, and a request that it has accepted and plans."""
        coordinator, worker = self.start_service()
        submission = self.submit("mixed-floor", "early")
        submission.await_log("conflicts")
        return coordinator, worker, submission

    def test_requests_are_refused_until_there_is_room(self):
        self.start_service()
        self.fill()
        self.assert_refused("one")
        self.assert_refused("two")
        self.make_room()
        plan = self.planned(self.submit("peer-inlet", "one"))
        self.assertEqual(service.planned_here("peer-inlet"), service.canonical(plan))

    def test_a_coordinator_does_not_begin_without_room_for_a_journal(self):
        self.fill()
        coordinator = self.coordinator()
        code, _ = coordinator.end(within=60)
        self.assertEqual(UNAVAILABLE, code)
        self.assertIn("the disk is full", coordinator.log)

    def test_what_was_accepted_is_planned_and_kept(self):
        coordinator, worker, submission = self.start_planning()
        self.fill()
        self.assert_refused("late")
        plan = self.planned(submission)
        self.assertEqual(service.planned_here("mixed-floor"), service.canonical(plan))
        coordinator.await_log("plans are kept in memory")
        self.assertEqual(plan, self.planned(self.submit("mixed-floor", "early")))
        self.make_room()
        coordinator.await_log("takes writes again")
        coordinator.kill()
        worker.kill()
        self.coordinator()  # nobody is there to plan anything anew
        self.assertEqual(plan, self.planned(self.submit("mixed-floor", "early")))

    def test_a_crash_meanwhile_loses_nothing_that_was_accepted(self):
        coordinator, _, submission = self.start_planning()
        self.fill()
        coordinator.kill()
        self.coordinator()
        self.assertEqual(service.planned_here("mixed-floor"),
                         service.canonical(self.planned(submission)))


if __name__ == "__main__":
    unittest.main()
