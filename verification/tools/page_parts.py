# SPDX-License-Identifier: BSD-3-Clause
"""Who writes which marked part of a page, and which page as a whole: always from files in verification/results (pages.py)."""
import json

from performance import checkpoint_cost
from tools import cement_table
from tools import closed_cycles_table
from tools import cut_off_table
from tools import converge_parts
from tools import deck_table
from tools import depth_at_rest_runs
from tools import elastic_shares_table
from tools import extremes_page
from performance import feature_cost
from tools import figures_page
from tools import flow_runs_table
from tools import main_job_table
from fits import fit_berea
from performance import many_ranks
from tools import measured_tables
from performance import off_costs
from tools import paper_parts
from tools import range_effects_table
from tools import rock_cards_table
from tools import shot_stress
import predictions
from performance import scaling
from performance import scaling_model
from performance import solver_cost
from performance import step_cost
from fits import synthetic_results
from tools import trade_page
from tools import uncertainty_parts
from performance import wet_time
from performance import whole_shot
from tools import validation_part
from tools.case_list import RESULTS
from tools.verification_pages import table


def pore_cost():
    data = json.loads((RESULTS / "pore_cost.json").read_text())
    return table(data["columns"], [[f"{row[0]:,}", *(f"{v:.1f}" if isinstance(v, float) else v for v in row[1:])] for row in data["rows"]])


def checkpoint_times():
    """Of large runs, at the bandwidths of checkpoint_cost.py."""
    found = json.loads((RESULTS / "checkpoint_cost.json").read_text())
    size, seconds = found["bytes"] / found["particles"], (found["write"] + found["verify"]) / found["particles"]
    rows = [[f"{n:.0e}".replace("e+0", "e"), f"{1e-9 * n * size:.0f}", f"{n * seconds / 60.0:.1f}"] for n in (1e7, 1e8, 1e9)]
    return table(["particles in three dimensions", "GB", "minutes to write and verify"], rows)


def laboratory_tests():
    """Each test with its datum, and what the cards give."""
    found = json.loads((RESULTS / "laboratory_tests.json").read_text())
    rows = [[*row[:4], *(f"{value:.3g}" for value in row[4:])] for row in found["rows"]]
    return table([*found["columns"][:4], *(f"`{card}`" for card in found["columns"][4:])], rows)


PARTS = {
    "arenisca_forms": feature_cost.stored_part,
    "berea_fit": fit_berea.stored_part,
    "cement_shot": cement_table.lines,
    "checkpoint_cost.py": checkpoint_cost.stored_part,
    "checkpoint_times": checkpoint_times,
    "closed_cycles": closed_cycles_table.lines,
    "converge_fine_jet": converge_parts.fine_jet,
    "converge_jet": converge_parts.jet,
    "converge_shell": converge_parts.shell,
    "cut_off": cut_off_table.lines,
    "decks": deck_table.lines,
    "depths": figures_page.depths,
    "elastic_shares": elastic_shares_table.lines,
    "fidelities": figures_page.fidelities,
    "figures": figures_page.figures,
    "flow_runs": flow_runs_table.lines,
    "laboratory_tests": laboratory_tests,
    "main_job": main_job_table.lines,
    "many_ranks.py": many_ranks.stored_part,
    "off_costs.py": off_costs.stored_part,
    "pore_cost": pore_cost,
    "range_effects": range_effects_table.lines,
    "rock_cards": rock_cards_table.lines,
    "scaling.py": scaling.stored_part,
    "scaling_model.py": scaling_model.stored_part,
    "shot_stress": shot_stress.lines,
    "shot_stress_factors": shot_stress.factors,
    "step_cost.py": step_cost.stored_part,
    "synthetic_fits.py": synthetic_results.stored_part,
    "uncertainty": uncertainty_parts.example,
    "validation": validation_part.overview,
    "validation_experiments": validation_part.sections,
    "validation_fails": validation_part.fails,
    "wet_time.py": wet_time.stored_part,
    "whole_shot.py": whole_shot.stored_part,
    **paper_parts.PARTS,
}


def whole_pages():
    """{file: text}; a listing of runs stands with the results; the site has it."""
    trade = json.loads((RESULTS / "trade.json").read_text())
    return {
        "verification/results/extremes.md": extremes_page.stored_page(),
        "verification/results/trade_runs.md": trade_page.runs_page(trade),
        "verification/results/depth_at_rest_runs.md": depth_at_rest_runs.page(),
        "docs/trade.md": trade_page.page_of(trade),
        "docs/cost.md": predictions.stored_page(),
        "docs/materials/arenisca_cost.md": solver_cost.stored_page(),
        "docs/materials/arenisca_forms_cost.md": feature_cost.stored_page(),
        **measured_tables.files(),
    }
