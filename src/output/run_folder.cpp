// SPDX-License-Identifier: BSD-3-Clause
#include "output/run_folder.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// Everything that a run writes beside its particles; a folder with one of these holds a result.
constexpr std::array<const char*, 10> result_files{
    "run.log",
    "deck.xml",
    "history.csv",
    "depth.csv",
    "radii.csv",
    "cavities.csv",
    "checkpoint.h5",
    "checkpoint_previous.h5",
    "checkpoint.h5.tmp",
    "summary.json"};

/// particles.e, a file of its set (particles.e.2.0), or one of them half written.
bool is_result(const std::string& name) {
  return name.rfind("particles.e", 0) == 0 ||
         std::find(result_files.begin(), result_files.end(), name) != result_files.end();
}

std::vector<fs::path> results_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;  // the probe finds a folder that cannot be read
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

/// Creating a file is the only sure test of permissions.
void probe(const fs::path& folder) {
  const fs::path file = folder / ".barreno_probe";
  errno = 0;
  const bool fine = static_cast<bool>(std::ofstream(file) << std::flush);
  const int why = errno;
  std::error_code ignored;
  fs::remove(file, ignored);
  if (!fine) refuse(folder, std::strerror(why));
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
  const std::vector<fs::path> found = results_in(folder);
  if (!found.empty() && !overwrite)
    throw FileError(
        "the run folder '" + folder.string() + "' already holds a result (" +
        found.front().filename().string() + "). Give another one with --out, or add --overwrite."
    );
  probe(folder);
  for (const fs::path& file : found)
    if (!fs::remove(file, error)) refuse(folder, error.message());
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

void discard_empty_run_folder(const Comm& comm, const fs::path& folder) {
  if (!is_root(comm)) return;
  std::error_code ignored;
  if (fs::is_empty(folder, ignored)) fs::remove(folder, ignored);
}

}  // namespace barreno
