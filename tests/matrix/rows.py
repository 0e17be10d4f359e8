"""The rows: which options each run has, and which rows are run.

FACTORS varies beside the input. Not every combination is a call: inserted knot lines go to a tolerance, not to a fixed
size, and curves know no --refine.
"""

import itertools
import random
from dataclasses import dataclass

from inputs import Input

FACTORS = {
    "tolerance": ("default", "5%", "1%", "0.1%"),
    "measure": ("max", "rms", "99.5%"),
    "route": ("search", "insert"),
    "knots": ("optimal", "error-model", "uniform"),
    "size": ("free", "8", "20", "40"),
    "stop": ("no", "2 s"),
}
DEFAULTS = {name: values[0] for name, values in FACTORS.items()}
SEED = 20
CANDIDATES = 30


@dataclass(frozen=True)
class Row:
    input: Input
    tolerance: str = "default"
    measure: str = "max"
    route: str = "search"
    knots: str = "optimal"
    size: str = "free"
    stop: str = "no"

    def options(self):
        """Of the command line; what is the default is left out."""
        out = []
        if self.tolerance != "default":
            out += ["--tol", self.tolerance]
        if self.measure == "rms":
            out += ["--rms"]
        elif self.measure != "max":
            out += ["--within", self.measure]
        if self.size != "free":
            out += ["--control-points", self.size if self.input.curve else f"{self.size}x{self.size}"]
        if self.route == "insert":
            out += ["--refine", "insert"]
        if self.knots != "optimal":
            out += ["--knots", self.knots]
        return out

    def call(self):
        """What tells it from other rows of the input: options, and the stop."""
        words = self.options() + (["(stopped after 2 s)"] if self.stop != "no" else [])
        return " ".join(words) or "(no option)"

    @property
    def key(self):
        return f"{self.input.name} {self.call()}"

    @property
    def stop_after(self):
        return 0 if self.stop == "no" else float(self.stop.split()[0])


def valid(given):
    """Whether options given so far (name -> value, `input` among them) can be one call."""
    insert = given.get("route") == "insert"
    return not insert or (given.get("size", "free") == "free" and not ("input" in given and given["input"].curve))


def product(inputs):
    """Every row there is."""
    for values in itertools.product(inputs, *FACTORS.values()):
        given = dict(zip(["input", *FACTORS], values))
        if valid(given):
            yield Row(**given)


def pairs_of(given):
    return {frozenset(pair) for pair in itertools.combinations(sorted(given.items(), key=lambda g: g[0]), 2)}


def all_pairs(levels):
    out = set()
    for (a, first), (b, second) in itertools.combinations(levels.items(), 2):
        out |= {frozenset({(a, x), (b, y)}) for x in first for y in second if valid({a: x, b: y})}
    return out


def candidate(levels, missing, rng):
    """A row around one pair that is missing, each further option the one that adds most."""
    given = dict(rng.choice(missing["list"]))
    names = [n for n in levels if n not in given]
    rng.shuffle(names)
    for name in names:
        best, most = [], -1
        for value in levels[name]:
            if not valid({**given, name: value}):
                continue
            new = sum(frozenset({(name, value), other}) in missing["set"] for other in given.items())
            if new > most:
                best, most = [value], new
            elif new == most:
                best.append(value)
        given[name] = best[0] if name == "stop" else rng.choice(best)  # what runs to its end tells more
    return given


def cover(inputs):
    """Rows such that every two options (or an option and an input) meet in one: the call without options of every
    input, then greedily. The same inputs give the same rows."""
    levels = {"input": tuple(inputs), **FACTORS}
    rng = random.Random(SEED)
    rows = [Row(i) for i in inputs]
    missing = all_pairs(levels)
    for i in inputs:
        missing -= pairs_of({"input": i, **DEFAULTS})
    while missing:
        ordered = sorted(missing, key=lambda pair: sorted((n, getattr(v, "name", v)) for n, v in pair))
        state = {"set": missing, "list": ordered}
        best = max((candidate(levels, state, rng) for _ in range(CANDIDATES)),
                   key=lambda given: len(pairs_of(given) & missing))
        missing -= pairs_of(best)
        rows.append(Row(**best))
    return rows
