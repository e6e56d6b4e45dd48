# SPDX-License-Identifier: BSD-3-Clause
"""A deck as nested dictionaries, and its check by the program."""

import contextlib
import difflib
import pathlib
import tempfile
import xml.etree.ElementTree as xml

from barreno.imports.deck import deck_text
from barreno.runs.faults import FILE, Fault, on_one_line
from barreno.runs.program import as_set, found_program, named, setting_words
from barreno.runs.regular_file import read_text
from barreno.runs.tables import place

READ = {"int": int, "double": float, "bool": lambda text: text.strip().lower() == "true"}
OF_A_DECK = '{"Time/End Time": "30 us"}'  # settings, as an example
TEXTS = ("Title",)  # entries that are never the name of a file


def value_of(entry):
    """Numbers and truths as such, all else as text: "10 ksi", "{0 mm, 1 mm}"."""
    text = entry.get("value", "")
    try:
        return READ.get(entry.get("type"), str)(text)
    except ValueError:
        return text


def entries_of(node):
    return {child.get("name", ""): entries_of(child) if child.tag == "ParameterList" else value_of(child)
        for child in node if child.tag in ("ParameterList", "Parameter")}


def with_whole_paths(entries, folder):
    """Files that are named beside the deck, by whole paths, so that the deck can be written elsewhere."""
    found = {}
    for name, value in entries.items():
        if isinstance(value, dict):
            value = with_whole_paths(value, folder)
        elif isinstance(value, str) and value and name not in TEXTS and "\n" not in value and len(value) < 1000:
            beside = folder / value
            value = str(beside.resolve()) if beside.is_file() else value
        found[name] = value
    return found


class NotInDeck(Fault, KeyError):
    """A path that a deck does not have."""

    __str__ = Exception.__str__


class Deck(dict):
    """The lists of a deck as dictionaries in dictionaries; a path such as "Time/End Time" reaches into them.

    Parameters
    ----------
    entries : dict
        Lists are dictionaries; values are numbers, truths, sequences of numbers, or texts with units as in a deck file.
    folder : path, optional
        Where files lie that the deck names without their whole path; the current folder if it is not given.
    name : str
        What sentences call the deck.

    Examples
    --------
    >>> deck = barreno.Deck.read("input_xml/perforation_quick.xml")
    >>> deck["Confinement/Pressure"] = "34 MPa"
    >>> deck.check()
    """

    def __init__(self, entries=(), folder=".", name="deck.xml"):
        super().__init__(entries)
        self.folder, self.name = pathlib.Path(folder), name

    @classmethod
    def read(cls, file):
        """A deck file.

        Parameters
        ----------
        file : path

        Returns
        -------
        Deck

        Raises
        ------
        Fault
            If the file cannot be read, or is no XML.
        """
        file = pathlib.Path(file)
        try:
            root = xml.fromstring(read_text(file))
        except FileNotFoundError:
            raise Fault(f"{file} does not exist (needed as the deck); check the path.", FILE) from None
        except (OSError, UnicodeDecodeError, xml.ParseError) as error:
            raise Fault(f"{file} cannot be read as a deck ({on_one_line(error)}); check the file.", FILE) from None
        return cls(entries_of(root), file.parent, file.name)

    def _owner(self, path, make=False):
        """(dictionary, name) of a path; lists on the way are made if they may be."""
        *lists, name = str(path).split("/")
        node, way = self, []
        for one in lists:
            way.append(one)
            if make:
                dict.setdefault(node, one, {})
            node = dict.get(node, one)
            if not isinstance(node, dict):
                raise NotInDeck(f"{self.name} has no list '{'/'.join(way)}'.")
        return node, name

    def __getitem__(self, path):
        node, name = self._owner(path)
        if name not in dict.keys(node):
            names = {one.lower(): one for one in dict.keys(node)}
            near = [names[one] for one in difflib.get_close_matches(name.lower(), list(names), 1)]
            raise NotInDeck(f"{self.name} has no '{path}'" + (f"; did you mean '{near[0]}'?" if near else "."))
        return dict.__getitem__(node, name)

    def __setitem__(self, path, value):
        node, name = self._owner(path, make=True)
        dict.__setitem__(node, name, value)

    def __delitem__(self, path):
        self[path]
        node, name = self._owner(path)
        dict.__delitem__(node, name)

    def __contains__(self, path):
        try:
            self[path]
        except KeyError:
            return False
        return True

    def get(self, path, default=None):
        """The value or list at a path; the default where there is none."""
        return self[path] if path in self else default

    def pop(self, path, *default):
        """The value or list at a path, which is removed; the default where there is none."""
        if default and path not in self:
            return default[0]
        value = self[path]
        del self[path]
        return value

    def setdefault(self, path, default=None):
        """The value or list at a path, which becomes the default where there is none."""
        if path not in self:
            self[path] = default
        return self[path]

    def update(self, *entries, **more):
        """Values by their paths."""
        for path, value in dict(*entries, **more).items():
            self[path] = value

    def text(self):
        """The XML of a deck file."""
        try:
            return deck_text(with_whole_paths(dict(self), self.folder), [])
        except (TypeError, ValueError) as error:
            raise Fault(f"{self.name} has a value that no deck can hold ({on_one_line(error)}); write numbers, sequences of numbers or "
                "texts with units.") from None

    def write(self, file):
        """Writes a deck file; files that the deck names are named by their whole paths.

        Parameters
        ----------
        file : path

        Raises
        ------
        Fault
            If the file cannot be written.
        """
        place(pathlib.Path(file), self.text())

    def check(self, set=None, fidelity=None):
        """The effective deck, with every value that would be used, in SI.

        Parameters
        ----------
        set : dict, optional
            {"List/Parameter": value}; None removes a value or a list.
        fidelity : {"fast", "balanced", "reference"}, optional

        Returns
        -------
        Deck

        Raises
        ------
        Fault
            With the sentence of `barreno check`, if the deck is not valid.
        """
        return check(self, set, fidelity)


@contextlib.contextmanager
def file_of(deck):
    """The file of a deck: itself, or that of dictionaries while it is needed."""
    if not isinstance(deck, dict):
        yield pathlib.Path(deck)
        return
    deck = deck if isinstance(deck, Deck) else Deck(deck)
    with tempfile.TemporaryDirectory(prefix="barreno-") as folder:
        file = pathlib.Path(folder) / deck.name
        deck.write(file)
        with named(deck.name):
            yield file


def words_of(file, settings, fidelity):
    """@param settings  {path: value}; None removes a value or a list"""
    words = setting_words(settings, OF_A_DECK)
    return [str(file), *as_set(words), *(["--fidelity", fidelity] if fidelity else [])]


def check(deck, set=None, fidelity=None):
    """The effective deck: every value that a run would use, in SI.

    Parameters
    ----------
    deck : path or dict
        A deck file, a `Deck` or nested dictionaries.
    set : dict, optional
        {"List/Parameter": value}; None removes a value or a list.
    fidelity : {"fast", "balanced", "reference"}, optional

    Returns
    -------
    Deck

    Raises
    ------
    Fault
        With the sentence of `barreno check`.
    """
    with file_of(deck) as file:
        text = found_program("check", 1).effective_deck(words_of(file, set, fidelity))
        return Deck(entries_of(xml.fromstring(text)), file.parent, file.name)
