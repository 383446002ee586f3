"""Runs on this machine: in process and over DDS, with the same numbers of workers, in turns."""
import json
import statistics
import subprocess

TIMEOUT = 600  # s: of a run
HEAD = """\
| scene | workers | in process s | times one | over DDS | s | times one | to in process | warm s \
| busy | coordinator | messages a task | KB a task | first task ms |
|---|---|---|---|---|---|---|---|---|---|---|---|---|---|"""


def in_process(args, scene, workers):
    """Seconds of planning, or None where there is no plan."""
    done = subprocess.run(
        [args.build / "bin/accord", "plan", scene, "--workers", str(workers), "--quiet", "--json",
         "-o", "/dev/null"], capture_output=True, text=True, timeout=TIMEOUT, check=False)
    return json.loads(done.stdout)["planning_time"] if done.returncode == 0 else None


def over_dds(args, scene, workers, transport):
    """What scaling_run says of one run with new processes, and the seconds of another."""
    done = subprocess.run(
        [args.build / "tests/scaling_run", scene, str(workers), transport, "2"],
        capture_output=True, text=True, timeout=TIMEOUT, check=True)
    first, second = json.loads(done.stdout)
    return {**first, "warm": second["seconds"], "solved": first["solved"] and second["solved"]}


def run(scene, args):
    local = {workers: [] for workers in args.workers}
    remote = {(transport, workers): [] for transport in args.transports
              for workers in args.workers}
    for _ in range(args.runs):
        for workers in args.workers:
            local[workers].append(in_process(args, scene, workers))
            for transport in args.transports:
                remote[transport, workers].append(over_dds(args, scene, workers, transport))
    solved = (None not in sum(local.values(), []) and
              all(row["solved"] for rows in remote.values() for row in rows))
    return {"scene": scene.stem, "solved": solved,
            "in_process": [{"workers": workers, "seconds": seconds}
                           for workers, seconds in local.items()],
            "over_dds": [{"transport": transport, "workers": workers, "runs": rows}
                         for (transport, workers), rows in remote.items()]}


def median(rows, value):
    return statistics.median(value(row) for row in rows)


def lines(result):
    if not result["solved"]:
        return f"| {result['scene']} | no plan | | | | | | | | | | | |"
    local = {row["workers"]: statistics.median(row["seconds"]) for row in result["in_process"]}
    one = local[min(local)]
    out = []
    for entry in result["over_dds"]:
        workers, rows = entry["workers"], entry["runs"]
        seconds = median(rows, lambda row: row["seconds"])
        first = next(median(other["runs"], lambda row: row["seconds"])
                     for other in result["over_dds"] if other["transport"] == entry["transport"])
        tasks = median(rows, lambda row: row["tasks"]) or 1
        out.append(
            f"| {result['scene']} | {workers} | {local[workers]:.3f} | {one / local[workers]:.2f} "
            f"| {entry['transport']} | {seconds:.3f} | {first / seconds:.2f} "
            f"| {seconds / local[workers] - 1:+.0%} | {median(rows, lambda row: row['warm']):.3f} "
            f"| {median(rows, lambda row: row['busy'] / row['seconds'] / row['workers']):.0%} "
            f"| {median(rows, lambda row: row['coordinator'] / row['seconds']):.1%} "
            f"| {median(rows, lambda row: row['messages']) / tasks:.1f} "
            f"| {median(rows, lambda row: row['bytes']) / tasks / 1e3:.1f} "
            f"| {median(rows, lambda row: row['first_task']) * 1e3:.2f} |")
    return "\n".join(out)
