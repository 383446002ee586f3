"""The table that an evaluation ends with, in markdown: a line for each scene and method."""
import statistics


def line(group):
    count = f"{len(group.solved)}/{len(group.runs)}"
    start = f"| {group.scene} | {group.method} | {count} | {group.robots or ''} |"
    if not group.solved:
        return f"{start} | | | {group.failures} |"
    remarks = "; ".join(filter(None, (group.solvers() or "none needed", group.failures)))
    return (f"{start} {statistics.median(group.times):.3f} | {max(group.times):.3f} "
            f"| {statistics.mean(group.ratios or [1]):.2f} | {remarks} |")


def table(groups):
    head = ["| scene | method | proved | robots | median s | largest s | cost | solvers |",
            "|---|---|---|---|---|---|---|---|"]
    return "\n".join(head + [line(group) for group in groups])
