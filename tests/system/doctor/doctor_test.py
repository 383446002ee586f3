#!/usr/bin/env python3
"""Breaks one thing at a time, and has accord doctor find it; whole, the same set-up has no fault.

  OnTwoHosts   a: coordinator and worker over UDP   b: the doctor
  OnOneHost    a: coordinator and workers that share memory, and the doctor
"""

import os
import pathlib
import signal
import subprocess
import time
import unittest

from patient import (ACCORD, COORDINATOR, DONE, FAULT, NO_SERVICE, ODD_PARTICIPANT, SKEWED_CLOCK,
                     WORKER, Patient)

NOBODY = ("setpriv", "--reuid", "65534", "--regid", "65534", "--clear-groups")
A, B = "10.77.0.1", "10.77.0.2"


class OnTwoHosts(Patient):
    FLAGS = ("--transport", "udp", "--cluster", "plant")

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.start_for_class("a", COORDINATOR, "--log", "off", *cls.FLAGS)
        cls.start_for_class("a", WORKER, "--log", "off", "--threads", "1", *cls.FLAGS)
        cls.await_health("b", *cls.FLAGS)

    def assert_fault(self, code, diagnosis):
        self.assertEqual(diagnosis.faults, [code], diagnosis.text)
        self.assertEqual(diagnosis.code, FAULT)
        self.assertTrue(diagnosis[code]["why"] and diagnosis[code]["mend"], diagnosis.text)
        return diagnosis[code]

    def test_no_data_where_a_firewall_lets_multicast_pass_alone(self):
        rule = ("INPUT", "-p", "udp", "-d", B, "-j", "DROP")
        with self.broken("b", ("iptables", "-A", *rule), ("iptables", "-D", *rule)):
            self.assert_fault("no-data", self.doctor("b", *self.FLAGS))

    def test_multicast_that_is_dropped(self):
        come, go = ((chain, "-d", "224.0.0.0/4", "-j", "DROP") for chain in ("INPUT", "OUTPUT"))
        with self.broken("b", ("iptables", "-A", *come), ("iptables", "-D", *come)):
            diagnosis = self.run_doctor("b", *self.FLAGS)  # who is asked still answers
            self.assertEqual((diagnosis.faults, diagnosis.warnings), ([], ["multicast"]))
            self.assertIn("did not come back", diagnosis["multicast"]["seen"])
            with self.broken("b", ("iptables", "-A", *go), ("iptables", "-D", *go)):
                found = self.assert_fault("multicast", self.doctor("b", *self.FLAGS))
        self.assertIn("Operation not permitted", found["seen"])

    def test_multicast_that_is_switched_off(self):
        link = ("ip", "link", "set", "eth0", "multicast")
        with self.broken("b", (*link, "off"), (*link, "on")):
            diagnosis = self.run_doctor("b", *self.FLAGS)
        self.assertEqual(diagnosis.warnings, ["multicast"], diagnosis.text)
        self.assertIn("ip link set eth0 multicast on", diagnosis["multicast"]["mend"])

    def test_peers_without_a_route_or_anybody_who_listens(self):
        peers = (*self.FLAGS, "--discovery", "peers", "--address", A)
        self.await_health("b", *peers)
        found = self.assert_fault("peer-unreachable",
                                  self.run_doctor("b", *peers, "--address", "10.99.0.1"))
        self.assertIn("10.99.0.1: Network is unreachable", found["seen"])
        found = self.assert_fault("peer-unreachable",
                                  self.run_doctor("b", *peers, "--address", f"{B}:9"))
        self.assertIn(f"{B}:9: nobody listens there", found["seen"])

    def test_a_discovery_server_that_is_gone(self):
        flags = ("--transport", "udp", "--domain", "5", "--discovery", "server",
                 "--address", f"{A}:11811")
        server = self.start_here("a", "fast-discovery-server", "-i", "0", "-l", A, "-p", "11811")
        self.start_here("a", COORDINATOR, "--log", "off", *flags)
        self.start_here("a", WORKER, "--log", "off", "--threads", "1", *flags)
        self.await_health("b", *flags)
        server.kill()
        server.wait()
        found = self.assert_fault("server-unreachable", self.doctor("b", *flags))
        self.assertIn("nobody listens there", found["seen"])
        self.assertIn(f"fast-discovery-server -i 0 -l {A} -p 11811", found["mend"][0])

    def test_a_participant_that_wants_certificates(self):
        folder = self.make_certificates()
        self.start_here("a", ODD_PARTICIPANT, "secured", folder, A, "plant")
        time.sleep(0.5)
        found = self.assert_fault("security", self.doctor("b", *self.FLAGS))
        self.assertIn("worker ", found["seen"])

    def make_certificates(self):
        folder = pathlib.Path(self.folder)
        key = ("-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:prime256v1", "-nodes")
        for command in (
                ("req", "-x509", *key, "-keyout", "ca.key", "-out", "ca.pem", "-subj", "/CN=ca",
                 "-addext", "keyUsage=critical,digitalSignature,keyCertSign"),
                ("req", *key, "-keyout", "key.pem", "-out", "request.pem", "-subj", "/CN=worker"),
                ("x509", "-req", "-in", "request.pem", "-CA", "ca.pem", "-CAkey", "ca.key",
                 "-CAcreateserial", "-out", "cert.pem")):
            subprocess.run(["openssl", *command], cwd=folder, check=True, capture_output=True)
        return folder

    def test_a_worker_of_another_protocol(self):
        self.start_here("a", ODD_PARTICIPANT, "protocol", "2", A, "plant")
        time.sleep(0.5)
        found = self.assert_fault("protocol", self.run_doctor("b", *self.FLAGS))
        self.assertIn("speaks 2", found["seen"])

    def test_a_service_of_another_cluster(self):
        found = self.assert_fault("cluster",
                                  self.doctor("b", "--transport", "udp", "--cluster", "plnat"))
        self.assertEqual(found["mend"], ["--cluster plant"])

    def test_a_clock_that_is_off(self):
        self.start_here("a", WORKER, "--log", "off", "--threads", "1", *self.FLAGS,
                        under=("env", f"LD_PRELOAD={SKEWED_CLOCK}", "CLOCK_AHEAD=3600"))
        time.sleep(0.5)
        diagnosis = self.run_doctor("b", *self.FLAGS)
        self.assertEqual((diagnosis.faults, diagnosis.warnings, diagnosis.code),
                         ([], ["clock-skew"], DONE), diagnosis.text)
        self.assertRegex(diagnosis["clock-skew"]["seen"], r"worker \w{16} is 3(600|599)\.\d+ s ahead")

    def test_a_transport_that_does_not_lead_there(self):
        diagnosis = self.doctor("b", *self.FLAGS, "--interface", "127.0.0.1")
        found = self.assert_fault("transport", diagnosis)
        self.assertIn(f"({A})", found["seen"])

    def test_an_interface_that_is_another_machines(self):
        self.assert_fault("interface", self.doctor("b", *self.FLAGS, "--interface", A))

    def test_a_service_without_workers(self):
        flags = ("--transport", "udp", "--domain", "6")
        self.start_here("a", COORDINATOR, "--log", "off", *flags)
        time.sleep(0.5)
        self.assert_fault("workers", self.run_doctor("b", *flags))
        self.start_here("a", WORKER, "--log", "off", "--threads", "1", *flags)
        self.await_health("b", *flags)

    def test_nobody_in_the_domain(self):
        diagnosis = self.doctor("b", "--transport", "udp", "--domain", "77", patience=1)
        self.assertEqual((diagnosis.faults, diagnosis.code), ([], NO_SERVICE), diagnosis.text)
        self.assertIn("nobody", diagnosis["service"]["seen"])

    def test_socket_buffers_that_are_small(self):
        small = pathlib.Path(self.folder) / "rmem_max"
        small.write_text("212992\n")
        diagnosis = self.run_doctor("b", *self.FLAGS, under=(
            "sh", "-c", f'mount --bind {small} /proc/sys/net/core/rmem_max && exec "$@"', "sh"))
        self.assertEqual((diagnosis.faults, diagnosis.warnings, diagnosis.code),
                         ([], ["socket-buffers"], DONE), diagnosis.text)
        self.assertIn("sysctl -w net.core.rmem_max=4194304",
                      diagnosis["socket-buffers"]["mend"][0])


class OnOneHost(Patient):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.start_for_class("a", COORDINATOR, "--log", "off")
        cls.start_for_class("a", WORKER, "--log", "off", "--threads", "1")
        cls.await_health("a")

    def test_memory_that_is_not_shared(self):
        diagnosis = self.doctor("a", memory=self.make_memory("1g"))
        self.assertEqual((diagnosis.faults, diagnosis.code), (["shm-not-shared"], FAULT),
                         diagnosis.text)
        self.assertIn("--ipc=host", diagnosis["shm-not-shared"]["mend"][0])

    def test_memory_of_another_user(self):
        diagnosis = self.doctor("a", "--transport", "shm", under=NOBODY)
        self.assertEqual((diagnosis.faults, diagnosis.code), (["shm-other-user"], FAULT),
                         diagnosis.text)
        self.assertIn("as user 65534", diagnosis["shm-other-user"]["seen"])

    def test_memory_of_another_user_that_is_left_for_udp(self):
        diagnosis = self.doctor("a", under=NOBODY)
        self.assertEqual((diagnosis.faults, diagnosis.code), ([], DONE), diagnosis.text)
        self.assertIn("shm-other-user", diagnosis.warnings)
        self.assertIn("Fast DDS of user 0", diagnosis["shm-other-user"]["seen"])
        self.assertIn("by UDP", diagnosis["domain"]["seen"])

    def test_segments_of_a_killed_worker(self):
        # Alone: those who have spoken with it would remove a part of what it leaves.
        memory = self.make_memory("1g")
        alone = {"patience": 1, "memory": memory}
        worker = self.start_here("a", WORKER, "--log", "off", "--domain", "10", memory=memory)
        time.sleep(2.5)  # no younger file is called stale
        whole = self.doctor("a", "--domain", "11", **alone)
        self.assertEqual((whole.faults, whole.warnings), ([], ["service"]), whole.text)
        worker.send_signal(signal.SIGKILL)
        worker.wait()
        diagnosis = self.doctor("a", "--domain", "11", **alone)
        self.assertEqual((diagnosis.faults, diagnosis.warnings, diagnosis.code),
                         ([], ["shm-stale", "service"], NO_SERVICE), diagnosis.text)
        remove = diagnosis["shm-stale"]["mend"][-1]
        self.assertRegex(remove, r"^rm -f( /dev/shm/(sem\.)?fastrtps_\w+){8}$")  # it has two ports
        self.start("a", *remove.split(), memory=memory).wait(10)
        self.assertEqual(os.listdir(memory), [])

    def test_memory_that_is_too_small_for_a_worker(self):
        memory = self.make_memory("30m")
        diagnosis = self.doctor("a", "--domain", "8", patience=1, memory=memory)
        self.assertEqual((diagnosis.faults, diagnosis.code), (["shm-small"], FAULT),
                         diagnosis.text)
        worker = self.start_here("a", WORKER, "--log", "off", "--domain", "8", memory=memory)
        self.assertEqual(worker.wait(20), -signal.SIGBUS)  # as the finding says
        whole = self.doctor("a", "--domain", "8", "--dds-segment-bytes", "8MiB", patience=1,
                            memory=self.make_memory("30m"))
        self.assertEqual((whole.faults, whole.code), ([], NO_SERVICE), whole.text)

    def test_a_service_with_shared_memory_alone(self):
        self.start_here("a", COORDINATOR, "--log", "off", "--domain", "9", "--transport", "shm")
        self.start_here("a", WORKER, "--log", "off", "--domain", "9", "--transport", "shm",
                        "--threads", "1")
        self.await_health("a", "--domain", "9", "--transport", "shm")
        diagnosis = self.doctor("a", "--domain", "9")
        self.assertEqual((diagnosis.faults, diagnosis.code), (["transport"], FAULT),
                         diagnosis.text)

    def test_what_it_says_to_people(self):
        process = self.start("a", ACCORD, "doctor", stdout=subprocess.PIPE, text=True)
        out, _ = process.communicate(timeout=60)
        self.assertEqual(process.returncode, DONE)
        self.assertRegex(out, r"(?m)^fine +service +0\.\d+\.\d+ on .* answers;")


if __name__ == "__main__":
    unittest.main()
