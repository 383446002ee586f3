#!/usr/bin/env python3
"""A journal that was backed up as docs/operations.md#backing-up-the-journal says holds what the
coordinator had said by then.

Environment variables: ACCORD, ACCORD_COORDINATOR, ACCORD_WORKER are the binaries, build/bin/... unless
told."""

import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/system/hosts"))
import service  # noqa: E402

PAGE = (ROOT / "docs/operations.md").read_text()
COMMAND = re.search(r"^    (cp \S+ \S+/journal\.db\S* \S+)$", PAGE, re.M)[1]
SOLVED = 0


class Backup(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)
        flags = ["--transport", "udp", "--interface", "127.0.0.1",
                 "--domain", random.randint(1, 200), "--cluster", f"test-{os.getpid()}"]
        (self.folder / "logs").mkdir()
        self.service = service.Service(
            lambda host, command, **options: subprocess.Popen(list(map(str, command)), **options),
            self.folder / "logs", lambda host: flags)
        self.addCleanup(self.service.stop)

    def plan(self, request):
        submission = self.service.submit("", "mixed-floor", "--id", request)
        code, _ = submission.end(60)
        self.assertEqual(SOLVED, code, self.service.logs())
        return json.loads(submission.output)

    def back_up(self, journal, folder):
        folder.mkdir()
        command = COMMAND.replace("/var/lib/accord/journal.db", str(journal))
        command = command.replace("/backup", str(folder))
        subprocess.run(command, shell=True, check=True, timeout=60)

    def test_holds_the_plans(self):
        first = self.service.coordinator("", self.folder / "journal.db")
        worker = self.service.worker("")
        worker.await_log("works for coordinator")
        plan = self.plan("before")
        first.terminate()
        self.assertEqual(0, first.end(60)[0], first.log)
        self.back_up(self.folder / "journal.db", self.folder / "backup")
        worker.kill()  # nobody is left to plan anything

        self.service.coordinator("", self.folder / "backup/journal.db")
        self.assertEqual(plan, self.plan("before"), "it is the very same one, times and all")


if __name__ == "__main__":
    unittest.main()
