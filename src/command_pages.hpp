// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "command_line.hpp"

#include <string>
#include <vector>

namespace barreno {

/// One option of a command: what its help says and what it changes.
struct OptionPage {
  const char* name;
  const char* value;    ///< "FOLDER"; nothing: the option takes no value
  const char* example;  ///< a value, for sentences
  const char* meaning;
  void (*take)(Options&, const std::string& value);
  bool required = false;
};

/// One command: the single source of its help and of what is understood behind it.
struct CommandPage {
  Command command;
  const char* name;
  const char* summary;
  const char* operand;  ///< "DECK"; nothing: every word belongs to an option
  const char* operand_meaning;
  bool operand_required;
  std::vector<OptionPage> options;
  const char* examples;  ///< one on each line
};

const std::vector<CommandPage>& command_pages();

}  // namespace barreno
