// SPDX-License-Identifier: BSD-3-Clause
/// The readers of fuzz_readers under libFuzzer, which keeps what reaches code that nothing before
/// did. Changes are ours (mutate.hpp) and libFuzzer's own in turn.
///
///     BARRENO_READER=deck BARRENO_FOLDER=/tmp/fuzz fuzz_guided CORPUS... -timeout=1
#include "mutate.hpp"
#include "readers.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>

// Names that libFuzzer asks for, and one that it gives.
// NOLINTBEGIN(readability-identifier-naming)
extern "C" {
int LLVMFuzzerInitialize(int* argc, char*** argv);
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
std::size_t LLVMFuzzerCustomMutator(
    std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed
);
}
// NOLINTEND(readability-identifier-naming)

namespace {

using namespace barreno::fuzz;

std::string variable(const char* name) {
  const char* const value = std::getenv(name);
  if (value != nullptr) return value;
  std::fprintf(stderr, "fuzz_guided: the environment lacks %s\n", name);
  std::exit(2);
}

Reader asked_reader() {
  const std::string word = variable("BARRENO_READER");
  for (int r = 0; r < reader_count; ++r)
    if (word == name_of(static_cast<Reader>(r))) return static_cast<Reader>(r);
  std::fprintf(stderr, "fuzz_guided: there is no reader '%s'\n", word.c_str());
  std::exit(2);
}

std::filesystem::path& folder() {
  static std::filesystem::path path;
  return path;
}
Reader& reader() {
  static Reader chosen{};
  return chosen;
}
/// What the input before this one was: parts of it go into the next.
std::string& donor() {
  static std::string bytes;
  return bytes;
}

std::string text_of(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace

int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  folder() = variable("BARRENO_FOLDER");
  reader() = asked_reader();
  prepare_folder(folder());
  return 0;
}

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const Answer answer = read_input(reader(), text_of(data, size), folder());
  if (answer.fault.empty()) return 0;
  std::fprintf(stderr, "the sentence %s: %s\n", answer.fault.c_str(), answer.sentence.c_str());
  std::abort();
}

std::size_t LLVMFuzzerCustomMutator(
    std::uint8_t* data, std::size_t size, std::size_t most, unsigned seed
) {
  if (seed % 4 == 0) return LLVMFuzzerMutate(data, size, most);
  Engine engine(seed);
  std::string bytes = text_of(data, size);
  const Seed own = seed_of(reader(), bytes);
  const Seed other = seed_of(reader(), donor().empty() ? bytes : donor());
  donor() = bytes;
  bytes = mutated(reader(), own, other, engine);
  const std::size_t count = std::min(bytes.size(), most);
  std::memcpy(data, bytes.data(), count);
  return count;
}
