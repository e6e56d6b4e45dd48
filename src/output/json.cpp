// SPDX-License-Identifier: BSD-3-Clause
#include "output/json.hpp"

#include "output/text_file.hpp"

#include <cmath>
#include <cstdio>

namespace barreno {

std::string json_string(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out += code;
    } else {
      out += c;
    }
  }
  return out + '"';
}

JsonWriter::JsonWriter() : text_("{") {}

void JsonWriter::member(const std::string& name, const std::string& value) {
  text_ += first_ ? "\n" : ",\n";
  text_ +=
      std::string(2 * static_cast<std::size_t>(level_), ' ') + json_string(name) + ": " + value;
  first_ = false;
}

void JsonWriter::text(const std::string& name, const std::string& value) {
  member(name, json_string(value));
}
void JsonWriter::number(const std::string& name, double value) {
  member(name, std::isfinite(value) ? to_text(value) : "null");
}
void JsonWriter::integer(const std::string& name, long long value) {
  member(name, std::to_string(value));
}
void JsonWriter::flag(const std::string& name, bool value) {
  member(name, value ? "true" : "false");
}

void JsonWriter::begin_object(const std::string& name) {
  member(name, "{");
  ++level_;
  first_ = true;
}

void JsonWriter::end_object() {
  --level_;
  if (!first_) text_ += "\n" + std::string(2 * static_cast<std::size_t>(level_), ' ');
  text_ += "}";
  first_ = false;
}

std::string JsonWriter::finish() {
  end_object();
  return text_ + "\n";
}

}  // namespace barreno
