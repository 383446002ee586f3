"""Runs in virtual time, for any number of workers, and what bounds them."""
import json
import subprocess

TIMEOUT = 1800  # s: of a scene
ANY = 4096      # workers: as many as could be of use
HEAD = """\
| scene | workers | s | times one | busy | of it for nothing | coordinator | what bounds it |
|---|---|---|---|---|---|---|---|"""


def run(scene, args):
    done = subprocess.run(
        [args.build / "tests/scaling_simulation", scene, "1", str(args.delay),
         *map(str, args.workers), str(ANY)],
        capture_output=True, text=True, timeout=TIMEOUT, check=True)
    *rows, any_number, free_caller = json.loads(done.stdout)
    return {"scene": scene.stem, "solved": all(row["solved"] for row in rows), "rows": rows,
            "any_number": any_number, "free_caller": free_caller}


def bound(result, row):
    """In words: what would have to change for more workers to be faster than this row's."""
    limit, free = result["any_number"], result["free_caller"]["seconds"]
    if row["seconds"] > 1.1 * limit["seconds"]:
        return "the number of workers"
    if limit["longest"] > 0.5 * row["seconds"]:
        return f"one attempt of {limit['longest'] * 1e3:.0f} ms"
    if free < 0.8 * limit["seconds"]:
        return "the coordinator"
    if limit["subproblems"] <= 2 * limit["rounds"]:
        return f"a chain of {limit['rounds']} rounds, {limit['subproblems']} subproblems"
    return f"{limit['subproblems']} subproblems in {limit['rounds']} rounds"


def lines(result):
    first = result["rows"][0]  # of one worker: does what is needed, and nothing else
    one = first["seconds"]
    out = []
    for row in result["rows"]:
        busy = row["busy"] / row["seconds"] / row["hands"]
        out.append(
            f"| {result['scene']} | {row['hands']} | {row['seconds']:.3f} "
            f"| {one / row['seconds']:.2f} | {busy:.0%} "
            f"| {max(0, 1 - first['busy'] / row['busy']):.0%} "
            f"| {row['caller'] / row['seconds']:.1%} | {bound(result, row)} |")
    return "\n".join(out)
