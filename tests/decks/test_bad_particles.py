#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Particles that expand too far: their policy in a whole run, its exit code, its sentence and its tallies.

    test_bad_particles.py BARRENO
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from tools.runs import DECKS, Run, mpi_environment


def run(policy, folder):
    command = [sys.argv[1], "run", DECKS / "stretched_bar.xml", "--out", folder]
    command += ["--set", f"Materials/Soft/Bad Particles={policy}", "--set", "Step/Largest Expansion=2"]
    command += ["--set", "Step/Shape Function=CPDI", "--set", "Step/Largest Domain=0"]  # which does not part before
    result = subprocess.run(command, env=mpi_environment(), capture_output=True, text=True, timeout=120)
    summary = json.loads((folder / "summary.json").read_text())
    said = [line for line in result.stderr.splitlines() if not line.startswith("warning: ")]
    assert said == ([f"barreno: {summary['reason']}"] if result.returncode else []), f"{policy}: {result.stderr}"
    assert summary["exit_code"] == result.returncode, f"{policy}: exit {result.returncode}, summary says {summary['exit_code']}"
    return result.returncode, summary, Run(folder).table("history.csv")


def main():
    with tempfile.TemporaryDirectory() as name:
        found = {policy: run(policy, pathlib.Path(name) / policy) for policy in ("remove", "hold", "stop")}
    for policy, (code, summary, history) in found.items():
        removed = summary["removed_particles"]["expanded"]["count"]
        assert history["removed_expanded"][-1] == removed and history["held"][-1] == summary["held_particles"]
        assert (removed > 0) == (policy == "remove"), f"{policy}: {removed} removed"
        assert (summary["held_particles"] > 0) == (policy == "hold"), f"{policy}: {summary['held_particles']} held"
        assert code == (3 if policy == "stop" else 0), f"{policy}: exit {code}"
        assert summary["finished"] == (policy != "stop")
    reason = found["stop"][1]["reason"]
    assert "of material 'Soft' expanded beyond \"Largest Expansion\" at t = " in reason, reason


if __name__ == "__main__":
    main()
