# SPDX-License-Identifier: BSD-3-Clause
"""The rows of docs/verification.md for the measurements that have pages of their own."""
import json

from demands import met


def trade_row(data):
    held = sum(met(check["value"], check["limit"], check["at_least"]) for check in data["checks"])
    return (f"| [Error against cost for every option of a run](trade.md) | four problems | {len(data['points'])} runs | | {held} of {len(data['checks'])} hold, "
            f"{len(data['checks']) - held} open | [picture](pictures/trade_depth.png) |")  # fmt: skip


def predictions_row(data):
    ratio = {name: deck["seconds"]["predicted"] / deck["seconds"]["came"] for name, deck in data.items()}
    within = sum(abs(value - 1.0) <= 0.3 for value in ratio.values())
    name, worst = max(ratio.items(), key=lambda item: abs(item[1] - 1.0))
    return (f"| [`check` predicts the cost of a run](cost.md) | the run | {name}, largest deviation: predicted over actual seconds {worst:.2f} | 0.7 to 1.3 | "
            f"{within} of {len(data)} decks | |")  # fmt: skip


def extremes_row(rows):
    count = {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in ("holds", "stops", "RED")}
    return (f"| [Extremes: every row meets its criterion or stops with a sentence that gives the reason](../verification/results/extremes.md) | one per row | | | {count['holds']} hold, "
            f"{count['stops']} stop, {count['RED']} open | |")  # fmt: skip


ROWS = {"extremes": extremes_row, "trade": trade_row, "predictions": predictions_row}


def rows_elsewhere(results):
    for name, row in ROWS.items():
        stored = results / f"{name}.json"
        if stored.exists():
            yield row(json.loads(stored.read_text()))
