"""What systemd would do with a unit, as far as it can be done without systemd."""

import collections
import re
import shlex

SERVICES = ("coordinator", "worker", "discovery")
UNITS = "/usr/lib/systemd/system"


def settings(root, service):
    """The unit's settings, those of the drop-in for all of ours included, as lists by name."""
    found = collections.defaultdict(list)
    for file in (f"accord-{service}.service", "accord-.service.d/10-accord.conf"):
        for line in root.inside(f"{UNITS}/{file}").read_text().splitlines():
            setting = re.fullmatch(r"(\w+)=(.*)", line)
            if setting:
                found[setting[1]].append(setting[2])
    return found


def one(found, name):
    (value,) = found[name]
    return value


def command(root, service):
    """What runs it: as the unit's user, in its folder, which is made as systemd makes it."""
    found = settings(root, service)
    user = one(found, "User")
    folder = one(found, "WorkingDirectory").replace("%S", "/var/lib")
    root.run("install", "-d", "-o", user, "-g", one(found, "Group"), "-m",
             one(found, "StateDirectoryMode"), f"/var/lib/{one(found, 'StateDirectory')}")
    return root.command(*shlex.split(one(found, "ExecStart")), user=user, folder=folder)


def seconds_to_stop(root, service):
    return float(one(settings(root, service), "TimeoutStopSec"))


def installed(root):
    return [name for name in SERVICES if root.inside(f"{UNITS}/accord-{name}.service").exists()]


def with_proposals(text):
    """A configuration file with all that it proposes: lines with a '#' and no space after it."""
    return re.sub(r"^( *)#(?=\S)", r"\1", text, flags=re.MULTILINE)
