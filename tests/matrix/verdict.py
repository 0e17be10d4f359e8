"""Whether a run kept its word: what docs/matrix.md says that a row fails on."""

import os
import re
import signal

import numpy as np

EXITS = {"reached": 0, "fixed_size": 0, "stopped": 130, "failed": 1, "not_run": 1}  # others: 3
OTHERS = 3
# Statuses that say why a surface that holds the tolerance at the points is none that was asked for.
EXCUSED = {"swings", "folded", "stopped", "time_limit", "failed"}
KNOWN = {"fixed_size", "reached", "not_reached", "data_too_sparse", "tolerance_below_noise", "folded", "limit_reached",
         "time_limit", "stopped", "failed", "swings"}

LARGEST_SWING, SHARE_ABOVE_3 = 10, 1 / 2000
BOX_FAILS, BOX_ASKED, BOX_TOLERANCES = 0.20, 0.02, 2
FIXED_EXCESS = 0.01  # of the diagonal: what is worth a remark where a fixed size follows the points to a few digits
OVERRUN = 10  # seconds
STARVED = 0.5  # share of one processor
STARTED = 0.5  # processor seconds in which the program surely listens to signals
MEMORY = 1 << 30  # bytes
ROUNDING = 1e-9

# A note on the box says that the surface leaves its data.
BOX_WORDS = re.compile(r"\b(swings?|box|strays?|leaves (the|its) data|"
                       r"(beyond|outside|away from|far from) (the|its) data)\b")
LEFT_OUT_WORDS = re.compile(r"\bleft out\b")
SWING_WORDS = re.compile(r"\b(swings?|between the points)\b")


def measured(errors, measure, share):
    """The error that counts: the largest, the root mean square, or the least that `share` of the points hold."""
    if measure == "max":
        return float(errors.max())
    if measure == "rms":
        return float(np.sqrt(np.mean(errors ** 2)))
    rank = int(np.clip(np.ceil(share * len(errors) * (1 - 1e-12)), 1, len(errors)))
    return float(np.partition(errors, rank - 1)[rank - 1])


def swings_too_much(s):
    return s.largest > LARGEST_SWING or s.share_above_3 > SHARE_ABOVE_3


def of_process(run, stop_after):
    """Faults that need no output, nor a clock."""
    faults = []
    if run.killed:
        faults.append(f"hung: killed after {run.seconds:.0f} s")
    elif stopped_at_its_start(run, stop_after):
        pass
    elif run.exit < 0:
        faults.append(f"ended by signal {-run.exit}")
    elif run.exit == 1:
        faults.append("exit 1: " + first_line(run.err))
    elif run.exit == 2:
        faults.append("refused: " + first_line(run.err))
    elif run.exit not in (0, 3, 130):
        faults.append(f"exit {run.exit}")
    if run.exit == 130 and not stop_after:
        faults.append("exit 130, and nobody stopped it")
    if run.memory > MEMORY:
        faults.append(f"{run.memory / 2 ** 20:.0f} MiB of memory")
    return faults


def of_clock(run, time_limit):
    """(faults, remarks) of seconds; those of a program that hardly got a processor are the machine's."""
    late = []
    if run.seconds > time_limit + OVERRUN:
        late.append(f"{run.seconds:.0f} s with a time limit of {time_limit} s")
    if run.after_stop > OVERRUN:
        late.append(f"ended {run.after_stop:.0f} s after it was stopped")
    load, processors = os.getloadavg()[0], os.cpu_count() or 1
    if late and load > processors + 1 and run.processor < STARVED * run.seconds:
        return [], [f"{words}: a busy machine, {run.processor:.1f} s of a processor" for words in late]
    return late, []


def stopped_at_its_start(run, stop_after):
    """On a busy machine the signal may come before the program has begun to listen."""
    return bool(stop_after) and run.exit == -signal.SIGINT and run.processor < STARTED


def of_status(status, exit_status):
    if status not in KNOWN:
        return [f"status {status} is none that docs/ knows"]
    wanted = EXITS.get(status, OTHERS)
    return [] if exit_status == wanted else [f"exit {exit_status} with status {status}"]


def of_points(m, count, said):
    """(faults, remarks) where the CSV has fewer points than the input's `count` (None: not known)."""
    if count is None or count == m.points:
        return [], []
    words = f"the CSV has {m.points} of the input's {count} points"
    if m.status == "reached" and not LEFT_OUT_WORDS.search(said):
        return [words + ", and no note says so"], []
    return [], [words]


def of_result(m, tolerance, count=None):
    """(faults, remarks) of a run that wrote a surface; tolerance is the report's member, or None; count: points of the
    input, or None."""
    said = " ".join(m.notes)
    faults, remarks = of_points(m, count, said)
    if m.disagree:
        faults.append(m.disagree)
    if m.report_differs:
        remarks.append(m.report_differs)
    limit = tolerance["value"] if tolerance else 0
    if tolerance:
        for source, errors in (("JSON", m.recomputed), ("CSV", m.errors)):
            error = measured(errors, tolerance["measure"], tolerance["share"])
            if m.status == "reached" and error > limit * (1 + ROUNDING):
                faults.append(f"reached, but the {source} says {error / limit:.4g} tolerances")
            elif m.status not in EXCUSED | {"reached"} and error <= limit * (1 - 1e-6):
                faults.append(f"{m.status}, but the {source} says {error / limit:.4g} tolerances")
    if swings_too_much(m.swings):
        if m.status == "reached":
            faults.append("reached, but it swings")
        elif (m.status == "fixed_size" and m.swings.excess > FIXED_EXCESS * m.diagonal
              and not SWING_WORDS.search(said)):
            remarks.append("swings, and no note says so")
    elif m.status == "swings":
        remarks.append("status swings, and the measure finds none")
    if m.box > BOX_FAILS * m.diagonal and m.status != "swings" and not BOX_WORDS.search(said):
        faults.append("the box is larger than the data's, and no note says so")
    elif m.box > max(BOX_ASKED * m.diagonal, BOX_TOLERANCES * limit):
        remarks.append("box")
    return faults, remarks


def first_line(text):
    return (text.strip().splitlines() or ["no message"])[0].removeprefix("knotfit: ")
