"""Hosts that are joined by a network whose links lose, crawl and break: network namespaces of this
machine. Nothing of it reaches the machine's own network.

                       switch: a namespace with a bridge
          +------------------+-----------------+------------------+
      a | link           b | link          c | link          d | link     (veth pairs)
    eth0 10.77.0.1     eth0 10.77.0.2    eth0 10.77.0.3    eth0 10.77.0.4
    a namespace each, named accord-test-<pid>-<name>

They go away with the process that made them: at its end, however it ends, or else when the next one
begins.
"""

import atexit
import contextlib
import json
import os
import re
import shutil
import signal
import subprocess

PREFIX = "accord-test-"


def why_not():
    """Why this machine cannot have such hosts; empty where it can."""
    if os.geteuid() != 0:
        return "network namespaces take root"
    missing = [name for name in ("ip", "iptables", "tc", "setpriv") if not shutil.which(name)]
    if missing:
        return f"not installed: {', '.join(missing)}"
    probe = f"{PREFIX}{os.getpid()}-probe"
    try:
        _run("ip", "netns", "add", probe)
        try:
            _run("ip", "netns", "exec", probe, "iptables", *_lose(0.5))
        finally:
            _run("ip", "netns", "delete", probe)
    except RuntimeError as error:
        return str(error)
    return ""


class Network:
    """Hosts by name, each with its address, all on one link layer."""

    def __init__(self, names):
        _remove_orphans()
        self.addresses = {name: f"10.77.0.{i + 1}" for i, name in enumerate(names)}
        atexit.register(self.remove)
        self._make("switch")
        self._ip("switch", "link", "add", "name", "bridge", "type", "bridge", "mcast_snooping", "0")
        self._ip("switch", "link", "set", "bridge", "up")
        for name, address in self.addresses.items():
            self._make(name)
            self._ip("switch", "link", "add", "name", name, "type", "veth",
                     "peer", "name", "eth0", "netns", self._namespace(name))
            self._ip("switch", "link", "set", "dev", name, "master", "bridge", "up")
            self._ip(name, "address", "add", f"{address}/24", "dev", "eth0")
            self._ip(name, "link", "set", "eth0", "up")

    def remove(self):
        for name in ("switch", *self.addresses):
            _remove(self._namespace(name))
        atexit.unregister(self.remove)

    def start(self, name, command, **options):
        """Starts a process on a host; it does not outlive this one."""
        return subprocess.Popen(
            ["setpriv", "--pdeathsig", "KILL", "ip", "netns", "exec", self._namespace(name),
             *map(str, command)], stdin=subprocess.DEVNULL, **options)

    def run(self, name, *command):
        """A command on a host, to its end."""
        return self._run(name, *command)

    def lose(self, share):
        """From now on every host loses that share of the frames that arrive, fragments of larger
        packets included: of what travels there and back, twice as much."""
        for name in self.addresses:
            self._run(name, "iptables", *_lose(share))

    def lost(self):
        """How many frames were lost."""
        tables = [self._run(name, "iptables", "-t", "raw", "-L", "PREROUTING", "-v", "-x", "-n")
                  for name in self.addresses]
        return sum(int(count) for table in tables
                   for count in re.findall(r"^\s*(\d+)\s+\d+\s+DROP", table, re.MULTILINE))

    def received(self, name):
        """How many bytes have arrived at a host, headers of frames included."""
        (link,) = json.loads(self._ip(name, "-json", "-statistics", "link", "show", "eth0"))
        return link["stats64"]["rx"]["bytes"]

    def limit(self, rate):
        """From now on every host sends, and is sent, at most so much, as in 10mbit."""
        for name in self.addresses:
            shape = ("root", "tbf", "rate", rate, "burst", "32kbit", "latency", "50ms")
            self._run(name, "tc", "qdisc", "add", "dev", "eth0", *shape)
            self._run("switch", "tc", "qdisc", "add", "dev", name, *shape)

    def cut(self, name):
        """Neither end of a host's link is told."""
        self._ip("switch", "link", "set", "dev", name, "nomaster")

    def pull(self, name):
        """The host notices that its link is down."""
        self._ip("switch", "link", "set", "dev", name, "down")

    def heal(self, name):
        self._ip("switch", "link", "set", "dev", name, "master", "bridge", "up")

    def _make(self, name):
        _run("ip", "netns", "add", self._namespace(name))
        self._ip(name, "link", "set", "lo", "up")

    def _namespace(self, name):
        return f"{PREFIX}{os.getpid()}-{name}"

    def _ip(self, name, *arguments):
        return _run("ip", "-netns", self._namespace(name), *arguments)

    def _run(self, name, *command):
        return _run("ip", "netns", "exec", self._namespace(name), *command)


# Frames, not packets: before fragments are put together.
def _lose(share):
    return ("-t", "raw", "-A", "PREROUTING", "-i", "eth0", "-m", "statistic", "--mode", "random",
            "--probability", str(share), "-j", "DROP")


def _run(*command):
    result = subprocess.run(command, check=False, text=True, capture_output=True)
    if result.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {result.stderr.strip()}")
    return result.stdout


def _namespaces():
    return [line.split()[0] for line in _run("ip", "netns", "list").splitlines()]


def _remove(namespace):
    """With all that runs there."""
    if namespace not in _namespaces():
        return
    for pid in _run("ip", "netns", "pids", namespace).split():
        with contextlib.suppress(ProcessLookupError):
            os.kill(int(pid), signal.SIGKILL)
    _run("ip", "netns", "delete", namespace)


def _remove_orphans():
    """What a process left that had no time to clear up."""
    for namespace in _namespaces():
        owner = re.fullmatch(rf"{PREFIX}(\d+)-\w+", namespace)
        if owner and not os.path.exists(f"/proc/{owner[1]}"):
            _remove(namespace)
