// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include "base/error.hpp"
#include "command_pages.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/continue_section.hpp"

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <filesystem>
#include <iterator>
#include <map>
#include <utility>

namespace barreno {
namespace {

const char* const title =
    "Barreno: a material point code for shaped-charge jets that perforate rock.\n";
const char* const exit_codes =
    "Exit codes: 0 finished, 1 bad deck or arguments, 2 file, 3 numerical failure, 4 internal,\n"
    "128 + the number of the signal that ended the run.";
const char* const other_words =
    "barreno COMMAND --help describes a command in detail. ./barreno of the source tree and "
    "barreno of\n"
    "an installation also have report FOLDER (pictures and numbers of a run), film FOLDER, jet "
    "DECK\n"
    "(its jet and depths by theory), flow FOLDER (into its hole), converge DECK (order and "
    "interval of\n"
    "its depth), sweep DECK (several values of its parameters), uncertainty DECK (how sure its "
    "depth\n"
    "is), compare RUN RUN (runs side by side), join FOLDER (files of all ranks), fit DATA (a card "
    "from\n"
    "laboratory tests) and import-ups FILE.\n\n";

/// Options of CLI11 back to what this code knows of them.
using Known = std::map<const CLI::Option*, const OptionPage*>;

void add_command(const CommandPage& page, CLI::App& program, Known& known) {
  CLI::App& app = *program.add_subcommand(page.name, std::string(page.summary) + "\n");
  app.allow_extras();  // said in sentences of our own
  app.group("Commands");
  app.footer(
      "Examples:\n  " + CLI::detail::find_and_replace(page.examples, "\n", "\n  ") + "\n\n" +
      exit_codes
  );
  if (page.operand != nullptr) {
    CLI::Option& operand = *app.add_option(page.operand)->description(page.operand_meaning);
    operand.option_text(" ");
    operand.required(page.operand_required);
  }
  for (const OptionPage& one : page.options) {
    CLI::Option& option =
        one.value == nullptr
            ? *app.add_flag(one.name)->disable_flag_override()
            : *app.add_option(one.name)->type_name(one.value)->allow_extra_args(false);
    option.description(one.meaning);
    option.required(one.required);
    option.multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
    known[&option] = &one;
  }
}

void add_commands(CLI::App& program, Known& known) {
  program.set_help_flag("-h,--help", "this page");
  program.allow_extras();
  program.require_subcommand(0, 1);
  program.footer(std::string(other_words) + exit_codes);
  program.get_formatter()->column_width(36);
  program.get_formatter()->label("Positionals", "Arguments");
  program.get_formatter()->label("SUBCOMMAND", "COMMAND");
  program.get_formatter()->label("REQUIRED", "(required)");
  for (const CommandPage& page : command_pages()) add_command(page, program, known);
  program.add_flag("--version", "version, commit, compiler and libraries");
}

/// What the launcher alone has, and the operand of each.
constexpr std::pair<const char*, const char*> source_commands[] = {
    {"report", "FOLDER"},
    {"film", "FOLDER --field FIELD"},
    {"jet", "DECK"},
    {"flow", "FOLDER"},
    {"join", "FOLDER --out FILE"},
    {"converge", "DECK"},
    {"uncertainty", "DECK"},
    {"sweep", "DECK --vary \"LIST/NAME=VALUE,VALUE\""},
    {"compare", "RUN RUN"},
    {"fit", "DATA... --out CARD.xml"},
    {"import-ups", "FILE.ups --out DECK.xml"}};

bool is_source_command(const std::string& word) {
  return std::any_of(
      std::begin(source_commands),
      std::end(source_commands),
      [&](const auto& command) { return word == command.first; }
  );
}

bool is_option(const std::string& word) {
  return word.size() > 1 && word.front() == '-';
}

[[noreturn]] void refuse_command(const std::string& word) {
  for (const auto& [name, operand] : source_commands) {
    if (word != name) continue;
    std::string sentence = word;
    sentence +=
        " is a command of ./barreno in the source tree and of an installed barreno, not of this "
        "program alone; write ./barreno ";
    throw DeckError(sentence.append(word).append(" ").append(operand).append("."));
  }
  std::vector<std::string> names;
  for (const CommandPage& page : command_pages()) names.emplace_back(page.name);
  throw DeckError(input::shown(word) + " is not a command; " + input::suggest_name(word, names));
}

[[noreturn]] void refuse_option(const std::string& word, const CommandPage& page) {
  std::vector<std::string> names;
  for (const OptionPage& option : page.options) names.emplace_back(option.name);
  names.emplace_back("--help");
  throw DeckError(
      word + " is not an option of this command; " +
      input::suggest_name(word.substr(0, word.find('=')), names)
  );
}

[[noreturn]] void refuse_no_value(const OptionPage& option) {
  throw DeckError(
      std::string(option.name) + " needs a value; write for example " + option.name + " " +
      option.example + "."
  );
}

/// What CLI11 could not read: an option without its value, or with one that it does not take.
[[noreturn]] void refuse_line(const CLI::ParseError& error, const CommandPage* page) {
  const std::string what = error.what();
  if (page != nullptr) {
    for (const OptionPage& option : page->options) {
      if (what.rfind(std::string(option.name) + ":", 0) == 0) refuse_no_value(option);
      if (option.value == nullptr && what.rfind(option.name + 2, 0) == 0) {
        throw DeckError(std::string(option.name) + " takes no value; write " + option.name + ".");
      }
    }
  }
  throw DeckError("the command line cannot be read (" + what + "); see barreno --help.");
}

/// Words that belong to no option; an empty one is a variable of a script that is not set.
std::string operand_of(const CLI::App& app, const CommandPage& page) {
  std::vector<std::string> words;
  if (page.operand != nullptr) words = app.get_option(page.operand)->results();
  for (const std::string& word : app.remaining()) {
    if (is_option(word)) refuse_option(word, page);
    words.push_back(word);
  }
  std::string operand;
  for (const std::string& word : words) {
    if (word.empty()) continue;
    if (page.operand == nullptr) {
      throw DeckError(
          input::shown(word) +
          " is not preceded by an option (drive takes every file with its option); write "
          "--material, --path or --out before it."
      );
    }
    if (!operand.empty()) {
      throw DeckError(
          input::shown(word) + " follows " + input::shown(operand) +
          " (only one is allowed); remove one of them."
      );
    }
    operand = word;
  }
  return operand;
}

/// In the order in which they were typed: later ones win.
void take_options(const CLI::App& app, const Known& known, Options& options) {
  std::map<const CLI::Option*, std::size_t> seen;
  for (const CLI::Option* given : app.parse_order()) {
    const auto found = known.find(given);
    if (found == known.end()) continue;  // the operand
    const OptionPage& page = *found->second;
    const std::string value = given->results().at(seen[given]++);
    const CLI::Option* const other = app.get_option_no_throw(value);
    if (page.value != nullptr && (value.empty() || (is_option(value) && other != nullptr)))
      refuse_no_value(page);
    page.take(options, value);
  }
}

void check_drive(const DriveRequest& request) {
  const std::pair<const char*, const std::string&> needed[] = {
      {"--material", request.material}, {"--path", request.path}, {"--out", request.out}};
  for (const auto& [option, value] : needed) {
    if (!value.empty()) continue;
    throw DeckError(
        std::string(option) +
        " is missing (drive needs a card, a path and a file for the answer); write for example "
        "barreno drive --material berea_sandstone.xml --path input_xml/paths/uniaxial_berea.csv "
        "--out answer.csv."
    );
  }
}

void check_operand(const std::string& operand, Command command) {
  if (!operand.empty()) return;
  if (command == Command::resume) {
    throw DeckError(
        "the run folder, which holds the checkpoint, is missing; write for example barreno resume "
        "runs/perforation-1."
    );
  }
  if (command == Command::solve_flow)
    throw DeckError(
        "the file with cells and pressures is missing; write for example barreno solve-flow "
        "problem.json --out answer.json."
    );
  if (command == Command::run || command == Command::check) {
    throw DeckError(
        "the deck file is missing; write for example barreno run "
        "input_xml/perforation.xml."
    );
  }
}

/// The run that is continued becomes a part of the deck, so that deck.xml of the new run names it.
void take_stage(const std::string& folder, Options& options) {
  const char* const example =
      "write for example barreno continue runs/perforation-1 --deck second_stage.xml.";
  if (folder.empty())
    throw DeckError(std::string("the folder of the finished run is missing; ") + example);
  if (options.deck_file.empty())
    throw DeckError(
        std::string("--deck is missing (the deck of the second stage says its pressures, time and "
                    "output); ") +
        example
    );
  const std::string run = std::filesystem::absolute(folder).lexically_normal().string();
  options.overrides.insert(options.overrides.begin(), path_of(&ContinueSpec::run) + "=" + run);
}

const CommandPage* page_of(const CLI::App& program) {
  if (program.get_subcommands().empty()) return nullptr;
  const std::string name = program.get_subcommands().front()->get_name();
  for (const CommandPage& page : command_pages())
    if (name == page.name) return &page;
  return nullptr;
}

}  // namespace

Options parse_command_line(int argc, const char* const* argv) {
  Options options;
  std::vector<std::string> words(argv + 1, argv + argc);
  if (words.empty()) return options;
  if (words.front() == "help" || words.front() == "version") words.front().insert(0, "--");
  if (is_source_command(words.front())) refuse_command(words.front());
  CLI::App program(title, "barreno");
  Known known;
  add_commands(program, known);
  bool help = false;
  try {
    program.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::CallForHelp&) {
    help = true;
  } catch (const CLI::RequiredError&) {  // said below, as an empty one is
  } catch (const CLI::ParseError& error) {
    refuse_line(error, page_of(program));
  }
  const CommandPage* const page = page_of(program);
  if (!program.remaining().empty()) refuse_command(program.remaining().front());
  options.help_of = page != nullptr ? page->command : Command::help;
  if (help) return options;
  if (page == nullptr) {
    options.command = Command::version;
    return options;
  }
  options.command = page->command;
  const CLI::App& app = *program.get_subcommands().front();
  const std::string operand = operand_of(app, *page);
  take_options(app, known, options);
  if (page->command == Command::continue_run) {
    take_stage(operand, options);
    return options;
  }
  (page->command == Command::describe ? options.section : options.deck_file) = operand;
  if (page->command == Command::drive)
    check_drive(options.drive);
  else
    check_operand(operand, page->command);
  return options;
}

std::string help_text(Command command) {
  CLI::App program(title, "barreno");
  Known known;
  add_commands(program, known);
  for (const CommandPage& page : command_pages())
    if (page.command == command) return program.get_subcommand(page.name)->help("barreno");
  return program.help("", CLI::AppFormatMode::All);
}

}  // namespace barreno
