# SPDX-License-Identifier: BSD-3-Clause
"""A set of files (one per rank) as one file. Each file of a set has a share of every block, those of the first file
come first."""

import contextlib
import pathlib
import re
import tempfile

import numpy as np
from netCDF4 import Dataset

from barreno.runs.classic_netcdf import refuse_cut
from barreno.runs.regular_file import checked

# What only a file of a set has: its place in the set, and its own numbers of the nodes and elements inside it.
NEMESIS = re.compile(
    r".*_global|(node|elem)_map[ibe].*|(nem_ftype|(int|bor|ext)_[ne]_stat|num_(int|bor|ext)_(node|elem)s?)"
    r"|(n|e)_comm_.*|num_processors|num_procs_file"
)


def files_of(path):
    """The files that `path` stands for, the first one first; itself if it is no set."""
    path = pathlib.Path(path)
    member = re.fullmatch(r"(.+)\.(\d+)\.\d+", path.name)
    if path.exists() and not member:
        return [path]
    stem, wanted = (member.group(1), int(member.group(2))) if member else (path.name, None)
    sets = {}
    for file in path.parent.glob(f"{stem}.*.*"):
        match = re.fullmatch(re.escape(stem) + r"\.(\d+)\.(\d+)", file.name)
        if match and wanted in (None, int(match.group(1))):
            sets.setdefault(int(match.group(1)), {})[int(match.group(2))] = file
    if not sets:
        raise OSError(f"there is neither '{path}' nor a set of files of that name")
    if len(sets) > 1:
        raise OSError(f"'{path.parent}' has sets of {' and '.join(map(str, sorted(sets)))} files; name a file of one")
    count, found = sets.popitem()
    missing = sorted(set(range(count)) - set(found))
    if missing:
        raise OSError(f"the set '{path.parent / stem}' of {count} files lacks number {missing[0]}")
    return [found[number] for number in range(count)]


def length(data, dimension):
    return len(data.dimensions[dimension]) if dimension in data.dimensions else 0


class Set:
    """The open files, and how many elements of each block they have."""

    def __init__(self, files):
        for file in files:
            refuse_cut(file)
        self.parts = [Dataset(checked(file)) for file in files]
        for part in self.parts:
            part.set_auto_mask(False)
        self.blocks = range(1, length(self.parts[0], "num_el_blk") + 1)
        self.counts = [[length(part, f"num_el_in_blk{b}") for b in self.blocks] for part in self.parts]
        sizes = [(length(p, "num_nodes"), length(p, "num_elem")) for p in self.parts]
        self.nodes, self.elements = (sum(size[i] for size in sizes) for i in (0, 1))
        self.per_element = self.nodes // self.elements if self.elements else 1
        self.steps = min(len(part.dimensions["time_step"]) for part in self.parts)

    def by_block(self, arrays, width):
        """Entries of nodes or elements, block after block, of arrays that have them file after file."""
        pieces = []
        for b in range(len(self.blocks)):
            for counts, values in zip(self.counts, arrays):
                begin = width * sum(counts[:b])
                pieces.append(values[begin : begin + width * counts[b]])
        return np.concatenate(pieces)

    def values(self, name, dimensions, step):
        """A variable of the whole set, at a time step unless that is None."""
        parts = [p.variables[name] for p in self.parts if name in p.variables]
        arrays = [part[:] if step is None else part[step] for part in parts]
        kind = dimensions[0 if step is None else 1] if len(dimensions) > (step is not None) else ""
        if name == "eb_status":
            return np.max(arrays, axis=0)
        if re.fullmatch(r"connect\d+", name):
            block = int(name[7:])
            begin = sum(sum(counts[: block - 1]) for counts in self.counts)
            rows = np.arange(begin, begin + sum(len(array) for array in arrays))
            return self.per_element * rows[:, None] + np.arange(self.per_element) + 1
        if kind in ("num_nodes", "num_elem"):
            whole = [p.variables[name] if name in p.variables else None for p in self.parts]
            whole = [np.empty(0) if v is None else v[:] if step is None else v[step] for v in whole]
            return self.by_block(whole, self.per_element if kind == "num_nodes" else 1)
        return np.concatenate(arrays) if kind.startswith("num_el_in_blk") else arrays[0]

    def close(self):
        for part in self.parts:
            part.close()

    def size(self, name):
        """Of a dimension, that of time left open."""
        own = {"time_step": None, "num_nodes": self.nodes, "num_elem": self.elements}
        if name in own:
            return own[name]
        sizes = [length(part, name) for part in self.parts]
        return sum(sizes) if name.startswith("num_el_in_blk") else max(sizes)


def join(files, out):
    whole = Set(files)
    with Dataset(out, "w", format=whole.parts[0].data_model) as joined:
        joined.setncatts({name: whole.parts[0].getncattr(name) for name in whole.parts[0].ncattrs()})
        for name in dict.fromkeys(name for part in whole.parts for name in part.dimensions):
            if not NEMESIS.fullmatch(name):
                joined.createDimension(name, whole.size(name))
        variables = {name: v for part in reversed(whole.parts) for name, v in part.variables.items()}
        for name, variable in variables.items():
            if NEMESIS.fullmatch(name):
                continue
            copy = joined.createVariable(name, variable.dtype, variable.dimensions)
            copy.setncatts({key: variable.getncattr(key) for key in variable.ncattrs()})
            if variable.dimensions[:1] != ("time_step",):
                copy[:] = whole.values(name, variable.dimensions, None)
                continue
            for step in range(whole.steps):
                copy[step] = whole.values(name, variable.dimensions, step)
    whole.close()


class WholeVariable:
    """A variable of a set; nothing of it is read before it is asked for."""

    def __init__(self, whole, name):
        self.whole, self.name = whole, name
        self.dimensions = next(part.variables[name].dimensions for part in whole.parts if name in part.variables)

    def __getitem__(self, index):
        """All of it, or a time step of what has one for each."""
        if self.dimensions[0] != "time_step":
            return self.whole.values(self.name, self.dimensions, None)[index]
        if isinstance(index, slice):
            steps = range(self.whole.steps)[index]
            return np.array([self.whole.values(self.name, self.dimensions, step) for step in steps])
        return self.whole.values(self.name, self.dimensions, range(self.whole.steps)[index])


class WholeData:
    """A set, open, with what a reader asks of one open file: dimensions that have a length, and variables."""

    def __init__(self, files):
        self.whole = Set(files)
        names = {name for part in self.whole.parts for name in part.dimensions}
        self.dimensions = {name: range(self.whole.steps if name == "time_step" else self.whole.size(name)) for name in names}
        self.variables = {name: WholeVariable(self.whole, name) for part in self.whole.parts for name in part.variables}

    def close(self):
        self.whole.close()


def open_whole(path):
    """What `path` stands for, open: a file, or a set of files, which is read as it lies there."""
    files = files_of(path)
    if len(files) > 1:
        return WholeData(files)
    refuse_cut(files[0])
    data = Dataset(checked(files[0]))
    data.set_auto_mask(False)
    return data


@contextlib.contextmanager
def as_one_file(path):
    """The file itself, or a joined one for as long as it is needed."""
    files = files_of(path)
    with tempfile.TemporaryDirectory() as folder:
        if len(files) > 1:
            join(files, pathlib.Path(folder) / "joined.e")
        yield files[0] if len(files) == 1 else pathlib.Path(folder) / "joined.e"
