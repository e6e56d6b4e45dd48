# SPDX-License-Identifier: BSD-3-Clause
"""What a fit says: tables, card, numbers; the picture is in picture.py."""

import json
import pathlib

import numpy

from barreno.fit import card as cards
from barreno.fit.kinds import DIMENSIONS, KINDS
from barreno.fit.parameters import PARAMETERS, shown
from barreno.fit.picture import draw
from barreno.fit.search import residuals_of

DIGITS = 6


def rounded(result):
    """The card with as many digits as it is written with."""
    out = dict(result.card)
    for name in [*result.values, "G0"]:
        out[name] = float(f"{out[name]:.{DIGITS}g}")
    return out


def misfit(test, name, model, residual):
    data = test.columns[name]
    # Of the largest value in a curve, of each value in a table.
    relative = (model - data) / (numpy.abs(data).max() if KINDS[test.kind].curve else data)
    rms = lambda values: float(numpy.sqrt((values**2).mean()))  # noqa: E731
    return {
        "file": test.file, "kind": test.kind, "confinement": test.confinement, "channel": name, "rows": test.rows,
        "rms": rms(model - data), "largest": float(numpy.abs(model - data).max()), "rms_relative": rms(relative),
        "largest_relative": float(numpy.abs(relative).max()), "rms_over_uncertainty": rms(residual),
        "scale": test.scales.get(name, 1.0),
    }  # fmt: skip


def summary(problem, result, tests, answers, start_name, version):
    """All numbers of a fit, SI, compression positive, strains logarithmic."""
    residuals = iter(residuals_of(tests, answers))
    out = {
        "version": version, "start": start_name, "cards_tried": problem.updates, "correlation": result.rho,
        "files": [{"file": t.file, "kind": t.kind, "sha256": t.digest, "source": t.source} for t in tests],
        "parameters": [], "misfits": [], "rows": [],
    }  # fmt: skip
    for name in result.values:
        low, high = result.ranges.get(name, (None, None))
        out["parameters"].append(
            {"name": name, "value": result.card[name], "low": low, "high": high, "start": problem.card({})[name],
             "open": result.left_open.get(name, "")}
        )  # fmt: skip
    out["fixed"] = problem.fixed
    for test, answer in zip(tests, answers):
        control = KINDS[test.kind].control
        for name in test.channels:
            r = next(residuals)
            out["misfits"].append(misfit(test, name, answer[name], r))
            for k in range(test.rows):
                out["rows"].append({
                    "file": test.file, "channel": name, "at": float(test.columns[control][k]) if control else None,
                    "data": float(test.columns[name][k]), "model": float(answer[name][k]),
                    "uncertainty": float(test.uncertainty[k]) * test.scales.get(name, 1.0), "source": test.labels[k],
                })  # fmt: skip
    return out


def value_of(name, value):
    if DIMENSIONS[name] == "stress":
        return f"{value / 1e6:.3g} MPa"
    return f"{100 * value:.3g} %" if DIMENSIONS[name] == "strain" else f"{value:.3g}"


def label_of(row):
    side = f", {row['confinement'] / 1e6:.4g} MPa" if row["kind"] == "triaxial" else ""
    return f"{pathlib.Path(row['file']).name} ({row['kind']}{side}, {row['channel']})"


def aligned(lines):
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return ["  ".join([line[0].ljust(widths[0]), *(cell.rjust(width) for cell, width in zip(line[1:], widths[1:]))]).rstrip()
        for line in lines]


def misfit_lines(summary):
    lines = [["test", "rows", "rms", "largest", "rms [%]", "largest [%]"]]
    for row in summary["misfits"]:
        lines.append([
            label_of(row), str(row["rows"]), value_of(row["channel"], row["rms"]), value_of(row["channel"], row["largest"]),
            f"{100 * row['rms_relative']:.2f}", f"{100 * row['largest_relative']:.2f}",
        ])  # fmt: skip
    return lines


def weight_lines(summary):
    """What was made of channels that scatter unlike."""
    parts = [f"{label_of(row)} {row['scale']:.2g}" for row in summary["misfits"] if row["scale"] != 1.0]
    return [f"The columns scatter unlike; each is weighed by its own scatter (over the common one: {'; '.join(parts)})."] if parts else []


def range_text(entry):
    return (
        f"{shown(entry['name'], entry['low'])} to {shown(entry['name'], entry['high'])}" if entry["low"] is not None else "not determined"
    )


def tables(summary, out):
    parameters = [["parameter", "value", "95 % range"]]
    for entry in summary["parameters"]:
        parameters.append([entry["name"], shown(entry["name"], entry["value"]), range_text(entry)])
    sentences = [entry["open"] for entry in summary["parameters"] if entry["open"]]
    sentences += [f"{name} is held at {shown(name, value) if name in PARAMETERS else f'{value:g}'}."
        for name, value in summary["fixed"].items()]
    return "\n".join([
        *aligned(misfit_lines(summary)), *weight_lines(summary), "", *aligned(parameters), *([""] if sentences else []), *sentences, "",
        f"Written: {out}, {out.with_suffix('.png')} (picture), {out.with_suffix('.json')} (all numbers).",
        f"Next: barreno drive --material {out} --path input_xml/paths/triaxial_berea.csv --out answer.csv",
    ])  # fmt: skip


def card_text(name, result, summary, tests):
    head = [f"Fitted by barreno fit {summary['version']} (docs/fit.md), start {pathlib.Path(summary['start']).name}. Behind parameters "
        "stand their 95 % ranges; the data, with the first digits of their SHA-256:"]
    for test in tests:
        rows = [row for row in summary["misfits"] if row["file"] == test.file]
        misfits = ", ".join(f"{row['channel']} {100 * row['rms_relative']:.2f} % rms" for row in rows)
        source = f" Source: {test.source}" if test.source else ""
        head.append(f"{pathlib.Path(test.file).name} ({test.kind}), {test.digest}; misfit {misfits}.{source}")
    about = {name: "held: given by the user or by the porosity of the data" for name in summary["fixed"]}
    if result.card.get("G1", 0.0) != 0.0 and "G0" not in summary["fixed"]:
        about["G0"] = "G0 = 1.5 B0 (1 - 2 G1)/(1 + G1), so that the modulus does not jump at zero pressure"
    for entry in summary["parameters"]:
        about[entry["name"]] = entry["open"] or f"{entry['name']}: {range_text(entry)}"
    return cards.written(name, result.card, head, about)


def as_json(summary):
    return json.dumps(summary, indent=1) + "\n"


__all__ = ["as_json", "card_text", "draw", "rounded", "summary", "tables"]
