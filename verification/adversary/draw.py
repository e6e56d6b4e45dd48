# SPDX-License-Identifier: BSD-3-Clause
"""Random option sets over a deck: values by the kind, unit and bounds that the deck reference gives them."""
import math
import re

from adversary.deck_tree import NUMBER, metres, numbers_in

# How likely an option of a section is to be drawn.
CHANCE = {"Step": 0.15, "Output": 0.2, "Quasi-Static": 0.3, "Jet": 0.15, "Pore Flow": 0.2, "Confinement": 0.2, "Body Force": 0.2}
OFTEN = {"Step/Shape Function": 0.6, "Step/Transfer": 0.6, "Step/Order": 0.5, "Step/Largest Expansion": 0.25,
    "Output/Checkpoint Steps": 0.0}
LISTS = {"Bodies": 0.06, "Loads": 0.05, "Conditions": 0.05, "Contact": 0.2, "Materials": 0.03, "Pore Flow/Rocks": 0.2,
    "Pore Flow/Conditions": 0.1}
# What a scene is made of: another choice seldom leaves a scene.
FIXED = {"Schema Version", "Title", "Units", "Mode", "Source", "Model", "Card", "Shape", "Material", "Other Material", "Body", "Bodies",
    "Face", "Table", "File"}
PLACES = {"Lower", "Upper", "Centre", "Start", "End", "Radius", "End Radius", "Inner Radius", "Corners", "Point", "Normal", "From", "To",
    "Axis", "Parts", "File Unit", "Shift"}


def shown(value):
    return repr(float(value))


def edge_of(option, rng):
    """A value at or beside one of an option's bounds."""
    sides = [s for s in (option.lower, option.upper) if math.isfinite(s)]
    side = float(rng.choice(sides))
    inside = 1.0 if side == option.lower else -1.0
    is_open = option.lower_open if side == option.lower else option.upper_open
    return side + inside * (10 ** rng.uniform(-3, -1) * max(abs(side), 1.0) if is_open or rng.random() < 0.5 else 0.0)


def scale_of(option, scene):
    """What a quantity of this unit is about, for one without a value of its own."""
    unit = option.unit
    time, cell = scene["time"], scene["cell"]
    table = {"s": 0.1 * time, "1/s": 3.0 / time, "m": 2 * cell, "m/s": 30.0, "Pa": 1e7, "m s-2": 1e4, "1/m": 0.3 / cell, "kg/m3": 1e3,
        "m2": 1e-13}
    return table.get(unit, 1.0)


def within(option, value):
    value = min(max(value, option.lower), option.upper)
    if value == option.lower and option.lower_open:
        value += 1e-3 * max(1.0, abs(value))
    if value == option.upper and option.upper_open:
        value -= 1e-3 * max(1.0, abs(value))
    return value


def number(option, now, scene, rng):
    """@param now  the number that holds without a change, None if there is none"""
    if (math.isfinite(option.lower) or math.isfinite(option.upper)) and rng.random() < 0.25:
        return edge_of(option, rng)
    if math.isfinite(option.lower) and math.isfinite(option.upper) and option.upper > option.lower:
        return float(rng.uniform(option.lower, option.upper))
    base = now if now else scale_of(option, scene)
    return within(option, base * 10 ** rng.uniform(-0.7, 0.7))


def whole(option, now, rng):
    lower = option.lower if math.isfinite(option.lower) else 0
    upper = option.upper if math.isfinite(option.upper) else max(4 * (now or 10), lower + 20)
    upper = min(upper, 5) if "Particles Per Cell" in option.name else upper
    return int(rng.integers(int(lower), int(upper) + 1))


def scaled(text, rng):
    """The numbers of a value, each a little different."""
    return NUMBER.sub(lambda found: shown(float(found.group()) * 10 ** rng.uniform(-0.3, 0.3)), text)


def draw_value(option, now, scene, rng):
    """A value as a deck would say it, None if there is none to be drawn. @param now  what the deck says, None if nothing"""
    known = now if now is not None else (option.default if option.default not in ("required", "optional", "empty") else None)
    if option.kind == "word":
        return str(rng.choice(option.words))
    if option.kind == "words" and option.words:
        return "{" + str(rng.choice(option.words)) + "}"
    if option.kind == "flag":
        return str(rng.choice(["true", "false"]))
    if option.kind == "integer":
        return str(whole(option, int(float(known)) if known else None, rng))
    if option.kind == "number":
        if now is not None and rng.random() < 0.7:
            return scaled(now, rng)
        return shown(number(option, numbers_in(known)[0] if known else None, scene, rng))
    if option.kind == "array":
        if now is not None:
            return scaled(now, rng)
        components = [within(option, scale_of(option, scene) * rng.normal()) for _ in range(scene["dimensions"])]
        return "{" + ", ".join(map(shown, components)) + "}"
    if option.kind == "table" and now is not None:
        return None
    return None


def add_lists(deck, rng, table):
    """Conditions, contact, loads and lists that the deck does without."""
    materials, bodies = deck.lists("Materials"), deck.lists("Bodies")
    faces = next(o.words for o in table["Conditions/*"] if o.name == "Face")[: 2 * len(metres(deck.value("Grid/Lower")))]
    taken = {deck.value(f"Conditions/{name}/Face") for name in deck.lists("Conditions")}
    added = []
    for face in faces:
        if face not in taken and rng.random() < 0.05:
            added += [(f"Conditions/drawn {face}/Face", face), (f"Conditions/drawn {face}/Kind", str(rng.choice(["symmetry", "fixed"])))]
    pairs = {frozenset((deck.value(f"Contact/{n}/Material"), deck.value(f"Contact/{n}/Other Material"))) for n in deck.lists("Contact")}
    for i, one in enumerate(materials):
        for other in materials[i + 1 :]:
            if frozenset((one, other)) not in pairs and rng.random() < 0.1:
                kind = str(rng.choice(["friction", "frictionless", "stick"]))
                at = f"Contact/{one} on {other}/"
                added += [(at + "Material", one), (at + "Other Material", other), (at + "Kind", kind)]
                added += [(at + "Friction Coefficient", shown(rng.uniform(0, 1)))] if kind == "friction" else []
    if deck.find("Body Force") is None and rng.random() < 0.06:
        force = [shown(10 ** rng.uniform(0, 5) * rng.normal()) for _ in metres(deck.value("Grid/Lower"))]
        added += [("Body Force/Kind", "gravity"), ("Body Force/Acceleration", "{" + ", ".join(force) + "}")]
    if deck.find("Confinement") is None and rng.random() < 0.05:
        added += [("Confinement/Pressure", shown(10 ** rng.uniform(3, 8))), ("Confinement/Bodies", "{" + ", ".join(bodies) + "}")]
    if deck.find("Quasi-Static") is None and rng.random() < 0.02:
        added += [("Quasi-Static/Transit Ratio", shown(10 ** rng.uniform(-4, -1)))]
    return added


def draw_set(deck, table, rng):
    """@return what to change: (path in the deck, value) pairs, and the path in the deck reference of each"""
    scene = {
        "time": max(metres_free(deck.value("Time/End Time")), 1e-9),
        "cell": metres(deck.value("Grid/Cell Size"))[0],
        "dimensions": len(metres(deck.value("Grid/Lower"))),
    }
    changes = add_lists(deck, rng, table)
    drawn = {path: re.sub("^(Conditions|Contact)/[^/]*", r"\1/*", path) for path, _ in changes}

    def consider(option, path, chance):
        if option.name in FIXED or option.kind in ("text", "file") or rng.random() >= chance:
            return
        value = draw_value(option, deck.value(path), scene, rng)
        if value is not None:
            changes.append((path, value))
            drawn[path] = option.path

    for section, options in table.items():
        if section.startswith("Model ") or section in ("Grid", "Time"):
            continue
        if not section.endswith("*"):
            if section and section not in ("Step", "Output") and deck.find(section) is None:
                continue
            for option in options:
                consider(option, option.path, OFTEN.get(option.path, CHANCE.get(section, 0.1)))
            continue
        lists = section[:-2]
        for name in deck.lists(lists):
            own = table.get("Model " + (deck.value(f"Materials/{name}/Model") or ""), []) if lists == "Materials" else []
            for option in [*options, *own]:
                path = f"{lists}/{name}/{option.name}"
                chance = LISTS.get(lists, 0.05)
                # Optional words of one kind of load, shape or motion are refused beside another; those that are there are not.
                if option.name in PLACES:
                    chance = 0.01 if deck.value(path) is not None else 0.0
                elif option.default == "optional" and deck.value(path) is None:
                    chance *= 0.3
                consider(option, path, chance)
    return changes, drawn


def metres_free(text):
    """A time in seconds; of a deck that ends at rest, about when it does."""
    if text == "at rest":
        return 500e-6
    units = {"": 1.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9}
    value, _, unit = text.strip().partition(" ")
    return float(value) * units[unit.strip()]
