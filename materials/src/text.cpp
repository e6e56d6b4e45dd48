// SPDX-License-Identifier: BSD-3-Clause
#include "text.hpp"

namespace barreno::input {

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r\n";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  if (trim(text).empty()) return parts;
  std::size_t begin = 0;
  while (true) {
    const std::size_t end = text.find(separator, begin);
    parts.emplace_back(trim(text.substr(begin, end - begin)));
    if (end == std::string_view::npos) return parts;
    begin = end + 1;
  }
}

namespace {

/// The last place up to `at` where no character of several bytes is cut.
std::size_t between_characters(std::string_view text, std::size_t at) {
  while (at > 0 && at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U)
    --at;
  return at;
}

}  // namespace

std::string cut_end(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  return std::string(text.substr(0, between_characters(text, longest - 3))) + "...";
}

std::string cut_middle(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  const std::size_t half = (longest - 3) / 2;
  return std::string(text.substr(0, between_characters(text, half))) + "..." +
         std::string(text.substr(between_characters(text, text.size() - half)));
}

int control_character(std::string_view text) {
  for (const char c : text)
    if (static_cast<unsigned char>(c) < ' ' && c != '\t' && c != '\n' && c != '\r')
      return static_cast<unsigned char>(c);
  return -1;
}

}  // namespace barreno::input
