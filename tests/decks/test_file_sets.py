#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Particle Files = "one per rank": the set is one data set for readers, and holds what the one file holds, bit for bit.

    test_file_sets.py BARRENO
"""
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

import numpy as np

from barreno.report.particles import ParticleFile
from barreno.runs.join_exodus import files_of, join_set
from netCDF4 import Dataset
from tools.resumed import at_previous, different_fields, lines_of, must_work, program, stopped_run
from tools.runs import DECKS, mpi_environment
from tools.small_decks import elastic, write_deck

TESTS = pathlib.Path(__file__).resolve().parents[1]
TOOLS = TESTS.parent / "verification" / "tools"
DECK = str(DECKS / "perforation_quick.xml")
SHORT = ("--set", "Time/End Time=15 us", "--set", "Output/Field Interval=5 us", "--set", "Output/Checkpoint Steps=150")
PER_RANK = ("--set", "Output/Particle Files=one per rank")


def run(barreno, ranks, folder, *words, deck=DECK):
    must_work(program(barreno, ranks, "run", deck, "--out", folder, *words))
    return folder


def set_names(folder):
    return sorted(path.name for path in folder.glob("particles.e*"))


def check_same(one, folder, ranks):
    """The set has its names and no others, and joined it is the one file, bit for bit."""
    assert set_names(folder) == [f"particles.e.{ranks}.{r}" for r in range(ranks)], set_names(folder)
    whole = folder / "joined"
    whole.mkdir()
    join_set(folder, whole / "particles.e")
    assert set_names(whole) == ["particles.e"], set_names(whole)  # and nothing aside
    for what, words in ((folder, "exists; choose another name"), (one, "is a single file"), (whole.parent / "joined" / "none", "neither")):
        try:
            join_set(what, whole / "particles.e")
            raise AssertionError(f"{what} was joined")
        except OSError as error:
            assert words in str(error), error
    different = different_fields(one, whole)
    assert not different, f"{folder.name}: {different} differ from the one file"
    with Dataset(one / "particles.e") as a, Dataset(whole / "particles.e") as b:
        assert set(a.variables) == set(b.variables), set(a.variables) ^ set(b.variables)
        assert all(len(a.dimensions[name]) == len(b.dimensions[name]) for name in a.dimensions)


def check_as_report_reads(one, folder):
    """Report, film and compare read the set where it lies, and see what the one file holds."""
    whole, parts = ParticleFile(one / "particles.e"), ParticleFile(folder / "particles.e")
    assert type(parts.data) is not type(whole.data), "it was joined"
    for what in ("times", "elements", "dimensions", "names", "sizes", "block_names"):
        assert np.array_equal(getattr(whole, what), getattr(parts, what)), what
    assert [whole.fields(b) for b in range(len(whole.sizes))] == [parts.fields(b) for b in range(len(parts.sizes))]
    assert np.array_equal(whole.radius(), parts.radius(), equal_nan=True), "radii differ"
    for step in range(len(whole.times)):
        a, b = whole.frame(step), parts.frame(step)
        assert a.time == b.time and np.array_equal(a.corners, b.corners), f"corners of step {step} differ"
        for name in whole.names:
            assert np.array_equal(a.variable(name), b.variable(name), equal_nan=True), f"{name} of step {step} differs"
    whole.close()
    parts.close()


def check_nemesis(folder, ranks):
    """What the files say of the set adds up, and their ids are the set's, each once."""
    ids, elements = [], 0
    for number, file in enumerate(files_of(folder / "particles.e")):
        with Dataset(file) as data:
            mine = len(data.dimensions["num_elem"]) if "num_elem" in data.dimensions else 0
            assert len(data.dimensions["num_processors"]) == ranks
            assert len(data.dimensions["num_procs_file"]) == 1
            total = len(data.dimensions["num_elems_global"])
            assert total == data["el_blk_cnt_global"][:].sum()
            if mine:
                assert np.array_equal(data[f"elem_mapi"][:], np.arange(1, mine + 1)), "inner elements are not all"
                ids.append(np.asarray(data["elem_num_map"][:]))
            elements += mine
    ids = np.concatenate(ids)
    assert elements == total == len(np.unique(ids)) == len(ids)


def by_id(folder, name):
    """Of the one file at its last step: by id the value of a variable and the places of the corners."""
    from check_exodus import names, size

    found = {}
    with Dataset(folder / "particles.e") as data:
        data.set_auto_mask(False)
        places = [data["coord" + axis][:] + data[f"vals_nod_var{i}"][-1] for i, axis in enumerate("xy", 1)]
        places = np.stack(places, axis=-1).reshape(size(data, "num_elem"), -1)
        variable, begin = names(data, "name_elem_var").index(name) + 1, 0
        for block in range(1, size(data, "num_el_blk") + 1):
            count = size(data, f"num_el_in_blk{block}")
            key = f"vals_elem_var{variable}eb{block}"
            for e, value in enumerate(data[key][-1] if count else ()):
                found[int(data["elem_num_map"][begin + e])] = (float(value), *map(float, places[begin + e]))
            begin += count
    return found


def leaves(data):
    """The grids of a VTK data set, whatever groups hold them; those without cells left out."""
    if data is None:
        return []
    parts = {
        "vtkPartitionedDataSetCollection": ("GetNumberOfPartitionedDataSets", "GetPartitionedDataSet"),
        "vtkPartitionedDataSet": ("GetNumberOfPartitions", "GetPartition"),
        "vtkMultiBlockDataSet": ("GetNumberOfBlocks", "GetBlock"),
    }
    if data.GetClassName() not in parts:
        return [data] if data.GetNumberOfCells() > 0 else []
    count, part = (getattr(data, name) for name in parts[data.GetClassName()])
    return [grid for i in range(count()) for grid in leaves(part(i))]


def seen(grids, name, id_name):
    """What VTK's grids have, as by_id."""
    from vtkmodules.util.numpy_support import vtk_to_numpy

    found = {}
    for grid in grids:
        data = grid.GetCellData()
        corners = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(grid.GetNumberOfCells(), -1)
        places = vtk_to_numpy(grid.GetPoints().GetData())[corners][:, :, :2].reshape(len(corners), -1)
        for number, value, place in zip(*(vtk_to_numpy(data.GetArray(key)) for key in (id_name, name)), places):
            assert number not in found, f"VTK sees particle {number} twice"
            found[int(number)] = (float(value), *map(float, place))
    return found


def read_as_one(files):
    """The last step of the set by the reader that ParaView takes for .e files."""
    from vtkmodules.vtkIOIOSS import vtkIOSSReader

    reader = vtkIOSSReader()
    for file in files:
        reader.AddFileName(str(file))
    reader.UpdateInformation()
    times = reader.GetOutputInformation(0).Get(reader.GetExecutive().TIME_STEPS())
    reader.UpdateTimeStep(times[-1])
    return len(times), leaves(reader.GetOutputDataObject(0))


def read_alone(file):
    """The last step of one file by the older reader."""
    from vtkmodules.vtkIOExodus import vtkExodusIIReader

    reader = vtkExodusIIReader()
    reader.SetFileName(str(file))
    reader.UpdateInformation()
    reader.SetAllArrayStatus(vtkExodusIIReader.ELEM_BLOCK, 1)
    reader.SetAllArrayStatus(vtkExodusIIReader.NODAL, 1)
    reader.SetGenerateGlobalElementIdArray(True)
    reader.SetTimeStep(reader.GetTimeStepRange()[1])
    reader.Update()
    return leaves(reader.GetOutput())


def check_readers(one, folder):
    """VTK opens the set as one data set, and each file alone; both show what the one file holds."""
    files = files_of(folder / "particles.e")
    with Dataset(one / "particles.e") as data:
        steps = len(data["time_whole"][:])
    expected = by_id(one, "pressure")
    found_steps, grids = read_as_one(files)
    assert found_steps == steps, f"VTK sees {found_steps} time steps of {steps}"
    assert seen(grids, "pressure", "ids") == expected, "VTK's IOSS reader does not show the set as the one file"
    alone = [seen(read_alone(file), "pressure", "GlobalElementId") for file in files]
    together = {number: values for part in alone for number, values in part.items()}
    assert sum(map(len, alone)) == len(together) == len(expected)
    assert all(together[number][0] == values[0] for number, values in expected.items())
    # This reader keeps places as single numbers.
    corners = np.array([[values[1:] for values in found.values()] for found in (dict(sorted(together.items())), expected)])
    order = np.argsort(list(expected))
    assert np.allclose(corners[0], corners[1][order], rtol=0.0, atol=1e-6 * np.abs(corners).max())


def check_whole_runs(barreno, folder, one):
    """Two and three ranks; exodiff and the report take a set."""
    for ranks in (2, 3):
        whole = run(barreno, ranks, folder / f"on{ranks}", *SHORT, *PER_RANK)
        check_same(one, whole, ranks)
        check_nemesis(whole, ranks)
        check_readers(one, whole)
        check_as_report_reads(one, whole)
    scripts = TESTS / "scripts"
    for command in (
        (scripts / "exodiff_lite.py", "-f", scripts / "same.exodiff", one / "particles.e", whole / "particles.e"),
        (TOOLS / "report.py", whole),
    ):
        result = subprocess.run([sys.executable, *command], capture_output=True, text=True, check=False)
        assert result.returncode == 0, f"{command[0].name}: {result.stdout}{result.stderr}"
    assert (whole / "report" / "fields.png").stat().st_size > 5000


def few_particles(folder):
    """A deck of two particles of one material, one of another and none of a third: on three ranks the first has none."""
    crumb = lambda name, at, across: {
        "Material": name, "Lower": [0.1, at], "Upper": [0.1 + 0.1 * across, at + 0.1], "Particles Per Cell": 1
    }  # fmt: skip
    deck = {
        "Grid": {"Mode": "plane strain", "Cell Size": 0.1, "Lower": [0.0, 0.0], "Upper": [1.0, 1.0]},
        "Materials": {name: elastic(1e6, 5e5) for name in ("Two", "One", "None")},
        "Bodies": {"Pair": crumb("Two", 0.1, 2), "Single": crumb("One", 0.7, 1)},
        "Time": {"End Time": 0.01},
        "Output": {"Field Interval": 0.005},
    }
    write_deck(folder / "few.xml", deck)
    return folder / "few.xml"


def check_empty_ranks(barreno, folder, _one):
    deck = few_particles(folder)
    for glyph in ("deformed", "point"):
        look = ("--set", f"Output/Particle Glyph={glyph}")
        one = run(barreno, 1, folder / f"few-{glyph}", *look, deck=deck)
        whole = run(barreno, 3, folder / f"few-{glyph}-set", *look, *PER_RANK, deck=deck)
        check_same(one, whole, 3)
        check_nemesis(whole, 3)
        with Dataset(whole / "particles.e.3.0") as data:
            assert "num_elem" not in data.dimensions or len(data.dimensions["num_elem"]) == 0
        check_readers(one, whole)
        check_as_report_reads(one, whole)


def check_resume(barreno, folder, one):
    """A set of two goes on as that set on 1, 2 and 3 ranks, without a gap or a step twice; after a kill too."""
    whole = run(barreno, 2, folder / "to_resume", *SHORT, *PER_RANK)
    for ranks in (1, 2, 3):
        again = at_previous(pathlib.Path(shutil.copytree(whole, folder / f"resumed{ranks}")))
        must_work(program(barreno, ranks, "resume", again))
        check_same(one, again, 2)
    killed = folder / "killed"
    words = ("run", DECK, "--out", killed, *SHORT, *PER_RANK, "--set", "Output/Checkpoint Steps=20")
    stopped_run(barreno, 2, words, signal.SIGKILL, lambda: lines_of(killed / "history.csv") >= 22)
    must_work(program(barreno, 2, "resume", killed))
    check_same(one, killed, 2)


def refused(result, *said):
    assert result.returncode == 2, f"exit {result.returncode}: {result.stderr}"
    lines = [line for line in result.stderr.splitlines() if not line.startswith("warning: ")]
    assert len(lines) == 1 and all(words in lines[0] for words in said), result.stderr


def check_missing(barreno, folder, _one):
    """Without one of its files a set neither goes on nor changes; a run does not write beside an old set."""
    whole = at_previous(pathlib.Path(shutil.copytree(folder / "to_resume", folder / "missing")))
    (whole / "particles.e.2.1").unlink()
    before = (whole / "particles.e.2.0").read_bytes()
    refused(program(barreno, 2, "resume", whole), "particles.e.2.1")
    assert (whole / "particles.e.2.0").read_bytes() == before
    for name in ("history.csv", "depth.csv", "run.log", "deck.xml", "summary.json", "checkpoint.h5", "checkpoint_previous.h5"):
        (whole / name).unlink(missing_ok=True)
    refused(program(barreno, 1, "run", DECK, "--out", whole, *SHORT), "already holds a result (particles.e.2.0)")
    run(barreno, 3, whole, *SHORT, *PER_RANK, "--overwrite")
    assert set_names(whole) == [f"particles.e.3.{r}" for r in range(3)]


def check_full_disk(barreno, folder, one):
    """No room for the second rank's file alone: one sentence, exit code 2, on all ranks; resumed, it is the run with room."""
    for name, limit in (("at_start", 500), ("later", 4500)):
        full = folder / f"full_{name}"
        words = [barreno, "run", DECK, "--out", str(full), *SHORT, *PER_RANK, "--set", "Output/Checkpoint Steps=20"]
        # A file that would grow beyond the limit fails as on a full disk; Open MPI's shared memory would count as one.
        limited = ["bash", "-c", f"trap '' XFSZ; ulimit -f {limit}; exec \"$0\" \"$@\"", *words]
        command = ["mpirun", "--quiet", "--mca", "btl", "self,tcp", "-n", "1", *words, ":", "-n", "1", *limited]
        result = subprocess.run(command, capture_output=True, text=True, env=mpi_environment(2), timeout=120, check=False)
        refused(result, "cannot write", "particles.e.2.1", "Free disk space")
    assert set_names(folder / "full_at_start") == [], "half a set was left"
    must_work(program(barreno, 2, "resume", full))
    check_same(one, full, 2)


def main():
    barreno = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        one = run(barreno, 1, folder / "one", *SHORT)
        for check in (check_whole_runs, check_empty_ranks, check_resume, check_missing, check_full_disk):
            check(barreno, folder, one)
            print(check.__name__, "holds", flush=True)


if __name__ == "__main__":
    main()
