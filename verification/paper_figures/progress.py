# SPDX-License-Identifier: BSD-3-Clause
"""How far the figures are: runs that have ended and the time left, judged by what each figure took when it was made last."""
import threading
import time

from barreno.sweeps.compute import duration


class Progress:
    """@param expected  {figure: (runs, their processor time in s)}; a figure that is not in it makes the time left unknown
    @param numbers     figures that are made
    @param jobs        runs at a time"""

    def __init__(self, expected, numbers, jobs, say=print):
        known = bool(numbers) and all(number in expected for number in numbers)
        # Figures come one after the other, and a single run has one core.
        self.expected = {number: (count, cost / max(1.0, min(jobs, count)))
            for number, (count, cost) in expected.items() if number in numbers} if known else None
        self.rest = sum(cost for _, cost in self.expected.values()) if known else None  # [s] on the machine that it was made on last
        self.jobs, self.say, self.lock = jobs, say, threading.Lock()
        self.began, self.computed, self.number, self.ended = time.monotonic(), 0.0, None, 0

    def first_line(self):
        if self.expected is None:
            return "How long this takes is not known."
        runs = sum(count for count, _ in self.expected.values())
        return (
            f"{len(self.expected)} figures of {runs:.0f} runs: about {duration(self.left())} with {self.jobs} at a time if none is there "
            "already."
        )

    def begin(self, number):
        self.number, self.ended = number, 0

    def left(self):
        """[s] on this machine, from the pace of what was computed so far; None where it is not known."""
        if self.rest is None:
            return None
        pace = (time.monotonic() - self.began) / self.computed if self.computed else 1.0
        return self.rest * pace

    def run_ended(self, name, seconds, reused):
        with self.lock:
            self.ended += 1
            count, cost = self.expected[self.number] if self.expected else (0.0, 0.0)
            share = cost / count if count else 0.0
            if self.rest is not None:
                self.rest = max(0.0, self.rest - share)
                self.computed += 0.0 if reused else share
            of = f"/{count:.0f}" if count else ""
            how = "is there already" if reused else duration(seconds)
            left = f"; about {duration(self.left())} left" if self.rest else ""
            self.say(f"  [{self.ended}{of}] {name}: {how}{left}", flush=True)

    def figure_ended(self):
        """Time that its runs did not account for is no longer to come."""
        if self.expected:
            later = list(self.expected)[list(self.expected).index(self.number) + 1 :]
            self.rest = sum(self.expected[number][1] for number in later)

    def whole(self):
        return duration(time.monotonic() - self.began)
