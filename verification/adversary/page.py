#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""docs/adversary.md from verification/results/adversary.json.

    page.py           writes the page
    page.py --check   exit code 1 if the page is another one
"""
import json
import pathlib
import sys

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

from tools.wrap_text import wrapped

ROOT = pathlib.Path(__file__).resolve().parents[2]
RESULTS = ROOT / "verification" / "results" / "adversary.json"
PAGE = ROOT / "docs" / "adversary.md"

HEAD = """# The adversary

Written by `verification/adversary/page.py` from `verification/results/adversary.json`; do not edit.

`verification/adversary/attack.py BUILD` tries to break runs. Every test run includes its short form (`ctest -R verification.adversary`).
`ctest -R slow.adversary` is the long form; `--out FILE` adds to the counts of earlier invocations.

- **Option sets.** A set is a shipped deck, at a size that runs in a twentieth of a second, with options drawn at random. The draw follows the kind, unit
  and bounds that `barreno describe --markdown` gives, so new options are included automatically. Where `check` refuses a change with one sentence that
  names it, the change is undone, until the deck is valid. The set is then run. Some sets are also repeated in part:
  killed by SIGKILL, SIGTERM, SIGINT, SIGHUP or SIGUSR1 and resumed, up to five times; run on two or three ranks, and resumed there from one; run
  by two processes that compete for one folder; killed with mpirun's process group and resumed at once; run under the address and
  undefined-behaviour sanitizers with every index checked.
- **Odd numbers.** Every number of every shipped deck, one at a time, as 1e300, 1e-300, -0, 5e-324, 2^31, 2^63, -1, 0, nan and inf.
- **Forged checkpoints.** Every table of a checkpoint with values that no state can have, with a wrong number of rows or columns, of a wrong type, or
  missing, under a valid seal.
- **Perforations.** A small perforation with a fidelity (fast, balanced) or with Subcycles, a kind of jet and Return Losses, each drawn at random. Three
  of its runs are killed and resumed. In some trials a disk fails: the n-th write, fsync, rename or open gets ENOSPC, EIO, EDQUOT or a short write, once
  or from then on (`verification/tools/full_disk.c`, preloaded). The run is then resumed on a sound disk. Some runs are resumed on another number of ranks.

Most kills are placed at a checkpoint (`verification/tools/kill_at.c`, preloaded); a few come at a random time. The checkpoint is drawn at random. The
signal comes while the next checkpoint is written, before a random call (open, write, fsync, rename), or once the checkpoint has its name, at once or
a short time later. If too many of the placed kills miss a running program that has a checkpoint, `attack.py` says so and ends with exit code 1.

These are findings:

- a crash by a signal, a sanitizer error, an internal error, or a hang;
- a refusal that is not one sentence;
- a result that is not a finite number, or mass that appears or vanishes;
- files that differ from the files of the uninterrupted run: every table, every field of particles.e and of the checkpoint, and the balances in the
  summary, bit for bit (with pore flow to 1e-5 of the largest value of a field);
- a checkpoint that the program wrote and refuses;
- exit code 0 or "Finished" after a failed write that lost something;
- numerical errors (stress integration, transfer) above 10 % of the energy put in without a warning.

About an hour on two cores tries 3,000 sets and kills 1,500 perforations:

    ./barreno python verification/adversary/attack.py BUILD --seed N --sets 3000 --perforations 300 --out verification/results/adversary.json
    ./barreno python verification/adversary/page.py

"""

ROWS = (
    ("option sets", "sets"), ("valid", "accepted"), ("not run, because a fidelity made it large", "too large"), ("finished", "finished"),
    ("ended with a reason (exit 3)", "stopped with a reason"),
    ("changes that were refused and undone", "refused"), ("run under sanitizers", "under sanitizers"), ("kills", "kills"),
    ("of these before the first checkpoint", "killed before the first checkpoint"),
    ("of these after the end of the run", "kills that came too late"),
    ("of these placed at a checkpoint", "kills placed at a checkpoint"),
    ("placed kills that met a running program with a checkpoint", "kills placed at a checkpoint that met one"),
    ("killed, resumed and identical", "killed, resumed and the same"),
    ("killed, resumed on more ranks and identical", "killed, resumed on more ranks and the same"),
    ("process groups killed, resumed at once and identical", "process group killed, resumed at once and the same"),
    ("identical on two or three ranks", "the same on more ranks"), ("two processes on one folder", "two processes on one folder"),
    ("odd numbers in decks", "odd numbers"), ("of these refused with a sentence", "odd numbers refused"),
    ("forged checkpoints", "forged checkpoints"),
    ("of these refused with a sentence that names the table", "forged: refused"),
    ("of these with an identical run", "forged: the same run"),
    ("perforations with fidelities and kinds of jet", "perforations with fidelities"), ("kills of perforations", "kills of perforations"),
    ("kills of perforations placed at a checkpoint", "kills of perforations placed at a checkpoint"),
    ("placed kills of perforations that met a running program with a checkpoint",
        "kills of perforations placed at a checkpoint that met one"),
    ("perforations killed, resumed and identical", "perforations killed, resumed and the same"),
    ("perforations resumed on other ranks and identical", "perforations resumed on other ranks and the same"),
    ("disks that failed", "disk faults"), ("of these ended with a sentence", "disk faults: ended with a sentence"),
    ("of these resumed and identical", "disk faults: resumed and the same"),
)


def share_met(counts):
    """A sentence on kills that are placed at checkpoints, if there are any."""
    placed, met = (counts.get(name, 0) for name in ("kills placed at a checkpoint", "kills placed at a checkpoint that met one"))
    if not placed:
        return ""
    return (
        f"\nOf the kills placed at a checkpoint {100.0 * met / placed:.0f} % met a running program that had one. Kills of earlier "
        "invocations came at random times.\n"
    )


def text(results):
    counts = results["counts"]
    page = HEAD + "| quantity | number |\n|---|---|\n"
    page += "".join(f"| {said} | {counts.get(name, 0)} |\n" for said, name in ROWS)
    page += (
        f"| shipped decks among them | {len(results['decks'])} |\n| options among them | {len(results['drawn'])} |\n| open findings | "
        f"{len(results['findings'])} |\n"
    )
    page += share_met(counts)
    seeds = ", ".join(f"{seed} ({sets} sets)" for seed, sets in sorted(results["sets"].items(), key=lambda item: int(item[0])))
    shots = ", ".join(f"{seed} ({number})"
        for seed, number in sorted(results.get("perforations", {}).items(), key=lambda item: int(item[0])))
    page += f"\nSeeds: {seeds}{'; perforations: ' + shots if shots else ''}. `attack.py BUILD --only SEED:NUMBER` repeats one set.\n"
    for finding in results["findings"]:
        page += f"\n- {finding['kind']} {finding['number']}: {finding['said'].splitlines()[0][:300]}"
    return page + ("\n" if results["findings"] else "")


def main():
    page = wrapped(text(json.loads(RESULTS.read_text())))
    if sys.argv[1:] == ["--check"]:
        if PAGE.read_text() != page:
            print("docs/adversary.md does not match verification/results/adversary.json; write it with verification/adversary/page.py")
            return 1
        return 0
    PAGE.write_text(page)
    return 0


if __name__ == "__main__":
    sys.exit(main())
