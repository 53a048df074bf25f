"""Ctrl-C ends a long call, and a fork does not make one."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest


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


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no process forks here")
def test_a_forked_process_answers_after_its_parent_used_all_threads(tmp_path: Path) -> None:
    # Two chunks of a file at least, which several threads read.
    (tmp_path / "long.csv").write_text("x,y\n" + "".join(f"{row},{row % 7}\n" for row in range(300_000)))
    program = """
import boundfit, os, signal
here = boundfit.fit_file("long.csv", x="x", y="y", eps=100).vertices
if os.fork() == 0:
    signal.alarm(100)
    os._exit(0 if boundfit.fit_file("long.csv", x="x", y="y", eps=100).vertices == here else 1)
print(os.waitstatus_to_exitcode(os.wait()[1]))
"""
    done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True, timeout=200, cwd=tmp_path)
    assert done.stdout == "0\n", done.stderr
