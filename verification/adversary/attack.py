#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What tries to break a run (docs/adversary.md): random valid option sets over the shipped decks, straight, killed and
resumed, on one to three ranks, by two processes and under sanitizers; odd numbers in decks; forged checkpoints.

    attack.py BUILD [--sets N] [--odd-numbers N] [--forgeries N] [--perforations N] [--seed S] [--jobs J] [--out results.json]
    attack.py BUILD --only SEED:NUMBER

BUILD is the build folder. With --out what is found is added to what is there already: a seed goes on behind its last
set, so that several sittings make one count. --only runs one set again and keeps its folder.
Exit code 1 if there is a finding, or if kills miss the checkpoints that they are placed at.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import sys
import tempfile
import time
import traceback

try:
    from tools import foreign_python  # noqa: F401
except ModuleNotFoundError:
    sys.exit(f"{sys.argv[0]}: it imports from folders beside its own; start it with ./barreno python {sys.argv[0]}.")

import numpy as np
from adversary.described import described_options
from adversary.forged import SCENES, forgeries_of, prepared, try_forgery
from adversary.kill_moments import built_library
from adversary.odd_numbers import all_odd_numbers, try_number
from adversary.one_set import DECKS, Finding, OptionSet, Tally
from adversary.perforations import try_perforations
from adversary.run_server import RunServer
from adversary.try_set import try_set

# Chances that a set is tried so; all are checked and run.
SHARE = {"kills": 0.15, "ranks": 0.1, "two": 0.04, "group": 0.01, "sanitized": 0.3}
# Kills that are placed at checkpoints, and the part of so many that must meet a run with one: else they try nothing.
ENOUGH, LEAST_MET = 10, 0.8
# Every checkpoint is brought to the disk, which takes its time on one: in memory, where there is some.
SCRATCH = "/dev/shm" if os.access("/dev/shm", os.W_OK) else None
EMPTY = {"sets": {}, "odd numbers": {}, "forgeries": {}, "perforations": {}, "counts": {}, "drawn": [], "decks": [], "refusals": {},
    "findings": []}


def servers_of(build, folder):
    programs = {"plain": "serve_runs", "other": "serve_runs", "sanitized": "serve_runs_sanitized"}
    servers = {"program": build / "src" / "barreno"}
    for name, program in programs.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        servers[name] = RunServer(build / "verification" / program, folder / name)
    (folder / "killed").mkdir(parents=True, exist_ok=True)
    library = built_library(folder, "kill_at")
    servers["killed"] = RunServer(build / "verification" / "serve_runs", folder / "killed", more={"LD_PRELOAD": str(library)})
    for ranks in (2, 3):
        servers[ranks] = RunServer(build / "verification" / "serve_runs", folder, ranks)
    return servers


def kind_of(refusal):
    """A sentence without the path, the names and the numbers in it."""
    return re.sub(r"'[^']*'|\"[^\"]*\"|[-+\d.e]*\d[-+\d.e]*", "#", refusal.partition(": ")[2].partition(": ")[2])[:160]


def try_sets(numbers, seed, table, servers, folder, tally):
    """Yields (number, what is tried, how it is tried)."""
    for number in numbers:
        one = OptionSet(seed, number, table, folder / "set")

        def trial(one=one):
            for refusal in try_set(one, servers, SHARE, tally):
                tally.refusals[kind_of(refusal)] = tally.refusals.get(kind_of(refusal), 0) + 1

        yield number, lambda one=one: [one.source.name, *one.changes], trial


def try_numbers(numbers, seed, table, servers, folder, tally):
    odd = all_odd_numbers()
    order = np.random.default_rng(seed).permutation(len(odd))
    for number in numbers:
        chosen = odd[order[number % len(odd)]]
        yield number, lambda chosen=chosen: chosen, lambda chosen=chosen: try_number(chosen, servers["plain"], folder, tally)


def try_forgeries(numbers, seed, table, servers, folder, tally):
    scenes = []
    for deck, settings in SCENES if numbers else ():
        place = folder / deck
        place.mkdir()
        words = [word for item in settings.items() for word in ("--set", "=".join(item))]
        straight, middle = prepared(servers["plain"], DECKS / deck, words, place)
        scenes += [(deck, straight, middle, forgery) for forgery in forgeries_of(middle / "checkpoint.h5")]
    order = np.random.default_rng(seed).permutation(len(scenes))
    for number in numbers:
        deck, straight, middle, forgery = scenes[order[number % len(scenes)]]

        def trial(straight=straight, middle=middle, forgery=forgery, number=number):
            came = try_forgery(servers["plain"], straight, middle, folder / "forged", forgery, np.random.default_rng([seed, number]))
            tally.add(f"forged: {came}")

        tally.add("forged checkpoints")
        yield number, lambda deck=deck, forgery=forgery: [deck, *forgery], trial


TRIALS = {"sets": try_sets, "odd numbers": try_numbers, "forgeries": try_forgeries, "perforations": try_perforations}


def worker(build, table, seed, shares, until):
    """@param shares  of each kind of trial, the numbers of those to be done; @return what came of them, and how far they came"""
    tally, done = Tally(), {}
    with tempfile.TemporaryDirectory(prefix="adversary-", dir=SCRATCH) as name:
        folder = pathlib.Path(name)
        servers = servers_of(build, folder)
        for kind, trials in TRIALS.items():
            for number, told, trial in trials(shares[kind], seed, table, servers, folder, tally):
                if time.time() > until:
                    break
                try:
                    trial()
                except Exception as finding:  # what the scripts cannot read is one too
                    said = str(finding) if isinstance(finding, Finding) else traceback.format_exc()
                    tally.findings.append({"kind": kind, "number": f"{seed}:{number}", "said": said, "of": told()})
                    print(f"{kind} {seed}:{number}: {said}\n   {told()}", flush=True)
                done[kind] = number + 1
        for server in servers.values():
            if isinstance(server, RunServer):
                server.end()
    return tally, done


def add(results, tally):
    for part, found in (("counts", tally.counts), ("refusals", tally.refusals)):
        for name, number in found.items():
            results[part][name] = results[part].get(name, 0) + number
    for key, values in (("drawn", tally.drawn), ("decks", tally.decks)):
        results[key] = sorted({*results[key], *values})
    results["findings"] += tally.findings


def missed_kills(tallies):
    """A sentence if kills miss their checkpoints."""
    placed, met = (sum(t.counts.get(name, 0) for t in tallies)
        for name in ("kills placed at a checkpoint", "kills placed at a checkpoint that met one"))
    if placed < ENOUGH or met >= LEAST_MET * placed:
        return ""
    return f"only {met} of {placed} kills that are placed at a checkpoint met a running program with one (tools/kill_at.c, kill_moments.py)"


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--sets", type=int, default=0)
    parser.add_argument("--odd-numbers", type=int, default=0)
    parser.add_argument("--forgeries", type=int, default=0)
    parser.add_argument("--perforations", type=int, default=0, help="with fidelities, failing disks and kills")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=1e6, help="ends after so long, with what was done")
    parser.add_argument("--only", help="SEED:NUMBER of an option set")
    return parser.parse_args()


def run_one(build, table, name):
    """One option set, tried in every way."""
    seed, number = map(int, name.split(":"))
    folder = (pathlib.Path("adversary") / name.replace(":", "-")).resolve()
    shutil.rmtree(folder, ignore_errors=True)
    one = OptionSet(seed, number, table, folder / "set")
    print(one.source.name, *one.changes, sep="\n")
    print(*try_set(one, servers_of(build, folder), {kind: 1.0 for kind in SHARE}, Tally()), f"no finding; {folder}", sep="\n")


def main():
    options = parsed()
    build = options.build.resolve()
    table = described_options(build / "src" / "barreno")
    if options.only:
        run_one(build, table, options.only)
        return 0
    results = json.loads(options.out.read_text()) if options.out and options.out.exists() else json.loads(json.dumps(EMPTY))
    seed, before, begun = str(options.seed), len(results["findings"]), time.time()
    asked = {"sets": options.sets, "odd numbers": options.odd_numbers, "forgeries": options.forgeries, "perforations": options.perforations}
    first = {kind: results.setdefault(kind, {}).get(seed, 0) for kind in TRIALS}
    shares = [{kind: range(first[kind] + job, first[kind] + asked[kind], options.jobs) for kind in TRIALS} for job in range(options.jobs)]
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        jobs = [pool.submit(worker, build, table, options.seed, share, begun + 60.0 * options.minutes) for share in shares]
        parts = [job.result() for job in jobs]
    for tally, done in parts:
        add(results, tally)
        for kind, number in done.items():
            results[kind][seed] = max(results[kind].get(seed, 0), number)
    if options.out:
        options.out.write_text(json.dumps(results, indent=1) + "\n")
    known = [o.path for section, part in table.items() if not section.startswith("Model ") for o in part]
    print(json.dumps(results["counts"], indent=1))
    print(f"{len(results['drawn'])} options drawn ({len(known)} are described) over {len(results['decks'])} decks in "
        f"{time.time() - begun:.0f} s")
    for finding in results["findings"][before:]:
        print(f"finding: {finding['kind']} {finding['number']}: {finding['said'][:200]}")
    missed = missed_kills([tally for tally, _ in parts])
    if missed:
        print(missed)
    return 1 if missed or len(results["findings"]) > before else 0


if __name__ == "__main__":
    sys.exit(main())
