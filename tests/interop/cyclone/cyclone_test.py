#!/usr/bin/env python3
"""A fleet manager on Cyclone DDS (environment variable CYCLONE_FLEET_CLIENT, of the C sources beside
this file) and the service on Fast DDS, as processes on 127.0.0.1: it submits, gets replies, statuses
and whole plans, cancels, and has plans said again that others asked for."""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
sys.path.insert(0, str(ROOT / "tests/system/hosts"))
from service import Service, canonical, planned_here  # noqa: E402

CLIENT = os.environ.pop("CYCLONE_FLEET_CLIENT", str(ROOT / "build/tests/cyclone_fleet_client"))
DONE, FAILED = range(2)

# Nothing leaves the machine. 127.0.0.1 has no multicast to Cyclone, so it is told whom to ask.
CYCLONE = """
<CycloneDDS><Domain Id="any">
  <General>
    <Interfaces><NetworkInterface address="127.0.0.1"/></Interfaces>
    <AllowMulticast>false</AllowMulticast>
  </General>
  <Discovery>
    <ParticipantIndex>auto</ParticipantIndex>
    <Peers><Peer address="127.0.0.1"/></Peers>
  </Discovery>
</Domain></CycloneDDS>"""

STATUS = re.compile(r"status: phase (\d), ([\d.]+) %, (\d+) of (\d+) conflicts, [\d.]+ s, cost ([\d.]+) s")


class Cyclone(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        self.domain = str(random.randint(1, 200))
        self.cluster = f"test-{os.getpid()}-{random.randrange(10**9)}"
        (self.folder / "logs").mkdir()
        flags = ["--domain", self.domain, "--cluster", self.cluster, "--transport", "udp",
                 "--interface", "127.0.0.1"]
        self.service = Service(lambda _, command, **options: subprocess.Popen(command, **options),
                               self.folder / "logs", lambda _: flags)
        self.addCleanup(self.service.stop)

    def start_coordinator(self):
        return self.service.coordinator("here", self.folder / "journal.db")

    def run_client(self, *arguments):
        return subprocess.run([CLIENT, self.domain, self.cluster, *arguments], cwd=ROOT / "scenes",
                              text=True, capture_output=True, timeout=120, check=False,
                              env={**os.environ, "CYCLONEDDS_URI": CYCLONE})

    def client(self, *arguments, expect=DONE):
        """Its plan, and what it has heard."""
        result = self.run_client(*arguments)
        self.assertEqual(expect, result.returncode, result.stderr + self.service.logs())
        return json.loads(result.stdout) if expect == DONE else None, result.stderr

    def assert_is_plan_of(self, scene, plan):
        self.assertEqual(planned_here(scene), canonical(plan))

    def test_gets_the_plan_that_one_process_makes(self):
        self.start_coordinator()
        self.service.worker("here")
        plan, heard = self.client("plan", "order-1", "adaptive-mobile.yaml")
        self.assert_is_plan_of("adaptive-mobile", plan)
        self.assertIn("reply: accepted 1, reason 0", heard)
        *_, (phase, per_cent, resolved, found, cost) = STATUS.findall(heard)
        self.assertEqual(("4", "100.0"), (phase, per_cent))
        self.assertEqual(plan["statistics"]["conflicts_found"], int(found))
        self.assertEqual(plan["statistics"]["conflicts_resolved"], int(resolved))
        self.assertAlmostEqual(plan["sum_of_costs"], float(cost), places=3)

    def test_sends_the_files_that_a_scene_names(self):
        self.start_coordinator()
        self.service.worker("here")
        plan, _ = self.client("plan", "order-1", "mixed-floor.yaml", "planar3.urdf")
        self.assert_is_plan_of("mixed-floor", plan)

    def test_gets_a_large_plan_whole(self):
        self.start_coordinator()
        self.service.worker("here")
        plan, _ = self.client("plan", "order-1", "fleet-1000.yaml")
        self.assert_is_plan_of("fleet-1000", plan)

    def test_has_said_again_what_others_asked_for(self):
        coordinator = self.start_coordinator()
        self.service.worker("here")
        first, _ = self.client("plan", "order-1", "low-mobile-08.yaml")
        late, heard = self.client("resend", "order-1")
        self.assertEqual(first, late)
        self.assertIn("reply: accepted 1, reason 0", heard)
        # Also by a service that was started since.
        coordinator.kill()
        self.start_coordinator()
        self.assertEqual(first, self.client("resend", "order-1")[0])

    def test_cancels(self):
        self.start_coordinator()  # no worker: it cannot have a plan before the cancel
        plan, heard = self.client("cancel", "order-1", "adaptive-mobile.yaml")
        self.assertEqual("cancelled", plan["status"])
        self.assertTrue(plan["message"])
        self.assertEqual([], plan["robots"])
        self.assertIn("reply: accepted 1, reason 0", heard)

    def test_hears_who_is_there(self):
        self.start_coordinator()
        self.service.worker("here")
        result = self.run_client("watch")
        self.assertEqual(DONE, result.returncode, result.stderr)
        self.assertRegex(result.stderr, "service: version .*, accepting")
        self.assertRegex(result.stderr, "worker: version .*, 1 threads, welcome")

    def test_is_told_why_a_request_is_not_accepted(self):
        self.start_coordinator()
        _, heard = self.client("plan", "order-1", "mixed-floor.yaml", expect=FAILED)
        self.assertRegex(heard, r'reply: accepted 0, reason 3, field ".*models.arm.urdf", ".*not attached"')
        _, heard = self.client("resend", "nobody's", expect=FAILED)
        self.assertIn("reply: accepted 0, reason 11", heard)


if __name__ == "__main__":
    unittest.main()
