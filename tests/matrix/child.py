"""One run of the program: its exit status, what it printed, seconds and peak memory.

The run is watched by a small Python of its own: Linux counts the memory of the process that starts a program into the
program's peak, and the one that measures surfaces is large.
"""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections import namedtuple

GRACE = 240  # seconds after which a run that should have ended is killed
running = set()  # watchers, by process id

# exit: below 0 where a signal ended it; after_stop: seconds from the signal to the end, 0 where none was sent;
# processor: seconds that the program had, all threads; memory: bytes; killed: by us, for hanging.
Run = namedtuple("Run", "exit out err seconds after_stop processor memory killed")


def default_signals():
    # A runner in the background hands ignored signals down; a Ctrl-C must arrive.
    signal.signal(signal.SIGINT, signal.SIG_DFL)


class Signals:
    """Signals sent later to a child that is not reaped yet, so that they never meet another process."""

    def __init__(self, pid):
        self.pid, self.ended, self.lock = pid, False, threading.Lock()
        self.sent, self.timers = {}, []

    def add(self, seconds, number):
        timer = threading.Timer(seconds, self.send, (number,))
        timer.daemon = True
        timer.start()
        self.timers.append(timer)

    def send(self, number):
        with self.lock:
            if not self.ended:
                os.kill(self.pid, number)
                self.sent[number] = time.monotonic()

    def wait(self):
        os.waitid(os.P_PID, self.pid, os.WEXITED | os.WNOWAIT)
        with self.lock:
            self.ended = True
        for timer in self.timers:
            timer.cancel()


def watch(command, time_limit, stop_after):
    """Runs `command` here; what is known of it as a dict."""
    environment = {k: v for k, v in os.environ.items() if k != "OPENBLAS_NUM_THREADS"}
    start = time.monotonic()
    with open("stdout", "wb") as out, open("stderr", "wb") as err:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=err, env=environment,
                                 preexec_fn=default_signals)
        signals = Signals(child.pid)
        if stop_after > 0:
            signals.add(stop_after, signal.SIGINT)
        signals.add(time_limit + GRACE, signal.SIGKILL)
        signals.wait()
        end = time.monotonic()
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = os.waitstatus_to_exitcode(status)
    stopped = signals.sent.get(signal.SIGINT)
    return {"exit": child.returncode, "seconds": end - start, "after_stop": end - stopped if stopped else 0.0,
            "processor": usage.ru_utime + usage.ru_stime, "memory": usage.ru_maxrss * 1024,
            "killed": signal.SIGKILL in signals.sent}


def run(command, folder, time_limit, stop_after=0):
    """Runs `command` in `folder`; SIGINT after stop_after seconds where that is above 0."""
    watcher = [sys.executable, "-I", "-S", os.path.abspath(__file__), str(time_limit), str(stop_after), *command]
    # A session of its own: a Ctrl-C for the matrix is none for the program, whose row would then tell of it.
    process = subprocess.Popen(watcher, cwd=folder, stdout=subprocess.PIPE, start_new_session=True)
    running.add(process.pid)
    said = process.communicate()[0]
    running.discard(process.pid)
    if process.returncode != 0:
        raise RuntimeError(f"the watcher ended with {process.returncode}")

    def text(name):
        with open(os.path.join(folder, name), encoding="utf-8", errors="replace") as file:
            return file.read()

    return Run(out=text("stdout"), err=text("stderr"), **json.loads(said))


def end_all():
    """Ends every run and its watcher."""
    for pid in list(running):
        try:
            os.killpg(pid, signal.SIGKILL)
        except ProcessLookupError:
            pass


if __name__ == "__main__":
    print(json.dumps(watch(sys.argv[3:], float(sys.argv[1]), float(sys.argv[2]))))
