# SPDX-License-Identifier: BSD-3-Clause
"""A run folder, open for reading."""

import contextlib
import difflib
import numbers
import pathlib
import warnings

import barreno
from barreno.interface import frames
from barreno.interface.deck import Deck
from barreno.runs.faults import FILE, BadRun, Fault, needed, on_one_line
from barreno.runs.lock import is_running
from barreno.runs.run_folder import other_version, progress_of, read_summary
from barreno.runs.words import TIME_UNITS, quantity_of

MICRO = 1e-6
MOST_SQUARES = 2e7  # of a grid, half a gigabyte
CLOSE = 1e-3  # of the interval of outputs: how far a time may be from an output that is meant


def time_text(time):
    return f"{time / MICRO:.6g} us"


def seconds_of(time):
    """A number in s, or a text as "30 us"."""
    try:
        return quantity_of(time, TIME_UNITS) if isinstance(time, str) else float(time)
    except (TypeError, ValueError):
        raise Fault(f'{time!r} is not a time; write for example "30 us", or 30e-6 in s.') from None


def step_of(times, time, folder):
    """The output at a time; the last one for None."""
    if time is None:
        return len(times) - 1
    wanted = seconds_of(time)
    away = [abs(one - wanted) for one in times]
    order = sorted(range(len(times)), key=away.__getitem__)
    interval = min((after - before for before, after in zip(times, times[1:])), default=abs(wanted))
    if away[order[0]] <= CLOSE * interval:
        return order[0]
    near = " and ".join(time_text(times[i]) for i in sorted(order[:2]))
    raise Fault(f"{folder} has no output at {time_text(wanted)}; the nearest are at {near} (times has all {len(times)}).")


def check_name(name, known, folder):
    if name in known:
        return
    near = difflib.get_close_matches(str(name).lower().replace(" ", "_"), known, 3, 0.5)
    hint = f"the nearest are {', '.join(near)}; " if near else ""
    raise Fault(f'"{name}" is not a field of {folder}; {hint}it has {", ".join(sorted(known))}.')


def need_fields():
    """What reads particles."""
    needed("numpy")
    needed("netCDF4")


def unit_of_field(name):
    from barreno.report.run_tables import UNITS

    return UNITS.get("velocity_x" if name == "speed" else name, "-")


class Run:
    """What a run wrote, as tables and arrays in SI units. Every call reads the files afresh, so a run may still be under way.

    Parameters
    ----------
    folder : path
        As `barreno.open` takes it.

    Attributes
    ----------
    folder : pathlib.Path
    """

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def __repr__(self):
        state = "running" if self.running else "finished" if self.finished else "not finished"
        return f"<barreno.Run {self.folder}: {state}>"

    @property
    def running(self):
        """Whether a program works in the folder now."""
        return is_running(self.folder)

    @property
    def finished(self):
        """Whether the run has reached its end."""
        with contextlib.suppress(Fault):  # of a summary that was cut
            return (self.folder / "summary.json").exists() and self.summary.get("finished") is True
        return False

    @property
    def summary(self):
        """dict of summary.json: how the run ended, and its results (docs/output.md).

        Raises
        ------
        Fault
            While the run is under way, or if it was killed.
        """
        if not (self.folder / "summary.json").exists():
            raise Fault(f"{self.folder} has no summary.json yet, {self._state()}", FILE)
        return read_summary(self.folder)

    def _state(self):
        if self.running:
            return f"because its run is under way ({100.0 * progress_of(self.folder):.0f} %); wait for its end, or read its tables."
        return f"because its run was stopped before its end; continue it with barreno resume {self.folder}."

    @property
    def deck(self):
        """The effective deck: every value that was used, in SI, as nested dictionaries."""
        return Deck.read(self.folder / "deck.xml")

    def table(self, name):
        """A table that the run wrote, such as "radii.csv".

        Parameters
        ----------
        name : str
            Of a CSV file in the folder.

        Returns
        -------
        pandas.DataFrame
            Its `attrs["units"]` has the unit of every column.

        Raises
        ------
        Fault
            If there is no such table, or the file is none; the sentence names those that are there.
        """
        if not (self.folder / name).exists():
            there = ", ".join(sorted(file.name for file in self.folder.glob("*.csv"))) or "none"
            raise Fault(f"{self.folder} has no table {name}; it has {there}.", FILE)
        return frames.read_columns(self.folder / name)

    @property
    def history(self):
        """pandas.DataFrame of history.csv: energies, balances, counts; units in `attrs["units"]`."""
        return self.table("history.csv")

    @property
    def depth(self):
        """pandas.DataFrame of depth.csv: depth of the jet and of its channel; units in `attrs["units"]`.

        Raises
        ------
        Fault
            If the deck has no jet.
        """
        return self.table("depth.csv")

    @contextlib.contextmanager
    def _reading(self):
        """Whatever a reader finds wrong, as a Fault; of a run under way the sentence says so."""
        try:
            yield
        except BadRun as error:
            state = "; its run is under way, so try again at its next output" if self.running else "; make the run again"
            raise Fault(f"cannot read {self.folder} ({on_one_line(error)}){state}.", FILE) from None

    @contextlib.contextmanager
    def _particle_file(self):
        need_fields()
        from barreno.report.deck import read_deck
        from barreno.report.files import reading
        from barreno.report.particles import ParticleFile

        path = self.folder / "particles.e"
        with self._reading():
            deck = read_deck(self.folder / "deck.xml")
            with reading(path):
                file = ParticleFile(path)
                try:
                    if len(file.times) == 0:
                        raise ValueError("it has no time step")
                    yield file, deck
                finally:
                    file.close()

    @property
    def times(self):
        """numpy.ndarray of the times of particles.e [s]."""
        with self._particle_file() as (file, _):
            return file.times.copy()

    @property
    def fields(self):
        """Names of the fields that `particles` and `grid` can give."""
        need_fields()
        from barreno.report.fields import known_fields

        with self._particle_file() as (file, deck):
            return sorted(known_fields(file, deck))

    def particles(self, time=None, fields=None):
        """Particles that exist at an output.

        Parameters
        ----------
        time : float or str, optional
            In s, or as "30 us"; the last output if it is not given.
        fields : list of str, optional
            All fields if it is not given.

        Returns
        -------
        pandas.DataFrame
            A row for each particle, by its number: material, centre (x, y and in three dimensions z [m]) and fields in SI, nan where a
            material does not carry the field. `attrs` has `time` [s] and `units`.

        Raises
        ------
        Fault
            If there is no such output or field: the sentence names the nearest.
        """
        pandas = needed("pandas")
        need_fields()
        from barreno.report.fields import known_fields, values_of

        fields = [fields] if isinstance(fields, str) else fields
        with self._particle_file() as (file, deck):
            known = known_fields(file, deck)
            for name in fields or ():
                check_name(name, known, self.folder)
            frame = file.frame(step_of(list(file.times), time, self.folder))
            axes = "xyz"[: file.dimensions]
            columns = {"material": pandas.Categorical.from_codes(frame.block, file.block_names)}
            columns |= {axis: frame.centres[:, i] for i, axis in enumerate(axes)}
            columns |= {name: values_of(frame, deck, name) for name in (sorted(known) if fields is None else fields)}
            found = pandas.DataFrame(columns, index=pandas.Index(file.numbers[frame.alive], name="particle"))
            found.attrs["time"] = frame.time
        units = dict.fromkeys(axes, "m")
        found.attrs["units"] = {name: units.get(name) or unit_of_field(name) for name in found.columns if name != "material"}
        return found

    def grid(self, field, time=None, spacing=None):
        """A field on a regular grid of the plane: the mean over the material in every square, by the deformed shapes of the particles.

        Parameters
        ----------
        field : str
        time : float or str, optional
            As of `particles`.
        spacing : float, optional
            Edge of the squares [m]; that of the deck's cells if it is not given.

        Returns
        -------
        xarray.DataArray
            Dimensions y and x [m], the centres of the squares; nan where no material is. Without xarray a dict of `x`, `y` and `values`.
            In three dimensions the particles that the plane of the report cuts, just inside the least z.
        """
        need_fields()
        from barreno.interface.squares import count_squares, mean_on_squares
        from barreno.report.fields import known_fields, values_of

        with self._particle_file() as (file, deck):
            check_name(field, known_fields(file, deck), self.folder)
            frame = file.frame(step_of(list(file.times), time, self.folder))
            spacing = deck.number("Grid/Cell Size") if spacing is None else spacing
            if not (isinstance(spacing, numbers.Real) and 0.0 < spacing < float("inf")):
                raise Fault(f"spacing={spacing!r} is not a length above 0 in m; write for example spacing=1e-3.")
            shapes, of = frame.shapes
            if count_squares(shapes, float(spacing)) > MOST_SQUARES:
                raise Fault(f"spacing={spacing:g} m divides the particles into more than {MOST_SQUARES:.0e} squares; choose a larger one.")
            x, y, values = mean_on_squares(shapes, values_of(frame, deck, field)[of], float(spacing))
            attributes = {"time": frame.time, "units": unit_of_field(field)}
        try:
            import xarray
        except ModuleNotFoundError:
            return {"x": x, "y": y, "values": values, **attributes}
        metre = {"units": "m"}
        return xarray.DataArray(values, {"y": ("y", y, metre), "x": ("x", x, metre)}, ("y", "x"), field, attributes)

    @property
    def hole(self):
        """The hole at the last output; see `hole_at`."""
        return self.hole_at()

    def hole_at(self, time=None):
        """The hole that the jet has left in the target (docs/report.md).

        Parameters
        ----------
        time : float or str, optional
            As of `particles`.

        Returns
        -------
        barreno.report.hole.Hole
            `depth` and `radius` of its rows, `length`, `entrance_diameter`, `volume` and `diameter_below(depth)`, in SI.

        Raises
        ------
        Fault
            If the deck has no jet.
        """
        need_fields()
        needed("pandas")
        from barreno.report.files import read_columns
        from barreno.report.hole import face_of, measure_hole

        with self._particle_file() as (file, deck):
            if not (deck.has_jet or deck.forms_jet):
                raise Fault(f"{self.folder} has no jet, and so no hole; its deck has neither Jet nor Jet Monitor.")
            frame = file.frame(step_of(list(file.times), time, self.folder))
            path = self.folder / "depth.csv"
            return measure_hole(frame, deck, face_of(read_columns(path) if path.exists() else None, file, deck))


def open(folder):
    """Opens the folder of a run, finished or not.

    Parameters
    ----------
    folder : path
        As "runs/perforation-1".

    Returns
    -------
    Run

    Raises
    ------
    Fault
        If there is no run in the folder.

    Warns
    -----
    UserWarning
        If another version of Barreno made the run, or its summary.json was cut: its tables can be read all the same.

    Examples
    --------
    >>> run = barreno.open("runs/quick")
    >>> run.depth.plot("time", "depth")
    """
    if not isinstance(folder, (str, pathlib.PurePath)):
        raise Fault(f'{folder!r} is not a path; write for example barreno.open("runs/perforation-1").', FILE)
    run = Run(folder)
    if not run.folder.is_dir():
        raise Fault(f"{folder} is not a folder (a run is opened by the folder that it wrote); check the path.", FILE)
    missing = [name for name in ("deck.xml", "history.csv") if not (run.folder / name).exists()]
    if missing:
        raise Fault(f"{folder} is not the folder of a run (it has no {missing[0]}); give the folder that barreno run named.", FILE)
    try:
        version = run.summary.get("version", "") if (run.folder / "summary.json").exists() else ""
    except Fault as fault:
        warnings.warn(str(fault), stacklevel=2)
        return run
    if other_version(folder, version):
        warnings.warn(other_version(folder, version), stacklevel=2)
    return run
