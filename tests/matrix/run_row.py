"""Runs one row and measures what it wrote: a Result, which is also what is kept and compared."""

import os
import re
import shutil
import tempfile
from dataclasses import asdict, dataclass, field

import child
import outputs
import truth
import verdict

TIME_LIMIT = 60  # seconds, given to every run
FEWER_POINTS = re.compile(r"(\d+) points are fewer than (\d+)(?: x (\d+))?")


@dataclass
class Result:
    input: str
    call: str
    exit: int = 0
    status: str = ""
    control_points: int = 0
    error: float = 0.0  # the one that counts, from the CSV; in tolerances, without one in % of the diagonal
    tolerance: float = 0.0  # in the data's unit; 0: none asked
    swing: float = 0.0
    above_3: float = 0.0  # share of the places
    places: int = 0
    swing_at: list = field(default_factory=list)
    box: float = 0.0  # in % of the diagonal
    box_tolerances: float = 0.0
    seconds: float = 0.0
    processor: float = 0.0  # seconds
    memory: float = 0.0  # MiB
    faults: list = field(default_factory=list)
    remarks: list = field(default_factory=list)

    @property
    def key(self):
        return f"{self.input} {self.call}"


def command_of(tool, row):
    return [tool, row.input.command, row.input.path, *row.input.arguments, *row.options(),
            "--time-limit", str(TIME_LIMIT), "--json", "-o", "out.json", "-o", "out.csv"]


def refused_rightly(run, row):
    """A fixed size of more control points than points has no answer."""
    found = FEWER_POINTS.search(run.err)
    if run.exit != 2 or row.size == "free" or not found:
        return False
    points, wide, high = (int(x or 1) for x in found.groups())
    return points < wide * high


def run(tool, row, keep=None):
    """tool: path of the program; keep: a folder for what a row that fails wrote."""
    with tempfile.TemporaryDirectory(prefix="knotfit-matrix-") as folder:
        result = run_in(folder, tool, row)
        if keep and result.faults:
            kept = os.path.join(keep, re.sub(r"[^\w.%-]+", "_", result.key))
            shutil.copytree(folder, kept, dirs_exist_ok=True)
        return result


def run_in(folder, tool, row):
    done = child.run(command_of(tool, row), folder, TIME_LIMIT, row.stop_after)
    result = Result(row.input.name, row.call(), exit=done.exit, seconds=done.seconds, processor=done.processor,
                    memory=done.memory / 2 ** 20)
    if refused_rightly(done, row):
        result.status, result.remarks = "refused", ["fewer points than control points"]
        return result
    result.faults = verdict.of_process(done, row.stop_after)
    if done.exit == 2 and not row.input.sound:
        result.status, result.remarks, result.faults = "refused", result.faults, []
        return result
    late, result.remarks = verdict.of_clock(done, TIME_LIMIT)
    result.faults += late
    try:
        measure(done, row, folder, result)
    except Exception as error:  # what cannot be read is the run's fault, and the next row still runs
        result.faults.append(f"its outputs cannot be measured: {type(error).__name__}: {error}")
    return result


def measure(done, row, folder, result):
    report = outputs.read_report(done.out)
    wrote = [os.path.exists(os.path.join(folder, name)) for name in ("out.json", "out.csv")]
    if report is None or not all(wrote):
        result.status = "refused" if done.exit == 2 else "none"
        at_start = verdict.stopped_at_its_start(done, row.stop_after)
        if (at_start or done.exit == 130) and row.stop_after and not any(wrote):
            result.remarks.append("stopped before there was a surface")
        elif not result.faults:
            result.faults.append(f"exit {done.exit} without a report and both files")
        return
    tolerance = report["tolerance"]
    limit = tolerance["value"] if tolerance else 0.0
    m = (outputs.of_curve if row.input.curve else outputs.of_surface)(folder, report, limit)
    result.faults += verdict.of_status(m.status, done.exit)
    denied = truth.denied(row.input.path, outputs.read_table(os.path.join(folder, "out.csv")))
    if denied:
        result.faults.append(denied)
    faults, remarks = verdict.of_result(m, tolerance, truth.count(row.input.path))
    result.faults += faults
    result.remarks += remarks
    if tolerance:
        error = verdict.measured(m.errors, tolerance["measure"], tolerance["share"])
    else:
        error = verdict.measured(m.errors, {"rms": "rms", "max": "max"}.get(row.measure, "percentile"), 0.995)
    result.status, result.control_points, result.tolerance = m.status, m.control_points, limit
    result.error = error / limit if limit else 100 * error / m.diagonal
    result.swing, result.above_3, result.places = m.swings.largest, m.swings.share_above_3, m.swings.places
    result.swing_at = list(m.swings.where)
    result.box = 100 * m.box / m.diagonal
    result.box_tolerances = m.box / limit if limit else 0.0


def as_record(result):
    return asdict(result)


def from_record(record):
    return Result(**record)
