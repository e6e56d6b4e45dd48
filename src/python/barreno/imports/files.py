# SPDX-License-Identifier: BSD-3-Clause
"""Files of an input of Uintah: XML, files that it includes, and files beside it."""

import pathlib
import xml.etree.ElementTree as ElementTree

from barreno.imports.ups import Ups
from barreno.runs.faults import FILE, Fault

MOST_INCLUDES = 100  # a file that includes itself
DEEPEST = 100  # elements in each other; inputs of Uintah have about twelve


def parse(path):
    try:
        root = ElementTree.parse(path).getroot()
    except OSError as error:
        raise Fault(f"{path} cannot be read ({error.strerror}); check the path.", FILE) from None
    except ElementTree.ParseError as error:
        raise Fault(f"{path} is not XML ({error}); correct it.") from None
    except (LookupError, ValueError) as error:  # a name of an encoding that Python or the parser lacks
        raise Fault(
            f'{path} cannot be read ({error}); write its first line with encoding="UTF-8" or "ISO-8859-1", whichever the file has.'
        ) from None
    refuse_depth(root, path)
    return root


def refuse_depth(root, path):
    """Level by level, since a function that calls itself ends in deep files."""
    level = [root]
    for _ in range(DEEPEST):
        level = [child for element in level for child in element]
        if not level:
            return
    raise Fault(f"{path} has elements nested more than {DEEPEST} deep (an input of Uintah has about twelve levels); correct it.")


def found_beside(name, folder, named_by):
    """Beside the file or above it: Uintah resolves such names from the folder that it is started in."""
    if not name:
        raise Fault(f"{named_by} in {folder} names no file; write its name.")
    for place in (folder, *folder.parents):
        try:
            if (place / name).is_file():
                return place / name
        except (OSError, ValueError):  # a name that no file can have
            break
    raise Fault(f"{name} does not exist (named by {named_by} in {folder}, and sought there and in the folders above); bring the file to "
        "its place.", FILE)


def section_of(root, section, path):
    """The element that an <include section="a/b"> names, whose children are meant."""
    parts = section.strip("/").split("/")
    for part in parts[1:] if parts[0] == root.tag else parts:
        child = next((child for child in root if child.tag == part), None)
        if child is None:
            raise Fault(f'{path} has no section "{section}" (an <include> names it); correct the name.')
        root = child
    return root


def included(child, beside, left):
    """(elements in the place of an <include>, how many more may come)"""
    path = found_beside(child.get("href", "").strip(), beside, "an <include>")
    root = parse(path)
    left = insert_includes(root, path.resolve().parent, left - 1)
    if child.get("section"):
        return list(section_of(root, child.get("section"), path)), left
    # A file of one material constant is that element; others hold several in a root of their own.
    return (list(root) if root.tag in ("Uintah_Include", "Uintah_specification") else [root]), left


def insert_includes(element, beside, left):
    """Replaces every <include href="..."/> by what its file holds. @param left  how many more may come"""
    for position, child in reversed(list(enumerate(element))):
        if child.tag != "include":
            left = insert_includes(child, beside, left)
            continue
        if left == 0:
            raise Fault(f"more than {MOST_INCLUDES} files are included (one of them may include itself); remove the circle.")
        new, left = included(child, beside, left)
        if child.tail and child.tail.strip():  # stray text stays where it is
            element.insert(position + 1, stray := ElementTree.Element("text"))
            stray.text = child.tail
        element[position : position + 1] = new
    return left


def read_ups(path):
    """@return the root of the file, with what it includes"""
    path = pathlib.Path(path)
    root = parse(path)
    if root.tag != "Uintah_specification":
        raise Fault(f"{path} begins with <{root.tag}>, not with <Uintah_specification> (it is no input file of Uintah); give another file.")
    insert_includes(root, path.resolve().parent, MOST_INCLUDES)
    refuse_depth(root, path)
    whole = Ups(root, path.name)
    whole.mark()
    return whole
