# SPDX-License-Identifier: BSD-3-Clause
"""What docs/verification.md says of the measurements that have pages of their own."""
import collections
import json

from trade_page import fidelity_section


def trade_section(data):
    held = sum(check["passed"] for check in data["checks"])
    table = fidelity_section(data).split("Error (and cost", 1)[1]
    return (f"## The trade between error and cost\n\n`verification/trade.py BARRENO --document`: every knob of a run on four problems, {len(data['points'])} runs, "
            f"with tables and\npictures in [trade.md](trade.md). {held} of {len(data['checks'])} demands hold. Error (and cost{table}")  # fmt: skip


def predictions_section(data):
    within = sum(abs(deck["seconds"] - 1.0) <= 0.3 for deck in data.values())
    worst = max(data.items(), key=lambda item: abs(item[1]["seconds"] - 1.0))
    return (f"## What `check` predicts\n\n`verification/predictions.py BARRENO --document`, table in [cost.md](cost.md): of {len(data)} shipped decks {within} take "
            f"the predicted time of\none core to within 30 %; the worst is {worst[0]}.xml with {worst[1]['seconds']:.2f} of it.\n")  # fmt: skip


def extremes_section(rows):
    """Counts by extreme, and all that is red with its reason."""
    verdicts = collections.defaultdict(collections.Counter)
    for row in rows:
        verdicts[row["extreme"]][row["verdict"]] += 1
    lines = ["## Extremes", "", "`verification/extremes.py BARRENO --full --document`, every row in [extremes.md](extremes.md).", "",
             "| extreme | holds | stops with its sentence | red |", "|---|---|---|---|"]  # fmt: skip
    lines += [f"| {extreme} | {count['holds']} | {count['stops']} | {count['RED']} |" for extreme, count in verdicts.items()]
    total = sum(verdicts.values(), collections.Counter())
    lines += [f"| all {len(rows)} | {total['holds']} | {total['stops']} | {total['RED']} |", "", "Red:", ""]
    lines += [f"- {row['extreme']}: {row['setup']}: {row['criterion']}: {row['found']}: {row['note']}" for row in rows if row["verdict"] == "RED"]
    return "\n".join(lines) + "\n"


SECTIONS = {"trade": trade_section, "predictions": predictions_section, "extremes": extremes_section}


def sections(results):
    for name, section in SECTIONS.items():
        stored = results / f"{name}.json"
        if stored.exists():
            yield section(json.loads(stored.read_text()))
