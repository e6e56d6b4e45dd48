#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Fits Berea sandstone with `barreno fit` and compares materials/cards/berea_sandstone.xml with the result.

    fit_berea.py [--out CARD.xml] [--document]

The data and the card that the fit starts from are in verification/fits/berea: every datum says where it comes from and how sure it is
(looked up in a stored copy of the source or in a text that quotes it; recalled from memory; assumed). The picture goes beside the card.
--document writes verification/results/berea_fit.json, from which docs/materials/berea_fit.md has its tables, and the picture of that page.
The library is that of BARRENO_LIBRARY, or of build/release.
"""

import argparse
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml

VERIFICATION = pathlib.Path(__file__).resolve().parents[1]
ROOT = VERIFICATION.parent
DATA = VERIFICATION / "fits" / "berea"
SHIPPED = ROOT / "materials" / "cards" / "berea_sandstone.xml"
STORED = VERIFICATION / "results" / "berea_fit.json"
PICTURE = ROOT / "docs" / "pictures" / "berea_fit.png"
LIBRARY = ROOT / "build" / "release" / "materials" / "libBARRENO.so"
# The slope at high pressure has no datum of this rock; the shear strength of shocked quartz rock is 0.6 to 1.4 GPa at 5 GPa.
HELD = ("YSLOPE=0.0724",)
LABELS = {
    "bulk_modulus": ("K at {at:.0f} MPa [GPa]", 1e9), "poissons_ratio": ("Poisson's ratio at {at:.0f} MPa", 1.0),
    "crush_pressure": ("P* at 20 % porosity [MPa]", 1e6), "open_pores": ("pore strain left at {at:.0f} MPa", 1.0),
    "triaxial": ("TXC peak at {at:.0f} MPa [MPa]", 1e6), "tensile_strength": ("uniaxial tension [MPa]", 1e6),
    "compaction": ("Q at P = {at:.0f} MPa, onset [MPa]", 1e6),
}  # fmt: skip
MEGA, GIGA = 1e6, 1e9
UNITS = {"PEAKI1": (MEGA, "MPa"), "STREN": (MEGA, "MPa"), "B0": (GIGA, "GPa"), "B1": (GIGA, "GPa"), "B2": (MEGA, "MPa"),
    "G0": (GIGA, "GPa"),
         "p0_crush_curve": (MEGA, "MPa"), "p1_crush_curve": (1e-9, "1/GPa")}  # fmt: skip


def fit(card):
    """Runs the fit; its numbers."""
    files = sorted(map(str, DATA.glob("*.csv")))
    held = [word for text in HELD for word in ("--fix", text)]
    words = [sys.executable, "-m", "barreno.fit", *files, "--start", str(DATA / "start.xml"), *held, "--out", str(card), "--name",
        "Berea Sandstone"]
    environment = {"BARRENO_LIBRARY": str(LIBRARY), **os.environ}
    subprocess.run(words, env=environment, check=True)
    return json.loads(card.with_suffix(".json").read_text())


def shipped_values():
    return {entry.get("name"): entry.get("value") for entry in xml.parse(SHIPPED).getroot().iter("Parameter")}


def shipped_answers(files):
    """{(file, row of the file): answer} of the shipped card in the same tests."""
    os.environ.setdefault("BARRENO_LIBRARY", str(LIBRARY))
    from barreno.fit import card, data
    from barreno.fit.answers import Laboratory
    from barreno.fit.specimens import opened
    from barreno.materials import load

    tests = [data.read_test(file) for file in files]
    with opened(card.in_a_test(card.read(str(SHIPPED)), Tolerance=card.TOLERANCE), load()) as rock:
        answers = Laboratory(tests).answers(rock)
    return {(test.file, k): float(answer[test.channels[0]][k]) for test, answer in zip(tests, answers) for k in range(test.rows)}


def to_store(numbers):
    """What the page needs: rows of label, datum, answer of the shipped card, of the fit, uncertainty, source; parameters of shipped card,
    fit and range."""
    rows, seen = [], {}
    of_shipped = shipped_answers([file["file"] for file in numbers["files"]])
    for row in numbers["rows"]:
        seen[row["file"]] = seen.get(row["file"], -1) + 1
        name = pathlib.Path(row["file"]).stem
        label, scale = LABELS[name.split("_")[0] if name.startswith(("triaxial", "compaction")) else row["channel"]]
        at = (row["at"] or 0.0) / MEGA
        rows.append([label.format(at=at), row["data"] / scale, of_shipped[row["file"], seen[row["file"]]] / scale, row["model"] / scale,
            row["uncertainty"], row["source"]])
    shipped = shipped_values()
    parameters = []
    for entry in numbers["parameters"]:
        scale, unit = UNITS.get(entry["name"], (1.0, ""))
        values = [float(shipped[entry["name"]]), entry["value"], entry["low"], entry["high"]]
        parameters.append([entry["name"], unit, *(None if value is None else value / scale for value in values), entry["open"]])
    return {"rows": rows, "parameters": parameters}


def stored_part():
    """Lines of the page."""
    stored = json.loads(STORED.read_text())
    lines = ["| quantity | data | shipped card | misfit | this fit | misfit | uncertainty | source |", "|---|---|---|---|---|---|---|---|"]
    for label, data, shipped, value, sigma, source in stored["rows"]:
        misfits = [f"{100 * (model / data - 1):+.0f} %" for model in (shipped, value)]
        lines.append(f"| {label} | {data:.4g} | {shipped:.4g} | {misfits[0]} | {value:.4g} | {misfits[1]} | {100 * sigma:.0f} % | {source} "
            "|")
    roots = [math.sqrt(sum((math.log(row[k] / row[1]) / row[4]) ** 2 for row in stored["rows"]) / len(stored["rows"])) for k in (2, 3)]
    lines += ["", f"Root mean square of misfit over uncertainty: {roots[0]:.3f} of the shipped card, {roots[1]:.3f} of this fit "
        f"({len(stored['rows'])} data)", ""]
    lines += ["| parameter | unit | shipped card | this fit | difference | 95 % range |", "|---|---|---|---|---|---|"]
    for name, unit, shipped, value, low, high, _ in stored["parameters"]:
        interval = f"{low:.4g} to {high:.4g}" if low is not None else "not determined"
        lines.append(f"| {name} | {unit} | {shipped:.4g} | {value:.4g} | {100 * (value / shipped - 1):+.1f} % | {interval} |")
    return lines + [""] + [f"- {entry[-1]}" for entry in stored["parameters"] if entry[-1]]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--out", type=pathlib.Path, help="the card (default: nowhere)")
    parser.add_argument("--document", action="store_true")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as scratch:
        card = options.out or pathlib.Path(scratch) / "berea.xml"
        numbers = fit(card)
        if options.document:
            from tools.write_pages import write_pages

            STORED.write_text(json.dumps(to_store(numbers), indent=1) + "\n")
            shutil.copy(card.with_suffix(".png"), PICTURE)
            write_pages()


if __name__ == "__main__":
    main()
