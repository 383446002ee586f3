"""Runs a command under a cap on its memory, and prints what it took as JSON:

    measured.py MEGABYTES SECONDS COMMAND...

code (of its exit; negative: the signal that ended it), err (the end of its stderr), wall (s, from
its start to its end), peak (MB of resident memory), hung (it was killed because it had not ended
after SECONDS).

A process of its own, and a small one: a child's peak counts what its parent had when it was forked.
"""
import json
import resource
import subprocess
import sys
import time


def main(megabytes, seconds, *command):
    def limit():
        cap = int(megabytes) << 20
        resource.setrlimit(resource.RLIMIT_AS, (cap, cap))

    start = time.monotonic()
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                               text=True, errors="replace", preexec_fn=limit)
    hung = False
    try:
        _, err = process.communicate(timeout=float(seconds))
    except subprocess.TimeoutExpired:
        hung = True
        process.kill()
        _, err = process.communicate()
    wall = time.monotonic() - start
    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(json.dumps({"code": process.returncode, "err": err.strip()[-300:], "wall": wall,
                      "peak": peak, "hung": hung}))


if __name__ == "__main__":
    main(*sys.argv[1:])
