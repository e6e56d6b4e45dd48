#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""barreno import-ups loses nothing in silence: each part of Uintah's format that moves, loads, breaks or ends a simulation is in
the deck or makes it incomplete, and the sentence says what and why.

    test_import_losses.py BARRENO
"""
import os
import pathlib
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ElementTree

from test_import import ROOT, Deck, imported, numbers, said

NEO_HOOK = (
    '<constitutive_model type="comp_neo_hook"><bulk_modulus>1e6</bulk_modulus><shear_modulus>4e5</shear_modulus>{}</constitutive_model>'
)
BOX = '<box label="{}"><min>[{}, 0.2, {}]</min><max>[{}, 0.6, {}]</max></box>'


def piece(label="b", velocity="[1, 0, 0]", low=0, high=0.05, extra="", left=0.2):
    return (
        f"<geom_object>{BOX.format(label, left, low, left + 0.4, high)}<res>[2, 2, "
        f"1]</res><velocity>{velocity}</velocity>{extra}</geom_object>"
    )


def material(name="Block", model=NEO_HOOK.format(""), objects=None, extra=""):
    heat = "<thermal_conductivity>1</thermal_conductivity><specific_heat>400</specific_heat>"
    return f'<material name="{name}"><density>1000</density>{model}{heat}{extra}{piece() if objects is None else objects}</material>'


def ups(materials=None, flags="", grid="", loads="", faces="", cells="<resolution>[20, 20, 1]</resolution>", time="", archive="", more=""):
    materials = material() if materials is None else materials
    if materials.count("<material ") > 1 and "<contact>" not in materials:
        materials += told("single_velocity")
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<Uintah_specification><Meta><title>small</title></Meta><SimulationComponent type="mpm"/>
<Time><maxTime>0.01</maxTime><initTime>0</initTime><timestep_multiplier>0.4</timestep_multiplier>{time}</Time>
<DataArchiver><outputInterval>0.001</outputInterval>{archive}</DataArchiver>
<MPM><time_integrator>explicit</time_integrator>{"" if "interpolator" in flags else "<interpolator>gimp</interpolator>"}{flags}</MPM>
<PhysicalBC><MPM>{loads}</MPM></PhysicalBC><MaterialProperties><MPM>{materials}</MPM></MaterialProperties>
<Grid><BoundaryConditions>{faces}</BoundaryConditions><Level><Box><lower>[0, 0, 0]</lower><upper>[1, 1, 0.05]</upper>{cells}</Box>{grid}</Level></Grid>{more}
</Uintah_specification>"""


class Folder:
    def __init__(self, path):
        self.path, self.out = path, path / "out.xml"

    def run(self, text, *words, code=0):
        file = self.path / "case.ups"
        file.write_bytes(text if isinstance(text, bytes) else text.encode())
        return imported(file, "--out", self.out, "--overwrite", *words, code=code)

    def valid(self, text, *sentences):
        answer = self.run(text)
        said(answer, *sentences)
        assert answer.rstrip().endswith("The deck is valid."), answer
        return Deck(self.out)

    def incomplete(self, text, *sentences):
        """The sentences are all that is lost."""
        answer = self.run(text)
        count = f"{len(sentences)} thing{'' if len(sentences) == 1 else 's'}"
        assert f"The deck is incomplete: {count} did not carry over" in answer and "valid" not in answer, answer
        first = answer.splitlines()[: len(sentences)]
        for sentence in sentences:
            assert sum(sentence in line for line in first) == 1, f"{sentence!r} in\n{answer}"
        return Deck(self.out)


def check_unknown_loses(folder):
    """What nobody knows may be anything: the deck is not called valid, and --strict fails."""
    text = ups(flags="<shiny_new>3</shiny_new>")
    folder.incomplete(text, "MPM/shiny_new = 3 is left out")
    folder.run(text, "--strict", code=1)
    assert folder.run(ups(), "--strict").rstrip().endswith("The deck is valid.")
    twice = material(objects=piece("a", extra="<charge>1</charge>") + piece("c", extra="<charge>1</charge>", left=0.6))
    folder.incomplete(ups(twice),
        "Block: material/geom_object/charge = 1 is left out (it has no counterpart in a deck, or none that the import knows). (2 times)")


METAL = """<constitutive_model type="elastic_plastic_hp"><shear_modulus>4.6e10</shear_modulus><bulk_modulus>1.29e11</bulk_modulus><flow_model type="johnson_cook">
<A>9e7</A><B>2.92e8</B><C>0.025</C><n>0.31</n><m>1.09</m></flow_model>{}</constitutive_model>"""


def check_materials(folder):
    damage = '<damage_model type="johnson_cook"><D1>0.54</D1><D2>4.89</D2><D3>-3.03</D3><D4>0.014</D4><D5>1.12</D5></damage_model>'
    deck = folder.valid(ups(material(model=METAL.format(""), extra=damage + "<melt_temp>1356</melt_temp>")), "D0 and Dc",
        "melt_temp = 1356 K is left out")
    assert deck.value("Materials/Block/D2") == "4.89" and deck.value("Materials/Block/Melt Temperature") == "1793.0"
    for kind in ("hancock_mackenzie", "Threshold", "Brittle"):
        for model in (METAL.format(""), NEO_HOOK.format("")):
            folder.incomplete(ups(material(model=model, extra=f'<damage_model type="{kind}"><x>1</x></damage_model>')),
                f"the damage model {kind} is left out")
    folder.incomplete(ups(material(model=NEO_HOOK.format("").replace("comp_neo_hook", "cnh_damage"), extra='<damage_model type="Threshold"/'
        '>')), "the damage model Threshold")
    deck = folder.valid(ups(material(model=METAL.format("<do_melting>true</do_melting><coeff_thermal_expansion>0.0</"
        "coeff_thermal_expansion><taylor_quinney_coeff>0.6</taylor_quinney_coeff>"))))
    assert deck.value("Materials/Block/Taylor Quinney") == "0.6"
    for tag in ("<isothermal>true</isothermal>", "<do_melting>false</do_melting>",
            "<initial_material_temperature>696</initial_material_temperature>",
                "<coeff_thermal_expansion>1e-5</coeff_thermal_expansion>", '<equation_of_state type="hyper"/>',
                '<yield_condition type="gurson"/>'):  # fmt: skip
        folder.incomplete(ups(material(model=METAL.format(tag))),
            ElementTree.fromstring(tag).get("type") or ElementTree.fromstring(tag).tag)
    plastic = NEO_HOOK.format("<usePlasticity>true</usePlasticity><yield_stress>1e3</yield_stress><hardening_modulus>50</"
        "hardening_modulus>")
    deck = folder.valid(ups(material(model=plastic)), "with usePlasticity becomes Johnson-Cook")
    assert [deck.value(f"Materials/Block/{key}") for key in ("A", "B", "n")] == ["1000.0", "50.0", "1.0"]
    named = plastic.replace("<usePlasticity>true</usePlasticity>", "<alpha>0.0</alpha>").replace("comp_neo_hook", "comp_neo_hook_plastic")
    deck = folder.valid(ups(material(model=named)), "comp_neo_hook_plastic becomes Johnson-Cook")
    assert [deck.value(f"Materials/Block/{key}") for key in ("A", "B", "n")] == ["1000.0", "50.0", "1.0"]
    strong = folder.valid(ups(material(model=named.replace("1e3", "1e10"))), "yield_stress = 1e+10 is above the shear modulus",
        "becomes Neo-Hookean")
    assert strong.value("Materials/Block/Model") == "Neo-Hookean"
    elastic = plastic.replace("<usePlasticity>true</usePlasticity>", "<alpha>0.5</alpha>")  # which Uintah does not read then
    assert folder.valid(ups(material(model=elastic)), "becomes Neo-Hookean").value("Materials/Block/Model") == "Neo-Hookean"
    other = METAL.format("").replace("johnson_cook", "zerilli_armstrong")
    answer = folder.run(ups(material() + material("Rod", other, piece("rod", left=0.6))))
    assert (
        "The material Rod is left out with its bodies (its flow rule zerilli_armstrong" in answer and "bulk_modulus" not in answer
    ), answer
    stress = NEO_HOOK.format("<useInitialStress>true</useInitialStress><initial_pressure>-1e4</initial_pressure>")
    folder.incomplete(ups(material(model=stress)), "initial_pressure = -10000, is left out")
    folder.incomplete(ups(material(extra='<erosion algorithm="ZeroStress"/>')), "erosion ZeroStress")
    folder.incomplete(ups(material(extra="<is_rigid>true</is_rigid>")), "is_rigid = true")
    folder.incomplete(ups(more="<CFD><ICE><cfl>0.4</cfl></ICE></CFD>"), "<CFD> is left out")


def check_nothing_left(folder):
    """A deck without materials or bodies: the sentence says why, not what check misses."""
    foam = '<constitutive_model type="foam_of_another_code"/>'
    text = folder.run(ups(material(model=foam)), code=1)
    assert "no counterpart of the model of Block" in text and "Materials is missing" not in text and len(text.splitlines()) == 1, text
    text = folder.run(ups("".join(material(name, foam) for name in "ABCDE")), code=1)
    assert "any of its 5 materials (A, B, C, ...)" in text, text
    text = folder.run(ups(material(objects=piece().replace("box", "ellipsoid"))), code=1)
    assert "has no body" in text and "remarks say" in text, text
    skin = (
        "<geom_object><difference><box><min>[0.1, 0.1, 0]</min><max>[0.7, 0.7, 0.05]</max></box><box label=\"b\"/></difference><res>[2, 2, "
        "1]</res></geom_object>"
    )
    deck = folder.incomplete(ups(material("Foam", foam) + material("Skin", objects=skin)), "The material Foam is left out with its bodies")
    assert deck.value("Bodies/Skin/Parts") == "{difference part, difference part 2}" and deck.names("Bodies") == ["Skin"]
    answer = folder.run(ups(material() + material("Skin", objects=skin.replace('"b"', '"nowhere"'))))
    assert 'label="nowhere"> has no dimensions' in answer and "incomplete: 1 thing" in answer, answer


def check_bodies(folder):
    deck = folder.valid(
        ups(material(objects=piece(extra="<temperature>294</temperature><pressure>101325</pressure><density>1717</density>"))))
    assert deck.names("Bodies") == ["b"]
    folder.incomplete(ups(material(objects=piece(velocity="[1, 0, 3]"))), "Body b: the velocity has the component 3 along z")
    text = ups(material(objects=piece() + piece("aside", low=0.1, high=0.2)))
    assert folder.incomplete(text, "Body aside of Block: left out (it lies beside the plane").names("Bodies") == ["b"]
    ball = "<geom_object><sphere><origin>[0.5, 0.5, {}]</origin><radius>0.13</radius></sphere></geom_object>"
    deck = folder.valid(ups(material(objects=ball.format(-0.025))))
    assert abs(float(deck.value("Bodies/Block/Radius")) - 0.12) < 1e-12  # a section 0.05 from the centre
    folder.incomplete(ups(material(objects=piece() + ball.format(-0.2))), "lies beside the plane")
    gravity = "<PhysicalConstants><gravity>[0, 0, -9.81]</gravity></PhysicalConstants>"
    assert folder.incomplete(ups(more=gravity), "Gravity has the component -9.81 along z").value("Body Force/Kind") is None


def face(side, *entries):
    return f'<Face side="{side}">{"".join(entries)}</Face>'


def velocity(value, index="all"):
    return f'<BCType id="{index}" label="Velocity" var="Dirichlet"><value>{value}</value></BCType>'


def check_conditions(folder):
    symmetric = '<BCType id="all" label="Symmetric" var="symmetry"/>'
    for both in ((velocity("[0, 0, 0]"), symmetric), (symmetric, velocity("[0, 0, 0]"))):  # of both nothing moves
        assert folder.valid(ups(faces=face("x-", *both))).value("Conditions/Face x lower/Kind") == "fixed"
    folder.incomplete(ups(faces=face("x-", velocity("[1, 0, 0]"), symmetric)),
        "x- has several conditions: symmetry is left out, prescribed velocity is taken")
    two = material() + material("Other", objects=piece("c", left=0.6))
    folder.incomplete(ups(two, faces=face("x-", velocity("[0, 0, 0]", 1))), "holds for the material 1 alone")
    gas = '<BCType id="0" label="Pressure" var="Neumann"><value>0</value></BCType>'
    folder.incomplete(ups(two, faces=face("x-", gas) + face("y+", gas)), "x-, y+: the condition Neumann Pressure has no counterpart")
    folder.incomplete(ups(faces=face("z-", velocity("[0, 0, 0]"))), "a face normal to the plane")
    folder.valid(ups(faces=face("z-", symmetric.replace("/>", "><value>[0, 0, 0]</value></BCType>"))
        + face("x+", velocity("[0, 0, 0]", 0))))
    folder.incomplete(ups(time="<max_Timesteps>50</max_Timesteps>"), "The largest number of steps, 50,")
    folder.incomplete(ups(grid="<periodic>[1, 0, 0]</periodic>"), "Grid/Level/periodic = [1, 0, 0]")
    folder.valid(ups(grid="<periodic>[0, 0, 0]</periodic>"), "Grid/Level/periodic")


def check_flags(folder):
    deck = folder.valid(ups(flags="<interpolator>fast_cpdi</interpolator><XPIC2>true</XPIC2><cpdi_lcrit>1.25</cpdi_lcrit>"))
    assert [deck.value(f"Step/{key}") for key in ("Shape Function", "Transfer", "XPIC Order", "Largest Domain")] == ["CPDI", "XPIC",
        "2", "1.25"]
    assert folder.valid(ups(flags="<cpdi_lcrit>1.25</cpdi_lcrit>")).value("Step/Largest Domain") is None
    folder.incomplete(ups(flags="<do_grid_reset>false</do_grid_reset>"), "do_grid_reset = false")
    folder.incomplete(ups(flags="<UsePrescribedDeformation>true</UsePrescribedDeformation><PrescribedDeformationFile>p.inp</"
        "PrescribedDeformationFile>"),
                      "The deformation that p.inp prescribes is left out")  # fmt: skip
    folder.valid(ups(flags="<boundary_traction_faces>[xminus]</boundary_traction_faces><solver>simple</solver>"),
        "MPM/boundary_traction_faces, MPM/solver")
    folder.incomplete(ups().replace('type="mpm"', 'type="impm"'),
        "SimulationComponent impm is read as mpm, the explicit material point method")
    folder.incomplete(ups().replace('type="mpm"', 'type="mpmice"'), "SimulationComponent mpmice is left out but for its material points")
    folder.valid(ups(flags="<refine_particles>false</refine_particles>"), "MPM/refine_particles")
    folder.incomplete(ups(flags="<refine_particles>true</refine_particles>"), "MPM/refine_particles = true")


CYLINDER = "<cylinder label=\"{}\"><bottom>[0, {}, 0]</bottom><top>[0, {}, 0]</top><radius>0.4</radius>{}</cylinder>"
AXIS = "<axisymmetric>true</axisymmetric><use_load_curves>true</use_load_curves>"


def pressure(surface, *loads):
    points = "".join(f"<time_point><time>{time}</time><load>{load}</load></time_point>" for time, load in enumerate(loads))
    return f"<pressure><geom_object>{surface}</geom_object><res>[2, 2, 1]</res><load_curve><id>1</id>{points}</load_curve></pressure>"


def plug(name, low, high):
    return material(name, objects=f"<geom_object>{CYLINDER.format(name, low, high, '')}<res>[2, 2, 1]</res></geom_object>")


def check_loads(folder):
    end, side = "<axisymmetric_end>true</axisymmetric_end>", "<axisymmetric_side>true</axisymmetric_side>"
    loads = pressure(CYLINDER.format("low", 0.19, 0.21, end), 1e4) + pressure(CYLINDER.format("high", 0.79, 0.81, end), 0, -2e4)
    deck = folder.valid(ups(plug("plug", 0.2, 0.8), AXIS, loads=loads + pressure(CYLINDER.format("s", 0.2, 0.8, side), -3e4)))
    found = [[deck.value(f"Loads/Pressure on plug {i}/{key}") for key in ("Faces", "Pressure", "Pressures")] for i in (1, 2, 3)]
    assert found == [["{y_lower}", "10000.0", None], ["{y_upper}", None, "{0.0, 20000.0}"], ["{x_upper}", "30000.0", None]], found
    two = plug("plug", 0.2, 0.8) + plug("plate", 0.1, 0.2)
    deck = folder.valid(ups(two, AXIS, loads=pressure(CYLINDER.format("s", 0.1, 0.8, side), -1e4)))
    assert {deck.value(f"Loads/{name}/Body") for name in deck.names("Loads")} == {"plug", "plate"}
    deck = folder.incomplete(ups(two, AXIS, loads=pressure(CYLINDER.format("s", 0.1, 0.5, side), -1e4)),
        'pressure on "s" of PhysicalBC covers a part of x_upper of plug')
    assert [deck.value(f"Loads/{name}/Body") for name in deck.names("Loads")] == ["plate"]
    twice = pressure(CYLINDER.format("s", 0.2, 0.8, side), -1e4) * 2
    folder.incomplete(ups(plug("plug", 0.2, 0.8), AXIS, loads=twice), "A second pressure")
    force = "<force><lower>[0, 0, 0]</lower><upper>[1, 1, 1]</upper><force_density>[1, 0, 0]</force_density></force>"
    folder.incomplete(ups(loads=force), "The load <force>")
    folder.valid(ups(loads=pressure(CYLINDER.format("s", 0, 1, side), -1e4)), "as Uintah does without use_load_curves")


def told(kind, **tags):
    return f"<contact><type>{kind}</type>{''.join(f'<{tag}>{text}</{tag}>' for tag, text in tags.items())}</contact>"


def check_contact(folder):
    wall = material("Wall",
        '<constitutive_model type="rigid"><shear_modulus>1e6</shear_modulus><bulk_modulus>1e6</bulk_modulus></constitutive_model>',
                    piece("wall", "[0, -2, 0]", left=0.6), "<is_rigid>true</is_rigid>")  # fmt: skip
    both = wall + material()
    deck = folder.valid(ups(both + told("rigid", direction="[1, 1, 1]", materials="[0, 1]")), "contact rigid becomes a Motion")
    assert numbers(deck.value("Bodies/wall/Motion")) == [0.0, -2.0] and deck.value("Bodies/wall/Velocity") is None
    folder.incomplete(ups(both + told("rigid", direction="[0, 1, 0]")), "leaves other materials free along x")
    deck = folder.valid(ups(both + told("specified", direction="[1, 1, 1]", master_material=0, stop_time="0.004")))
    assert numbers(deck.value("Bodies/wall/Motion Factors")) == [1.0, 1.0, 0.0], deck.value("Bodies/wall/Motion Factors")
    (folder.path / "profile.txt").write_text("0 0 0 0\n0.01 3 0 0\n")
    profile = told("specified", direction="[1, 1, 1]", filename="profile.txt")
    deck = folder.valid(ups(both + profile))
    assert numbers(deck.value("Bodies/wall/Motion")) == [3.0, 0.0] and numbers(deck.value("Bodies/wall/Motion Factors")) == [0.0, 1.0]
    (folder.path / "profile.txt").write_text("0 0 0 0\n0.01 fast 0 0\n")
    assert "two or more rows of 4 numbers" in folder.run(ups(both + profile), code=1)
    other = material() + material("Other", objects=piece("c", left=0.6))
    folder.incomplete(ups(other + told("single_velocity", materials="[0, 7]")), "No contact of the file holds for Block and Other")
    assert "names materials that the file does not have (7; it has 2" in (folder.path / "out.xml").read_text()
    folder.incomplete(ups(other + told("null")), "Contact null")


def check_files(folder):
    inner = folder.path / "inputs" / "MPM"
    inner.mkdir(parents=True)
    (inner / "rows.dat").write_text("0.001 1 0 0 0 0 -5 0\n")
    shot = ups(plug("Shot", 0.7, 0.8).replace("<res>", "<color>1</color><res>") + material("Rest"),
        "<axisymmetric>true</axisymmetric><InsertParticles>true</InsertParticles>"
               "<InsertParticlesFile>inputs/MPM/rows.dat</InsertParticlesFile>")  # fmt: skip
    (inner / "shot.ups").write_text(shot)
    assert "1 insertions of rows.dat become slugs" in imported(inner / "shot.ups", "--out", folder.out, "--overwrite")
    deep = b"<Uintah_specification>" + b"<a>" * 3000 + b"</a>" * 3000 + b"</Uintah_specification>"
    for text, sentence in (
        (b'<?xml version="1.0" encoding="ISO-8859-99"?><Uintah_specification/>', "unknown encoding"),
        (b'<?xml version="1.0" encoding="utf-7"?><Uintah_specification/>', "cannot be read"),
        (b"<Uintah_specification>\xff\xfe</Uintah_specification>", "is not XML"),
        (deep, "nested more than 100 deep"),
        (ups(archive='<checkpoint interval="often"/>').encode(), 'checkpoint, interval is "often", which is not a number'),
        (ups(archive='<checkpoint timestepInterval="nan"/>').encode(), "which is not a number"),
        (ups(cells="<spacing>[0, 0.05, 0.05]</spacing>").encode(), "spacing is [0, 0.05, 0.05], which is not positive"),
        (ups(cells="<resolution>[20, 20, inf]</resolution>").encode(), "resolution"),
        (ups(material(objects=piece().replace("[2, 2, 1]", "[nan, 2, 1]"))).encode(), "which is not a vector"),
        (ups().replace("[1, 1, 0.05]", "[0, 1, 0.05]").encode(), "not above its lower corner"),
        (ups(more="<include/>").encode(), "names no file"),
    ):
        answer = folder.run(text, code=1)
        assert sentence in answer and len(answer.splitlines()) == 1 and answer.startswith("barreno: "), answer


def check_letters(folder):
    """Names with letters that the terminal lacks."""
    (folder.path / "case.ups").write_text(ups(flags="<größe>3</größe>"), encoding="utf-8")
    environment = {**os.environ, "PYTHONIOENCODING": "ascii", "BARRENO_PROGRAM": str(pathlib.Path(sys.argv[1]).resolve()),
                   "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}  # fmt: skip
    words = [sys.executable, "-m", "barreno.imports", folder.path / "case.ups", "--out", folder.out, "--overwrite"]
    result = subprocess.run(words, env=environment, capture_output=True, text=True, check=False)
    assert result.returncode == 0 and "incomplete: 1 thing" in result.stdout and not result.stderr, result.stderr


def main():
    checks = (check_unknown_loses, check_materials, check_nothing_left, check_bodies, check_conditions, check_flags, check_loads,
        check_contact, check_files,
              check_letters)  # fmt: skip
    for check in checks:
        with tempfile.TemporaryDirectory() as name:
            check(Folder(pathlib.Path(name)))
    print("nothing of Uintah's inputs is lost in silence")


if __name__ == "__main__":
    main()
