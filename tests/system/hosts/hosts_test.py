#!/usr/bin/env python3
"""A coordinator, two workers and a fleet manager, each on a host of its own (topology.py), plan what
one process plans while the network between them loses frames, crawls and breaks.

    accord submit: manager 10.77.0.1     accord-worker: first  10.77.0.3
    accord-coordinator: hub 10.77.0.2    accord-worker: second 10.77.0.4
    accord-discovery, or Fast DDS's own, in some cases: directory 10.77.0.5

Environment variables: ACCORD, ACCORD_COORDINATOR, ACCORD_WORKER are the binaries, build/bin/... unless
told. Takes root; where it cannot be had, all is skipped.
"""

import functools
import json
import signal
import subprocess
import sys
import time
import unittest

import on_hosts
import service

HOSTS = ("manager", "hub", "first", "second", "directory")
SCENES = ("mixed-floor", "high-manipulator-4", "low-mobile-32", "random-crossing-0300")
SOLVED = 0
PATIENCE = 60  # s; finding each other takes some on a bad network
# For bad links: a datagram of 64 KiB is 45 frames, which never all arrive, or do not fit into a slow
# link's queue.
ONE_FRAME = ["--dds-datagram-bytes", "1452"]

planned_here = functools.cache(service.planned_here)


class HostsTest(on_hosts.OnHosts):
    HOSTS = HOSTS

    def setUp(self):
        super().setUp()
        self.settings = []

    def flags(self, host):
        return [*super().flags(host), *self.settings]

    def start(self):
        """Coordinator and workers, once they know each other."""
        self.hub = self.service.coordinator("hub", self.folder / "journal.db")
        for worker in [self.service.worker(host) for host in ("first", "second")]:
            worker.await_log("works for coordinator")

    def assert_planned(self, name, within):
        self.assert_ends_planned(
            name, self.service.submit("manager", name, "--patience", PATIENCE), within)

    def assert_ends_planned(self, name, submission, within):
        expected = planned_here(name)
        code, took = submission.end(within)
        self.assertEqual(SOLVED, code, f"{name}\n{self.service.logs()}")
        self.assertEqual(expected, service.canonical(json.loads(submission.output)), name)
        print(f"{self.id().split('.', 1)[-1]}: {name}: {took:.2f} s", file=sys.stderr)


class Discovery(HostsTest):
    """How hosts find each other."""

    def assert_all_plans(self):
        self.start()
        for name in ("mixed-floor", "low-mobile-32"):
            self.assert_planned(name, within=30)

    def test_by_multicast(self):
        self.assert_all_plans()

    def test_by_the_addresses_of_peers(self):
        self.settings = ["--discovery", "peers"]
        for address in self.network.addresses.values():
            self.settings += ["--address", address]
        self.assert_all_plans()

    def test_by_the_coordinators_address_alone(self):
        self.settings = ["--discovery", "peers", "--address", self.network.addresses["hub"]]
        self.assert_all_plans()

    def test_by_a_discovery_server(self):
        self.assert_all_plans_with_a_server_on("directory")

    def test_by_a_discovery_server_beside_the_coordinator(self):
        self.assert_all_plans_with_a_server_on("hub")

    def test_by_a_discovery_server_that_was_gone_for_a_while(self):
        self.serve_discovery_on("directory").kill()
        self.serve_discovery_on("directory")
        self.assert_all_plans()

    def test_by_the_discovery_server_of_fast_dds(self):
        address = self.ask_at("hub")
        server = self.network.start(
            "hub", ["fast-discovery-server", "-i", 0, "-l", address, "-p", 11811],
            stdout=subprocess.DEVNULL)
        self.addCleanup(server.wait)
        self.addCleanup(server.send_signal, signal.SIGINT)  # else it leaves its shared memory behind
        self.assert_all_plans()

    def assert_all_plans_with_a_server_on(self, host):
        self.serve_discovery_on(host)
        self.assert_all_plans()

    def serve_discovery_on(self, host):
        return self.service.discovery(host, "--listen", self.ask_at(host))

    def ask_at(self, host):
        """The address that all others ask from now on."""
        address = self.network.addresses[host]
        self.settings = ["--discovery", "server", "--address", f"{address}:11811"]
        return address


class Loss(HostsTest):
    """Frames get lost, from the first sign of life on."""

    def assert_all_plans(self, share, within):
        if share:
            self.network.lose(share)
        self.start()
        for name in SCENES:
            self.assert_planned(name, within)
        self.assertEqual(share > 0, self.network.lost() > 0)

    def test_none(self):
        self.assert_all_plans(0, within=30)

    def test_of_5_percent(self):
        self.assert_all_plans(0.05, within=30)

    def test_of_30_percent(self):
        self.settings = ONE_FRAME
        self.assert_all_plans(0.3, within=90)


class Rate(HostsTest):
    def test_of_10_megabit_a_second(self):
        self.settings = ONE_FRAME
        self.network.limit("10mbit")
        self.start()
        for name in ("mixed-floor", "high-manipulator-4", "low-mobile-32", "depot-map"):
            self.assert_planned(name, within=60)


class CutLinks(HostsTest):
    """Links break while a request is planned."""

    def assert_planned_through(self, hosts, break_link, heals):
        self.start()
        submission = self.service.submit("manager", "mixed-floor")
        submission.await_log("conflicts")
        for host in hosts:
            break_link(host)
        if heals:
            time.sleep(3)
            for host in hosts:
                self.network.heal(host)
        self.assert_ends_planned("mixed-floor", submission, within=30)

    def test_of_one_worker_that_heals(self):
        self.assert_planned_through(["first"], self.network.pull, heals=True)
        self.assert_planned("high-manipulator-4", within=30)

    def test_of_one_worker_that_stays_cut(self):
        self.assert_planned_through(["first"], self.network.pull, heals=False)

    def test_of_both_workers_that_heal(self):
        self.assert_planned_through(["first", "second"], self.network.cut, heals=True)

    def test_of_the_coordinator_that_heals(self):
        self.assert_planned_through(["hub"], self.network.pull, heals=True)

    def test_of_the_fleet_manager_that_heals(self):
        self.assert_planned_through(["manager"], self.network.cut, heals=True)


def on_termination(signal_number, frame):
    # unittest takes any other exception for a test's failure and goes on.
    raise KeyboardInterrupt


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, on_termination)
    unittest.main()
