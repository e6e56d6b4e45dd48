// SPDX-License-Identifier: BSD-3-Clause
#include "output/run_folder.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// Everything that a run writes beside its particles; a folder with one of these holds a result.
constexpr std::array<const char*, 12> result_files{
    "run.log",
    "deck.xml",
    "history.csv",
    "depth.csv",
    "radii.csv",
    "cavities.csv",
    "checkpoint.h5",
    "checkpoint_previous.h5",
    "checkpoint.h5.tmp",
    "checkpoint_damaged.h5",
    "checkpoint_previous_damaged.h5",
    "summary.json"};

/// particles.e, a file of its set (particles.e.2.0), or one of them half written. A surface that
/// was copied into the folder stays: the deck that is run again there may name it.
bool is_result(const std::string& name) {
  return name.rfind("particles.e", 0) == 0 ||
         std::find(result_files.begin(), result_files.end(), name) != result_files.end();
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;  // the lock finds a folder that cannot be used
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (is_result(entry.path().filename())) found.push_back(entry.path());
  std::sort(found.begin(), found.end());
  return found;
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& why) {
  throw FileError(
      "cannot write into the run folder '" + folder.string() + "' (" + why +
      "). Give another one with --out."
  );
}

void refuse_result(const fs::path& folder) {
  const std::vector<fs::path> found = results_in(folder);
  if (!found.empty())
    throw FileError(
        "the run folder '" + folder.string() + "' already holds a result (" +
        found.front().filename().string() + "). Give another one with --out, or add --overwrite."
    );
}

fs::path use_named(const fs::path& folder, bool overwrite) {
  std::error_code error;
  const fs::file_status status = fs::status(folder, error);
  if (fs::exists(status) && !fs::is_directory(status)) refuse(folder, "it is a file");
  const bool was_there = fs::exists(status);
  if (!was_there) {
    fs::create_directories(folder, error);
    if (error) refuse(folder, error.message());
  }
  if (!overwrite) refuse_result(folder);
  return folder;
}

fs::path create_numbered(const std::string& deck_name) {
  const fs::path parent = "runs";
  std::error_code error;
  fs::create_directories(parent, error);
  if (error) refuse(parent, error.message());
  for (int counter = 1;; ++counter) {
    fs::path folder = parent / (deck_name + "-" + std::to_string(counter));
    // Creating it is one indivisible operation: two runs that start together get different folders.
    if (fs::create_directory(folder, error)) return folder;
    if (error && !fs::exists(folder)) refuse(folder, error.message());
  }
}

}  // namespace

fs::path create_run_folder(const Comm& comm, const RunFolderRequest& request) {
  RootWork work(comm);
  fs::path folder;
  work.run([&] {
    folder = request.out.empty() ? create_numbered(request.deck_name)
                                 : use_named(request.out, request.overwrite);
  });
  work.agree();
  return broadcast_from_root(comm, folder.string());
}

void clear_run_folder(const Comm& comm, const fs::path& folder, bool overwrite) {
  RootWork work(comm);
  work.run([&] {
    // One that started at the same time may have ended while this one waited for its lock.
    if (!overwrite) refuse_result(folder);
    std::error_code error;
    for (const fs::path& file : results_in(folder))
      if (!fs::remove(file, error)) refuse(folder, error.message());
  });
  work.agree();
}

}  // namespace barreno
