// SPDX-License-Identifier: BSD-3-Clause
#include "output/json.hpp"

#include "base/utf8.hpp"
#include "output/text_file.hpp"

#include <cmath>
#include <cstdio>

namespace barreno {

std::string json_string(const std::string& text) {
  std::string out = "\"";
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    const auto code = static_cast<unsigned char>(c);
    const std::size_t bytes = character_bytes(text, at);
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (bytes == 0 || code < 0x20) {
      char escape[8];  // a byte that is no UTF-8 as the character of Latin-1
      std::snprintf(escape, sizeof escape, "\\u%04x", static_cast<unsigned>(code));
      out += escape;
    } else {
      out += text.substr(at, bytes);
    }
    at += bytes == 0 ? 1 : bytes;
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
