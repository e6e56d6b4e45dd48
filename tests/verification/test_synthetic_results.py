#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The study of synthetic fits fails where its results miss what is asked: misfit, time, coverage, words; and passes where they do not."""
import copy

from fits.synthetic_results import SETS, faults_of

NAMES = [f"P{k}" for k in range(10)]


def parameter(name, inside, width=0.2):
    return {"name": name, "truth": 1.0, "value": 1.05, "low": 0.9 if inside else 1.01, "high": 1.2, "width": width}


def sound_rows():
    """One in twenty ranges misses the truth."""
    return [
        {"set": k, "ratio": 0.98, "seconds": 30.0, "parameters": [parameter(name, (k + 2 * i) % 20 != 0) for i, name in enumerate(NAMES)]}
        for k in range(SETS)
    ]


def spoilt(change):
    rows = copy.deepcopy(sound_rows())
    change(rows)
    return faults_of(rows)


def miss(rows, name, every):
    for row in rows:
        for p in row["parameters"]:
            if name in (p["name"], "all") and row["set"] % every == 0:
                p["low"] = 1.01


def hold_all(rows):
    for row in rows:
        for p in row["parameters"]:
            p["low"] = 0.9


def main():
    assert faults_of(sound_rows()) == [], faults_of(sound_rows())
    cases = {
        "the misfit of set 3 is 1.03": lambda rows: rows[3].update(ratio=1.03),
        "set 5 takes 61.0 s": lambda rows: rows[5].update(seconds=61.0),
        "set 2 gives no card: refused": lambda rows: rows[2].update(ratio=None, said="refused", parameters=[]),
        "the ranges of P1 hold the truth in": lambda rows: miss(rows, "P1", 4),
        "the ranges of all hold the truth in": lambda rows: miss(rows, "all", 8),
        "the ranges of all hold the truth in 400 of 400": hold_all,
        "P0 of set 7 is called determined": lambda rows: rows[7]["parameters"][0].update(width=3.0),
        "P1 of set 7 is called": lambda rows: rows[7]["parameters"][1].update(low=None, high=None),
    }
    for sentence, change in cases.items():
        said = spoilt(change)
        assert any(sentence in fault for fault in said), f"{sentence}: {said}"
    print("the study fails where it should")


if __name__ == "__main__":
    main()
