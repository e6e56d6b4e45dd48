// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/find_checkpoint.hpp"

#include "base/error.hpp"
#include "base/rank_work.hpp"
#include "base/region.hpp"
#include "checkpoint/seal.hpp"
#include "checkpoint/write_checkpoint.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"
#include "files/text_file.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <sstream>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// All tables of a group.
RunNumbers read_numbers(const Hdf5File& file, const std::string& group) {
  RunNumbers numbers;
  for (const std::string& name : file.names(group))
    numbers[name] = file.read(std::string(group).append("/").append(name)).values;
  return numbers;
}

fs::path damaged_name(const fs::path& path) {
  return path.parent_path() / (path.stem().string() + "_damaged.h5");
}

/// The version that a file gives itself; -1 if it gives none.
double version_of(const Hdf5File& file) {
  const Hdf5Size size = file.size_of("run/version");
  return size.rows == 1 && size.columns == 1 ? file.read("run/version").values[0] : -1.0;
}

/// What rank 0 reads of a file whose seal is right; what is wrong with it, if anything is.
std::string read_on_root(const SealedFile& sealed, const fs::path& path, Checkpoint& found) {
  try {
    auto file = std::make_shared<Hdf5File>(path, Hdf5File::Mode::read);
    if (!file->is(sealed.handle())) return "it was replaced while it was being read";
    const double version = version_of(*file);
    if (version != checkpoint_version)
      return "it has version " + to_text(version) + ", this program reads " +
             to_text(checkpoint_version);
    found.deck_text = file->read_text("deck");
    found.numbers = read_numbers(*file, "run");
    found.output = read_numbers(*file, "output");
    if (file->has("continued")) found.continued = read_numbers(*file, "continued");
    if (file->has("continued_names")) found.continued_names = file->read_text("continued_names");
    found.open = std::move(file);
  } catch (const FileError& error) {
    return error.what();
  }
  return {};
}

/// Every rank opens the file that it has compared, before it may get another name. Collective.
void open_on_others(
    const Comm& comm, const SealedFile& sealed, const fs::path& path, Checkpoint& found
) {
  RankWork work(comm);
  work.run([&] {
    if (is_root(comm)) return;
    found.open = std::make_shared<Hdf5File>(path, Hdf5File::Mode::read);
    if (found.open->is(sealed.handle())) return;
    throw FileError(
        "cannot resume from '" + path.string() +
        "' (it was replaced while it was being read); "
        "try again."
    );
  });
  work.agree();
}

/// Whether a file is a whole checkpoint of this version, then open on every rank; why not, if it is
/// not. Collective, and the same on every rank.
std::string fault_of(const Comm& comm, const fs::path& path, Checkpoint& found) {
  const SealedFile sealed(comm, path);
  if (!sealed.fault().empty()) return sealed.fault();
  std::string fault;
  if (is_root(comm)) fault = read_on_root(sealed, path, found);
  fault = broadcast_from_root(comm, fault);
  if (!fault.empty()) return fault;
  open_on_others(comm, sealed, path, found);
  found.file = path;
  return {};
}

/// Whether rank 0 has a file of that name.
bool is_there(const Comm& comm, const fs::path& path) {
  std::error_code error;
  const bool there = is_root(comm) && fs::exists(path, error);
  return broadcast_from_root(comm, there ? "there" : "") == "there";
}

Checkpoint find_newest(const Comm& comm, const fs::path& folder) {
  Checkpoint found;
  // Any kill may leave one that was not sealed, so that is not reported.
  const fs::path aside = folder / checkpoint_temporary_name;
  if (is_there(comm, aside) && fault_of(comm, aside, found).empty()) return found;
  std::string faults;
  for (const char* name : {checkpoint_name, previous_checkpoint_name}) {
    const fs::path path = folder / name;
    if (!is_there(comm, path)) continue;
    const std::string fault = fault_of(comm, path, found);
    if (fault.empty()) return found;
    faults += (faults.empty() ? "" : "; ") + std::string(name) + ": " + fault;
    found.notes.push_back(
        std::string(name) + " is skipped (" + fault + ") and kept as " +
        damaged_name(path).filename().string() + "."
    );
    found.damaged.push_back(path);
  }
  throw FileError(
      "cannot resume from '" + folder.string() + "' (" +
      (faults.empty() ? "it holds no checkpoint.h5" : faults) +
      "); name the folder of a run, or start it again with barreno run."
  );
}

RunNumbers share(const Comm& comm, const RunNumbers& mine) {
  std::ostringstream names;
  std::vector<double> values;
  for (const auto& [name, numbers] : mine) {
    names << name << '\n' << numbers.size() << '\n';
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  std::istringstream shared(broadcast_from_root(comm, names.str()));
  RunNumbers all;
  std::size_t total = 0;
  std::vector<std::pair<std::string, std::size_t>> entries;
  std::string name;
  while (std::getline(shared, name)) {
    std::string size;
    std::getline(shared, size);
    entries.emplace_back(name, std::stoul(size));
    total += entries.back().second;
  }
  values.resize(total);
  if (total > 0) Teuchos::broadcast<int, double>(comm, 0, static_cast<int>(total), values.data());
  auto next = values.begin();
  for (const auto& [entry, size] : entries) {
    all[entry].assign(next, next + static_cast<std::ptrdiff_t>(size));
    next += static_cast<std::ptrdiff_t>(size);
  }
  return all;
}

std::string trimmed(const std::string& line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos ? "an empty line" : line.substr(begin);
}

std::string mark_of(const std::string& entry) {
  return "name=\"" + entry + "\"";
}

/// End times may differ, and the name that a comment gives the deck.
bool may_differ(const std::string& a, const std::string& b) {
  for (const std::string& mark : {std::string("<!-- "), mark_of(name_of(&TimeSpec::end_time))})
    if (a.find(mark) != std::string::npos && b.find(mark) != std::string::npos) return true;
  return false;
}

/// The next line of a deck, but for its longest time, which comes and goes with the end.
bool next_line(std::istream& deck, std::string& line) {
  const std::string longest = mark_of(name_of(&TimeSpec::longest_time));
  while (std::getline(deck, line))
    if (line.find(longest) == std::string::npos) return true;
  return false;
}

bool ends_a_line(const std::string& text) {
  return !text.empty() && text.back() == '\n';
}

}  // namespace

Checkpoint find_checkpoint(const Comm& comm, const fs::path& folder) {
  const Region region("find_checkpoint");
  Checkpoint found = find_newest(comm, folder);
  found.deck_text = broadcast_from_root(comm, found.deck_text);
  found.numbers = share(comm, found.numbers);
  found.output = share(comm, found.output);
  found.continued = share(comm, found.continued);
  found.continued_names = broadcast_from_root(comm, found.continued_names);
  return found;
}

void settle_checkpoints(const Comm& comm, const Checkpoint& checkpoint) {
  RootWork work(comm);
  work.run([&] {
    for (const fs::path& path : checkpoint.damaged) {
      std::error_code error;
      fs::rename(path, damaged_name(path), error);
      if (error)
        throw FileError(
            "cannot rename the damaged '" + path.string() + "' (" + error.message() +
            "); check the folder's permissions."
        );
    }
    if (checkpoint.file.filename() == checkpoint_temporary_name)
      rename_checkpoint(checkpoint.file.parent_path());
  });
  work.agree();
}

std::string deck_difference(const std::string& kept, const std::string& found) {
  std::istringstream one(kept), other(found);
  std::string a, b;
  for (int line = 1;; ++line) {
    const bool more = next_line(one, a);
    const bool other_more = next_line(other, b);
    if (!more && !other_more)
      return ends_a_line(kept) == ends_a_line(found) ? "" : "the last line has no end";
    if (!more) a = "nothing";
    if (!other_more) b = "nothing";
    if (a == b || may_differ(a, b)) continue;
    return "line " + std::to_string(line) + ": " + trimmed(a) + " against " + trimmed(b);
  }
}

}  // namespace barreno
