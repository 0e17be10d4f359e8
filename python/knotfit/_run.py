"""Progress and stop of long calls."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, NamedTuple, Union


class Progress(NamedTuple):
    """A report on long work. What is not known is -1, a size 0."""

    stage: str
    fraction: float
    error: float
    tolerance: float
    size_u: int
    size_v: int
    fits: int

    def __str__(self) -> str:
        text = self.stage
        if self.fraction >= 0:
            text += f" {100 * min(1.0, self.fraction):.0f} %"
        if self.size_u > 0:
            text += f", {self.size_u} x {self.size_v} control points"
        if self.error >= 0:
            text += f", error {self.error:.3g}"
        if self.error >= 0 and self.tolerance > 0:
            text += f" (tolerance {self.tolerance:.3g})"
        return text + (f", {self.fits} fits" if self.fits > 0 else "")


ProgressLike = Union[bool, Callable[[Progress], Any], None]


class _Line:
    """A line on stderr, or tqdm's bar where it is installed."""

    def __init__(self) -> None:
        try:
            from tqdm.auto import tqdm
        except ImportError:
            self._bar: Any = None
        else:
            self._bar = tqdm(total=100, bar_format="{desc} {elapsed}", leave=False)
        self._width = 0

    def __call__(self, progress: Progress) -> None:
        text = str(progress)
        if self._bar is not None:
            self._bar.set_description_str(text)
            return
        sys.stderr.write("\r" + text.ljust(self._width))
        sys.stderr.flush()
        self._width = len(text)

    def close(self) -> None:
        if self._bar is not None:
            self._bar.close()
        elif self._width:
            sys.stderr.write("\r" + " " * self._width + "\r")
            sys.stderr.flush()


class watched:
    """Around a call of the core: what it tells, as `progress` wants it."""

    def __init__(self, progress: ProgressLike) -> None:
        if progress is not None and not isinstance(progress, bool) and not callable(progress):
            raise TypeError(f"progress: takes True, False or a callable, not {type(progress).__name__}")
        self._progress = progress
        self._line: _Line | None = None

    def __enter__(self) -> Callable[..., Any] | None:
        if not self._progress:
            return None
        if callable(self._progress) and not isinstance(self._progress, bool):
            tell: Callable[[Progress], Any] = self._progress
        else:
            self._line = tell = _Line()
        return lambda *members: tell(Progress(*members))

    def __exit__(self, *_: object) -> None:
        if self._line is not None:
            self._line.close()


def thread_count(threads: int) -> int:
    if isinstance(threads, bool) or not hasattr(threads, "__index__"):
        raise TypeError(f"threads: takes a number, not {type(threads).__name__}")
    count = threads.__index__()
    if not 0 <= count <= 4096:
        raise ValueError(f"threads: {count} is not a number from 0 (as many as there are cores) to 4096")
    return count
