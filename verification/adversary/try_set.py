# SPDX-License-Identifier: BSD-3-Clause
"""What is tried with one random option set: it is checked, run, run under sanitizers, killed and resumed, run on more ranks."""
from adversary.kills import try_kills, try_ranks
from adversary.one_set import FINISHED, MOST_REFUSALS, NUMERICAL, REFUSED, Finding, must_end, sentence_of
from adversary.same_runs import unsound
from adversary.two_processes import try_group, try_two


def try_set(one, servers, share, tally):
    """@param share  chances of "sanitized", "kills", "ranks", "two" processes and a killed "group"; @raises Finding"""
    plain = servers["plain"]
    tally.add("sets")
    refusals = []
    plan = plain.run("check", one.file)
    while must_end(plan, FINISHED, REFUSED) == REFUSED:
        tally.add("refused")
        refusals.append(sentence_of(plan))
        if not one.changes or len(refusals) > MOST_REFUSALS:
            return refusals
        one.give_up(refusals[-1])
        plan = plain.run("check", one.file)
    tally.add("accepted")
    tally.decks.add(one.source.name)
    tally.drawn.update(one.drawn_paths())
    if not one.shorten(plan.out, "plain"):
        tally.add("too large")
        return refusals
    straight = one.folder / "straight"
    begun = plain.run("run", one.file, "--out", straight)
    code = must_end(begun, FINISHED, NUMERICAL)
    tally.add("finished" if code == FINISHED else "stopped with a reason")
    if code == FINISHED:
        wrong = unsound(straight)
        if wrong:
            raise Finding("; ".join(wrong[:8]))
        seconds = max(begun.seconds, 0.02)
        if one.rng.random() < share["kills"]:
            try_kills(one, servers["killed"], straight, seconds, tally)
        if one.rng.random() < share["ranks"]:
            try_ranks(one, servers["killed"], servers[int(one.rng.choice([2, 3]))], straight, seconds, tally)
        if one.rng.random() < share["two"]:
            try_two(one, servers, straight, seconds, tally)
        if one.rng.random() < share["group"]:
            try_group(one, servers, straight, servers["program"], tally)
    if one.rng.random() < share["sanitized"] and one.shorten(plan.out, "sanitized"):
        must_end(servers["sanitized"].run("run", one.file, "--out", one.folder / "sanitized"), FINISHED, NUMERICAL)
        tally.add("under sanitizers")
    return refusals
