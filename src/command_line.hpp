// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "drive/drive.hpp"

#include <string>
#include <vector>

namespace barreno {

enum class Command { help, version, run, continue_run, resume, check, drive, solve_flow, describe };

/// Tables of what a run writes, as docs/output.md and the report have them.
enum class OutputTable { none, fields, history, ledger, report };

/// What was typed after `barreno`.
struct Options {
  Command command = Command::help;
  Command help_of = Command::help;  ///< whose help was asked for
  std::string deck_file;  ///< run, check; of resume the run's folder, of solve-flow the problem
  std::vector<std::string> overrides;  ///< --set, in order; --until; of continue its folder
  DriveRequest drive;
  std::string out;  ///< empty: a new folder below runs/
  bool overwrite = false;
  int ranks = 0;  ///< --ranks; 0: not given. The launcher starts that many; the code only compares.
  std::string section;                    ///< describe; empty: overview
  bool markdown = false;                  ///< describe as docs/deck.md
  OutputTable table = OutputTable::none;  ///< describe that one
  bool print_deck = false;                ///< check: the effective deck instead of the plan
  bool print_jet = false;                 ///< check: the slugs of the jet instead of the plan
};

/// @throws DeckError  with one sentence
Options parse_command_line(int argc, const char* const* argv);

/// What --help prints of a command; of Command::help all.
std::string help_text(Command command = Command::help);

}  // namespace barreno
