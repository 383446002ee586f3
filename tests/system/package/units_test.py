#!/usr/bin/env python3
"""The systemd units, as systemd-analyze sees them: it understands all of each, and what is left open to
the services of the machine is little.
"""

import pathlib
import shutil
import subprocess
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[3]
SYSTEM = pathlib.Path("usr/lib/systemd/system")
SERVICES = [file.name for file in sorted((ROOT / "deploy/systemd").glob("*.service"))]
EXPOSURE = 2.0  # of 10; below it systemd says "OK"


@unittest.skipUnless(shutil.which("systemd-analyze"), "not installed: systemd-analyze")
class Units(unittest.TestCase):
    def setUp(self):
        """A root with systemd's own units, ours, and programs for them."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        shutil.copytree("/" / SYSTEM, self.root / SYSTEM, symlinks=True)
        shutil.copytree(ROOT / "deploy/systemd", self.root / SYSTEM, dirs_exist_ok=True)
        (self.root / "usr/bin").mkdir()
        for service in SERVICES:
            program = self.root / "usr/bin" / service.removesuffix(".service")
            program.write_text("#!/bin/sh\n")
            program.chmod(0o755)

    def analyze(self, verb, *arguments):
        result = subprocess.run(["systemd-analyze", verb, f"--root={self.root}", *arguments],
                                check=False, text=True, capture_output=True)
        return result.returncode, result.stdout + result.stderr

    def test_systemd_understands_all_of_each(self):
        self.assertGreater(len(SERVICES), 1)
        # It looks for other units' manuals and programs, too, which are not in this root.
        code, said = self.analyze("verify", "--man=no", "--recursive-errors=no", *SERVICES)
        self.assertEqual((code, said), (0, ""))

    def test_a_mistyped_setting_would_be_found(self):
        file = self.root / SYSTEM / SERVICES[0]
        file.write_text(file.read_text().replace("[Service]", "[Service]\nProtectSytem=strict"))
        _, said = self.analyze("verify", "--man=no", "--recursive-errors=no", SERVICES[0])
        self.assertIn("ProtectSytem", said)

    def test_they_may_do_little_on_the_machine(self):
        for service in SERVICES:
            code, said = self.analyze("security", "--offline=true",
                                      f"--threshold={EXPOSURE * 10:.0f}", service)
            self.assertEqual(code, 0, said)


if __name__ == "__main__":
    unittest.main()
