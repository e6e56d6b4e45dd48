#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What every range of the rock's card changes in the main job: depth, hole, crushed rock.

    range_effects.py BARRENO [--card NAME] [--until TIME] [--study FOLDER] [--jobs N]    verification/results/range_effects.json,
                                                                                        and docs/materials/arenisca.md

Both ends of each range of a card of rock, one at a time, of perforation.xml with --fidelity fast; some minutes a run. --study keeps the
runs: what is there is taken as it is.
"""
import argparse
import json
import os
import pathlib
import sys
import tempfile

from tools import foreign_python  # noqa: F401
from tools.range_effects_table import OF_THE_JOB, STORED
from tools.runs import DECKS
from tools.write_pages import write_pages

import barreno
from barreno.runs.csv_table import WORDS, read_csv

KEPT = ("depth", "probed_depth", "channel_volume", "zones_in_body")
HELD = ("Materials/Tungsten", "Materials/Steel", "Jet", "Confinement")
MOST = 99  # runs: no range is left out


def answers_of(run):
    summary = json.loads((pathlib.Path(run["folder"]) / "summary.json").read_text())
    return {**{name: summary["penetration"][name] for name in KEPT}, "cpu_seconds": summary["cpu_seconds"]}


def measured(study):
    """{middle, and of each range both ends with its row in the card's table}"""
    record = json.loads((study / "uncertainty.json").read_text())
    given = read_csv(study / "ranges.csv", cells=WORDS).to_dict("records")
    middle, *ends = map(answers_of, record["runs"])
    assert len(ends) == 2 * len(given), f"{len(ends)} runs for {len(given)} ranges"
    rows = [{"parameter": row["parameter"].rpartition("/")[2], **{name: row[name] for name in ("low", "high", "known")},
        "at_low": ends[2 * i], "at_high": ends[2 * i + 1]} for i, row in enumerate(given)]
    return {"middle": middle, "rows": rows}


def keep(card, until, found):
    """Beside what is stored of other cards."""
    known = json.loads(STORED.read_text()) if STORED.exists() else {}
    STORED.write_text(json.dumps({**known, card: {"until": until, **found}}, indent=1) + "\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=pathlib.Path)
    parser.add_argument("--card", default=OF_THE_JOB, help="of materials/cards, without .xml; left out: that of the deck")
    parser.add_argument("--until", metavar="TIME", default="400 us", help='end of the runs, as "120 us"; left out: 400 us')
    parser.add_argument("--study", type=pathlib.Path, metavar="FOLDER")
    parser.add_argument("--jobs", type=int, metavar="N")
    options = parser.parse_args()
    os.environ["BARRENO_PROGRAM"] = str(options.barreno.resolve())
    with tempfile.TemporaryDirectory() as scratch:
        study = (options.study or pathlib.Path(scratch) / "study").resolve()
        entries = {"Materials/Sandstone/Card": f"{options.card}.xml", "Time/End Time": options.until}
        barreno.uncertainty(DECKS / "perforation.xml", fidelity="fast", design="one-at-a-time", runs=MOST, hold=HELD, jobs=options.jobs,
            out=study, set=entries)
        keep(options.card, options.until, measured(study))
    write_pages()
    return 0


if __name__ == "__main__":
    sys.exit(main())
