# SPDX-License-Identifier: BSD-3-Clause
"""The runs side by side, and what is said of them meanwhile."""

import shutil
import sys
import time

from barreno.runs.faults import Fault
from barreno.runs.make_runs import Making, finished_in, take_finished
from barreno.compare.results import DEPTH
from barreno.runs.run_folder import progress_of, read_summary, scalars_of

PAUSE = 0.1  # [s] between two looks at the runs
SILENCE = 60.0  # [s] after which progress is said where no terminal shows it
KNOWN_SHARE = 0.02  # of a run, from which on its time can be told


def duration(seconds):
    """With two digits, which is as much as can be known of time left."""
    value, unit = (seconds, "s") if seconds < 100.0 else (seconds / 60.0, "min") if seconds < 6000.0 else (seconds / 3600.0, "h")
    return f"{value:.2g} {unit}" if value < 10.0 else f"{value:.0f} {unit}"


class Clock:
    """When a run began, and how far it had come then."""

    def __init__(self, making):
        self.making, self.began = making, time.monotonic()
        self.first = progress_of(making.run.folder) if making.resumes else 0.0
        self.share = self.first

    def look(self):
        """Not in the first second, in which the log may still be that of an earlier run."""
        if self.passed() > 1.0:
            self.share = progress_of(self.making.run.folder)

    def passed(self):
        return time.monotonic() - self.began

    def whole(self):
        """Time of a run from its start to its end, None while that is unknown."""
        done = self.share - self.first
        return self.passed() / done if done > KNOWN_SHARE else None


def time_left(whole_times, clocks, waiting, jobs):
    """[s], None while nothing is known.  @param whole_times  of runs that have ended"""
    known = whole_times + [whole for whole in (clock.whole() for clock in clocks) if whole is not None]
    if not known:
        return None
    typical = sum(known) / len(known)
    rest = [(clock.whole() or typical) * (1.0 - clock.share) for clock in clocks]
    return max([0.0, *rest, (sum(rest) + waiting * typical) / jobs])


class Watch:
    """Lines of the screen: one for every run that ends, and on a terminal one that changes."""

    def __init__(self, total, jobs):
        self.total, self.jobs, self.ended = total, jobs, 0
        self.whole_times, self.terminal = [], sys.stdout.isatty()
        self.last = time.monotonic()

    def line(self, text):
        print(f"\r\033[K{text}" if self.terminal else text, flush=True)
        self.last = time.monotonic()

    def took(self, point, older):
        self.ended += 1
        self.line(f"[{self.ended}/{self.total}] {point.label}: finished run in {point.folder}{older}")

    def ends(self, clock, left):
        point = clock.making.run
        self.ended += 1
        self.line(f"[{self.ended}/{self.total}] {point.label}: {outcome(point)}, {duration(clock.passed())}{left_words(left)}")

    def tick(self, clocks, left):
        text = (
            f"{self.ended} of {self.total} ended, {len(clocks)} running "
            f"({', '.join(f'{100.0 * clock.share:.0f} %' for clock in clocks[:8])}){left_words(left)}"
        )
        if self.terminal:
            print(f"\r\033[K{text[: shutil.get_terminal_size().columns - 1]}", end="", flush=True)
        elif time.monotonic() - self.last > SILENCE:
            self.line(text)


def left_words(left):
    return "" if left is None or left == 0.0 else f"; about {duration(left)} left"


def outcome(point):
    if point.code:
        return "not finished"
    depth = scalars_of(read_summary(point.folder)).get(DEPTH)
    return "finished" if depth is None else f"depth {1e3 * depth:.2f} mm"


def take_all(program, points, places, took):
    """@return the points that are not there yet"""
    version = program.version()
    finished = finished_in(places, version)
    missing = []
    for point in points:
        if not take_finished(point, version, finished):
            missing.append(point)
            continue
        newer = program.is_newer_than(point.folder / "deck.xml")
        took(point, " (made before the program was built last; remove it if its answer has changed since)" if newer else "")
    return missing


def compute_all(program, points, places, jobs):
    """Every run that is not there, `jobs` of them at a time, until a signal asks for the end."""
    watch, version = Watch(len(points), jobs), program.version()
    waiting, clocks = take_all(program, points, places, watch.took), []
    while clocks or (waiting and not program.asked):
        while waiting and len(clocks) < jobs and not program.asked:
            clocks.append(Clock(Making(program, waiting.pop(0), version)))
        for clock in [clock for clock in clocks if clock.making.ended()]:
            clocks.remove(clock)
            if not clock.making.run.code:
                watch.whole_times.append(clock.passed() / max(KNOWN_SHARE, 1.0 - clock.first))
            watch.ends(clock, time_left(watch.whole_times, clocks, len(waiting), jobs))
        for clock in clocks:
            clock.look()
        if clocks:
            watch.tick(clocks, time_left(watch.whole_times, clocks, len(waiting), jobs))
            time.sleep(PAUSE)
    if watch.terminal:
        print("\r\033[K", end="", flush=True)


def refuse_interrupted(program, points):
    if program.asked and any(not point.how or point.code for point in points):
        there = sum(bool(point.how) and not point.code for point in points)
        raise Fault(f"interrupted with {there} of {len(points)} runs finished; the same command continues, and takes the finished runs as "
            "they are.", 128 + program.asked)


def say_failures(points):
    """@return exit code"""
    failed = [point for point in points if point.code]
    for point in failed:
        print(f"barreno: the run with {point.label} {point.failure()}", file=sys.stderr)
    return failed[0].failure_code() if failed else 0
