// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// Writes a JSON object member by member, two blanks per level; numbers that JSON cannot say become
/// null.
class JsonWriter {
public:
  JsonWriter();
  void text(const std::string& name, const std::string& value);
  void number(const std::string& name, double value);
  void integer(const std::string& name, long long value);
  void flag(const std::string& name, bool value);
  void begin_object(const std::string& name);
  void end_object();
  /// Closes the outermost object. @return the whole text
  std::string finish();

private:
  void member(const std::string& name, const std::string& value);
  std::string text_;
  int level_ = 1;
  bool first_ = true;
};

/// The text as a JSON string, quotes included.
std::string json_string(const std::string& text);

}  // namespace barreno
