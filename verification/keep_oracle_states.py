#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Keep the answers of the Arenisca oracle that the cheap form of arenisca_against_oracle needs; those that still hold stay.

    keep_oracle_states.py

Needed after a change of the oracle or of the cheap form's rows: without it the test computes them, which takes minutes.
"""
import json

from tools import foreign_python  # noqa: F401

from cases.arenisca_against_oracle import KEPT, cheap_rows, digest_of, kept_answer


def main():
    if not KEPT.exists():
        KEPT.write_text("{}\n")
    kept = {}
    for name, _, rock, points in cheap_rows():
        kept[name] = {"of": digest_of(name, rock, points), "states": kept_answer(name, rock, points).tolist()}
    KEPT.write_text(json.dumps(kept, indent=1) + "\n")


if __name__ == "__main__":
    main()
