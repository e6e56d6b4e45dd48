// SPDX-License-Identifier: BSD-3-Clause
#include "continue_run.hpp"

#include "base/error.hpp"
#include "checkpoint/check_values.hpp"
#include "checkpoint/continued_tables.hpp"
#include "checkpoint/read_checkpoint.hpp"
#include "deck/echo_deck.hpp"
#include "deck/files/read_deck.hpp"
#include "deck/list_text.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/quasi_static_section.hpp"
#include "deck/sections/shape_section.hpp"
#include "files/text_file.hpp"
#include "output/radii.hpp"
#include "scene/body_force.hpp"
#include "scene/build_scene.hpp"
#include "state/build_state.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

namespace barreno {
namespace {

namespace fs = std::filesystem;

std::string place_of_run() {
  return path_of(&ContinueSpec::run);
}

/// The words of the run's summary; the same on every rank. @throws FileError  if there is none
std::string summary_of(const Deck& deck, const std::string& run, const Comm& comm) {
  std::string text;
  RootWork work(comm);
  work.run([&] {
    std::ifstream stream(fs::path(run) / "summary.json");
    if (!stream)
      throw FileError(
          deck.name() + ": " + place_of_run() + " = " + input::shown(run) +
          " has no summary.json (it is not the folder of a run that has ended); name the folder of "
          "a finished run."
      );
    text.assign(std::istreambuf_iterator<char>(stream), {});
  });
  work.agree();
  return broadcast_from_root(comm, text);
}

/// The number of the summary's own that has this name.
double number_in(const std::string& summary, const std::string& name) {
  const std::string mark = "\n  \"" + name + "\": ";
  const std::size_t at = summary.find(mark);
  return at == std::string::npos ? -1.0 : std::strtod(summary.c_str() + at + mark.size(), nullptr);
}

/// A run that was cut off, or prolonged and cut off then, is no end to start from.
void refuse_unfinished(
    const Deck& deck, const std::string& run, const std::string& summary, const Checkpoint& last
) {
  const bool finished = summary.find("\"finished\": true") != std::string::npos;
  if (finished && number_in(summary, "time") == number_of(last.numbers, "time")) return;
  deck.refuse_value(
      place_of_run(),
      "has not finished (the state of its last checkpoint is not that of its end); end it first "
      "with barreno resume " +
          shell_word(run)
  );
}

/// The deck of a run, as its folder has it.
Deck deck_of_run(const std::string& run, const Comm& comm) {
  return read_deck((fs::path(run) / "deck.xml").string(), {}, comm);
}

void refuse_other_deck(
    const Deck& deck, const std::string& run, const Deck& deck_of_run, const Checkpoint& checkpoint
) {
  const std::string other = deck_difference(checkpoint.deck_text, effective_deck_xml(deck_of_run));
  if (other.empty()) return;
  throw DeckError(
      deck.name() + ": " + place_of_run() + " = " + input::shown(run) +
      " has a deck.xml that differs from the deck in its checkpoint (" + other +
      "); put that deck back."
  );
}

/// What a deck that continues a run cannot have.
void refuse_features(const Deck& deck, const Scene& scene, bool at_rest) {
  const std::string why = " a deck that continues a run (";
  if (scene.jet.present)
    deck.refuse(
        table_of<JetSpec>().path,
        "has no place in" + why +
            "the bodies are there, and a jet would be launched into them anew); remove the list, "
            "or --set \"Jet=\""
    );
  if (is_manufactured(scene.body_force))
    deck.refuse_value(
        path_of(&BodyForceSpec::kind),
        "has no meaning in" + why + "it belongs to bodies as they were made); remove it"
    );
  for (const PressureLoadSpec& load : scene.loads)
    if (traits_of(load.kind).fills_hollow)
      deck.refuse(
          table_of<PressureLoadSpec>().path,
          "has a pore fluid, which has no meaning in" + why +
              "how much of it is in the hollow is not known); remove it"
      );
  const std::string velocities = path_of(&ContinueSpec::velocities);
  const std::string remedy = "; write \"at rest\", or barreno continue --at-rest";
  if (at_rest) return;
  if (scene.quasi_static.on())
    deck.refuse_value(
        velocities, "cannot be combined with Quasi-Static (which scales inertia)" + remedy
    );
  if (scene.step.transfer == Transfer::apic)
    deck.refuse_value(
        velocities,
        "cannot be combined with Transfer = APIC (whose particles remember the other grid)" + remedy
    );
}

std::vector<std::string> names_of_bodies(const Scene& scene) {
  std::vector<std::string> names;
  for (const BodySpec& body : scene.bodies) names.push_back(body.name);
  return names;
}

/// Index of the run's body of that name.
std::size_t body_of_run(const Deck& deck, const Scene& run, const std::string& name) {
  const std::vector<std::string> names = names_of_bodies(run);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  std::string all;
  for (const std::string& each : names) all += (all.empty() ? "" : ", ") + each;
  deck.refuse(
      list_of<BodySpec>(name),
      "is no body of the run that the deck continues (its bodies are " + all +
          "); remove it, or give it the name that it has there"
  );
}

/// The words of a shape, with those of the shapes that it is combined from.
std::string shape_text(const Deck& deck, const std::string& list) {
  std::vector<std::string> names;
  for (const input::Entry& entry : shape_entries()) names.push_back(entry.name);
  std::string text = list_text(deck, list, names);
  const std::string parts = input::join(list, name_of(&ShapeSection::parts));
  if (!deck.has(parts)) return text;
  for (const std::string& part : deck.words(parts))
    text += shape_text(deck, list_of<ShapeSection>(part));
  return text;
}

void refuse_other_shape(const Deck& deck, const Deck& run, const std::string& name) {
  const std::string list = list_of<BodySpec>(name);
  if (shape_text(deck, list) == shape_text(run, list)) return;
  deck.refuse(
      list,
      "has another shape than in the run that the deck continues (where loads act is known by the "
      "shape that the body was made with); copy its shape from the run's deck.xml"
  );
}

/// Names of a material's internal variables.
std::string history_text(const MaterialSpec& material) {
  std::string text;
  for (const HistoryField& field : material.history_table())
    text += (text.empty() ? "" : ", ") + std::string(field.name);
  return text.empty() ? "none" : text;
}

void refuse_other_model(
    const Deck& deck, const BodySpec& body, const MaterialSpec& now, const MaterialSpec& before
) {
  const std::string path = path_of(&BodySpec::material, body.name);
  if (now.model_name() != before.model_name())
    deck.refuse_value(
        path,
        "has the model " + now.model_name() + ", but the body of the run has " +
            before.model_name() +
            " (its internal variables would mean nothing); take a card of that model"
    );
  if (history_text(now) != history_text(before))
    deck.refuse_value(
        path,
        "has other internal variables than in the run (" + history_text(now) + " against " +
            history_text(before) + "); take the options of the run's card"
    );
}

/// Bodies of the deck by body of the run. @throws DeckError  where they do not fit
Succession succession_of(
    const Deck& deck, const Scene& scene, const Deck& deck_of_run, const Scene& run
) {
  if (run.grid.mode != scene.grid.mode)
    deck.refuse_value(
        path_of(&GridSpec::mode),
        std::string("is not the mode of the run that the deck continues (") +
            word_of(run.grid.mode) + "); write that one"
    );
  Succession succession;
  succession.body_of.assign(run.bodies.size() + 1, -1);
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    const BodySpec& body = scene.bodies[b];
    const std::size_t before = body_of_run(deck, run, body.name);
    refuse_other_shape(deck, deck_of_run, body.name);
    const MaterialSpec& old = run.materials[static_cast<std::size_t>(run.bodies[before].material)];
    const MaterialSpec& now = scene.materials[static_cast<std::size_t>(body.material)];
    refuse_other_model(deck, body, now, old);
    succession.body_of[before] = static_cast<int>(b);
    succession.same_material.push_back(
        list_text(deck, list_of<MaterialSection>(now.name())) ==
        list_text(deck_of_run, list_of<MaterialSection>(old.name()))
    );
  }
  return succession;
}

/// The scene in which the particles were made: where a run continues another one, that of the
/// first.
Origin find_origin(
    const Deck& deck, const Deck& deck_of_last, const Teuchos::RCP<const Comm>& comm
) {
  Deck made = deck_of_last;
  std::set<std::string> seen;
  for (auto said = read_section<ContinueSpec>(made); said.on();
       said = read_section<ContinueSpec>(made)) {
    if (!seen.insert(said.run).second)
      deck.refuse_value(
          place_of_run(), "continues a run that continues itself; name the folder of another run"
      );
    made = deck_of_run(said.run, *comm);
  }
  Origin origin{build_scene(made), {}};
  origin.census = take_census(origin.scene, comm);
  return origin;
}

/// What the run itself took over from another one; not on() if it continues none.
Continued continued_before(const Stage& stage) {
  return stage.checkpoint.continued.empty() ? Continued{}
                                            : read_continued(stage.run, stage.checkpoint);
}

/// Ids of the run's particles, by body, its jet last.
std::vector<IdRange> ids_of_run(
    const Stage& stage, const Continued& before, const BodyCensus& census
) {
  if (!before.on()) return particle_id_ranges(stage.run, census.first);
  std::vector<IdRange> ids;
  for (const BodySpec& body : stage.run.bodies) {
    std::size_t place = 0;  // among the bodies that the run took over
    for (const ContinuedBody& taken : before.bodies) {
      if (!taken.in_deck) continue;
      if (taken.name == input::on_one_line(body.name)) break;
      ++place;
    }
    ids.push_back(before.ids.at(place));  // read_continued has found all bodies
  }
  return ids;
}

/// A particle wider than a cell of a finer grid than it was made for would miss nodes.
void refuse_wide_particles(
    const Stage& stage, const State& ended, const Deck& deck, const Scene& scene
) {
  const double cell = scene.grid.cell_size;
  if (cell >= stage.run.grid.cell_size) return;
  std::vector<double> widest(stage.run.bodies.size() + 1, 0.0);
  for (const Particles& particles : ended.particles)
    for (int p = 0; p < particles.count; ++p) {
      double& mine = widest[static_cast<std::size_t>(particles.body(p) & ~debris_bit)];
      for (int d = 0; d < particles.half_size.components; ++d)
        mine = std::max(mine, 2.0 * particles.half_size(p, d));
    }
  max_over_ranks(*ended.grid.comm, widest);
  constexpr double round_off = 1e-9;
  for (std::size_t b = 0; b < stage.run.bodies.size(); ++b)
    if (stage.succession.body_of[b] >= 0 && widest[b] > (1.0 + round_off) * cell)
      deck.refuse_value(
          path_of(&GridSpec::cell_size),
          "is smaller than the particles of Bodies/" + stage.run.bodies[b].name +
              " that the run left, which are up to " + to_text(widest[b]) +
              " m wide; take cells of that size or larger"
      );
}

void refuse_empty_bodies(const Deck& deck, const Continued& continued) {
  for (const ContinuedBody& body : continued.bodies)
    if (body.in_deck && body.taken.particles == 0.0)
      deck.refuse(
          list_of<BodySpec>(body.name),
          "gets no particle (none that the run left is inside the grid); remove it or enlarge Grid"
      );
}

/// Radii of hollow balls start with those of the undeformed bodies. Collective.
std::vector<double> start_of_taken_radii(
    const Origin& origin, const Scene& scene, const Teuchos::RCP<const Comm>& comm
) {
  std::vector<double> start;
  if (hollow_balls(scene).empty()) return start;
  const std::vector<double> made =
      start_of_radii(origin.scene, build_state(origin.scene, origin.census, comm));
  const std::vector<int> balls = hollow_balls(origin.scene);
  for (const int body : hollow_balls(scene))
    for (std::size_t i = 0; i < balls.size(); ++i)
      if (origin.scene.bodies[static_cast<std::size_t>(balls[i])].name ==
          scene.bodies[static_cast<std::size_t>(body)].name)
        start.insert(start.end(), {made[2 * i], made[2 * i + 1]});
  return start;
}

}  // namespace

std::optional<Stage> find_stage(
    const Deck& deck, const Scene& scene, const Teuchos::RCP<const Comm>& comm
) {
  const auto said = read_section<ContinueSpec>(deck);
  if (!said.on()) return {};
  const bool at_rest = said.velocities == TakenVelocities::at_rest;
  refuse_features(deck, scene, at_rest);
  const std::string summary = summary_of(deck, said.run, *comm);
  Checkpoint checkpoint = find_checkpoint(*comm, said.run);
  refuse_unfinished(deck, said.run, summary, checkpoint);
  const Deck before = deck_of_run(said.run, *comm);
  refuse_other_deck(deck, said.run, before, checkpoint);
  Scene run = build_scene(before);
  Succession succession = succession_of(deck, scene, before, run);
  succession.at_rest = at_rest;
  return Stage{said, checkpoint, run, succession, find_origin(deck, before, comm)};
}

std::string stage_note(const Stage& stage) {
  return "the bodies start with the particles that " + stage.said.run +
         " left at t = " + to_text(number_of(stage.checkpoint.numbers, "time")) +
         " s; particles and cost are predicted for bodies that the deck fills itself";
}

Continued start_from_run(const Stage& stage, const Deck& deck, const Scene& scene, State& state) {
  const Teuchos::RCP<const Comm> comm = state.grid.comm;
  const BodyCensus census = take_census(stage.run, comm);
  const std::vector<IdRange> ids = ids_of_run(stage, continued_before(stage), census);
  State ended = build_empty_state(stage.run, census, comm);
  check_checkpoint(stage.run, ended, stage.checkpoint);
  read_checkpoint(stage.run, ids, stage.checkpoint, ended);
  refuse_wide_particles(stage, ended, deck, scene);
  Continued continued = take_over(stage.run, ended, ids, stage.succession, scene, state);
  refuse_empty_bodies(deck, continued);
  put_loads_on_taken(stage.origin, scene, state);
  continued.radii_start = start_of_taken_radii(stage.origin, scene, comm);
  return continued;
}

std::vector<IdRange> ids_in_order(const Continued& continued) {
  std::vector<IdRange> ids = continued.ids;
  std::sort(ids.begin(), ids.end(), [](const IdRange& a, const IdRange& b) {
    return a.first < b.first;
  });
  return ids;
}

}  // namespace barreno
