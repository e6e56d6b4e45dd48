# SPDX-License-Identifier: BSD-3-Clause
"""What comes back: lines of the screen, converge.csv, converge.json, a picture, and the interval in the summaries of the runs."""

import csv
import io
import json
import math
import os

from barreno.converge import order
from barreno.runs.run_folder import read_summary
from barreno.runs.tables import aligned, number, place

METHOD = (
    "Grid Convergence Index of the three smallest cells, with the observed order and a safety factor of 1.25, or where the observed order "
    "is above "
    "the formal one with that and a factor of 3 (Roache, J. Fluids Eng. 116, 405, 1994; Celik et al., J. Fluids Eng. 130, 078001, 2008)"
)


def interval_text(verdict):
    """With as many digits as tell its ends apart."""
    width, size = verdict.high - verdict.low, max(abs(verdict.low), abs(verdict.high))
    digits = 3 if width == 0.0 or size == 0.0 else max(3, min(12, 3 + math.ceil(math.log10(size / width))))
    return f"{number(verdict.low, digits)} to {number(verdict.high, digits)}"


def table(name, levels, rows):
    """Lines of the screen; lengths in m, times in s."""
    heads = ["time [s]", *(level.name() for level in levels), "order", "extrapolated", "interval"]
    body = []
    for time, values, verdict in rows:
        body.append([number(time, 4), *(number(value) for value in values), number(verdict.order, 3), number(verdict.limit),
            interval_text(verdict)])
    return "\n".join([f"{name} with cells of", *aligned([heads, *body])])


def remarks(rows, formal):
    """One sentence for every reason not to extrapolate, with its times."""
    times = {}
    for time, _, verdict in rows:
        said = order.sentence(verdict, formal)
        if said:
            times.setdefault(said, []).append(f"{time:.4g}")
    return [f"At {', '.join(when)} s {said}." for said, when in times.items()]


def offer(settings):
    """What one more level, of smaller cells, takes.  @param settings  of the smallest cells so far, which then are the middle ones"""
    words = " ".join(f'--set "{setting}"' for setting in settings)
    return (
        f"The same command with {words} adds a level of smaller cells, whose run takes about eight times as long, and leaves the largest "
        "out."
    )


def measured_error(quantity, finest):
    """What cells of that size were measured to do to a depth, which needs no order, or why that is unknown; empty without a jet."""
    error = read_summary(finest.folder).get("penetration", {}).get("depth_error", {}) if quantity.name == "depth" else {}
    if "unknown" in error:
        return (f"Error of the depth at the end with the smallest cells: unknown ({error['unknown']}); "
                "the interval above counts these levels alone, so give it no level of confidence.")  # fmt: skip
    if "value" not in error:
        return ""
    return (f"Error of the depth at the end with the smallest cells, which are {error['cells_per_radius']:.2g} per jet radius: "
        f"{error_text(error)}, "
            f"{error['source']}.")  # fmt: skip


def error_text(error):
    """-14 % (-15 to -3 %)"""
    percent = lambda share: f"{round(100.0 * share):+d}" if round(100.0 * share) else "0"  # noqa: E731
    return f"{percent(error['value'])} % ({percent(error['low'])} to {percent(error['high'])} %)"


def unknown_text(error):
    """unknown (why); what to do"""
    return "; ".join([f"unknown ({error['unknown']})", *([error["advice"]] if "advice" in error else [])])


def as_csv(name, levels, rows):
    out = io.StringIO()
    out.write(f"# SI units; {name} by cell size; low and high: the interval; {METHOD}\n")
    writer = csv.writer(out, lineterminator="\n")
    writer.writerow(["time", *(f"cells_{level.cells:.6g}" for level in levels), "order", "extrapolated", "low", "high", "verdict"])
    for time, values, verdict in rows:
        cells = [verdict.order, verdict.limit, verdict.low, verdict.high]
        writer.writerow([repr(time), *map(repr, values), *("" if value is None else repr(value) for value in cells), verdict.kind])
    return out.getvalue()


def as_json(deck, name, levels, rows, formal):
    finite = lambda value: value if value is None or abs(value) < float("inf") else None  # noqa: E731
    results = []
    for time, values, verdict in rows:
        results.append({
            "time": time, "values": values, "verdict": verdict.kind, "order": finite(verdict.order), "order_used": verdict.order_used,
            "extrapolated": verdict.limit, "low": verdict.low, "high": verdict.high, "why": order.sentence(verdict, formal),
        })  # fmt: skip
    runs = [{"cells": level.cells, "refined_to": level.refined_to(), "folder": str(level.folder), "how": level.how} for level in levels]
    return json.dumps({"deck": str(deck), "quantity": name, "formal_order": formal, "method": METHOD, "levels": runs, "results": results},
        indent=1) + "\n"


def note_in_summaries(levels, verdict, file):
    """The depth of a run stands with its interval from now on: in summary.json, and so in its report."""
    for level in levels:
        summary = read_summary(level.folder)
        if not isinstance(summary.get("penetration"), dict):
            continue
        summary["penetration"]["convergence"] = {
            "cells": [one.cells for one in levels], "low": verdict.low, "high": verdict.high, "extrapolated": verdict.limit,
            "order": verdict.order if verdict.limit is not None else None, "verdict": verdict.kind,
            "file": os.path.relpath(file, level.folder),
        }  # fmt: skip
        place(level.folder / "summary.json", json.dumps(summary, indent=2, ensure_ascii=False) + "\n")
