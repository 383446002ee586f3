#!/usr/bin/env python3
"""The Debian packages of this build, installed on a clean Debian 12 by its own apt-get: what they
depend on comes along, what they ship runs, a fleet manager compiled against them works, and nothing
stays behind that should not.

    tests/system/package/run [--all]

Environment: ACCORD_BUILD is the build folder, build unless told. Takes root and packages from the
network; where a Debian root cannot be had, all is skipped. What runs as a service has a network of
its own (tests/system/hosts/topology.py), so it finds nothing but the test.
"""

import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import unittest

sys.path.append(str(pathlib.Path(__file__).resolve().parent.parent / "hosts"))

# pylint: disable=wrong-import-position
import packages
import root as debian
import topology
import units

SCENES = "/usr/share/accord/scenes"
EXAMPLE = "/usr/share/doc/libaccord-fleet-dev/examples"
HOST = "box"
ALL = bool(os.environ.get("ACCORD_PACKAGE_ALL"))


def canonical(text):
    """A plan without what it took to make it."""
    plan = json.loads(text)
    del plan["planning_time"]
    plan["statistics"] = {name: value for name, value in plan["statistics"].items()
                          if not name.endswith("_time")}
    return json.dumps(plan, indent=1)


class Machine:
    """One for all tests: a root with `accord` and the library installed, and a network."""


def setUpModule():  # pylint: disable=invalid-name
    why_not = topology.why_not()
    if why_not:
        raise unittest.SkipTest(why_not)
    try:
        Machine.root = debian.DebianRoot()
    except debian.Unavailable as why:
        raise unittest.SkipTest(str(why)) from why
    unittest.addModuleCleanup(Machine.root.remove)
    folder = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(folder.cleanup)
    Machine.folder = pathlib.Path(folder.name)
    Machine.packages = packages.make(Machine.folder / "packages")
    try:
        Machine.root.run("apt-get", "update", "--error-on=any")
    except AssertionError as fault:
        raise unittest.SkipTest(f"no packages to be had: {fault}") from fault
    Machine.root.install(Machine.packages["accord"], Machine.packages["libaccord-fleet0"])
    Machine.network = topology.Network([HOST])
    unittest.addModuleCleanup(Machine.network.remove)


class Installed(unittest.TestCase):
    def setUp(self):
        self.root, self.folder = Machine.root, Machine.folder
        self.packages, self.network = Machine.packages, Machine.network
        self.addCleanup(self.root.clear_shared_memory)

    def start(self, *command):
        """On the network; ends with the test. Its output is in the files `output` and `log`."""
        files = [tempfile.TemporaryFile("w+") for _ in range(2)]
        process = self.network.start(HOST, command, stdout=files[0], stderr=files[1])
        process.output, process.log = files
        self.addCleanup(lambda: (process.kill(), process.wait(), *(file.close() for file in files)))
        return process

    def finish(self, process, within=60):
        """Its exit code, output and log."""
        code = process.wait(within)
        texts = []
        for file in (process.output, process.log):
            file.seek(0)
            texts.append(file.read())
        return code, *texts

    def start_service(self):
        """A coordinator and a worker, as the units start them, with what /etc/accord says."""
        return {name: self.start(*units.command(self.root, name))
                for name in ("coordinator", "worker")}

    def submit(self, user="accord"):
        return self.start(*self.root.command(
            "/usr/bin/accord", "submit", f"{SCENES}/mixed-floor.yaml", "--json", "--quiet",
            user=user))

    def planned_by_the_build(self):
        return canonical(subprocess.run(
            [packages.BUILD / "bin/accord", "plan", packages.ROOT / "scenes/mixed-floor.yaml", "--json",
             "--quiet"], check=True, text=True, capture_output=True, timeout=60).stdout)


class Programs(Installed):
    def test_every_scene_comes_with_all_that_it_names(self):
        scenes = [file for file in packages.files(self.packages["accord"])
                  if file.startswith(f"{SCENES}/") and file.count("/") == SCENES.count("/") + 1
                  and file.endswith(".yaml")]
        self.assertGreater(len(scenes), 10)
        for scene in scenes:
            self.root.run("accord", "info", scene, user="games")

    def test_the_command_plans_as_the_build_does(self):
        plan = self.root.run("accord", "plan", f"{SCENES}/mixed-floor.yaml", "--json", "--quiet",
                             user="games")
        self.assertEqual(canonical(plan), self.planned_by_the_build())

    def test_what_is_installed_is_stripped(self):
        for file in packages.files(self.packages["accord"]):
            if file.startswith("/usr/bin/"):
                sections = subprocess.run(["readelf", "--sections", self.root.inside(file)],
                                          check=True, text=True, capture_output=True).stdout
                self.assertNotIn(".symtab", sections, file)


class Services(Installed):
    def test_they_plan_with_the_configuration_that_is_shipped(self):
        services = self.start_service()
        code, plan, log = self.finish(self.submit())
        self.assertEqual(code, 0, log)
        self.assertEqual(canonical(plan), self.planned_by_the_build())
        user = int(self.root.run("id", "--user", "accord"))
        self.assertEqual(self.root.inside("/var/lib/accord/journal.db").stat().st_uid, user)
        shared = list(self.root.inside("/dev/shm").glob("fastrtps_*"))
        self.assertEqual({file.stat().st_uid for file in shared}, {user})
        for name in ("worker", "coordinator"):
            services[name].send_signal(signal.SIGTERM)
            code, _, log = self.finish(services[name], units.seconds_to_stop(self.root, name))
            self.assertEqual(code, 0, log)

    def test_another_user_of_the_machine_may_ask_them(self):
        """Without shared memory, which is between processes of one user."""
        self.start_service()
        code, _, log = self.finish(self.submit(user="games"))
        self.assertEqual(code, 0, log)

    def test_what_makes_no_sense_ends_them_with_a_code_that_systemd_does_not_start_again(self):
        for name in ("coordinator", "worker"):
            file = self.root.inside(f"/etc/accord/{name}.yaml")
            before = file.read_text()
            self.addCleanup(file.write_text, before)
            file.write_text(f"{before}\nnonsense: 1\n")
            code, _, log = self.finish(self.start(*units.command(self.root, name)))
            prevented = units.one(units.settings(self.root, name), "RestartPreventExitStatus")
            self.assertIn(str(code), prevented.split(), log)
            self.assertIn("nonsense", log)

    def test_units_and_configuration_say_what_the_programs_understand(self):
        """Also what the configuration only proposes. All faults are told at once, so with one that
        is certain it is the only one, and nothing is started."""
        for name in units.installed(self.root):
            file = self.root.inside(f"/etc/accord/{name}.yaml")
            before = file.read_text()
            self.addCleanup(file.write_text, before)
            for text in (before, units.with_proposals(before)):
                file.write_text(text)
                code, _, log = self.finish(self.start(
                    *units.command(self.root, name), "--log", "loud"))
                self.assertEqual(code, 2, log)
                told = log.splitlines()
                self.assertEqual(len(told), 2, log)
                self.assertRegex(told[0], "^--log: expected ")


class FleetManagers(Installed):
    """Of other people: compiled against the packages, with nothing of this checkout."""

    def test_one_compiled_against_the_package_drives_robots(self):
        unpacked = self.folder / "unpacked"
        for name in ("libaccord-fleet0", "libaccord-fleet-dev"):
            packages.unpack(self.packages[name], unpacked)
        sources = unpacked / EXAMPLE.lstrip("/")
        build = self.folder / "example"
        for command in (["cmake", "-G", "Ninja", "-S", sources, "-B", build,
                         f"-DCMAKE_PREFIX_PATH={unpacked}/usr"], ["cmake", "--build", build]):
            made = subprocess.run(command, check=False, text=True, capture_output=True)
            self.assertEqual(made.returncode, 0, made.stdout + made.stderr)
        self.drives(build / "fleet_manager_example")

    if ALL:  # takes minutes

        def test_one_compiled_on_the_clean_debian_drives_robots(self):
            self.root.install(self.packages["libaccord-fleet-dev"], "cmake", "g++", "make")
            build = "/root/example"
            self.root.run("cmake", "-S", EXAMPLE, "-B", build)
            self.root.run("cmake", "--build", build)
            self.drives(self.root.inside(build) / "fleet_manager_example")

    def drives(self, program):
        """Run inside, where nothing is that was only needed to compile it."""
        inside = "/usr/local/bin/fleet_manager"
        shutil.copy(program, self.root.inside(inside))
        self.start_service()
        code, output, log = self.finish(self.start(*self.root.command(
            inside, f"{SCENES}/mixed-floor.yaml", "1000", user="accord")))
        self.assertEqual(code, 0, output + log)
        self.assertRegex(output, r"robots planned")


class Removal(Installed):
    def test_an_upgrade_keeps_what_a_person_has_configured(self):
        file = self.root.inside("/etc/accord/worker.yaml")
        changed = file.read_text() + "threads: 1\n"
        file.write_text(changed)
        self.install_again()
        self.assertEqual(file.read_text(), changed)

    def test_removing_keeps_the_journal_and_purging_does_not(self):
        journal = self.root.inside("/var/lib/accord/journal.db")
        self.addCleanup(self.install_again)
        journal.write_text("what was accepted")
        self.root.run("dpkg", "--remove", "accord")
        self.assertTrue(journal.exists())
        self.assertTrue(self.root.inside("/etc/accord/coordinator.yaml").exists())
        self.assertFalse(self.root.inside("/usr/bin/accord").exists())
        self.root.run("dpkg", "--purge", "accord")
        self.root.run("dpkg", "--purge", "libaccord-fleet-dev", "libaccord-fleet0")
        left = self.root.run("find", "/etc", "/usr", "/var/lib", "/run", "-iname", "*accord*")
        self.assertEqual(left, "")

    def test_the_user_stays_for_who_comes_back(self):
        number = self.root.run("id", "--user", "accord")
        self.addCleanup(self.install_again)
        self.root.run("dpkg", "--purge", "accord")
        self.install_again()
        self.assertEqual(self.root.run("id", "--user", "accord"), number)
        owner = self.root.run("stat", "--format", "%U %a", "/var/lib/accord")
        self.assertEqual(owner.strip(), "accord 750")

    def install_again(self):
        self.root.run("dpkg", "--install", "/root/" + self.packages["accord"].name)


if __name__ == "__main__":
    unittest.main()
