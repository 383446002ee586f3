"""Shows on stderr how far an evaluation is.

A line that is rewritten on a terminal, elsewhere one for each scene and method. Troubles are lines
of their own.
"""
import sys
import time


class Progress:
    def __init__(self, total):
        self._total, self._done, self._failed = total, 0, 0
        self._start = time.monotonic()
        self._live = sys.stderr.isatty()
        self._last = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self._clear()

    def begin(self, scene, method, seed):
        text = (f"{self._done + 1}/{self._total}: {scene}, {method}, seed {seed}"
                f"{self._left()}; {self._failed} without a plan")
        if self._live:
            print(f"\r{text}\033[K", end="", file=sys.stderr, flush=True)
        elif (scene, method) != self._last:
            print(text, file=sys.stderr, flush=True)
        self._last = scene, method

    def end(self, status, trouble):
        self._done += 1
        self._failed += status != "solved"
        if trouble:
            self._clear()
            print(trouble, file=sys.stderr, flush=True)

    def _left(self):
        """Guessed from the runs so far."""
        if self._done == 0:
            return ""
        seconds = (time.monotonic() - self._start) / self._done * (self._total - self._done)
        return f"; about {seconds / 60:.0f} min left" if seconds >= 90 else \
            f"; about {seconds:.0f} s left"

    def _clear(self):
        if self._live:
            print("\r\033[K", end="", file=sys.stderr, flush=True)
