#!/usr/bin/env python3
"""What others compile and link against, as it is installed: the headers include nothing that is not
installed with them, neither of ours nor of what the library is made of, and the library exports what
is ours and nothing else.

Environment: ACCORD_BUILD is the build folder, build unless told.
"""

import pathlib
import re
import subprocess
import tempfile
import unittest

import packages

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]', re.MULTILINE)
# The standard library's headers have no dot; these come with what the package depends on.
OTHERS = {"tl/expected.hpp", "Eigen/Geometry"}
# What somebody's program calls: one of each kind.
CALLED = ("accord::FleetManager::plan(", "accord::Cancellation::next(", "accord::request_for_scene(",
          "accord::make_dds_fleet_client(", "accord::make_dds_fleet_service(",
          "accord::make_dds_robot_port(", "accord::configure(", "accord::add_dds_settings(",
          "accord::Trajectory::at(", "accord::to_string(accord::PlanStatus)", "accord::printable(",
          "accord::least_duration(", "accord::PathAssembly::add(", "accord::Settings::find(")


def output(*command):
    result = subprocess.run([str(word) for word in command], check=False, text=True,
                            capture_output=True)
    if result.returncode != 0:
        raise AssertionError(f"{command[0]}: {result.stdout}{result.stderr}")
    return result.stdout


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        for component in ("library", "development"):
            output("cmake", "--install", packages.BUILD, "--component", component,
                   "--prefix", folder.name)
        cls.prefix = pathlib.Path(folder.name)
        cls.headers = cls.prefix / "include/accord"
        (cls.library,) = cls.prefix.glob("lib/**/libaccord-fleet.so.0")

    def test_headers_include_nothing_that_is_not_installed(self):
        found = sorted(self.headers.rglob("*.h"))
        self.assertGreater(len(found), 20)
        for header in found:
            for mark, included in INCLUDE.findall(header.read_text()):
                where = f"{header.relative_to(self.headers)} includes {included}"
                if mark == '"':
                    self.assertTrue((self.headers / included).exists(),
                                    f"{where}, which accord_fleet_headers lacks")
                elif included not in OTHERS:
                    self.assertRegex(included, r"^[a-z_]+$", where)

    def test_all_headers_compile_together(self):
        everything = self.prefix / "everything.cpp"
        everything.write_text("".join(f'#include "{header.relative_to(self.headers)}"\n'
                                      for header in sorted(self.headers.rglob("*.h"))))
        output("c++", "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-isystem",
               "/usr/include/eigen3", f"-I{self.headers}", everything)

    def test_the_library_exports_what_is_ours_and_nothing_else(self):
        lines = output("nm", "--dynamic", "--defined-only", "--demangle", self.library).splitlines()
        names = [re.sub(r"\[abi:cxx11\]|@@ACCORD_FLEET_0$", "", line.split(" ", 2)[2])
                 for line in lines]
        for name in names:
            self.assertRegex(name, r"^accord::|^ACCORD_FLEET_0$")
        for name in CALLED:
            self.assertTrue(any(exported.startswith(name) for exported in names), name)
        internal = [name for name in names
                    if re.match(r"accord::(dds|fleet)::|.*(CollisionWorld|SimulatedFleet)", name)]
        self.assertEqual(internal, [])

    def test_who_links_it_needs_to_name_nothing_that_it_is_made_of(self):
        targets = "".join(file.read_text() for file in self.prefix.glob("lib/**/accord-targets*.cmake"))
        for part in ("fastrtps", "fastcdr", "fcl", "protobuf", "spdlog", str(packages.ROOT)):
            self.assertNotIn(part, targets)


if __name__ == "__main__":
    unittest.main()
