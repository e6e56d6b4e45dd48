// SPDX-License-Identifier: BSD-3-Clause
/// Random input of every kind that a user gives: none may crash, take longer than a second, or be
/// refused otherwise than with one sentence.
///
///     fuzz_readers FOLDER replay FILE...              every file as it is
///     fuzz_readers FOLDER READER ROUNDS SEED FILE...  changes of the files, for one reader
///
/// FOLDER is emptied, and keeps the last input after a crash. One line of numbers for every reader;
/// what went wrong stands before it. Exit code 0: nothing did.
#include "mutate.hpp"
#include "readers.hpp"

#include <Kokkos_Core.hpp>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <set>
#include <sstream>
#include <sys/time.h>
#include <unistd.h>

// NOLINTBEGIN(bugprone-reserved-identifier,readability-identifier-naming): the sanitizer's own name
extern "C" {
// A reader that wants more than this at once, or a process that has more than the second, has
// failed.
const char* __asan_default_options();
const char* __asan_default_options() {
  return "max_allocation_size_mb=1200:hard_rss_limit_mb=3000:detect_stack_use_after_return=1";
}
}
// NOLINTEND(bugprone-reserved-identifier,readability-identifier-naming)

namespace {

using namespace barreno::fuzz;
namespace fs = std::filesystem;

constexpr double longest_seconds = 1.0;
constexpr int given_up_after = 20;  // [s]

double cpu_now() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void say_hang(int) {
  static const char text[] = "hang: the last input takes too long\n";
  if (write(STDOUT_FILENO, text, sizeof text - 1) < 0) _exit(4);
  _exit(3);
}

void watch() {
  const itimerval limit{{0, 0}, {given_up_after, 0}};
  setitimer(ITIMER_PROF, &limit, nullptr);
}

/// A sentence without what the input put into it: numbers and words in quotes.
std::string kind_of(const std::string& sentence) {
  std::string kind;
  char quote = '\0';
  for (const char c : sentence.substr(std::min(sentence.size(), sentence.find(' ')))) {
    if (quote != '\0') {
      if (c == quote) quote = '\0';
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (!(c >= '0' && c <= '9') && c != '.' && c != '-') {
      kind += c;
    }
  }
  return kind;
}

struct Tally {
  long inputs = 0, accepted = 0, faults = 0, slow = 0;
  double slowest = 0.0;
  std::set<std::string> kinds;
};

void report(
    const char* what,
    const std::string& name,
    const Answer& answer,
    const std::string& bytes,
    const fs::path& folder
) {
  static int kept = 0;
  const fs::path file = folder / ("found_" + std::to_string(++kept));
  if (kept <= 50) std::ofstream(file, std::ios::binary) << bytes;
  std::printf(
      "%s: %s: %s (%s)\n", name.c_str(), what, answer.sentence.substr(0, 3000).c_str(), file.c_str()
  );
}

void judge(
    Reader reader,
    const std::string& bytes,
    const std::string& name,
    const fs::path& folder,
    Tally& tally
) {
  watch();
  const double start = cpu_now();
  const Answer answer = read_input(reader, bytes, folder);
  const double seconds = cpu_now() - start;
  ++tally.inputs;
  tally.accepted += answer.accepted ? 1 : 0;
  tally.slowest = std::max(tally.slowest, seconds);
  if (!answer.accepted) tally.kinds.insert(kind_of(answer.sentence));
  if (!answer.fault.empty()) {
    ++tally.faults;
    report(("the sentence " + answer.fault).c_str(), name, answer, bytes, folder);
  }
  if (seconds > longest_seconds) {
    ++tally.slow;
    report(("took " + std::to_string(seconds) + " s").c_str(), name, answer, bytes, folder);
  }
}

bool summed_up(Reader reader, const Tally& tally) {
  std::printf(
      "%s inputs %ld accepted %ld kinds %zu faults %ld slow %ld slowest %.3f\n",
      name_of(reader),
      tally.inputs,
      tally.accepted,
      tally.kinds.size(),
      tally.faults,
      tally.slow,
      tally.slowest
  );
  return tally.faults == 0 && tally.slow == 0;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

bool replay(const fs::path& folder, const std::vector<fs::path>& files) {
  std::vector<Tally> tallies(reader_count);
  for (const fs::path& file : files) {
    const std::string bytes = bytes_of(file);
    const Reader reader = reader_of(file, bytes);
    judge(reader, bytes, file.string(), folder, tallies[static_cast<std::size_t>(reader)]);
  }
  bool sound = true;
  for (int r = 0; r < reader_count; ++r)
    sound = summed_up(static_cast<Reader>(r), tallies[static_cast<std::size_t>(r)]) && sound;
  return sound;
}

/// What is read as it is, and what is refused.
struct Seeds {
  std::vector<Seed> sound, bad;
};

Seeds seeds_of(Reader reader, const std::vector<fs::path>& files, const fs::path& folder) {
  Seeds seeds;
  for (const fs::path& file : files) {
    const std::string bytes = bytes_of(file);
    if (reader_of(file, bytes) != reader || bytes.size() > 64U << 10U) continue;
    const bool sound = read_input(reader, bytes, folder).accepted;
    (sound ? seeds.sound : seeds.bad).push_back(seed_of(reader, bytes));
  }
  return seeds;
}

const Seed& any_seed(const Seeds& seeds, Engine& engine) {
  return seeds.bad.empty() || !one_in(engine, 4) ? any_of(engine, seeds.sound)
                                                 : any_of(engine, seeds.bad);
}

bool fuzz(
    const fs::path& folder,
    const std::string& word,
    long rounds,
    unsigned long number,
    const std::vector<fs::path>& files
) {
  int r = 0;
  while (r + 1 < reader_count && word != name_of(static_cast<Reader>(r))) ++r;
  const auto reader = static_cast<Reader>(r);
  const Seeds seeds = seeds_of(reader, files, folder);
  if (word != name_of(reader) || seeds.sound.empty()) {
    std::printf("no sound file is for a reader '%s'\n", word.c_str());
    return false;
  }
  Engine engine(number);
  Tally tally;
  for (long round = 0; round < rounds; ++round) {
    const Seed& seed = any_seed(seeds, engine);
    const Seed& donor = any_seed(seeds, engine);
    const std::string bytes = mutated(reader, seed, donor, engine);
    judge(reader, bytes, "round " + std::to_string(round), folder, tally);
  }
  return summed_up(reader, tally);
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> words(argv + 1, argv + argc);
  const bool replayed = words.size() > 2 && words[1] == "replay";
  if (!replayed && words.size() < 5) {
    std::puts("fuzz_readers FOLDER replay FILE...\nfuzz_readers FOLDER READER ROUNDS SEED FILE...");
    return 2;
  }
  std::signal(SIGPROF, say_hang);
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  prepare_folder(words[0]);
  const std::vector<fs::path> files(words.begin() + (replayed ? 2 : 4), words.end());
  const bool sound =
      replayed ? replay(words[0], files)
               : fuzz(words[0], words[1], std::stol(words[2]), std::stoul(words[3]), files);
  return sound ? 0 : 1;
}
