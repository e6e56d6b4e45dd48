#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Short forms of the shipped decks with every order of the step and every transfer, under the sanitizers and with every index
checked: none may end otherwise than with a result, a reason (no numerical answer) or a sentence.

    test_orders.py BUILD/verification [--all]

Without --all every deck comes once, every transfer with every order over the decks; the shape functions and the expansion
beyond which particles go take their turn. --all: every deck with every pair, and every shape
function with each.
"""
import argparse
import itertools
import pathlib
import sys
import tempfile

import numpy as np
from adversary.deck_tree import Deck
from adversary.described import described_options
from adversary.one_set import DECKS, FINISHED, NUMERICAL, REFUSED, Finding, must_end, shortened
from adversary.run_server import RunServer
from adversary.small_scene import shrink

STEPS = 40
# Particle-steps under the sanitizers: a few tenths of a second.
WORK = 6e3
# None, the smallest that matter leaves, and one that a jet's debris reaches.
EXPANSIONS = (None, "1.001", "1.1")


def combinations(decks, words, everything):
    """(deck, order, transfer, shape function, largest expansion)"""
    orders, transfers, shapes = (words[name] for name in ("Order", "Transfer", "Shape Function"))
    if everything:
        return [(d, o, t, s, EXPANSIONS[i % len(EXPANSIONS)])
            for i, (d, o, t, s) in enumerate(itertools.product(decks, orders, transfers, shapes))]
    found = []
    for k, deck in enumerate(decks):
        turn = k // len(orders)
        shape, expansion = shapes[(k + turn) % len(shapes)], EXPANSIONS[(k + turn // len(transfers)) % len(EXPANSIONS)]
        found.append((deck, orders[k % len(orders)], transfers[turn % len(transfers)], shape, expansion))
    pairs = {(order, transfer) for _, order, transfer, _, _ in found}
    assert len(pairs) == len(orders) * len(transfers), f"not every transfer comes with every order: {sorted(pairs)}"
    assert {shape for _, _, _, shape, _ in found} == set(shapes), "a shape function is missing"
    return found


def try_combination(servers, folder, combination, seed):
    """@return whether it was run to its end. @raises Finding"""
    name, order, transfer, shape, expansion = combination
    deck = Deck(DECKS / name)
    shrink(deck, np.random.default_rng(seed))
    for path, value in {"Step/Order": order, "Step/Transfer": transfer, "Step/Shape Function": shape,
            "Step/Largest Expansion": expansion}.items():
        if value is not None:
            deck.set(path, value)
    # What belongs to the transfer that the deck has itself.
    for path in ("Step/PIC Fraction", "Step/XPIC Order"):
        deck.remove(path)
    if (order, transfer) != ("stress last", "FLIP"):  # only these know what each particle lost
        deck.remove("Step/Return Losses")
    # Cells of several sizes are refused with these, by sentences that tests/decks holds.
    if transfer in ("XPIC", "APIC") or shape == "linear":
        for path in ("Refinement", "Jet/Cells Per Radius"):
            deck.remove(path)
    file = folder / "deck.xml"
    deck.write(file)
    plan = servers[0].run("check", file)
    if must_end(plan, FINISHED, REFUSED) == REFUSED:
        return False
    end = shortened(plan.out, WORK, STEPS)[0]
    ended = servers[1].run("run", file, "--out", folder / "run", "--overwrite", "--set", f"Time/End Time={end!r}")
    must_end(ended, FINISHED, NUMERICAL)
    return True


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path, help="folder of serve_runs and serve_runs_sanitized")
    parser.add_argument("--all", action="store_true")
    options = parser.parse_args()
    programs = options.programs.resolve()
    words = {option.name: option.words for option in described_options(programs.parent / "src" / "barreno")["Step"]}
    decks = sorted(file.name for file in DECKS.glob("*.xml"))
    chosen = combinations(decks, words, options.all)
    findings, refused, seconds = 0, 0, 0.0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "jets").symlink_to(DECKS / "jets")
        servers = [RunServer(programs / name, folder) for name in ("serve_runs", "serve_runs_sanitized")]
        for seed, combination in enumerate(chosen):
            try:
                refused += not try_combination(servers, folder, combination, seed)
            except Finding as finding:
                findings += 1
                print(*combination, ":", finding, flush=True)
        for server in servers:
            seconds += server.seconds
            server.end()
    print(f"{len(chosen)} combinations over {len(decks)} decks, {refused} refused, {findings} findings, {seconds:.0f} s of processor")
    assert refused <= 0.1 * len(chosen), "most of what was to be run was refused"
    return 1 if findings else 0


if __name__ == "__main__":
    sys.exit(main())
