"""Purpose: the image is small, has every program, and runs anywhere: without a network, without rights,
and on a root that nobody can write to.

Topology: one container, alone.
"""

import json
import os

import composition

MEGABYTE = 1_000_000
MOST_OVER_ITS_BASE = 150 * MEGABYTE


class Image(composition.Case):
    def run_in_it(self, *command):
        return self.docker("run", "--rm", "--read-only", "--tmpfs", "/tmp", "--network", "none",
                           "--cap-drop", "ALL", composition.IMAGE, *command)

    def size_of(self, image):
        return int(self.inspect(image, "{{.Size}}"))

    def test_is_small(self):
        base = os.environ.get("ACCORD_BASE", "debian:bookworm-slim")
        self.assertLess(self.size_of(composition.IMAGE) - self.size_of(base), MOST_OVER_ITS_BASE)

    def test_has_every_program(self):
        for program in ("accord", "accord-coordinator", "accord-worker", "accord-discovery"):
            self.assertRegex(self.run_in_it(program, "--version"), r"\d+\.\d+\.\d+")

    def test_plans_by_itself(self):
        plan = self.run_in_it("accord", "plan", "/usr/share/accord/scenes/mixed-floor.yaml",
                              "--json", "--quiet")
        self.assertEqual(composition.planned_here("mixed-floor"),
                         composition.service.canonical(json.loads(plan)))

    def test_has_nothing_that_it_was_built_with(self):
        for program in ("g++", "cmake", "protoc"):
            self.assertEqual("", self.run_in_it("sh", "-c", f"command -v {program} || true"))
