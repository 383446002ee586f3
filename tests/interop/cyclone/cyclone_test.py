#!/usr/bin/env python3
"""A fleet manager on Cyclone DDS (environment variable CYCLONE_FLEET_CLIENT, of the C sources beside
this file) and the service on Fast DDS, as processes on 127.0.0.1: it submits, gets replies, statuses
and whole plans, cancels, and has plans said again that others asked for. Robots and nodes of ROS 2 on
Cyclone DDS hear of single paths."""

import fractions
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
from service import Process, Service, canonical, planned_here  # noqa: E402

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

PLACE = {"cwd": ROOT / "scenes", "env": {**os.environ, "CYCLONEDDS_URI": CYCLONE}}

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

    def start_coordinator(self, *more):
        return self.service.coordinator("here", self.folder / "journal.db", *more)

    def run_client(self, *arguments):
        return subprocess.run([CLIENT, self.domain, self.cluster, *arguments],
                              text=True, capture_output=True, timeout=120, check=False, **PLACE)

    def start_client(self, *arguments):
        process = Process(lambda command, **options: subprocess.Popen(command, **PLACE, **options),
                          self.folder / "logs", [CLIENT, self.domain, self.cluster, *arguments])
        self.addCleanup(process.kill)
        return process

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

    def assert_is_path_of(self, robot, plan, output, heard):
        names = [each["name"] for each in plan["robots"]]
        expected = plan["robots"][names.index(robot)]
        followed = json.loads(output)
        self.assertEqual(names.index(robot), followed["index"])
        for segment in followed["path"]["segments"]:
            segment["robots"] = [names[index] for index in segment["robots"]]
        self.assertEqual(expected, followed["path"])
        self.assertRegex(heard, r"pieces: [1-9]\d*, of other robots 0\n")

    def test_a_robot_hears_of_its_own_path_alone(self):
        self.start_coordinator()
        self.service.worker("here")
        robot = planned_here("mixed-cell")["robots"][1]["name"]
        early = self.start_client("follow", robot)
        early.await_log("writers: 1")
        plan, _ = self.client("plan", "order-1", "mixed-cell.yaml", "arm6.urdf")
        code, _ = early.end(within=60)
        self.assertEqual(DONE, code, early.log)
        self.assert_is_path_of(robot, plan, early.output, early.log)
        for late in (robot, plan["robots"][-1]["name"]):
            result = self.run_client("follow", late)
            self.assertEqual(DONE, result.returncode, result.stderr)
            self.assert_is_path_of(late, plan, result.stdout, result.stderr)
        self.assert_is_plan_of("mixed-cell", plan)

    def test_nodes_of_ros_hear_of_paths(self):
        self.start_coordinator("--ros", "accord", "--ros-frame", "cell")
        self.service.worker("here")
        early = self.start_client("ros", "d1", "path", "accord")
        self.client("plan", "order-1", "mixed-cell.yaml", "arm6.urdf")
        code, _ = early.end(within=60)
        self.assertEqual(DONE, code, early.log)
        paths = {robot["name"]: robot["waypoints"] for robot in planned_here("mixed-cell")["robots"]}
        self.assert_are_poses(paths["d1"], json.loads(early.output))
        self.assert_are_poses(paths["d3"], self.ros_message("d3", "path"))
        for arm in ("left", "right"):
            self.assert_are_points(paths[arm], self.ros_message(arm, "joint_trajectory"))

    def ros_message(self, robot, kind):
        result = self.run_client("ros", robot, kind, "accord")
        self.assertEqual(DONE, result.returncode, result.stderr + self.service.logs())
        return json.loads(result.stdout)

    def assert_are_poses(self, waypoints, message):
        self.assert_header(message)
        self.assertEqual([each["q"] for each in waypoints],
                         [pose["position"] for pose in message["poses"]])
        for waypoint, pose in zip(waypoints, message["poses"]):
            self.assert_is_time(waypoint["t"], pose["stamp"])
            self.assertEqual("cell", pose["frame"])
            self.assertEqual([0, 0, 0, 1], pose["orientation"])

    def assert_are_points(self, waypoints, message):
        self.assert_header(message)
        self.assertEqual(["yaw", "pitch", "elbow", "forearm_roll", "wrist_pitch", "tool_roll"],
                         message["joints"])
        self.assertEqual([each["q"] for each in waypoints],
                         [point["positions"] for point in message["points"]])
        for waypoint, point in zip(waypoints, message["points"]):
            self.assert_is_time(waypoint["t"], point["time_from_start"])
            self.assertEqual([[], [], []],
                             [point[what] for what in ("velocities", "accelerations", "effort")])

    def assert_header(self, message):
        self.assertEqual(([0, 0], "cell"), (message["stamp"], message["frame"]))

    def assert_is_time(self, t, stamp):
        """To the nanosecond that is nearest."""
        sec, nanosec = stamp
        self.assertLess(nanosec, 10**9)
        exact = fractions.Fraction(t) * 10**9
        self.assertLessEqual(abs(exact - (sec * 10**9 + nanosec)), fractions.Fraction(501, 1000))


if __name__ == "__main__":
    unittest.main()
