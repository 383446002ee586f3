"""A coordinator, a worker and a discovery server on 127.0.0.1 that serve metrics, and what these are. The
binaries are the environment variables ACCORD_COORDINATOR, ACCORD_WORKER and ACCORD_DISCOVERY,
build/bin/... unless told."""

import dataclasses
import os
import pathlib
import random
import re
import socket
import subprocess
import tempfile
import time
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[3]
# Taken out of the environment: else the services would take them for settings.
BINARIES = {name: os.environ.pop(f"ACCORD_{name.upper()}", str(ROOT / f"build/bin/accord-{name}"))
            for name in ("coordinator", "worker", "discovery")}


@dataclasses.dataclass
class Metric:
    kind: str  # counter, gauge or histogram
    help: str
    labels: dict  # by name: the values there are


def parse(text):
    """By name: what Prometheus's text format says of each metric."""
    metrics = {}
    for line in text.splitlines():
        if match := re.fullmatch(r"# HELP (\w+) (.*)", line):
            metrics[match[1]] = Metric("", match[2], {})
        elif match := re.fullmatch(r"# TYPE (\w+) (\w+)", line):
            metrics[match[1]].kind = match[2]
        else:
            name, labels, _ = re.fullmatch(r"(\w+)(?:\{(.*)\})? (\S+)", line).groups()
            if name not in metrics:
                name = re.sub(r"_(bucket|sum|count)$", "", name)
            for label, value in re.findall(r'(\w+)="([^"]*)"', labels or ""):
                metrics[name].labels.setdefault(label, set()).add(value)
    return metrics


def free_port():
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


def get(port):
    with urllib.request.urlopen(f"http://127.0.0.1:{port}/metrics", timeout=5) as answer:
        return answer.read().decode()


def scrape():
    """By process, "coordinator", "worker" and "discovery": the metrics that each has before anybody asks for a
    plan. All that a dashboard can name has to be there by then."""
    flags = ["--domain", str(random.randint(1, 200)), "--log", "error"]
    service = ["--transport", "udp", "--interface", "127.0.0.1", "--cluster", f"test-{os.getpid()}"]
    out, processes = {}, []
    with tempfile.TemporaryDirectory() as folder:
        more = {"coordinator": [*service, "--journal", f"{folder}/journal.db"],
                "worker": [*service, "--threads", "1"],
                "discovery": ["--listen", f"127.0.0.1:{free_port()}"]}
        try:
            for name, binary in BINARIES.items():
                port = free_port()
                processes.append(subprocess.Popen(
                    [binary, *flags, *more[name], "--metrics", str(port)],
                    stdin=subprocess.DEVNULL))
                out[name] = parse(patiently(port, processes[-1]))
        finally:
            for process in processes:
                process.terminate()
            for process in processes:
                process.wait(30)
    return out


def patiently(port, process):
    end = time.monotonic() + 30
    while True:
        try:
            return get(port)
        except OSError:
            if time.monotonic() > end or process.poll() is not None:
                raise
            time.sleep(0.05)
