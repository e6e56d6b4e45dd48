# SPDX-License-Identifier: BSD-3-Clause
"""The command: its words, the runs, and what is written of them."""

import json
import pathlib
import re
import sys

from barreno.compare.differences import against, as_csv, deck_differences, decks_as_csv, quantities_of, shortened
from barreno.runs.faults import FILE, Fault, exit_code, printable
from barreno.compare.results import finished_row, write_results
from barreno.runs.run_folder import deck_in
from barreno.runs.tables import aligned, make_folder, number, place
from barreno.runs.words import Words

EXAMPLE = "write for example barreno compare runs/perforation-1 runs/perforation-2"
RECORD = "compare.json"
SHOWN = (
    re.compile(
        r"penetration\.(depth|through_since|channel_depth|probed_depth|probed_volume|channel_radius_mid|channel_volume)|"
        r"penetration\.(jet_mass_inside|tip_velocity)|"
        r"penetration\.(channel_depth|entrance_diameter)_in_body\..+|"
        r"penetration\.zones_in_body\..+\.(radius|crushed_to|dilated_to|skin)|"
        r"balances\.energy\.(kinetic|elastic|plastic|viscous|error)|"
        r"time|steps|particle_steps|wall_seconds|peak_resident_bytes")
)  # fmt: skip


def parse(words):
    parser = Words(
        "compare",
        EXAMPLE,
        "sweep.md",
        description="Runs side by side: what their decks and results differ in, curves and channels (docs/sweep.md).",
        epilog="Example:\n  barreno compare runs/perforation-1 runs/perforation-2\n\nExit codes: 0 compared, 1 bad arguments, 2 file, 4 "
            "internal.",
    )
    parser.add_argument("runs", nargs="*", metavar="RUN", help="folders of runs; differences are those from the first")
    parser.add_argument("--out", metavar="FOLDER", help="folder of the results (default runs/FIRST-compare)")
    options = parser.parse_args(words)
    options.runs = [pathlib.Path(run) for run in options.runs]
    return options


def check_runs(runs):
    if len(runs) < 2:
        raise Fault(f"compare needs two runs or more, and there {'is one' if runs else 'are none'}; {EXAMPLE}.")
    for i, run in enumerate(runs):
        if not run.is_dir():
            raise Fault(f"{run} is not a folder (compare reads what runs wrote into theirs); check the path.", FILE)
        if any(run.resolve() == other.resolve() for other in runs[:i]):
            raise Fault(f"{run} is given twice (there is nothing to compare a run with itself for); leave it out once.")
        if deck_in(run) is None:
            raise Fault(f"{run} is not the folder of a run (it has no readable deck.xml); give folders that barreno run has written.", FILE)
        if not (run / "summary.json").exists():
            raise Fault(f"{run} has no summary.json (its run goes on, or was killed); wait for it, or continue it with barreno resume "
                f"{run}.", FILE)


def labels_of(runs):
    """Names of the folders, or as much of their paths as tells them apart."""
    for parts in (1, 2, 3):
        names = ["/".join(run.resolve().parts[-parts:]) for run in runs]
        if len(set(names)) == len(names):
            break
    else:
        names = [str(run.resolve()) for run in runs]
    return [printable(name) for name in names]


def out_folder(options, labels):
    out = pathlib.Path(options.out) if options.out else pathlib.Path("runs") / f"{labels[0].replace('/', '-')}-compare"
    if out.exists() and not out.is_dir():
        raise Fault(f"--out {out} is a file (the results need a folder); name another one.", FILE)
    held = sorted(file.name for file in out.iterdir()) if out.exists() else []
    if held and RECORD not in held:
        raise Fault(f"--out {out} holds something else ({', '.join(held[:3])}{', ...' if len(held) > 3 else ''}, and no {RECORD}); name "
            "another folder.", FILE)
    return out


def deck_lines(labels, differences):
    if not differences:
        return ["The decks are the same."]
    rows = [["decks differ in", *labels], *([printable(path), *map(printable, shortened(values))] for path, values in differences.items())]
    return aligned(rows)


def result_lines(labels, quantities):
    """What is worth a look; all numbers are in differences.csv."""
    heads = ["SI", labels[0], *(head for label in labels[1:] for head in (label, "difference", "%"))]
    rows = [heads]
    for name, (first, *others) in quantities:
        if not SHOWN.fullmatch(name):
            continue
        cells = [cell for other in others for cell in (number(other), *(number(part, 3) for part in against(first, other)))]
        rows.append([name, number(first), *cells])
    return aligned(rows)


def unfinished_lines(rows):
    return [f"{row.label} has not finished: it ended at {row.scalars.get('time', 0.0):.4g} s "
        f"({printable(row.scalars.get('reason') or 'no reason given')})." for row in rows if row.scalars.get("finished") is not True]


def write(out, options, labels, rows, differences, quantities):
    """@return names of the files, and remarks"""
    make_folder(out)
    place(out / RECORD, json.dumps({"runs": list(map(str, options.runs))}, indent=1, ensure_ascii=False) + "\n")
    place(out / "differences.csv", as_csv(labels, quantities))
    place(out / "decks.csv", decks_as_csv(labels, differences))
    files, remarks = write_results(out, list(differences), rows)
    return ["differences.csv", "decks.csv", *files], remarks


def run(words):
    options = parse(words)
    check_runs(options.runs)
    labels = labels_of(options.runs)
    out = out_folder(options, labels)
    differences = deck_differences(options.runs)
    columns = [shortened(values) for values in differences.values()]
    rows = [finished_row(label, folder, [column[i] for column in columns]) for i, (label, folder) in enumerate(zip(labels, options.runs))]
    quantities = quantities_of(rows)
    files, remarks = write(out, options, labels, rows, differences, quantities)
    for line in [*deck_lines(labels, differences), "", *result_lines(labels, quantities), *unfinished_lines(rows), *remarks]:
        print(line)
    print(f"Written to {out}: {', '.join(files)}")
    return 0


def main(words=None):
    return exit_code(run, sys.argv[1:] if words is None else words)
