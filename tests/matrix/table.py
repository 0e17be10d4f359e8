"""The table of a matrix: written as Markdown, read back, and compared with an older one."""

import os

HEAD = ["input", "call", "exit", "status", "control points", "error", "swing", "above 3, %", "box, %", "box, tol", "s",
        "processor s", "MiB", "fails on", "remarks"]
MARK = "<!-- Rows: written by scripts/matrix --table; what stands below is replaced. -->"
# A row that ends in a later one than before got worse.
RANK = {status: rank for rank, status in enumerate(
    ["reached", "fixed_size", "not_reached", "limit_reached", "tolerance_below_noise", "data_too_sparse", "folded",
     "swings", "time_limit", "stopped", "refused", "none", "failed"])}
MORE = 1.10  # times as many control points
# Where a clock or a signal ends a run, its size is not the search's.
TIMED = {"time_limit", "stopped"}


def short(x):
    return "0" if x == 0 else f"{x:.3g}"


def cells(r):
    unit = " tol" if r.tolerance else " %"
    measured = r.control_points > 0
    return [r.input, r.call, str(r.exit), r.status, str(r.control_points) if measured else "",
            short(r.error) + unit if measured else "", short(r.swing) if measured else "",
            short(100 * r.above_3) if measured else "", short(r.box) if measured else "",
            short(r.box_tolerances) if measured and r.tolerance else "", f"{r.seconds:.1f}", f"{r.processor:.1f}",
            f"{r.memory:.0f}", "; ".join(r.faults), "; ".join(r.remarks)]


def escaped(text):
    return text.replace("|", "\\|").replace("\n", " ")


def markdown(results):
    lines = ["| " + " | ".join(HEAD) + " |", "|" + "---|" * len(HEAD)]
    for r in sorted(results, key=lambda r: (r.input, r.call)):
        lines.append("| " + " | ".join(escaped(c) for c in cells(r)) + " |")
    return "\n".join(lines) + "\n"


def write(path, results, summary):
    """What stands above MARK in the file stays."""
    head = ""
    if os.path.exists(path):
        with open(path, encoding="utf-8") as file:
            before, mark, _ = file.read().partition(MARK)
        if mark:
            head = before + MARK + "\n\n"
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(head + summary + "\n\n" + markdown(results))
    os.replace(path + ".part", path)


def read(path):
    """(input, call) -> (status, control points) of a table that write() wrote."""
    rows = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            parts = [c.strip() for c in line.replace("\\|", "\0").strip().strip("|").split("|")]
            if len(parts) == len(HEAD) and parts[0] != HEAD[0] and not parts[0].startswith("-"):
                rows[(parts[0], parts[1])] = (parts[3], int(parts[4] or 0))
    return rows


def worse(old, results):
    """Sentences on rows whose status got worse or that need more control points than in `old` (as read())."""
    out = []
    for r in results:
        if (r.input, r.call) not in old:
            continue
        status, points = old[(r.input, r.call)]
        if RANK.get(r.status, len(RANK)) > RANK.get(status, len(RANK)):
            out.append(f"{r.key}: {status} -> {r.status}")
        elif r.status == status and status not in TIMED and points and r.control_points > MORE * points:
            out.append(f"{r.key}: {points} -> {r.control_points} control points")
    return out
