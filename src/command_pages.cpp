// SPDX-License-Identifier: BSD-3-Clause
#include "command_pages.hpp"

#include "base/error.hpp"
#include "deck/fidelity.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/continue_section.hpp"
#include "deck/sections/head_section.hpp"
#include "deck/sections/time_section.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <charconv>

namespace barreno {
namespace {

/// @param what  "number of ranks", for the sentence
int count_of(const std::string& option, const std::string& text, const std::string& what) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size() || count < 1) {
    throw DeckError(
        option + " " + input::shown(text) + " is not a " + what +
        " (1 or more); write for example " + option + " 2."
    );
  }
  return count;
}

void take_ranks(Options& options, const std::string& value) {
  options.ranks = count_of("--ranks", value, "number of ranks");
}

void take_override(Options& options, const std::string& value) {
  options.overrides.push_back(value);
}

/// As the deck would say it, so that it can be read back from the effective deck.
void take_fidelity(Options& options, const std::string& value) {
  const std::vector<std::string> known = fidelity_choices();
  if (std::find(known.begin(), known.end(), value) == known.end()) {
    throw DeckError(
        "--fidelity " + input::shown(value) + " is not a fidelity; " +
        input::suggest_name(value, known)
    );
  }
  options.overrides.push_back(fidelity_override(value));
}

const OptionPage set_option = {
    "--set",
    "\"LIST/NAME=VALUE\"",
    "\"Time/End Time=50 us\"",
    "change a value of the deck, as often as needed;\n"
    "\"LIST/NAME=\" removes a value or a list",
    take_override};

const OptionPage fidelity_option = {
    "--fidelity",
    "WORD",
    "balanced",
    "fast, balanced or reference: choose between error\n"
    "and cost where the deck does not (docs/trade.md);\n"
    "none: without the choices of a deck's Fidelity",
    take_fidelity};

CommandPage run_page() {
  return {
      Command::run,
      "run",
      "Compute a deck. The results go into a new folder, runs/NAME-1, -2, ... of a deck NAME.xml,\n"
      "unless --out gives one (docs/output.md).",
      "DECK",
      "deck file (docs/deck.md)",
      true,
      {{"--out",
        "FOLDER",
        "results",
        "the run's folder; refused if it holds results",
        [](Options& options, const std::string& value) { options.out = value; }},
       {"--overwrite",
        nullptr,
        nullptr,
        "replace the results in that folder",
        [](Options& options, const std::string&) { options.overwrite = true; }},
       {"--ranks",
        "N",
        "2",
        "processes that ./barreno starts; default: one per\n"
        "core. Under mpirun -n N its processes are used",
        take_ranks},
       set_option,
       fidelity_option},
      "barreno run input_xml/perforation.xml --out results\n"
      "barreno run input_xml/perforation.xml --set \"Grid/Cell Size=0.5 mm\" --ranks 4"};
}

CommandPage continue_page() {
  CommandPage page = run_page();
  page.command = Command::continue_run;
  page.name = "continue";
  page.summary =
      "Compute a deck whose bodies start with the particles of a finished run (docs/continue.md):\n"
      "other pressures, drained flow, slow loading. What was taken over is listed.";
  page.operand = "FOLDER";
  page.operand_meaning = "the finished run's folder";
  page.options.insert(
      page.options.begin(),
      {{"--deck",
        "DECK",
        "input_xml/perforation_drainage.xml",
        "deck file of the second stage (docs/deck.md)",
        [](Options& options, const std::string& value) { options.deck_file = value; },
        true},
       {"--at-rest",
        nullptr,
        nullptr,
        "set the velocities of the particles to zero",
        [](Options& options, const std::string&) {
          options.overrides.push_back(
              path_of(&ContinueSpec::velocities) + "=" + word_of(TakenVelocities::at_rest)
          );
        }}}
  );
  page.examples =
      "barreno continue runs/shot --deck input_xml/perforation_drainage.xml --set \"Jet=\" "
      "--at-rest";
  return page;
}

CommandPage resume_page() {
  return {
      Command::resume,
      "resume",
      "Continue a run from its last checkpoint, bit for bit (docs/checkpoints.md).",
      "FOLDER",
      "the run's folder",
      true,
      {{"--until",
        "TIME",
        "\"200 us\"",
        "a new End Time, or \"at rest\"",
        [](Options& options, const std::string& value) {
          options.overrides.push_back(path_of(&TimeSpec::end_time) + "=" + value);
        }},
       {"--longest",
        "TIME",
        "\"800 us\"",
        "a new Longest Time of a run that ends at rest",
        [](Options& options, const std::string& value) {
          options.overrides.push_back(path_of(&TimeSpec::longest_time) + "=" + value);
        }},
       {"--ranks", "N", "2", "processes, as for run; any number works", take_ranks}},
      "barreno resume runs/perforation-1 --until \"200 us\""};
}

CommandPage check_page() {
  return {
      Command::check,
      "check",
      "Validate a deck, and report what the run will do, how long it takes and what it costs\n"
      "(docs/cost.md), how well its cells resolve a jet (docs/trade.md), and what may be a "
      "mistake:\n"
      "gaps, a jet that misses, an early end, a forgotten unit. Nothing is written.",
      "DECK",
      "deck file (docs/deck.md)",
      true,
      {set_option,
       fidelity_option,
       {"--ranks", "N", "2", "number of processes to predict the cost for", take_ranks},
       {"--print-deck",
        nullptr,
        nullptr,
        "print the effective deck, every value that a run\n"
        "would use, instead of the plan",
        [](Options& options, const std::string&) { options.print_deck = true; }},
       {"--print-jet",
        nullptr,
        nullptr,
        "print the slugs of the jet, as the deck has them\n"
        "and as they are launched (JSON), instead of the plan",
        [](Options& options, const std::string&) { options.print_jet = true; }}},
      "barreno check input_xml/perforation.xml --ranks 4"};
}

CommandPage drive_page() {
  return {
      Command::drive,
      "drive",
      "Drive one material point along a path of deformation gradient, strain or stress\n"
      "(docs/drive.md).",
      nullptr,
      nullptr,
      false,
      {{"--material",
        "CARD",
        "berea_sandstone.xml",
        "material card, by path or by name",
        [](Options& options, const std::string& value) { options.drive.material = value; },
        true},
       {"--path",
        "FILE",
        "input_xml/paths/uniaxial_berea.csv",
        "the path, CSV",
        [](Options& options, const std::string& value) { options.drive.path = value; },
        true},
       {"--out",
        "FILE",
        "answer.csv",
        "stress and state along the path, CSV",
        [](Options& options, const std::string& value) { options.drive.out = value; },
        true},
       {"--steps-per-row",
        "N",
        "10",
        "equal steps between two rows of the path; default 1",
        [](Options& options, const std::string& value) {
          options.drive.steps.per_row = count_of("--steps-per-row", value, "number of steps");
        }},
       {"--every-step",
        nullptr,
        nullptr,
        "a row of the answer for every step, not for rows of the path alone",
        [](Options& options, const std::string&) { options.drive.steps.every = true; }},
       {"--plot",
        "FILE",
        "answer.png",
        "picture of every step with the yield surface (PNG, PDF or SVG),\n"
        "and the surface as a table, FILE_surface.csv; needs Python 3\n"
        "with Matplotlib",
        [](Options& options, const std::string& value) { options.drive.picture = value; }},
       {"--set",
        "NAME=VALUE",
        "\"PEAKI1=20 MPa\"",
        "change or add a value of the card, as often as needed",
        [](Options& options, const std::string& value) {
          options.drive.overrides.push_back(value);
        }}},
      "barreno drive --material berea_sandstone.xml --path input_xml/paths/uniaxial_berea.csv "
      "--out answer.csv\n"
      "barreno drive --material berea_sandstone --path input_xml/paths/triaxial_berea.csv "
      "--out answer.csv --steps-per-row 40 --every-step --plot answer.png"};
}

CommandPage solve_flow_page() {
  return {
      Command::solve_flow,
      "solve-flow",
      "Steady flow through rings of rock around a hole, which barreno flow makes of a run\n"
      "(docs/flow.md).",
      "PROBLEM",
      "JSON file with cells and pressures",
      true,
      {{"--out",
        "FILE",
        "answer.json",
        "pressures and flows, JSON",
        [](Options& options, const std::string& value) { options.out = value; },
        true}},
      "barreno solve-flow problem.json --out answer.json"};
}

CommandPage describe_page() {
  return {
      Command::describe,
      "describe",
      "The deck reference: every section, parameter, unit, bound and default.",
      "NAME",
      "a section of the deck, a material model, a parameter, or a word of a run's files; default: "
      "an overview",
      false,
      {{"--markdown",
        nullptr,
        nullptr,
        "everything, as in docs/deck.md",
        [](Options& options, const std::string&) { options.markdown = true; }},
       {"--fields",
        nullptr,
        nullptr,
        "the fields of particles.e, as in docs/output.md",
        [](Options& options, const std::string&) { options.table = OutputTable::fields; }},
       {"--history",
        nullptr,
        nullptr,
        "the columns of history.csv, as in docs/output.md",
        [](Options& options, const std::string&) { options.table = OutputTable::history; }},
       {"--ledger",
        nullptr,
        nullptr,
        "the ledger in summary.json, as in docs/output.md",
        [](Options& options, const std::string&) { options.table = OutputTable::ledger; }},
       {"--report-tables",
        nullptr,
        nullptr,
        "units and energies for the report, as in run_tables.json",
        [](Options& options, const std::string&) { options.table = OutputTable::report; }}},
      "barreno describe Grid\n"
      "barreno describe \"Pore Flow/Rocks\"\n"
      "barreno describe Arenisca\n"
      "barreno describe Permeability\n"
      "barreno describe channel_depth"};
}

}  // namespace

const std::vector<CommandPage>& command_pages() {
  static const std::vector<CommandPage> pages = {
      run_page(),
      continue_page(),
      resume_page(),
      check_page(),
      drive_page(),
      solve_flow_page(),
      describe_page()};
  return pages;
}

}  // namespace barreno
