#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Random valid option sets over the shipped decks, straight, killed and resumed, on one to three ranks and under sanitizers.

    adversary.py BUILD [--sets N] [--seed S] [--out results.json] [--jobs J] [--only SEED:NUMBER]

BUILD is the build folder. With --out what is found is added to what is there already: a seed goes on behind its last
set, so that several sittings make one count. --only runs one set again and keeps its folder.
Exit code 1 if there is a finding.
"""
import argparse
import concurrent.futures
import json
import pathlib
import re
import shutil
import sys
import tempfile
import time
import traceback

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from described import described_options  # noqa: E402
from one_set import Finding, OptionSet, Tally, try_set  # noqa: E402
from run_server import RunServer  # noqa: E402

SHARE = {"kills": 0.2, "ranks": 0.1, "sanitized": 0.3}


def servers_of(build, folder):
    programs = {"plain": "verification/serve_runs", "sanitized": "verification/serve_runs_sanitized"}
    servers = {}
    for name, program in programs.items():
        (folder / name).mkdir(parents=True, exist_ok=True)
        servers[name] = RunServer(build / program, folder / name)
    for ranks in (2, 3):
        servers[ranks] = RunServer(build / programs["plain"], folder, ranks)
    return servers


def worker(build, table, seed, numbers, share, until):
    """Some sets of a seed. @return what came of them, and the sets that were tried"""
    tally, tried, refusals = Tally(), [], {}
    with tempfile.TemporaryDirectory(prefix="adversary-") as name:
        folder = pathlib.Path(name)
        servers = servers_of(build, folder)
        for number in numbers:
            if time.time() > until:
                break
            one = OptionSet(seed, number, table, folder / "set")
            try:
                for refusal in try_set(one, servers, share, tally):
                    kind = re.sub(r"'[^']*'|\"[^\"]*\"|[-+\d.e]*\d[-+\d.e]*", "#", refusal.partition(": ")[2].partition(": ")[2])[:160]
                    refusals[kind] = refusals.get(kind, 0) + 1
            except Exception as finding:  # what the scripts cannot read is one too
                said = str(finding) if isinstance(finding, Finding) else traceback.format_exc()
                tally.findings.append({"set": one.name, "deck": one.source.name, "said": said, "changes": one.changes})
                print(f"{one.name} {one.source.name}: {said}\n   {one.changes}", flush=True)
            tried.append(number)
        for server in servers.values():
            server.end()
    return tally, tried, refusals


def merged(results, tally):
    for name, number in tally.counts.items():
        results["counts"][name] = results["counts"].get(name, 0) + number
    for key, values in (("drawn", tally.drawn), ("decks", tally.decks)):
        results[key] = sorted({*results[key], *values})
    results["findings"] += tally.findings


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("--sets", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--out", type=pathlib.Path)
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--minutes", type=float, default=1e6, help="ends after so long, with what was done")
    parser.add_argument("--only")
    options = parser.parse_args()
    build = options.build.resolve()
    table = described_options(build / "src" / "barreno")
    if options.only:
        seed, number = map(int, options.only.split(":"))
        folder = pathlib.Path("adversary") / options.only.replace(":", "-")
        shutil.rmtree(folder, ignore_errors=True)
        servers = servers_of(build, folder.resolve())
        one = OptionSet(seed, number, table, folder.resolve() / "set")
        print(one.source.name, *one.changes, sep="\n")
        print(*try_set(one, servers, {name: 1.0 for name in SHARE}, Tally()), f"no finding; {folder}", sep="\n")
        return 0
    results = {"sets": {}, "counts": {}, "drawn": [], "decks": [], "refusals": {}, "findings": []}
    if options.out and options.out.exists():
        results = json.loads(options.out.read_text())
    first = results["sets"].get(str(options.seed), 0)
    numbers = range(first, first + options.sets)
    begun = time.time()
    until = begun + 60.0 * options.minutes
    with concurrent.futures.ProcessPoolExecutor(options.jobs) as pool:
        shares = [numbers[job :: options.jobs] for job in range(options.jobs)]
        parts = list(pool.map(worker, *zip(*[(build, table, options.seed, share, SHARE, until) for share in shares])))
    before = len(results["findings"])
    for tally, _, refusals in parts:
        merged(results, tally)
        for kind, count in refusals.items():
            results["refusals"][kind] = results["refusals"].get(kind, 0) + count
    done = max((max(tried) + 1 for _, tried, _ in parts if tried), default=first)
    results["sets"][str(options.seed)] = done
    if options.out:
        options.out.write_text(json.dumps(results, indent=1) + "\n")
    seconds = time.time() - begun
    counts = results["counts"]
    print(json.dumps(counts, indent=1))
    known = [o.path for section, part in table.items() if not section.startswith("Model ") for o in part]
    print(f"{len(results['drawn'])} options drawn of {len(known)} that are described; {len(results['decks'])} decks; {seconds:.0f} s, {(done - first) / seconds:.2f} sets/s")
    for kind, count in sorted(results["refusals"].items(), key=lambda item: -item[1])[:40]:
        print(count, kind)
    return 1 if len(results["findings"]) > before else 0


if __name__ == "__main__":
    sys.exit(main())
