"""What tests of accord doctor have in common: a service on hosts of its own, and a doctor on one."""

import contextlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "hosts"))
import topology  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[3]
WHY_NOT = topology.why_not()


def _binary(variable, name):
    # Else the services would take it for a setting.
    return os.environ.pop(variable, str(ROOT / "build" / name))


ACCORD = _binary("ACCORD", "bin/accord")
COORDINATOR = _binary("ACCORD_COORDINATOR", "bin/accord-coordinator")
WORKER = _binary("ACCORD_WORKER", "bin/accord-worker")
ODD_PARTICIPANT = _binary("ODD_PARTICIPANT", "tests/odd_participant")
SKEWED_CLOCK = _binary("SKEWED_CLOCK", "tests/libskewed_clock.so")

DONE, NO_SERVICE, FAULT = 0, 6, 7


class Diagnosis:
    """What a run of accord doctor has said."""

    def __init__(self, result):
        self.code = result.returncode
        self.text = result.stdout + result.stderr
        self.findings = [json.loads(line) for line in result.stdout.splitlines()]

    def of(self, severity):
        return [finding["code"] for finding in self.findings if finding["severity"] == severity]

    @property
    def faults(self):
        return self.of("fault")

    @property
    def warnings(self):
        return self.of("warning")

    def __getitem__(self, code):
        return next(finding for finding in self.findings if finding["code"] == code)


@unittest.skipIf(WHY_NOT, WHY_NOT)
class Patient(unittest.TestCase):
    """Hosts a and b; each test has processes of its own beside those of its class."""

    @classmethod
    def setUpClass(cls):
        # Only what is said here counts, whatever the machine's own settings are.
        for name in [name for name in os.environ if name.startswith("ACCORD_")]:
            del os.environ[name]
        cls.folder = cls.enter(tempfile.TemporaryDirectory())
        os.chmod(cls.folder, 0o755)
        cls.network = topology.Network(["a", "b"])
        cls.addClassCleanup(cls.network.remove)
        cls.memory = cls.make_memory("1g")

    @classmethod
    def enter(cls, context):
        value = context.__enter__()
        cls.addClassCleanup(context.__exit__, None, None, None)
        return value

    @classmethod
    def make_memory(cls, size):
        """A /dev/shm for processes to be started with."""
        folder = tempfile.mkdtemp(dir=cls.folder)
        subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size},mode=1777", "tmpfs", folder],
                       check=True)
        cls.addClassCleanup(subprocess.run, ["umount", "-l", folder], check=True)
        return folder

    @classmethod
    def start(cls, host, *command, memory=None, under=(), **options):
        """A process with a /dev/shm of its machine's, or another one. `under`: commands before it."""
        options = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, **options}
        bound = ["unshare", "-m", "sh", "-c", 'mount --bind "$0" /dev/shm && exec "$@"',
                 memory or cls.memory, *under]
        return cls.network.start(host, [*bound, *command], **options)

    @classmethod
    def start_for_class(cls, *command, **options):
        process = cls.start(*command, **options)
        cls.addClassCleanup(cls.kill, process)
        return process

    def start_here(self, *command, **options):
        process = self.start(*command, **options)
        self.addCleanup(self.kill, process)
        return process

    @staticmethod
    def kill(process):
        process.kill()
        process.wait()
        for stream in (process.stdout, process.stderr):
            if stream:
                stream.close()

    @classmethod
    def run_doctor(cls, host, *flags, patience=10, **options):
        process = cls.start(host, ACCORD, "doctor", "--json", "--patience", patience, *flags,
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, **options)
        out, error = process.communicate(timeout=60)
        return Diagnosis(subprocess.CompletedProcess([], process.returncode, out, error))

    def doctor(self, host, *flags, patience=2, **options):
        """Of what is broken: it listens to the end of its patience, mostly in vain."""
        return self.run_doctor(host, *flags, patience=patience, **options)

    @classmethod
    def await_health(cls, host, *flags, within=20, **options):
        """Until a doctor finds nothing: that what is about to be broken is whole."""
        end = time.monotonic() + within
        while True:
            diagnosis = cls.run_doctor(host, *flags, **options)
            if diagnosis.code == DONE and not diagnosis.faults and not diagnosis.warnings:
                return diagnosis
            if time.monotonic() > end:
                raise AssertionError(f"not healthy: {diagnosis.text}")

    def in_host(self, host, *command):
        self.network.run(host, *command)

    @contextlib.contextmanager
    def broken(self, host, break_it, mend_it):
        self.in_host(host, *break_it)
        try:
            yield
        finally:
            self.in_host(host, *mend_it)
