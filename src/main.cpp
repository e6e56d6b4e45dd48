// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "base/process.hpp"
#include "base/start_mpi.hpp"
#include "check/launched_jet.hpp"
#include "check/plan.hpp"
#include "check/predict_cost.hpp"
#include "command_line.hpp"
#include "continue_run.hpp"
#include "deck/describe_deck.hpp"
#include "deck/echo_deck.hpp"
#include "deck/files/read_deck.hpp"
#include "deck/sections/head_section.hpp"
#include "drive/drive.hpp"
#include "output/folder_lock.hpp"
#include "output/history_columns.hpp"
#include "output/output.hpp"
#include "output/particle_field_table.hpp"
#include "output/report_tables.hpp"
#include "output/run_folder.hpp"
#include "pore_flow/check_solver_lists.hpp"
#include "pore_flow/steady_flow.hpp"
#include "resume.hpp"
#include "run.hpp"
#include "scene/build_scene.hpp"
#include "scene/jet/jet_monitor.hpp"
#include "state/build_state.hpp"
#include "state/ledger_table.hpp"
#include "version.hpp"

#include <Kokkos_Core.hpp>
#include <Teuchos_DefaultSerialComm.hpp>
#include <Tpetra_Core.hpp>

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <thread>

namespace barreno {
namespace {

/// On rank 0, which prints the prediction. What the scene cannot do is said by all ranks when they
/// build it.
std::optional<Probe> probe_run(const Scene& scene, const Comm& comm) {
  if (!is_root(comm)) return {};
  try {
    return probe_cost(scene);
  } catch (const DeckError&) {
    return {};
  }
}

int run_deck(const Options& options, const Teuchos::RCP<const Comm>& comm) {
  const Deck deck = read_deck(options.deck_file, options.overrides, *comm);
  const Scene scene = build_scene(deck);
  refuse_short_domains(deck, scene);
  refuse_unreachable_end(deck, scene);
  refuse_rest_without_target(deck, scene);
  check_solver_lists(deck, scene, *comm);
  const std::optional<Stage> stage = find_stage(deck, scene, comm);
  const std::optional<Probe> probe = probe_run(scene, *comm);
  const BodyCensus census = take_census(scene, comm);
  const Prediction prediction =
      probe ? predict_cost(scene, *probe, census.counts, comm->getSize()) : Prediction{};
  State state = stage ? build_empty_state(scene, census, comm) : build_state(scene, census, comm);
  const Continued continued = stage ? start_from_run(*stage, deck, scene, state) : Continued{};
  const std::string name = std::filesystem::path(options.deck_file).stem().string();
  const auto folder = create_run_folder(*comm, {options.out, options.overwrite, name});
  const FolderLock lock(*comm, folder);
  clear_run_folder(*comm, folder, options.overwrite);
  // A deck that Python holds as dictionaries comes from a temporary file, whose path says nothing.
  const char* const shown = std::getenv("BARRENO_DECK_NAME");
  const RunDescription description{
      folder,
      shown && *shown ? std::string(shown) : options.deck_file,
      effective_deck_xml(deck),
      BARRENO_VERSION,
      notes_of(deck, scene),
      prediction,
      deck.surface_files,
      build_facts(),
      jet_monitor_of(deck, scene),
      stage ? ids_in_order(continued) : particle_id_ranges(scene, census.first),
      stage ? stage->said : ContinueSpec{},
      continued};
  catch_signals();  // before this nothing is lost
  Output output(scene, state, description);
  output.write_if_due(scene, state);
  return run_to_end(scene, state, output, description);
}

/// As many machines like this one as the ranks that are planned fill.
int machines_for(int ranks) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  return (ranks + cores - 1) / cores;
}

int check_deck(const Options& options, const Teuchos::RCP<const Comm>& comm) {
  const int ranks = std::max(1, options.ranks);
  set_machines(std::max(machines(), machines_for(ranks)));
  const Deck deck = read_deck(options.deck_file, options.overrides, *comm);
  const Scene scene = build_scene(deck);
  refuse_short_domains(deck, scene);
  refuse_unreachable_end(deck, scene);
  refuse_rest_without_target(deck, scene);
  check_solver_lists(deck, scene, *comm);
  const std::optional<Stage> stage = find_stage(deck, scene, comm);
  if (options.print_deck) {
    if (is_root(*comm)) std::cout << effective_deck_xml(deck);
    return static_cast<int>(ExitCode::finished);
  }
  if (options.print_jet) {
    const std::string jet = launched_jet_json(deck, scene);
    if (is_root(*comm)) std::cout << jet;
    return static_cast<int>(ExitCode::finished);
  }
  const auto scene_with = [&](const std::string& fidelity) {
    std::vector<std::string> overrides = options.overrides;
    overrides.push_back(fidelity_override(fidelity));
    return build_scene(read_deck(options.deck_file, overrides, *comm));
  };
  const std::string fidelities = fidelity_lines(scene_with, ranks);
  std::vector<std::string> notes = notes_of(deck, scene);
  if (stage) notes.push_back(stage_note(*stage));
  if (is_root(*comm))
    std::cout << plan_text(scene, probe_cost(scene), ranks, notes, jet_monitor_of(deck, scene))
              << fidelities;
  return static_cast<int>(ExitCode::finished);
}

std::string description(const Options& options) {
  switch (options.table) {
    case OutputTable::fields:
      return particle_fields_markdown();
    case OutputTable::history:
      return history_markdown();
    case OutputTable::ledger:
      return ledger_markdown();
    case OutputTable::report:
      return report_tables();
    case OutputTable::none:
      break;
  }
  return options.markdown ? describe_markdown() : describe_text(options.section);
}

int carry_out(const Options& options, const Teuchos::RCP<const Comm>& comm) {
  const bool root = is_root(*comm);
  switch (options.command) {
    case Command::run:
    case Command::continue_run:
      return run_deck(options, comm);
    case Command::resume:
      return resume(options.deck_file, options.overrides, build_facts(), comm);
    case Command::check:
      return check_deck(options, comm);
    case Command::drive: {
      const std::string screen = drive(options.drive, *comm);
      if (root) (goes_to_stream(options.drive) ? std::cerr : std::cout) << screen;
      break;
    }
    case Command::solve_flow:
      solve_flow_file(options.deck_file, options.out, comm);
      break;
    case Command::describe:
      if (root) std::cout << description(options);
      break;
    case Command::version:
      if (root) std::cout << version_text();
      break;
    case Command::help:
      if (root) std::cout << help_text(options.help_of);
      break;
  }
  return static_cast<int>(ExitCode::finished);
}

/// A page that did not reach the file or pipe it was sent to is a failure; a run has its run.log.
void refuse_lost_screen(const Options& options, const Comm& comm) {
  const bool computes = options.command == Command::run || options.command == Command::resume ||
                        options.command == Command::continue_run;
  RootWork work(comm);
  work.run([&] {
    if (!computes && !std::cout.flush())
      throw FileError(
          "cannot write to the standard output (the disk may be full); send it elsewhere."
      );
  });
  work.agree();
}

int execute(int argc, char** argv, const Teuchos::RCP<const Comm>& comm) {
  const Options options = parse_command_line(argc, argv);
  const int code = carry_out(options, comm);
  refuse_lost_screen(options, *comm);
  return code;
}

/// An error that every rank meets is said once and ends the run in order; one that only this rank
/// can know of must not leave the others waiting.
int report_errors(int argc, char** argv, const Teuchos::RCP<const Comm>& comm) {
  try {
    return execute(argc, argv, comm);
  } catch (const std::exception& error) {
    const ExitCode code = exit_code_of(error);
    if (code != ExitCode::internal) {
      if (is_root(*comm)) std::cerr << "barreno: " << error.what() << std::endl;
    } else {
      std::cerr << "barreno: internal error on rank " << comm->getRank() << ": " << error.what()
                << std::endl;
      if (comm->getSize() > 1) MPI_Abort(MPI_COMM_WORLD, static_cast<int>(code));
    }
    return static_cast<int>(code);
  }
}

/// A run needs MPI, whatever mpirun has started, and the plan of one, and flow: MueLu cannot set up
/// its grids without. A point or a page of text comes ten times sooner.
bool needs_mpi(int argc, char** argv) {
  if (is_rank()) return true;
  const std::string word = argc > 1 ? argv[1] : "";
  return word == "run" || word == "continue" || word == "resume" || word == "check" ||
         word == "solve-flow";
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  // Kokkos would answer --help itself and take other words away: it sees the program's name alone.
  int words = 1;
  char** first_word = argv;
  if (!barreno::needs_mpi(argc, argv)) {
    const Kokkos::ScopeGuard kokkos(words, first_word);
    return barreno::report_errors(argc, argv, Teuchos::rcp(new Teuchos::SerialComm<int>));
  }
  barreno::prepare_lone_mpi();
  const Tpetra::ScopeGuard mpi_and_kokkos(&words, &first_word);
  barreno::set_machines(barreno::count_machines());
  return barreno::report_errors(argc, argv, Tpetra::getDefaultComm());
}
