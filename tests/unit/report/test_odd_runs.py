#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""What report, film, compare, sweep and join do with run folders that no run wrote: dollar signs in names, named pipes instead of files,
texts instead of numbers, endless nesting, letters that no terminal shows. Each ends with a result or one sentence; none waits, none prints
a traceback.

    test_odd_runs.py [--every N]

Of the values of summaries and decks, each of which is changed in turn, one in N is (1: all).
"""
import contextlib
import copy
import fcntl
import io
import json
import os
import pathlib
import re
import shutil
import signal
import socket
import struct
import subprocess
import sys
import tempfile
import unittest.mock

import numpy as np
import synthetic_run
import synthetic_runs

from barreno.compare.command import main as compare
from barreno.report.command import main as report
from barreno.runs import faults, join_exodus, plots

ROOT = pathlib.Path(__file__).resolve().parents[3]
NAMES = (r"$\foo{$", "steel $5 to $9", r"T $\foo{$ \ ^_# %d %s {0} $a_{$")
PATIENCE = 500  # s, after which a command counts as waiting
EVERY = int(sys.argv[2]) if sys.argv[1:2] == ["--every"] else 1
FILES = ("summary.json", "history.csv", "depth.csv", "deck.xml", "particles.e")


class Waits(BaseException):
    """A command has not ended."""


def alarm(*_):
    raise Waits


def said_by(command, *words):
    """(exit code, what it printed)"""
    out = io.StringIO()
    signal.signal(signal.SIGALRM, alarm)
    signal.alarm(PATIENCE)
    try:
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(out):
            code = command([str(word) for word in words])
    finally:
        signal.alarm(0)
    return code, out.getvalue()


def whole_run(folder):
    """A run with a hole in rock, and what compare asks of it."""
    blocks = [synthetic_run.rock(synthetic_run.lattice(0.004, 0.02, 0.0, 0.03)),
        synthetic_run.jet(synthetic_run.lattice(0.0, 0.002, 0.005, 0.02), 3000.0)]
    synthetic_run.write_run(folder, blocks)
    more = json.loads((folder / "summary.json").read_text())
    made = synthetic_runs.summary_of(0.02)
    made["penetration"]["cells_per_radius"] = {"least": 1.0, "most": 2.0, "tip": 1.5, "tail": 1.0}
    made["balances"]["energy"].update(more.pop("balances")["energy"])
    (folder / "summary.json").write_text(
        json.dumps({**made, **more, "wall_seconds": 3.0, "ranks": 1, "ns_per_particle_step": 9.0, "bytes_per_particle": 400.0}))
    return folder


def check_sentence(code, said, what):
    lines = said.strip().splitlines()
    assert code in (1,
        2) and len(lines) == 1 and lines[0].startswith("barreno: ") and "internal error" not in said, f"{what}: exit {code}: {said}"


def check_no_fault(code, said, what):
    """A result, or a sentence that was foreseen."""
    assert "Traceback" not in said and "internal error" not in said and code in (0, 1, 2), f"{what}: exit {code}: {said}"
    if code:
        check_sentence(code, said, what)


def renamed(run, name):
    """The same run with a name of the user's in all places."""
    quoted = name.replace("&", "&amp;").replace('"', "&quot;")
    deck = (run / "deck.xml").read_text()
    for old in ("Sandstone", "Tungsten", "Rock"):
        deck = deck.replace(f'"{old}"', f'"{old[0]} {quoted}"')
    (run / "deck.xml").write_text(deck)
    summary = json.loads((run / "summary.json").read_text())
    (run / "summary.json").write_text(json.dumps({**summary, "title": name, "reason": name, "deck": f"{name}.xml"}))
    blocks = [synthetic_run.rock(synthetic_run.lattice(0.004, 0.02, 0.0, 0.03)),
        synthetic_run.jet(synthetic_run.lattice(0.0, 0.002, 0.005, 0.02), 3000.0)]
    for block in blocks:
        block.name = f"{block.name[0]} {name}"[:60]
    synthetic_run.write_particles(run / "particles.e", blocks)
    return run


def check_dollars(folder):
    """No name is read as a formula, by any command that draws."""
    other = whole_run(folder / "other")
    for i, name in enumerate(NAMES):
        run = renamed(whole_run(folder / f"{i}" / name.replace("/", "_")), name)
        code, said = said_by(report, "report", run, *(("--pdf", "--particles", "near tip") if i == len(NAMES) - 1 else ()))
        assert code == 0 and (run / "report" / "index.html").exists(), f"{name}: {said}"
        code, said = said_by(report, "film", run, "--field", "pressure")
        assert code == 0, f"{name}: {said}"
        code, said = said_by(compare, run, other, "--out", folder / f"compare {i}")
        assert code == 0 and (folder / f"compare {i}" / "channels.png").exists() and "lacks" not in said, f"{name}: {said}"


def check_swept_dollars(folder):
    from barreno.converge import order
    from barreno.converge.levels import Level
    from barreno.converge.picture import draw
    from barreno.sweeps.picture import Axis, draw_against

    for i, name in enumerate(NAMES):
        draw_against(folder / f"{i}.png", [Axis(name, None, [name, "b"])], [name, "b"], [0.01, 0.02])
        draw_against(folder / f"{i}.png", [Axis(name, [1.0, 2.0], [name, "b"]), Axis(name, None, [name, "b"])], [name, "b"], [0.01, 0.02])
        cells = [0.5e-3, 1e-3, 2e-3]
        rows = [(1e-5, [1.0, 1.1, 1.5], order.judge(cells, [1.0, 1.1, 1.5]))]
        draw(folder / f"{i}.png", f"{name}.depth", [Level([], "", folder, cells=size) for size in cells], [None] * 3, rows)


def check_plain_logs():
    """Numbers of logarithmic axes are numbers, not what a formula is written with."""
    figure, axes = plots.plt.subplots()
    axes.set(xscale="log", yscale="log", xlim=(1e-4, 1e6), ylim=(2.0, 7.0))
    plots.plain_log(axes.xaxis, axes.yaxis)
    figure.canvas.draw()
    texts = [tick.get_text() for axis in (axes.xaxis, axes.yaxis) for minor in (False, True) for tick in axis.get_ticklabels(minor)]
    plots.plt.close(figure)
    shown = [text for text in texts if text]
    assert len(shown) > 3 and all(re.fullmatch(r"[\d.e+−-]+", text) for text in shown), texts


def lay(file, kind):
    file.unlink()
    if kind == "pipe":
        os.mkfifo(file)
    elif kind == "folder":
        file.mkdir()
    elif kind == "device":
        file.symlink_to("/dev/zero")
    else:
        here = os.getcwd()
        os.chdir(file.parent)  # a socket's path is short
        with socket.socket(socket.AF_UNIX) as one:
            one.bind(file.name)
        os.chdir(here)


def check_other_kinds(folder):
    """What is no ordinary file is named, and not waited for."""
    whole, other = whole_run(folder / "whole"), whole_run(folder / "other")
    words = {"pipe": "named pipe", "socket": "a socket", "device": "a device", "folder": "a folder"}
    for kind in words:
        for name in FILES if kind == "pipe" else ("summary.json", "particles.e"):
            run = pathlib.Path(shutil.copytree(whole, folder / f"{kind} {name}"))
            lay(run / name, kind)
            what = f"{kind} as {name}"
            code, said = said_by(report, "report", run)
            check_sentence(code, said, what)
            assert words[kind] in said and name in said, f"{what}: {said}"
            check_no_fault(*said_by(report, "film", run, "--field", "pressure"), what)
            code, said = said_by(compare, run, other, "--out", folder / f"out {kind} {name}")
            assert (code == 0) == (name in ("history.csv", "particles.e")) and (name != "particles.e"
                or words[kind] in said), f"{what}: {said}"
            if code:
                check_sentence(code, said, what)
    code, said = said_by(join_exodus.main, folder / "pipe particles.e", "--out", folder / "a.e")
    check_sentence(code, said, "join")
    os.mkfifo(folder / "particles.e.2.0")
    os.mkfifo(folder / "particles.e.2.1")
    code, said = said_by(join_exodus.main, folder, "--out", folder / "a.e")
    check_sentence(code, said, "join of a set")
    assert "named pipe" in said, said


def leaves(tree, path=()):
    for name, value in tree.items():
        yield from leaves(value, (*path, name)) if isinstance(value, dict) else [(*path, name)]


def changed(tree, path, value):
    tree = copy.deepcopy(tree)
    node = tree
    for name in path[:-1]:
        node = node[name]
    node[path[-1]] = value
    return tree


def check_remarks(folder):
    """A run of another version, one that was killed and one that is running have their page, with one sentence."""
    run = whole_run(folder / "run")
    summary = json.loads((run / "summary.json").read_text())
    (run / "summary.json").write_text(json.dumps({**summary, "version": "0.0.7"}))
    cases = {"was made by Barreno 0.0.7, and this is": lambda: None, "because the run was killed": (run / "summary.json").unlink,
        "is still running": lambda: held.append(locked(run / "run.lock"))}
    held = []
    for expected, change in cases.items():
        change()
        code, said = said_by(report, "report", run)
        assert code == 0 and said.count("\n") == 2 and expected in said.split("\n")[0], (code, said)
        assert expected in (run / "report" / "index.html").read_text() and expected in (run / "report" / "index.md").read_text()
    os.close(held[0])


def locked(file):
    """An open file with the lock that a program holds in the folder of its run."""
    handle = os.open(file, os.O_RDWR | os.O_CREAT, 0o600)
    fcntl.fcntl(handle, fcntl.F_OFD_SETLK, struct.pack("hhqqi", fcntl.F_WRLCK, os.SEEK_SET, 0, 2, 0))
    return handle


def some(items):
    return items[::EVERY]


def check_odd_summaries(folder):
    """Every value of summary.json in turn as another kind of value."""
    whole, other = whole_run(folder / "whole"), whole_run(folder / "other")
    (whole / "particles.e").rename(folder / "particles.e")  # pictures of channels cost time and read no summary
    summary = json.loads((whole / "summary.json").read_text())
    odd = ("ten", None, [1], {"a": "b"}, 10**400, float("nan"), True, "\ud800 µ\n")
    for path, value in some([(path, value) for path in leaves(summary) for value in odd]):
        (whole / "summary.json").write_text(json.dumps(changed(summary, path, value)))
        check_no_fault(*said_by(compare, whole, other, "--out", folder / "out"), f"compare, {path} = {value!r}")
    (folder / "particles.e").rename(whole / "particles.e")
    for path in some(list(leaves(summary))):
        (whole / "summary.json").write_text(json.dumps(changed(summary, path, "ten")))
        check_no_fault(*said_by(report, "report", whole), f"report, {path}")
    (whole / "summary.json").write_text(json.dumps(changed(summary, ("penetration", "depth"), "ten")))
    code, said = said_by(compare, whole, other, "--out", folder / "out")
    assert code == 2 and 'penetration.depth is "ten", where a number belongs' in said, said


ODD_FILES = {  # file: what it holds
    "summary.json": (b'{"a": ' * 3000 + b"1" + b"}" * 3000, b'{"a": ' + b"[" * 100000 + b"]" * 100000 + b"}",
        b'{"time": "ten", "finished": true}', b"\xff\xfe{\x00}\x00", b"{\"title\": \"\xe9\"}", b"null", b""),
    "deck.xml": (b"<ParameterList name='a'>" * 20000 + b"</ParameterList>" * 20000,
        "<?xml version='1.0' encoding='latin-1'?><ParameterList name='é'/>".encode("latin-1"),
                 b"<?xml version='1.0' encoding='nonsense'?><ParameterList/>",
                 b"<ParameterList><Parameter/><ParameterList/></ParameterList>", b"\xff\xfe<\x00", b"",
                 b"<ParameterList><Parameter name='Title' value='a&#10;forged: line'/></ParameterList>"),
    "depth.csv": (b"time,depth\n0,ten\n1,2\n", b"time,depth\n0,\xe9\n", b"time;depth\n0;1\n", b"\x00\n", b"", b"time,time\n1,2\n",
        b"time,depth\n" + b"9" * 5000 + b",1\n"),
    "history.csv": (b"time,step\n0,ten\n", b"\xff\n", b"time\n1\n"),
}  # fmt: skip


def check_odd_files(folder):
    """Encodings, nesting, texts for numbers."""
    whole, other = whole_run(folder / "whole"), whole_run(folder / "other")
    for name, contents in ODD_FILES.items():
        for i, content in enumerate(contents):
            run = pathlib.Path(shutil.copytree(whole, folder / f"{name} {i}"))
            (run / name).write_bytes(content)
            what = f"{name} of {content[:60]}"
            code, said = said_by(compare, run, other, "--out", folder / f"out {name} {i}")
            check_no_fault(code, said, f"compare, {what}")
            assert "\nforged" not in said, said
            check_no_fault(*said_by(report, "report", run), f"report, {what}")
            check_no_fault(*said_by(report, "film", run, "--field", "speed"), f"film, {what}")


def check_odd_decks(folder):
    """Every value of the deck in turn as a text."""
    whole, other = whole_run(folder / "whole"), whole_run(folder / "other")
    deck = (whole / "deck.xml").read_text()
    for found in some(list(re.finditer(r'value="[^"]*"', deck))):
        (whole / "deck.xml").write_text(deck[: found.start()] + 'value="two"' + deck[found.end() :])
        check_no_fault(*said_by(report, "report", whole), f"report, {found.group()}")
        check_no_fault(*said_by(compare, whole, other, "--out", folder / "out"), f"compare, {found.group()}")


def check_last_resort():
    """What nobody foresaw is one sentence too, of exit code 4, from every command."""
    def fails(_):
        return 1 // 0

    code, said = said_by(lambda words: faults.exit_code(fails, words))
    assert (
        code == 4 and said.count("\n") == 1 and "internal error at report/test_odd_runs.py, line" in said and "ZeroDivisionError" in said
    ), said
    def lacks(_):
        raise ModuleNotFoundError("No module named 'netCDF4'", name="netCDF4")

    code, said = said_by(lambda words: faults.exit_code(lacks, words))
    assert code == 2 and said.startswith("barreno: Python lacks netCDF4") and "python3-netcdf4" in said and said.count("\n") == 1, said


def check_bare_python(folder):
    """A Python without packages, from every package that is started; a terminal without the letters of a name; a full disk behind the
    output."""
    environment = dict(os.environ)
    for package, words in {"barreno.report": ("report", "x"), "barreno.compare": ("x", "y"),
            "barreno.runs.join_exodus": ("x", "--out", "y"), "barreno.fit": ("x", "--out", "y.xml")}.items():
        result = subprocess.run([sys.executable, "-S", "-m", package, *words], env=environment, cwd=folder, capture_output=True, text=True,
            timeout=60, check=False)
        assert result.returncode == 2 and result.stderr.count("\n") == 1 and "Traceback" not in result.stderr, f"{package}: {result.stderr}"
    runs = [whole_run(folder / name) for name in ("µ", "b")]
    words = [sys.executable, "-m", "barreno.compare", *map(str, runs), "--out", str(folder / "out")]
    result = subprocess.run(words, env={**environment, "PYTHONIOENCODING": "ascii"}, capture_output=True, text=True, timeout=60,
        check=False)
    assert result.returncode == 0 and r"\xb5" in result.stdout, result.stderr
    with open("/dev/full", "w", encoding="utf-8") as full:
        result = subprocess.run(words, env=environment, stdout=full, stderr=subprocess.PIPE, text=True, timeout=60, check=False)
    assert (
        result.returncode == 2 and result.stderr.count("\n") == 1 and "what is printed cannot be" in result.stderr
    ), f"{result.returncode}: {result.stderr}"


def laid(_, file, **__):
    pathlib.Path(file).write_bytes(b"\x89PNG")


def main():
    np.seterr(all="ignore")
    check_last_resort()
    check_plain_logs()
    for check in (check_dollars, check_swept_dollars, check_bare_python, check_remarks, check_other_kinds, check_odd_summaries,
            check_odd_files, check_odd_decks):
        # What a picture is made of is looked at in all checks, how its dots come out in the first ones.
        drawn = contextlib.nullcontext() if check in (check_dollars,
            check_swept_dollars) else unittest.mock.patch("matplotlib.figure.Figure.savefig", laid)
        with tempfile.TemporaryDirectory() as scratch, drawn:
            check(pathlib.Path(scratch).resolve())
    print("odd run folders end in results or in sentences")


if __name__ == "__main__":
    main()
