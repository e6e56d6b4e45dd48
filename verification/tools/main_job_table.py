# SPDX-License-Identifier: BSD-3-Clause
"""The table of README.md: what the main job answers, beside the shot to 120 us that came before it."""
import json

from tools.case_list import RESULTS
from tools.verification_pages import table

BEFORE, MAIN = "perforation_120us.xml", "perforation.xml"


def with_interval(value, error, digits, unit=""):
    """A number, and where it lies by its measured error."""
    write = lambda number: f"{number:.{digits}f}"  # noqa: E731
    if not error or "unknown" in error:
        return write(value) + unit, "unknown"
    return write(value) + unit, f"{write(value / (1.0 + error['high']))} to {write(value / (1.0 + error['low']))}{unit}"


def least_certain(one):
    """What the ranges of the rock's card change, over the depth and the volume."""
    found = one.get("least_certain", {}).get("range_of", {})
    ends = sorted({at["until"] for at in found.values() if "until" in at})
    return "; ".join(
        f"{name}, which changes the depth by {100 * at['depth']['at_low']:+.0f} to {100 * at['depth']['at_high']:+.0f} %, the volume by "
        f"{100 * at['channel_volume']['at_low']:+.0f} to {100 * at['channel_volume']['at_high']:+.0f} %"
        for name, at in found.items()
    ) + (f" (runs to {' and '.join(ends)})" if ends else "") or "not measured"  # fmt: skip


def zones(one):
    """What has become of the rock half-way down."""
    found = one["zones_in_body"]["Rock"]
    crushed = f"crushed from {1e3 * found['crushed_from']:.1f} to {1e3 * found['crushed_to']:.1f} mm from the axis"
    return crushed, f"{found['skin']:.1f}"


def answers(one, varied):
    """@param varied  what a study of its ranges says"""
    crushed, skin = zones(one)
    entrance = one["entrance_diameter_in_body"]
    return [
        *with_interval(1e3 * one["probed_depth"], one.get("probed_depth_error"), 0, " mm"),
        *with_interval(1e3 * one["depth"], one.get("depth_error"), 0, " mm"),
        f"{1e3 * entrance['Casing']:.1f} and {1e3 * entrance['Rock']:.1f} mm",
        *with_interval(1e6 * one["channel_volume"], one.get("channel_volume_error"), 1, " cm3"),
        crushed, skin, *with_interval(one["efficiency"], one.get("core_flow_efficiency_error"), 2),
        f"{100.0 * one['lost']:.1f} %", least_certain(one), varied,
        f"{one['seconds']:.0f} s, {1e-6 * one['bytes']:.0f} MB",
    ]  # fmt: skip


SPREAD = (("probed depth", "as wide as the jet", 1e3, 0, " mm"), ("volume of the hole", "volume", 1e6, 1, " cm3"),
    ("core flow efficiency", "core flow efficiency", 1.0, 2, ""))  # fmt: skip


def spread():
    """What the ranges of all inputs make of the answers, with the error of the cells (uncertainty_examples.py)."""
    study = json.loads((RESULTS / "uncertainty.json").read_text())
    of_words, said = {answer["words"]: answer for answer in study["answers"].values()}, []
    for words, short, factor, digits, unit in SPREAD:
        found = of_words[words]
        low, high = (f"{factor * (found['with_cells'] or found['ranges'])[end]:.{digits}f}" for end in ("low", "high"))
        said.append(f"{short} {low} to {high}{unit}{'' if found['with_cells'] else ' without the error of the cells'}")
    return f"{', '.join(said)} ({study['runs']} runs of *fast* to 400 us, docs/uncertainty.md)"


QUESTIONS = (
    "how deep: as wide as the jet's widest slug", "its interval, by the cells",
    "how deep: the tip of the thread behind", "its interval, by the cells",
    "what hole: entrance in the casing and in the rock", "what hole: volume", "its interval, by the cells", "how damaged: half-way down",
    "how much it flows: skin there", "how much it flows: core flow efficiency of the whole hole, fed from its side",
    "its interval, by the cells",
    "how sure: energy lost by the method", "how sure: least certain of the rock",
    "how sure: 90 % of cases within the ranges of rock, metals, jet and pressures, and with the error of the cells",
    "time and memory, two ranks",
)  # fmt: skip


def lines():
    found = json.loads((RESULTS / "main_job.json").read_text())
    columns = [answers(found[deck], varied) for deck, varied in ((MAIN, spread()), (BEFORE, "not measured"))]
    ends = [f"{1e6 * found[deck]['end']:.0f} us" for deck in (MAIN, BEFORE)]
    rests = " (at rest)" if found[MAIN]["rest"]["at_rest"] else ""
    head = ["question", f"main job, to {ends[0]}{rests}", f"`{BEFORE}`, to {ends[1]}"]
    return table(head, [list(row) for row in zip(QUESTIONS, *columns)])
