"""Ctrl-C ends a long call."""

from __future__ import annotations

import subprocess
import sys


def test_a_signal_ends_a_long_call() -> None:
    # It would take hours. In a process of its own, with which the work that was given up ends.
    program = """
import boundfit, random, signal
chance = random.Random(1)
x = [chance.random() for _ in range(1500)]
y = [chance.random() + own for own in x]
signal.signal(signal.SIGALRM, signal.default_int_handler)
signal.setitimer(signal.ITIMER_REAL, 0.2)
try:
    boundfit.outliers(x, y, "0.3", max_steps=10**15)
except KeyboardInterrupt:
    print(boundfit.fit([0, 1], [0, 1], 0).kind, flush=True)
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=120)
    assert (done.stdout, done.stderr) == ("point\n", "")
