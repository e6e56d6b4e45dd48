// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/read_on_root.hpp"

#include "base/error.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <barreno/input/scan_xml.hpp>
#include <filesystem>
#include <fstream>
#include <iterator>

namespace barreno {
namespace {

/// What rank 0 met, as a number that can be sent.
enum class Verdict { read, deck_error, file_error };

struct Result {
  Verdict verdict = Verdict::read;
  std::string text;
};

Result attempt(const std::function<std::string()>& read) {
  try {
    return {Verdict::read, read()};
  } catch (const DeckError& error) {
    return {Verdict::deck_error, error.what()};
  } catch (const FileError& error) {
    return {Verdict::file_error, error.what()};
  }
}

}  // namespace

std::string read_on_root(const std::function<std::string()>& read, const Teuchos::Comm<int>& comm) {
  Result result;
  if (comm.getRank() == 0) result = attempt(read);
  int head[2] = {static_cast<int>(result.verdict), static_cast<int>(result.text.size())};
  Teuchos::broadcast(comm, 0, 2, head);
  result.text.resize(static_cast<std::size_t>(head[1]));
  Teuchos::broadcast(comm, 0, head[1], result.text.data());
  switch (static_cast<Verdict>(head[0])) {
    case Verdict::deck_error:
      throw DeckError(result.text);
    case Verdict::file_error:
      throw FileError(result.text);
    case Verdict::read:
      break;
  }
  return result.text;
}

std::string read_file(const std::string& file, std::size_t largest, const std::string& what) {
  const std::string name = input::on_one_line(file);
  const std::string purpose = " (needed as " + what + "); ";
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (!std::filesystem::exists(status))
    throw FileError(name + " does not exist" + purpose + "check the path.");
  if (std::filesystem::is_directory(status))
    throw FileError(name + " is a directory" + purpose + "give the path of a file.");
  // Reading a pipe without a writer, or a device, would never end.
  if (!std::filesystem::is_regular_file(status))
    throw FileError(name + " is a pipe or a device" + purpose + "give the path of a plain file.");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw FileError(name + " cannot be opened" + purpose + "check its permissions.");
  const auto too_large = [&] {
    const std::string bytes = std::to_string(largest);
    return DeckError(
        name + " is larger than " + bytes + " bytes" + purpose + "is it the right file?"
    );
  };
  const auto size = std::filesystem::file_size(file, error);
  if (!error && size > largest) throw too_large();
  // One byte more than is there shows whether the file grows.
  std::string text((error ? largest : static_cast<std::size_t>(size)) + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  if (text.size() > largest) throw too_large();
  if (stream.bad()) throw FileError(name + " cannot be read" + purpose + "check the disk.");
  return text;
}

}  // namespace barreno
