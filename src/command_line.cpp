// SPDX-License-Identifier: BSD-3-Clause
#include "command_line.hpp"

#include "base/error.hpp"
#include "deck/fidelity.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <charconv>

namespace barreno {
namespace {

const std::vector<std::string> commands = {"run", "resume", "check", "drive", "describe"};
/// The arguments, with a cursor that knows what an option still needs.
class Arguments {
public:
  Arguments(int argc, const char* const* argv) : words_(argv + 1, argv + argc) {}
  bool at_end() const { return at_ == words_.size(); }
  std::string next() { return words_[at_++]; }
  std::string value_of(const std::string& option, const std::string& example) {
    std::string value = at_end() ? "" : next();
    if (!value.empty()) return value;
    throw DeckError(
        option + " has no value after it (it needs one); write for example " + option + " " +
        example + "."
    );
  }

private:
  std::vector<std::string> words_;
  std::size_t at_ = 0;
};

/// @param what  "number of ranks", for the sentence
int count_of(const std::string& option, const std::string& text, const std::string& what) {
  int count = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (error != std::errc{} || end != text.data() + text.size() || count < 1) {
    throw DeckError(
        option + " " + input::shown(text) + " is no " + what + " (1 or more); write for example " +
        option + " 2."
    );
  }
  return count;
}

Command command_of(const std::string& word) {
  if (word == "--help" || word == "-h" || word == "help") return Command::help;
  if (word == "--version" || word == "version") return Command::version;
  if (word == "run") return Command::run;
  if (word == "resume") return Command::resume;
  if (word == "check") return Command::check;
  if (word == "drive") return Command::drive;
  if (word == "describe") return Command::describe;
  if (word == "report") {
    throw DeckError(
        "report is a command of the source tree (it draws with Python); write there ./barreno "
        "report FOLDER."
    );
  }
  throw DeckError(input::shown(word) + " is not a command; " + input::suggest_name(word, commands));
}

std::vector<std::string> known_options(Command command) {
  if (command == Command::describe) return {"--markdown", "--help"};
  if (command == Command::drive)
    return {"--material", "--path", "--out", "--steps-per-row", "--set", "--help"};
  if (command == Command::check) return {"--set", "--fidelity", "--ranks", "--help"};
  if (command == Command::resume) return {"--until", "--ranks", "--help"};
  return {"--out", "--ranks", "--set", "--fidelity", "--overwrite", "--help"};
}

[[noreturn]] void refuse_option(const std::string& word, Command command) {
  throw DeckError(
      word + " is not an option of this command; " +
      input::suggest_name(word, known_options(command))
  );
}

/// As the deck would say it, so that it can be read back from the effective deck.
std::string fidelity_override(const std::string& name) {
  const std::vector<std::string> known = fidelity_words();
  if (std::find(known.begin(), known.end(), name) == known.end()) {
    throw DeckError(
        "--fidelity " + input::shown(name) + " names no set of choices; " +
        input::suggest_name(name, known)
    );
  }
  return "Fidelity=" + name;
}

/// The options that have another meaning for `drive`, or none elsewhere.
void parse_drive_option(const std::string& word, Arguments& arguments, DriveRequest& request) {
  if (word == "--material") request.material = arguments.value_of(word, "berea_sandstone.xml");
  if (word == "--path")
    request.path = arguments.value_of(word, "input_xml/paths/uniaxial_berea.csv");
  if (word == "--out") request.out = arguments.value_of(word, "answer.csv");
  if (word == "--set") request.overrides.push_back(arguments.value_of(word, "\"PEAKI1=20 MPa\""));
  if (word == "--steps-per-row") {
    const std::string text = arguments.value_of(word, "10");
    request.steps_per_row = count_of(word, text, "number of steps");
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

void parse_option(const std::string& word, Arguments& arguments, Options& options) {
  const Command command = options.command;
  bool known = false;
  for (const auto& option : known_options(command)) known = known || word == option;
  if (!known) refuse_option(word, command);
  if (word == "--help") {
    options.command = Command::help;
    options.help_of = command;
    return;
  }
  if (command == Command::drive) return parse_drive_option(word, arguments, options.drive);
  if (word == "--markdown") options.markdown = true;
  if (word == "--overwrite") options.overwrite = true;
  if (word == "--until")
    options.overrides.push_back("Time/End Time=" + arguments.value_of(word, "\"200 us\""));
  if (word == "--out") options.out = arguments.value_of(word, "results");
  if (word == "--ranks")
    options.ranks = count_of(word, arguments.value_of(word, "2"), "number of ranks");
  if (word == "--set")
    options.overrides.push_back(arguments.value_of(word, "\"Time/End Time=50 us\""));
  if (word == "--fidelity")
    options.overrides.push_back(fidelity_override(arguments.value_of(word, "balanced")));
}

}  // namespace

Options parse_command_line(int argc, const char* const* argv) {
  Arguments arguments(argc, argv);
  Options options;
  if (arguments.at_end()) return options;
  options.command = command_of(arguments.next());
  if (options.command == Command::help || options.command == Command::version) return options;
  std::string& operand = options.command == Command::describe ? options.section : options.deck_file;
  bool given = false;
  while (!arguments.at_end()) {
    std::string word = arguments.next();
    if (word == "-h") word = "--help";
    if (word.size() > 1 && word.front() == '-') {
      parse_option(word, arguments, options);
      if (options.command == Command::help) return options;
    } else if (options.command == Command::drive) {
      throw DeckError(
          input::shown(word) +
          " stands alone (drive takes every file by its option); write --material, --path or --out "
          "before it."
      );
    } else if (given) {
      throw DeckError(
          input::shown(word) + " comes after " + input::shown(operand) +
          " (one is enough); remove one of them."
      );
    } else {
      operand = word;
      given = !word.empty();  // of a variable of a script that is not set
    }
  }
  if (options.command == Command::drive) {
    check_drive(options.drive);
    return options;
  }
  if (!given && options.command == Command::resume) {
    throw DeckError(
        "no run is named (its folder holds the checkpoint); write for example barreno resume "
        "runs/perforation-1."
    );
  }
  if (!given && options.command != Command::describe) {
    throw DeckError(
        "no deck is named (it says what to compute); write for example barreno run "
        "input_xml/perforation.xml."
    );
  }
  return options;
}

std::string help_text(Command command) {
  const std::pair<Command, const char*> pages[] = {
      {Command::run,
       "barreno run DECK [--out DIR] [--ranks N] [--set \"Sub List/Parameter=value\"]... "
       "[--overwrite]\n"
       "        [--fidelity fast|balanced|reference]\n"
       "    compute; without --out into runs/<deck name>-<counter>; --set \"Sub List/Parameter=\" "
       "takes a\n"
       "    value or a list away\n"},
      {Command::resume,
       "barreno resume FOLDER [--until TIME] [--ranks N]\n"
       "    go on from the last checkpoint of a run\n"},
      {Command::check,
       "barreno check DECK [--set \"Sub List/Parameter=value\"]... [--fidelity ...] [--ranks N]\n"
       "    validate, print the plan, write nothing; a fidelity chooses between error and cost\n"
       "    what the deck does not say (docs/trade.md)\n"},
      {Command::drive,
       "barreno drive --material CARD --path PATH.csv --out OUT.csv\n"
       "        [--steps-per-row N] [--set PARAMETER=value]...\n"
       "    one material point along a path of the deformation gradient (docs/drive.md)\n"},
      {Command::describe,
       "barreno describe [SECTION or MODEL] [--markdown]\n"
       "    the deck reference\n"}};
  std::string text;
  for (const auto& [one, page] : pages)
    if (command == one || command == Command::help) text += page;
  return text +
         "\n"
         "Exit codes: 0 finished, 1 bad deck or arguments, 2 file, 3 numerical failure, 4 "
         "internal,\n"
         "128 + the signal's number where one ended the run.\n";
}

}  // namespace barreno
