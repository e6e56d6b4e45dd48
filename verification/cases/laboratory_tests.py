# SPDX-License-Identifier: BSD-3-Clause
"""Laboratory tests of sandstone with one material point: what the cards give, against what was measured."""
import pathlib
import tempfile

from barreno.materials import Material, load
from tools.case import Result
from tools.plug import Plug, write_card

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
CARDS_FOLDER = REPOSITORY / "materials" / "cards"
CARDS = ("berea_sandstone", "berea_sandstone_bounded", "berea_sandstone_damage", "berea_sandstone_heat")
KEPT = CARDS[-1]  # of the main job, whose answers must hold
MEGA = 1e6
STEP = 2e-4  # axial strain of an increment
PORE_STRAIN = 0.2231  # p3_crush_curve of the cards
SHORTENING = 0.05  # where volume strains are compared
WATER = {"fluid_B0": 2.25e9, "Matrix bulk modulus": 36e9, "Backstress strain": "poroplastic"}

SEEN, DERIVED, RECALLED, ASSUMED = "seen", "from seen ones", "recalled", "assumed"
# name: what was measured, its mark, source
DATA = {
    "unconfined strength [MPa]": ("77.0 and 79.8", SEEN, "two quarry blocks of Berea sandstone, ASTM C170"),
    "slope of the strength, 0 to 10 MPa": (
        "6.5 to 9", DERIVED, "friction angles of 50 and 55 degrees, J. Geotech. Geoenv. Eng. 133 (2007) 116"),
    "uniaxial tensile strength [MPa]": ("2 to 4", RECALLED, ""),
    "volume strain at 10 MPa [%]": ("dilates", SEEN, "Menendez, Zhu and Wong, J. Struct. Geol. 18 (1996) 1: shear band with dilatancy"),
    "volume strain at 40 MPa [%]": ("hardly dilates", SEEN, "the same: shear band with little dilatancy"),
    "volume strain at 250 MPa [%]": ("compacts", SEEN, "the same: compacting flow"),
    "largest swelling, 0.1 MPa, 12 % shorter [%]": ("a few", ASSUMED, ""),
    "undrained bulk modulus at 10 MPa [GPa]": ("15.8", SEEN, "Hart and Wang, JGR 100 (1995) 17741, a set consistent to 20 %"),
    "Skempton's coefficient at 10 MPa": ("0.75", SEEN, "the same"),
    "pore strain left at 2.5 GPa": ("closed", SEEN, "Ebert et al., Meteorit. Planet. Sci. (2018): shock in porous sandstone"),
    "pore strain left at 5 GPa": ("closed", SEEN, "Kowitz et al., Meteorit. Planet. Sci. 48 (2013): Seeberger sandstone, plane shock"),
    "strength at 200 /s over static": ("1.9", SEEN, "Rae et al. (2021): Seeberger sandstone, unconfined bar tests"),
    "pressure after 10 % of uniaxial extension [MPa]": ("none", ASSUMED, "torn rock bears neither tension nor pressure"),
}  # fmt: skip


def with_card(library, name, more, measure):
    with tempfile.TemporaryDirectory() as folder, Material(write_card(folder, CARDS_FOLDER / f"{name}.xml", more), library) as material:
        return measure(material)


def compressed(material, confinement, shortening, rate=1e-5):
    """Largest stress difference, and volume strain since the confinement, of a triaxial test at a rate [1/s]."""
    plug = Plug(material, None, STEP / rate)
    plug.confine(confinement)
    peak, volume = 0.0, 0.0
    for _ in range(round(shortening / STEP)):
        volume += plug.shorten(-STEP, confinement)
        peak = max(peak, float(plug.stress[0, 1] - plug.stress[0, 0]))
    return peak, volume


def pulled(material):
    """Largest axial tension under no stress at the side."""
    plug = Plug(material, None)
    peak = 0.0
    for _ in range(200):
        plug.shorten(0.02 * STEP, 0.0)
        peak = max(peak, float(plug.stress[0, 0]))
    return peak


def undrained(material):
    """Bulk modulus and Skempton's coefficient where the pressure less that of the fluid is 10 MPa."""
    plug = Plug(material, None)
    while plug.pressure() - plug.get("pore_pressure") < 10.0 * MEGA:
        plug.confine(plug.pressure() + MEGA)
    fluid = plug.get("pore_pressure")
    volume = plug.confine(plug.pressure() + MEGA)
    return -MEGA / volume, (plug.get("pore_pressure") - fluid) / MEGA


def pores_left(material, stress):
    """Share of the pore strain that is left when uniaxial strain has raised the axial stress to this."""
    plug = Plug(material, None)
    while -float(plug.stress[0, 0]) < stress:
        plug.strain_axially(-STEP)
    return 1.0 + plug.get("plastic_volume_strain") / PORE_STRAIN


def pressure_of_torn_rock(material):
    plug = Plug(material, None)
    for _ in range(round(0.1 / STEP)):
        plug.strain_axially(STEP)
    return plug.pressure()


def answers(library, name):
    """The numbers of DATA, in its order."""

    def dry(material):
        strength = compressed(material, 0.0, 0.01)[0]
        confined = compressed(material, 10.0 * MEGA, 0.02)[0]
        swelling = [100.0 * compressed(material, at * MEGA, SHORTENING)[1] for at in (10.0, 40.0, 250.0)]
        return [strength / MEGA, 1.0 + (confined - strength) / (10.0 * MEGA), pulled(material) / MEGA, *swelling,
                100.0 * compressed(material, 0.1 * MEGA, 0.12)[1]]  # fmt: skip

    def last(material):
        fast, slow = (compressed(material, 0.0, 0.01, rate)[0] for rate in (200.0, 1e-5))
        return [pores_left(material, 2.5e9), pores_left(material, 5e9), fast / slow, pressure_of_torn_rock(material) / MEGA]

    modulus, skempton = with_card(library, name, WATER, undrained)
    return [*with_card(library, name, {}, dry), modulus / 1e9, skempton, *with_card(library, name, {}, last)]


def demand(result, found):
    """What the card must give: from the data that were seen, and two that follow from what torn and sheared rock is."""
    at = found[KEPT].__getitem__
    result.demand("unconfined strength: off 78 MPa [MPa]", abs(at("unconfined strength [MPa]") - 78.0), 8.0)
    result.demand("strength from 0 to 10 MPa: slope off 7.75", abs(at("slope of the strength, 0 to 10 MPa") - 7.75), 1.25)
    dilation = at("volume strain at 10 MPa [%]")
    result.demand("sheared at 10 MPa: dilates [%]", dilation, 0.5, at_least=True)
    result.demand("sheared at 40 MPa: dilates, over 10 MPa", abs(at("volume strain at 40 MPa [%]")) / dilation, 0.33)
    result.demand("sheared at 250 MPa: compacts [%]", -at("volume strain at 250 MPa [%]"), 0.5, at_least=True)
    result.demand("sheared at 0.1 MPa: swells at 12 % [%]", at("largest swelling, 0.1 MPa, 12 % shorter [%]"), 6.0)
    modulus, skempton = at("undrained bulk modulus at 10 MPa [GPa]"), at("Skempton's coefficient at 10 MPa")
    result.demand("undrained at 10 MPa: bulk modulus off 15.8 GPa, relative", abs(modulus / 15.8 - 1.0), 0.2)
    result.demand("undrained at 10 MPa: Skempton's coefficient off 0.75, relative", abs(skempton / 0.75 - 1.0), 0.2)
    result.demand("compressed to 2.5 GPa: pore strain left", at("pore strain left at 2.5 GPa"), 0.1)
    result.demand("compressed to 5 GPa: pore strain left", at("pore strain left at 5 GPa"), 0.02)
    result.demand("at 200 /s: strength over static, off 1.9, relative", abs(at("strength at 200 /s over static") / 1.9 - 1.0), 0.1)
    result.demand("torn by 10 %: pressure [MPa]", at("pressure after 10 % of uniaxial extension [MPa]"), 0.0)


def run(barreno, full):
    del full  # one form: it takes seconds
    library = load(barreno.resolve().parents[1] / "materials" / "libBARRENO.so")
    found = {card: dict(zip(DATA, answers(library, card))) for card in CARDS}
    result = Result(
        "Laboratory tests of sandstone",
        "A card of Berea sandstone gives strength, dilatancy, undrained stiffness and closure of pores as measured.",
        "measurements, each with its mark: *seen*, read in a text that was opened; *from seen ones*; *recalled*, from memory, never "
        "required; *assumed*. One material point, no grid. Volume strain: at 5 % of axial shortening, since the confinement.",
        ["test", "measured", "mark", "source", *CARDS],
        [],
    )  # fmt: skip
    for name, (measured, mark, source) in DATA.items():
        result.rows.append([name, measured, mark, source, *(found[card][name] for card in CARDS)])
    demand(result, found)
    result.notes = (
        "`berea_sandstone` is the published card, that of most shipped decks. Its flow is associated: sheared rock swells "
        "without limit, and rock that is pulled apart ends under pressure. `berea_sandstone_bounded` differs in PEAKI1 and FSLOPE, which "
        "follow from the unconfined and the tensile strength, "
        "and in the bounds of its dilatancy: `Dilatancy limit` 5 % (range 2 to 10 %, assumed) and "
        "`Dilatancy pressure` 60 MPa (range 40 to 100 MPa, chosen for the three signs).\n\n"
        "`berea_sandstone_damage` adds damage: it bears the same until it breaks, and dilatancy ends with damage "
        "([rock_damage](rock_damage.md)). `berea_sandstone_heat`, the card of the main job, has a limit of strength, grains that "
        "stiffen, and heat besides; its answers are those that are required.\n\n"
        "What does not hold: none of these cards depends on the rate; `seeberger_sandstone` does "
        "([seeberger_and_cement](seeberger_and_cement.md)). Skempton's coefficient follows from Gassmann's relation with water of "
        "2.25 GPa, 20 % of pores and the drained modulus: 0.59. The measured set, 0.75 with an undrained modulus of 15.8 GPa, needs a "
        "fluid of 4 GPa in that relation. Its authors call it consistent to 20 %."
    )
    return result
