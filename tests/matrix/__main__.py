"""Runs the program over every input and option, and holds each result against its word.

  scripts/matrix [--quick|--full] [--only PATTERN] [--tool PATH] [--data FOLDER] [--jobs N]
                 [--table FILE] [--against FILE] [--keep FOLDER] [--resume] [--list]

Without --quick or --full: every two options, and every option and input, meet in one row (some 200 rows, an hour or
two). What is measured and what a row fails on: docs/matrix.md.
"""

import argparse
import collections
import concurrent.futures
import fnmatch
import hashlib
import json
import os
import signal
import sys
import tempfile
import time

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # measuring beside runs takes one processor
try:
    import numpy  # noqa: F401
    import scipy  # noqa: F401
except ImportError as missing:
    print(f"skipped: {missing} (scripts/setup installs it)")
    sys.exit(77)

import child
import inputs
import quick
import rows
import run_row
import table


def options():
    parser = argparse.ArgumentParser(prog="scripts/matrix", formatter_class=argparse.RawDescriptionHelpFormatter,
                                     description=__doc__)
    which = parser.add_mutually_exclusive_group()
    which.add_argument("--quick", action="store_true", help="twenty rows on small data: those of scripts/test")
    which.add_argument("--full", action="store_true", help="every row there is, days")
    parser.add_argument("--only", metavar="PATTERN", action="append", default=[],
                        help="rows whose 'input call' holds this text or fits this pattern (* and ?); may repeat")
    parser.add_argument("--made", action="store_true", help="made inputs only")
    parser.add_argument("--tool", default=os.path.join(inputs.ROOT, "build/dev/tool/knotfit"), help="the program")
    parser.add_argument("--data", default=os.environ.get("KNOTFIT_DATA", ""), help="more inputs; default: KNOTFIT_DATA")
    parser.add_argument("--calls", default="", help="how your own inputs are called: lines as in calls.txt")
    parser.add_argument("--jobs", type=int, default=1, metavar="N", help="rows at once; default 1: seconds are true")
    parser.add_argument("--calm", type=float, metavar="LOAD", help="begin a row only while the load is below this")
    parser.add_argument("--table", metavar="FILE", help="write the results as a Markdown table")
    parser.add_argument("--against", metavar="FILE", help="list rows that are worse than in this table")
    parser.add_argument("--keep", metavar="FOLDER", help="keep what rows that fail wrote: a folder a row")
    parser.add_argument("--resume", action="store_true", help="do not run again what this program has run")
    parser.add_argument("--state", metavar="FILE", help="where results are kept; default: in build/matrix/")
    parser.add_argument("--list", action="store_true", help="name the rows and run none")
    return parser.parse_args()


def wanted(row, patterns):
    return not patterns or any(p in row.key or fnmatch.fnmatch(row.key, p) for p in patterns)


def choose(o, folder):
    """(rows, [(input, why it is skipped)])."""
    if o.quick:
        chosen, skipped = quick.rows(folder), []
    else:
        found, skipped = inputs.collect(folder, o.data, o.calls)
        if o.made:
            found, skipped = [i for i in found if i.name.startswith("made:")], []
        chosen = rows.product(found) if o.full else rows.cover(found)
    return [r for r in chosen if wanted(r, o.only)], skipped


class State:
    """Results as they come, a line of JSON each, in a file named after the program's content. One thread keeps them."""

    def __init__(self, o):
        with open(o.tool, "rb") as file:
            digest = hashlib.sha256(file.read()).hexdigest()[:12]
        self.path = o.state or os.path.join(inputs.ROOT, "build/matrix", digest + ".jsonl")
        self.known = {}
        os.makedirs(os.path.dirname(os.path.abspath(self.path)), exist_ok=True)
        if o.resume and os.path.exists(self.path):
            with open(self.path, encoding="utf-8") as file:
                for line in file:
                    result = run_row.from_record(json.loads(line))
                    self.known[result.key] = result
        self.file = open(self.path, "a" if o.resume else "w", encoding="utf-8")

    def keep(self, result):
        self.file.write(json.dumps(run_row.as_record(result)) + "\n")
        self.file.flush()


def line_of(number, count, r):
    parts = [f"{number}/{count}", "FAILS" if r.faults else "ok", r.key + ":", f"exit {r.exit}", r.status]
    if r.control_points:
        parts.append(f"{r.control_points} points, error {r.error:.3g}{' tol' if r.tolerance else ' %'}, "
                     f"swing {r.swing:.3g} ({100 * r.above_3:.2g} % above 3), box {r.box:.3g} %")
    parts.append(f"{r.seconds:.1f} s ({r.processor:.1f} of a processor) {r.memory:.0f} MiB")
    parts += ["!! " + f for f in r.faults] + ["(" + x + ")" for x in r.remarks]
    return " ".join(parts)


def run_one(o, row):
    while o.calm and os.getloadavg()[0] >= o.calm:
        time.sleep(5)
    return run_row.run(os.path.abspath(o.tool), row, o.keep)


def run_all(o, chosen, state):
    results = [state.known[r.key] for r in chosen if r.key in state.known]
    left = [r for r in chosen if r.key not in state.known]
    if results:
        print(f"{len(results)} rows are known from {os.path.relpath(state.path)}")

    pool = concurrent.futures.ThreadPoolExecutor(o.jobs)
    try:
        waiting = [pool.submit(run_one, o, r) for r in left]
        for done in concurrent.futures.as_completed(waiting):
            results.append(done.result())
            state.keep(results[-1])
            print(line_of(len(results), len(chosen), results[-1]), flush=True)
            write_table(o, results)
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        child.end_all()
        raise
    pool.shutdown()
    return results


def write_table(o, results):
    if o.table:
        table.write(o.table, results, summary_of(results))


def summary_of(results):
    failed = [r for r in results if r.faults]
    statuses = collections.Counter(r.status for r in results)
    words = ", ".join(f"{count} {name}" for name, count in statuses.most_common())
    return f"{len(results)} rows, {len(failed)} fail: {words}."


def main():
    o = options()
    if not os.access(o.tool, os.X_OK):
        sys.exit(f"matrix: there is no program {o.tool}: build it, or name it with --tool")
    with tempfile.TemporaryDirectory(prefix="knotfit-matrix-made-") as folder:
        chosen, skipped = choose(o, folder)
        for name, why in skipped:
            print(f"skipped: {name}: {why}")
        if o.list:
            print("\n".join(r.key for r in chosen))
            return 0
        if not chosen:
            sys.exit("matrix: no row fits")
        results = run_all(o, chosen, State(o))
    write_table(o, results)
    summary = summary_of(results)
    for r in results:
        if r.faults:
            print(f"FAILS: {r.key}: {'; '.join(r.faults)}")
    if o.against:
        for sentence in table.worse(table.read(o.against), results):
            print(f"WORSE: {sentence}")
    print(summary)
    return 1 if any(r.faults for r in results) else 0


def interrupted(*_):
    raise KeyboardInterrupt


if __name__ == "__main__":
    signal.signal(signal.SIGTERM, interrupted)
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print("matrix: interrupted; --resume goes on", file=sys.stderr)
        sys.exit(130)
