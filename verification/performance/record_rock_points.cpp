// SPDX-License-Identifier: BSD-3-Clause
// States and strain increments that sandstone meets in a run, as a table:
//
//   barreno_record_rock_points DECK FILE [--flowing N] [--elastic N] [--hardest N] [--set
//   SETTING]...
//
// runs the deck on one rank, with settings of its own as `barreno run --set` has them, and writes a
// uniform random sample of its point updates, in random order: those that flow plastically (4096)
// and those that do not (1024); and of all that flow those that need the most substeps (64).
#include "base/error.hpp"
#include "deck/files/read_deck.hpp"
#include "scene/build_scene.hpp"
#include "support/scenes.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>

#include <barreno/history_values.hpp>
#include <barreno/models.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

namespace barreno {
namespace {

/// xx yy zz xy of the unrotated stress: the recorder is for runs in the plane.
constexpr int components = 4;

/// A point before its update: stress, then history by the model's own count.
struct PointRow {
  std::vector<double> values;
};

/// Rows kept by the smallest of their keys: uniform over all that were offered if those are random,
/// however many come.
class Sample {
public:
  explicit Sample(std::size_t size) : size_(size) {}
  bool wants(std::uint64_t key) const {
    return size_ > 0 && (rows_.size() < size_ || key < rows_.rbegin()->first);
  }
  void put(std::uint64_t key, const std::string& row) {
    rows_[key] = row;
    if (rows_.size() > size_) rows_.erase(std::prev(rows_.end()));
  }
  const std::map<std::uint64_t, std::string>& rows() const { return rows_; }

private:
  std::size_t size_;
  std::map<std::uint64_t, std::string> rows_;
};
struct Samples {
  Sample flowing{4096}, elastic{1024}, hardest{64};
};

/// A number for each particle and step that looks random (the mixing steps of splitmix64).
std::uint64_t random_key(std::uint64_t id, std::uint64_t step) {
  std::uint64_t z = id * 0x9e3779b97f4a7c15ULL + step * 0xd1b54a32d192ed03ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

bool is_arenisca(const AnyModel& any) {
  return std::visit([](const auto& m) { return std::string(m.name) == Arenisca::name; }, any);
}

/// The one Arenisca of a scene, whatever its form.
int find_rock(const Scene& scene) {
  int rock = -1;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    if (!is_arenisca(scene.materials[m].material().model)) continue;
    if (rock >= 0)
      throw std::runtime_error(
          "the deck has two materials of Arenisca, and a table is for one; take one away."
      );
    rock = static_cast<int>(m);
  }
  if (rock < 0)
    throw std::runtime_error(
        "the deck has no material of Arenisca; give one whose rock can be recorded."
    );
  if (scene.grid.mode == Mode::three_dimensional)
    throw std::runtime_error(
        "the deck is in three dimensions; give one in the plane or with an axis of symmetry."
    );
  return rock;
}

PointRow row_of(const Particles& p, int i, int history_count) {
  PointRow row;
  for (int c = 0; c < components; ++c) row.values.push_back(p.stress(i, c));
  for (int c = 0; c < history_count; ++c) row.values.push_back(p.history(i, c));
  return row;
}

std::string text_of(const PointRow& before, const Particles& p, int i, double dt) {
  std::string text;
  const auto append = [&text](double value) {
    char number[32];
    std::snprintf(number, sizeof number, "%s%.9g", text.empty() ? "" : ",", value);
    text += number;
  };
  for (const double value : before.values) append(value);
  for (int c = 0; c < components; ++c) append(p.increment(i, c));
  append(dt);
  return text;
}

/// Substeps of the update that a point has just made.
template <class Model>
int substeps_of(
    const Model& model, const PointRow& before, const Particles& p, int row, double dt
) {
  const std::vector<double>& v = before.values;
  Sym3 stress = {v[0], v[1], v[2], v[3], 0.0, 0.0};
  typename Model::History history{};
  for (int c = 0; c < Model::history_count; ++c)
    history_values<Model>(history)[c] =
        v[static_cast<std::size_t>(components) + static_cast<std::size_t>(c)];
  Increment increment;
  increment.strain = {
      p.increment(row, 0), p.increment(row, 1), p.increment(row, 2), p.increment(row, 3), 0.0, 0.0};
  increment.dt = dt;
  return model.update(increment, stress, history).substeps;
}

/// Offers every point of rock that was updated in the last step.
void offer(
    const AnyModel& model,
    const State& state,
    const Particles& rock,
    const std::unordered_map<ParticleId, PointRow>& before,
    Samples& samples
) {
  constexpr std::uint64_t most_substeps = 0xffff;
  for (int i = 0; i < rock.count; ++i) {
    const ParticleId id = rock.id(static_cast<std::size_t>(i));
    const auto found = before.find(id);
    const bool held = (rock.body(static_cast<std::size_t>(i)) & debris_bit) != 0;
    if (found == before.end() || held || !is_placed(rock.key(static_cast<std::size_t>(i))))
      continue;
    const PointRow& row = found->second;
    const bool flows = rock.history(i, 1) > row.values[components + 1] ||
                       rock.history(i, 0) != row.values[components];
    const double dt = state.clock.dt;
    Sample& sample = flows ? samples.flowing : samples.elastic;
    const std::uint64_t key =
        random_key(static_cast<std::uint64_t>(id), static_cast<std::uint64_t>(state.clock.step));
    if (sample.wants(key)) sample.put(key, text_of(row, rock, i, dt));
    if (!flows) continue;
    const int substeps =
        std::visit([&](const auto& m) { return substeps_of(m, row, rock, i, dt); }, model);
    const std::uint64_t fewer = most_substeps - static_cast<std::uint64_t>(substeps);
    const std::uint64_t order = (fewer << 48) | (key >> 16);
    if (samples.hardest.wants(order)) samples.hardest.put(order, text_of(row, rock, i, dt));
  }
}

void record(const Scene& scene, Samples& samples) {
  const int material = find_rock(scene);
  const AnyModel& model = scene.materials[static_cast<std::size_t>(material)].material().model;
  const int history_count = std::visit([](const auto& m) { return m.history_count; }, model);
  State state = testing::start(scene);
  std::unordered_map<ParticleId, PointRow> before;
  while (state.clock.time < scene.end_time) {
    before.clear();
    for (const Particles& particles : state.particles)
      for (int i = 0; particles.material == material && i < particles.count; ++i)
        before[particles.id(static_cast<std::size_t>(i))] = row_of(particles, i, history_count);
    if (advance(scene, scene.end_time, state).stopped) return;
    for (const Particles& particles : state.particles)
      if (particles.material == material) offer(model, state, particles, before, samples);
  }
}

struct Options {
  std::string deck, file;
  std::vector<std::string> settings;
  Samples samples;
};

std::string command_of(const Options& options) {
  const Samples& s = options.samples;
  std::string text = "barreno_record_rock_points " + options.deck + " " + options.file +
                     " --flowing " + std::to_string(s.flowing.rows().size()) + " --elastic " +
                     std::to_string(s.elastic.rows().size());
  for (const std::string& setting : options.settings) text += " --set \"" + setting + "\"";
  return text;
}

bool write(const Options& options, const Scene& scene) {
  std::FILE* out = std::fopen(options.file.c_str(), "w");
  if (out == nullptr) return false;
  const AnyModel& model =
      scene.materials[static_cast<std::size_t>(find_rock(scene))].material().model;
  std::fprintf(out, "# Point updates of rock, sampled by %s\n", command_of(options).c_str());
  std::fprintf(
      out, "# unrotated stress [Pa], history before the update, strain increment, time step [s]\n"
  );
  std::fprintf(out, "kind,sxx,syy,szz,sxy");
  for (const HistoryField& field :
       std::visit([](const auto& m) { return m.history_table(); }, model))
    std::fprintf(out, ",%s", field.name);
  std::fprintf(out, ",dexx,deyy,dezz,dexy,dt\n");
  const auto put = [out](const char* kind, const Sample& sample) {
    for (const auto& row : sample.rows()) std::fprintf(out, "%s,%s\n", kind, row.second.c_str());
  };
  put("flows", options.samples.flowing);
  put("elastic", options.samples.elastic);
  put("hardest", options.samples.hardest);
  return std::fclose(out) == 0;
}

std::size_t count_of(const std::string& word, const char* text) {
  char* end = nullptr;
  const long count = std::strtol(text, &end, 10);
  if (end == text || *end != '\0' || count < 0)
    throw std::runtime_error(
        word + " is '" + text + "'; give the number of points to keep, 0 or more."
    );
  return static_cast<std::size_t>(count);
}

Options options_of(int argc, char** argv) {
  const std::string use =
      "barreno_record_rock_points needs a deck and the file to write, then --flowing, --elastic, "
      "--hardest with numbers of points and --set with settings.";
  if (argc < 3) throw std::runtime_error(use);
  Options options;
  options.deck = argv[1];
  options.file = argv[2];
  for (int i = 3; i < argc; i += 2) {
    const std::string word = argv[i];
    if (i + 1 == argc)
      throw std::runtime_error(std::string("nothing follows ").append(word).append("; ") + use);
    if (word == "--set")
      options.settings.emplace_back(argv[i + 1]);
    else if (word == "--flowing")
      options.samples.flowing = Sample(count_of(word, argv[i + 1]));
    else if (word == "--elastic")
      options.samples.elastic = Sample(count_of(word, argv[i + 1]));
    else if (word == "--hardest")
      options.samples.hardest = Sample(count_of(word, argv[i + 1]));
    else
      throw std::runtime_error(
          std::string("there is no option '").append(word).append("'; ") + use
      );
  }
  return options;
}

int run(int argc, char** argv) {
  Options options = options_of(argc, argv);
  const Scene scene =
      build_scene(read_deck(options.deck, options.settings, *Tpetra::getDefaultComm()));
  record(scene, options.samples);
  if (!write(options, scene)) {
    std::cerr << "cannot write '" << options.file << "'; check that its folder exists.\n";
    return 2;
  }
  std::printf(
      "%zu updates that flow, %zu elastic ones and the %zu hardest in %s\n",
      options.samples.flowing.rows().size(),
      options.samples.elastic.rows().size(),
      options.samples.hardest.rows().size(),
      options.file.c_str()
  );
  return 0;
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard guard(&argc, &argv);
  try {
    return barreno::run(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
