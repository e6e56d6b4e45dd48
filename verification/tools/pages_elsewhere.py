# SPDX-License-Identifier: BSD-3-Clause
"""The rows of docs/verification.md for the measurements that have pages of their own."""
import json

from tools.demands import met
from tools.experiment import checks_of


def trade_row(data):
    held = sum(met(check["value"], check["limit"], check["at_least"]) for check in data["checks"])
    return (f"| [Error against cost for every option of a run](trade.md) | four problems | runs | | {len(data['points'])} | | "
            f"{held} of {len(data['checks'])} hold, {len(data['checks']) - held} open | [picture](pictures/trade_depth.png) |")  # fmt: skip


def predictions_row(data):
    ratio = {name: deck["seconds"]["predicted"] / deck["seconds"]["came"] for name, deck in data.items()}
    within = sum(abs(value - 1.0) <= 0.3 for value in ratio.values())
    name, worst = max(ratio.items(), key=lambda item: abs(item[1] - 1.0))
    return (f"| [`check` predicts the cost of a run](cost.md) | the run | predicted over actual seconds, largest deviation | {name} | "
        f"{worst:.2f} | 0.7 to 1.3 | "
            f"{within} of {len(data)} decks | |")  # fmt: skip


def extremes_row(rows):
    count = {verdict: sum(row["verdict"] == verdict for row in rows) for verdict in ("holds", "stops", "RED")}
    return ("| [Extreme inputs meet their criterion, or stop with a sentence that gives the reason](../verification/results/extremes.md) "
        "| one per row | | | | | "
            f"{count['holds']} hold, {count['stops']} stop, {count['RED']} open | |")  # fmt: skip


def validation_row(experiments):
    checks = [check for data in experiments.values() for check in checks_of(data)]
    held = sum(met(check["value"], check["limit"], check["at_least"]) for check in checks)
    shown = sum(len(data["rows"]) for data in experiments.values()) - len(checks)
    verdict = f"{held} of {len(checks)} hold, {len(checks) - held} fail, {shown} shown"
    return ("| [Runs with the shipped cards agree with experiments](validation.md) | measurements | one per quantity | | | | "
            f"{verdict} | [picture](pictures/validation_craters.png) |")  # fmt: skip


ROWS = {"extremes": extremes_row, "trade": trade_row, "predictions": predictions_row, "validation": validation_row}


def rows_elsewhere(results):
    for name, row in ROWS.items():
        stored = results / f"{name}.json"
        if stored.exists():
            yield row(json.loads(stored.read_text()))
