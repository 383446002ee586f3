#!/usr/bin/env python3
"""What arrives at a robot's host while the plan of a large fleet is published: the robot's own path,
and what finding each other takes. Fleet managers and robots are on Cyclone DDS, which listens for
multicast; two read everything, so that a service that sent to all at once would be found out.

    cyclone_fleet_client plan:          manager 10.77.0.1, other 10.77.0.2
    accord-coordinator, accord-worker:  hub     10.77.0.3
    cyclone_fleet_client follow ROBOT:  early   10.77.0.4, late  10.77.0.5
    nothing at all:                     idle    10.77.0.6

Environment variables: ACCORD, ACCORD_COORDINATOR, ACCORD_WORKER and CYCLONE_FLEET_CLIENT are the
binaries, build/... unless told. Takes root; where it cannot be had, all is skipped.
"""

import functools
import json
import os
import sys
import unittest

import on_hosts
import service

CLIENT = os.environ.pop("CYCLONE_FLEET_CLIENT",
                        str(service.ROOT / "build/tests/cyclone_fleet_client"))
HOSTS = ("manager", "other", "hub", "early", "late", "idle")
SCENE = "fleet-1000"
SHARE = 0.1  # of what the whole plan takes, at most; a busy machine's discovery goes on for longer
DONE = 0


class OneRobot(on_hosts.OnHosts):
    HOSTS = HOSTS

    def client(self, host, *arguments):
        process = service.Process(functools.partial(self.network.start, host), self.folder,
                                  [CLIENT, "0", "default", *arguments])
        self.addCleanup(process.kill)
        return process

    def output(self, client):
        code, _ = client.end(within=60)
        self.assertEqual(DONE, code, client.log + self.service.logs())
        return json.loads(client.output)

    def received(self):
        return {host: self.network.received(host) for host in HOSTS}

    def arrived_since(self, before):
        return {host: count - before[host] for host, count in self.received().items()}

    def test_is_sent_its_own_path_alone(self):
        expected = service.planned_here(SCENE)
        self.service.coordinator("hub", self.folder / "journal.db")
        self.service.worker("hub").await_log("works for coordinator")
        robots = {"early": 7, "late": 500}
        names = [robot["name"] for robot in expected["robots"]]
        early = self.client("early", "follow", names[robots["early"]])
        early.await_log("writers: 1")

        start = self.received()
        readers = [self.client(host, "plan", "order", service.scene(SCENE))
                   for host in ("manager", "other")]
        for reader in readers:
            self.assertEqual(expected, service.canonical(self.output(reader)))
        paths = {"early": self.output(early)}
        paths["late"] = self.output(self.client("late", "follow", names[robots["late"]]))
        arrived = self.arrived_since(start)

        print(f"bytes that arrived: {arrived}", file=sys.stderr)
        for host, index in robots.items():
            self.assertEqual(index, paths[host]["index"])
            self.assertEqual(expected["robots"][index]["waypoints"],
                             paths[host]["path"]["waypoints"])
        whole = min(arrived["manager"], arrived["other"])
        for host in ("early", "late", "idle"):
            self.assertLess(arrived[host], SHARE * whole, f"{host}: {arrived}")


if __name__ == "__main__":
    unittest.main()
