// SPDX-License-Identifier: BSD-3-Clause
#include "resume.hpp"

#include "base/error.hpp"
#include "base/interrupt.hpp"
#include "check/plan.hpp"
#include "checkpoint/check_values.hpp"
#include "checkpoint/continued_tables.hpp"
#include "checkpoint/read_checkpoint.hpp"
#include "continue_run.hpp"
#include "deck/echo_deck.hpp"
#include "deck/files/read_deck.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/time_section.hpp"
#include "files/text_file.hpp"
#include "jet/rest.hpp"
#include "output/folder_lock.hpp"
#include "output/output.hpp"
#include "output/radii.hpp"
#include "run.hpp"
#include "scene/build_scene.hpp"
#include "scene/jet/jet_monitor.hpp"
#include "state/build_state.hpp"

#include <array>
#include <fstream>
#include <memory>

namespace barreno {
namespace {

constexpr const char* ended_at_rest = "\"ended_at\": \"rest\"";

bool says(const std::filesystem::path& summary, const std::string& words) {
  std::ifstream stream(summary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return text.find(words) != std::string::npos;
}

/// Whether a run's last words are that it has come to this end. One that was killed between its
/// last checkpoint and those words has them still to say.
bool says_finished(const std::filesystem::path& summary, double end_time) {
  return says(summary, "\"finished\": true") &&
         says(summary, "\"end_time\": " + to_text(end_time) + ",");
}

/// What a new fixed end leaves without meaning is taken out of the deck.
std::vector<std::string> with_end(
    std::vector<std::string> overrides, const std::string& deck_text
) {
  const std::string end = path_of(&TimeSpec::end_time) + "=";
  const std::string longest = path_of(&TimeSpec::longest_time) + "=";
  bool fixed = false, bounded = false;
  for (const std::string& one : overrides) {
    if (one.rfind(end, 0) == 0) fixed = one != end + at_rest_word;
    if (one.rfind(longest, 0) == 0) bounded = true;
  }
  const std::string entry = "name=\"" + name_of(&TimeSpec::longest_time) + "\"";
  if (fixed && !bounded && deck_text.find(entry) != std::string::npos) overrides.push_back(longest);
  return overrides;
}

/// What keeps a run from being resumed.
void refuse_resume(
    const std::filesystem::path& folder,
    const Deck& deck,
    const Scene& scene,
    const Checkpoint& checkpoint
) {
  const std::string other = deck_difference(checkpoint.deck_text, effective_deck_xml(deck));
  if (!other.empty())
    throw DeckError(
        "cannot resume '" + folder.string() +
        "': its deck.xml differs from the deck in its checkpoint (" + other +
        "); put the deck back, or start a new run with barreno run."
    );
  const double time = number_of(checkpoint.numbers, "time");
  const std::filesystem::path summary = folder / "summary.json";
  const std::string example = "for example --until \"" + to_text(2.0 * time) + " s\".";
  if (scene.at_rest && is_at_rest(checkpoint.output) && says(summary, ended_at_rest))
    throw DeckError(
        "'" + folder.string() + "' has ended at " + to_text(time) +
        " s, because the hole of its jet is at rest; to go on all the same, give a time with "
        "--until, " +
        example
    );
  const bool over =
      time > scene.end_time || (time == scene.end_time && says_finished(summary, time));
  if (!over) return;
  if (scene.at_rest)
    throw DeckError(
        "'" + folder.string() + "' has reached its longest time (" + to_text(time) +
        " s); give a later one with --longest, or a fixed end with --until, " + example
    );
  throw DeckError(
      "'" + folder.string() + "' has reached its end time (" + to_text(time) +
      " s); give a later one with --until, " + example
  );
}

/// A path that is not a folder is reported as one without a checkpoint.
std::unique_ptr<FolderLock> lock_if_there(const Comm& comm, const std::filesystem::path& folder) {
  std::array<double, 1> there{0.0};
  if (is_root(comm)) there[0] = std::filesystem::is_directory(folder) ? 1.0 : 0.0;
  max_over_ranks(comm, there);
  return there[0] == 1.0 ? std::make_unique<FolderLock>(comm, folder) : nullptr;
}

/// Where the output of the run was. What a hollow ball was at t = 0 its particles alone tell, which
/// are made for that and let go. Collective.
RunNumbers position_in(
    const Scene& scene,
    const BodyCensus& census,
    const Continued& continued,
    const Checkpoint& checkpoint,
    const Teuchos::RCP<const Comm>& comm
) {
  RunNumbers position = checkpoint.output;
  position["time"] = {number_of(checkpoint.numbers, "time")};
  if (!hollow_balls(scene).empty() && !continued.on())
    position["radii_start"] = start_of_radii(scene, build_state(scene, census, comm));
  return position;
}

}  // namespace

int resume(
    const std::filesystem::path& folder,
    const std::vector<std::string>& new_end,
    const BuildFacts& build,
    const Teuchos::RCP<const Comm>& comm
) {
  const std::unique_ptr<FolderLock> lock = lock_if_there(*comm, folder);
  const Checkpoint checkpoint = find_checkpoint(*comm, folder);
  const std::string file = (folder / "deck.xml").string();
  const std::vector<std::string> overrides = with_end(new_end, checkpoint.deck_text);
  const Deck deck = read_deck(file, overrides, *comm);
  const Scene scene = build_scene(deck);
  refuse_rest_without_target(deck, scene);
  refuse_resume(folder, deck, scene, checkpoint);
  const BodyCensus census = take_census(scene, comm);
  const auto continues = read_section<ContinueSpec>(deck);
  const Continued continued = continues.on() ? read_continued(scene, checkpoint) : Continued{};
  const std::vector<IdRange> ids =
      continues.on() ? ids_in_order(continued) : particle_id_ranges(scene, census.first);
  const RunNumbers position = position_in(scene, census, continued, checkpoint, comm);
  State state = build_empty_state(scene, census, comm);
  if (continues.on()) bound_steps(scene, continued, state);
  check_checkpoint(scene, state, checkpoint);
  read_checkpoint(scene, ids, checkpoint, state);
  settle_checkpoints(*comm, checkpoint);
  std::vector<std::string> notes = notes_of(deck, scene);
  notes.insert(notes.end(), checkpoint.notes.begin(), checkpoint.notes.end());
  notes.push_back(
      "resumed from " + checkpoint.file.filename().string() +
      ": t = " + to_text(number_of(checkpoint.numbers, "time")) + " s, step " +
      to_text(number_of(checkpoint.numbers, "step"))
  );
  const std::string text = overrides.empty() ? checkpoint.deck_text : effective_deck_xml(deck);
  RunDescription description;
  description.folder = folder;
  description.deck_name = file;
  description.deck_text = text;
  description.version = BARRENO_VERSION;
  description.notes = notes;
  description.build = build;
  description.monitor = jet_monitor_of(deck, scene);
  description.ids = ids;
  description.continued_run = continues;
  description.continued = continued;
  catch_signals();
  Output output(scene, state, description, position);
  output.go_on_from(scene, state);
  return run_to_end(scene, state, output, description);
}

}  // namespace barreno
