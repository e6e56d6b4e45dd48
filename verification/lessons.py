#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""The lessons of docs/guide: runs their commands in a tree of its own, as a reader would type them, page after page.

    lessons.py BARRENO            reduced: runs end after a microsecond, a fit has fewer tests and parameters
    lessons.py BARRENO --full     the commands as they stand
    lessons.py BARRENO --write    the same, and puts what they print, and their pictures, into the pages

BARRENO is the program in its build folder (build/release/src/barreno). A command that fails fails the test; so does a page whose printed
lines have other words than the program now (numbers are not compared), where the reduced form changes nothing. What a page says to this
script:

    ```sh ... ```                 commands; those of a page share one shell: its folder and its variables
    ```text ... ```               behind commands: what they print
    <!-- exit: 1 -->              before commands: the code that they end with
    <!-- needs: ccx -->           before commands: only where there is CalculiX (--ccx)
    <!-- short: 20 us -->         before commands: end of their runs in the reduced form, where a microsecond says nothing yet
    <!-- lines: Depth|Cost -->    before what they print: only lines in which this regular expression is found
    <!-- picture: FILE -->        before a picture: the file that commands made and that is copied to it
"""
import argparse
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
GUIDE = ROOT / "docs" / "guide"
SHORT = '--set "Time/End Time=1 us" --ranks 1'
SHORTEST = "1 us"
HELD = ("FSLOPE=0.549", "STREN=128.5e6", "B1=28.6e9", "B2=264e6", "p0_crush_curve=-1.2244e9")  # by the reduced form of a fit
# Words that it leaves out: the specimens of strengths are what a fit takes its time for.
LEFT_OUT = r" \S*triaxial_strength\.csv(?=.* --out)"
# Words that the reduced form adds to a command of ./barreno; the last of two values counts.
REDUCED = {"run": SHORT, "resume": '--until "1.2 us" --ranks 1', "converge": f"{SHORT} --levels 2", "sweep": SHORT,
    "fit": "--start berea_sandstone " + " ".join(f"--fix {value}" for value in HELD)}
# They read what a reduced command has written.
READS_RUNS = ("report", "film", "compare", "drive")
NOTE = re.compile(r"<!-- (exit|needs|short|lines|picture): (.*) -->$")
PICTURE = re.compile(r"!\[.*\]\((\S+\.png)\)")
NUMBER = re.compile(r"[-+]?\d[\d,]*\.?\d*(?:e[-+]?\d+)?")


@dataclasses.dataclass
class Commands:
    """Commands of a page, and where what they print stands (lines of the page, if it shows it)."""

    page: pathlib.Path
    line: int
    text: str
    code: int = 0
    needs: str = ""
    short: str = SHORTEST
    kept: str = ""
    shown: tuple = ()


@dataclasses.dataclass
class Picture:
    page: pathlib.Path
    line: int
    source: str
    target: pathlib.Path


def parts_of(page):
    """Commands and pictures of a page in their order."""
    lines = page.read_text().splitlines()
    parts, notes, at = [], {}, 0
    while at < len(lines):
        note, fence = NOTE.match(lines[at]), re.match(r"```(sh|text)$", lines[at])
        if note:
            notes[note.group(1)] = note.group(2)
        elif fence:
            end = next(i for i in range(at + 1, len(lines)) if lines[i] == "```")
            if fence.group(1) == "sh":
                text = "\n".join(lines[at + 1 : end])
                parts.append(Commands(page, at + 1, text, int(notes.get("exit", 0)), notes.get("needs", ""), notes.get("short", SHORTEST)))
            else:
                parts[-1].shown, parts[-1].kept = (at + 1, end), notes.get("lines", "")
            notes, at = {}, end
        elif "picture" in notes and PICTURE.match(lines[at]):
            parts.append(Picture(page, at + 1, notes["picture"], (page.parent / PICTURE.match(lines[at]).group(1)).resolve()))
            notes = {}
        at += 1
    return parts


def reduced(text, short=SHORTEST):
    """The commands with what makes them cheap."""
    out = []
    for line in re.sub(r"\\\n\s*", "", text).splitlines():
        words = line.split()
        add = REDUCED.get(words[1], "") if words[:1] == ["./barreno"] and len(words) > 1 else ""
        out.append(f"{re.sub(LEFT_OUT, '', line)} {add.replace(SHORTEST, short, 1)}".rstrip() if add else line)
    return "\n".join(out)


def make_tree(folder, barreno):
    """A tree that looks built: the launcher, the files that commands name, and the build folder of the program."""
    tree, build = folder / "barreno", barreno.parents[1]
    (tree / "build" / "release").mkdir(parents=True)
    shutil.copy(ROOT / "barreno", tree)
    shutil.copytree(ROOT / "input_xml", tree / "input_xml")
    for name in ("docs", "materials", "src", "tests", "verification"):
        (tree / name).symlink_to(ROOT / name)
    for entry in build.iterdir():
        if entry.name not in ("CMakeCache.txt", "build.ninja"):
            (tree / "build" / "release" / entry.name).symlink_to(entry)
    cache = (build / "CMakeCache.txt").read_text()
    (tree / "build" / "release" / "CMakeCache.txt").write_text(re.sub(r"(?m)^CMAKE_HOME_DIRECTORY:INTERNAL=.*$",
        f"CMAKE_HOME_DIRECTORY:INTERNAL={tree}", cache))
    (tree / "build" / "release" / "build.ninja").write_text("")
    return tree


class Shell:
    """Runs commands one after the other in the folder and with the variables that those before have left."""

    def __init__(self, folder, tree, ccx):
        self.state, self.tree, home = folder / "state", tree, folder / "home"
        for made in (self.state, home, folder / "bin"):
            made.mkdir()
        (folder / "bin" / "ninja").write_text("#!/bin/sh\necho 'ninja: no work to do.'\n")
        (folder / "bin" / "ninja").chmod(0o755)
        if ccx:
            (home / "ccx").mkdir()
            (home / "ccx" / "ccx").symlink_to(ccx)
        self.fresh = {name: value for name, value in os.environ.items() if not name.startswith("BARRENO_") and name != "PYTHONPATH"}
        # Matplotlib's list of fonts takes seconds to make anew.
        self.fresh.setdefault("XDG_CACHE_HOME", str(pathlib.Path.home() / ".cache"))
        self.fresh.update(HOME=str(home), PATH=f"{folder / 'bin'}:{os.environ['PATH']}", OMP_NUM_THREADS="1", PYTHONDONTWRITEBYTECODE="1")
        self.begin()

    def begin(self):
        """As in a new terminal."""
        self.folder, self.environment = self.tree, dict(self.fresh)

    def run(self, text):
        """Exit code and what was printed. Nothing is installed."""
        text = re.sub(r"(?m)^\./barreno ", "./barreno --no-install ", text)
        script = f'trap \'env -0 >"{self.state}/env"; pwd >"{self.state}/pwd"\' EXIT\nset -e\n{text}\n'
        done = subprocess.run(["bash", "-c", script], cwd=self.folder, env=self.environment, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT, text=True, timeout=3600, check=False)
        if (self.state / "env").exists():
            self.environment = dict(entry.split("=", 1) for entry in (self.state / "env").read_text().split("\0") if "=" in entry)
            self.folder = pathlib.Path((self.state / "pwd").read_text().rstrip("\n"))
        return done.returncode, done.stdout


def shown(commands, printed):
    """The lines that a page shows of what was printed; dots stand for those left out."""
    out = []
    for line in printed.expandtabs().splitlines():
        if not commands.kept or re.search(commands.kept, line):
            out.append(line.rstrip())
        elif out[-1:] != ["..."]:
            out.append("...")
    return out


def masked(lines):
    """Words without numbers, times and what depends on the machine's cores."""
    text = re.sub(r"(?:\d+ (?:h|min) )*\b\d[\d.e+-]* (?:s|min)\b", "# s", "\n".join(lines))
    text = NUMBER.sub("#", text).replace("ranks", "rank")
    return re.sub(r"[ -]+", " ", text)


def title(part):
    return f"{part.page.relative_to(ROOT)}:{part.line}"


def run_commands(shell, commands, full):
    """What is wrong with commands, and the lines that a page shows of what they print."""
    text = commands.text if full else reduced(commands.text, commands.short)
    code, printed = shell.run(text)
    if code != commands.code:
        return [f"{title(commands)}: ends with {code}, not {commands.code}:\n{text}\n{printed}"], []
    return [], shown(commands, printed)


def comparable(commands, full):
    words = commands.text.split()
    return commands.shown and (full
        or (reduced(commands.text) == re.sub(r"\\\n\s*", "", commands.text) and not set(words[1:2]) & set(READS_RUNS)))


def old_lines(commands, lines):
    """A sentence if a page shows other words than the program prints."""
    start, end = commands.shown
    on_page = commands.page.read_text().splitlines()[start:end]
    if masked(on_page) == masked(lines):
        return []
    return [f"{title(commands)}: the page shows\n" + "\n".join(on_page) + "\nbut the program prints\n" + "\n".join(lines)
        + "\nverification/lessons.py BARRENO --write puts that into the page."]


def write_page(page, results):
    """Puts what was printed into the page, from its end so that line numbers hold."""
    lines = page.read_text().splitlines()
    for commands, printed in sorted(results, key=lambda result: -result[0].line):
        if commands.shown:
            lines[commands.shown[0] : commands.shown[1]] = printed
    page.write_text("\n".join(lines) + "\n")


def copy_picture(shell, picture, write):
    made = shell.tree / picture.source
    if not made.is_file():
        return [f"{title(picture)}: no command has made {picture.source}"]
    if write:
        shutil.copyfile(made, picture.target)
    return []


def run_page(shell, page, options, skipped):
    """What is wrong with a page."""
    problems, results, full = [], [], options.full or options.write
    shell.begin()
    for part in parts_of(page):
        if isinstance(part, Picture):
            problems += copy_picture(shell, part, options.write)
        elif part.needs == "ccx" and not options.ccx:
            skipped.append(title(part))
        else:
            wrong, lines = run_commands(shell, part, full)
            problems += wrong
            if wrong:
                break  # what follows builds on it
            results.append((part, lines))
            if not options.write and comparable(part, full):
                problems += old_lines(part, lines)
    if options.write and not problems:
        write_page(page, results)
    return problems


def words():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("barreno", type=lambda path: pathlib.Path(path).resolve(), help="the program in its build folder")
    parser.add_argument("--full", action="store_true", help="the commands as they stand")
    parser.add_argument("--write", action="store_true", help="the same, and write what they print into the pages")
    parser.add_argument("--ccx", type=pathlib.Path, help="CalculiX, as tests/hosts/build_ccx.sh builds it")
    parser.add_argument("--from", type=int, default=1, dest="first", metavar="N",
        help="begin with lesson N: 1, 4 or a later one than 5, which use no files of earlier ones")
    parser.add_argument("--to", type=int, dest="last", metavar="N", help="end with lesson N")
    options = parser.parse_args()
    if options.ccx is None or not options.ccx.is_file():
        options.ccx = None
    return options


def main():
    options = words()
    numbered = {int(page.name.partition("_")[0]): page for page in sorted(GUIDE.glob("[1-9]_*.md"))}
    pages = [page for number, page in numbered.items() if options.first <= number <= (options.last or number)]
    problems, skipped, count = [], [], 0
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch).resolve()
        shell = Shell(folder, make_tree(folder, options.barreno), options.ccx and options.ccx.resolve())
        for page in pages:
            wrong = run_page(shell, page, options, skipped)
            count += sum(isinstance(part, Commands) for part in parts_of(page))
            problems += wrong
            if wrong:
                break  # later lessons use the files of earlier ones
    for place in skipped:
        print(f"{place}: skipped, there is no CalculiX (tests/hosts/build_ccx.sh FOLDER, then --ccx FOLDER/ccx)")
    print("\n".join(problems) or f"{len(pages)} lessons, {count} blocks of commands: all run")
    return 1 if problems or not count else 0


if __name__ == "__main__":
    sys.exit(main())
