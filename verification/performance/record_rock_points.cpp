// SPDX-License-Identifier: BSD-3-Clause
// States and strain increments that sandstone meets in a run, as a table:
//
//   barreno_record_rock_points DECK FILE [FLOWING] [ELASTIC]
//
// runs the deck on one rank and writes a uniform random sample of its point updates, in random
// order: FLOWING (4096) that flow plastically and ELASTIC (1024) that do not.
#include "base/error.hpp"
#include "deck/files/read_deck.hpp"
#include "scene/build_scene.hpp"
#include "support/scenes.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>

#include <array>
#include <barreno/models.hpp>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <map>
#include <string>
#include <unordered_map>
#include <variant>

namespace barreno {
namespace {

/// xx yy zz xy of the stress, and the history: volumetric and equivalent plastic strain.
using PointRow = std::array<double, 6>;

/// Rows kept by the smallest of their random keys: uniform over all that were offered, however many
/// come.
class Sample {
public:
  explicit Sample(std::size_t size) : size_(size) {}
  bool wants(std::uint64_t key) const {
    return rows_.size() < size_ || key < rows_.rbegin()->first;
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

/// A number for each particle and step that looks random (the mixing steps of splitmix64).
std::uint64_t random_key(std::uint64_t id, std::uint64_t step) {
  std::uint64_t z = id * 0x9e3779b97f4a7c15ULL + step * 0xd1b54a32d192ed03ULL;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  return z ^ (z >> 31);
}

bool is_rock(const Scene& scene, const Particles& particles) {
  const auto& spec = scene.materials[static_cast<std::size_t>(particles.material)];
  return std::holds_alternative<Arenisca>(spec.material().model);
}

PointRow row_of(const Particles& p, int i) {
  return {
      p.stress(i, 0),
      p.stress(i, 1),
      p.stress(i, 2),
      p.stress(i, 3),
      p.history(i, 0),
      p.history(i, 1)};
}

std::string text_of(const PointRow& before, const Particles& p, int i) {
  std::string text;
  const auto append = [&text](double value) {
    char number[32];
    std::snprintf(number, sizeof number, "%s%.9g", text.empty() ? "" : ",", value);
    text += number;
  };
  for (const double value : before) append(value);
  for (int c = 0; c < 4; ++c) append(p.increment(i, c));
  return text;
}

/// Offers every point of rock that was updated in the last step.
void offer(
    const State& state,
    const Particles& rock,
    const std::unordered_map<ParticleId, PointRow>& before,
    Sample& flowing,
    Sample& elastic
) {
  for (int i = 0; i < rock.count; ++i) {
    const ParticleId id = rock.id(static_cast<std::size_t>(i));
    const auto found = before.find(id);
    const bool held = (rock.body(static_cast<std::size_t>(i)) & debris_bit) != 0;
    if (found == before.end() || held || !is_placed(rock.key(static_cast<std::size_t>(i))))
      continue;
    const bool flows =
        rock.history(i, 1) > found->second[5] || rock.history(i, 0) != found->second[4];
    Sample& sample = flows ? flowing : elastic;
    const std::uint64_t key =
        random_key(static_cast<std::uint64_t>(id), static_cast<std::uint64_t>(state.clock.step));
    if (sample.wants(key)) sample.put(key, text_of(found->second, rock, i));
  }
}

void record(const Scene& scene, Sample& flowing, Sample& elastic) {
  State state = testing::start(scene);
  std::unordered_map<ParticleId, PointRow> before;
  while (state.clock.time < scene.end_time) {
    before.clear();
    for (const Particles& particles : state.particles)
      for (int i = 0; is_rock(scene, particles) && i < particles.count; ++i)
        before[particles.id(static_cast<std::size_t>(i))] = row_of(particles, i);
    if (advance(scene, scene.end_time, state).stopped) return;
    for (const Particles& particles : state.particles)
      if (is_rock(scene, particles)) offer(state, particles, before, flowing, elastic);
  }
}

bool write(const char* file, const char* deck, const Sample& flowing, const Sample& elastic) {
  std::FILE* out = std::fopen(file, "w");
  if (out == nullptr) return false;
  std::fprintf(out, "# Point updates of rock, sampled by barreno_record_rock_points %s\n", deck);
  std::fprintf(
      out, "# unrotated stress [Pa], plastic strains before the update, strain increment\n"
  );
  std::fprintf(out, "kind,sxx,syy,szz,sxy,evp,eqp,dexx,deyy,dezz,dexy\n");
  for (const auto& row : flowing.rows()) std::fprintf(out, "flows,%s\n", row.second.c_str());
  for (const auto& row : elastic.rows()) std::fprintf(out, "elastic,%s\n", row.second.c_str());
  return std::fclose(out) == 0;
}

}  // namespace
}  // namespace barreno

int main(int argc, char** argv) {
  const Tpetra::ScopeGuard guard(&argc, &argv);
  using namespace barreno;
  if (argc < 3) {
    std::cerr << "barreno_record_rock_points needs a deck and the file to write.\n";
    return 1;
  }
  const auto count = [&](int i, std::size_t otherwise) {
    return argc > i ? static_cast<std::size_t>(std::atol(argv[i])) : otherwise;
  };
  Sample flowing(count(3, 4096)), elastic(count(4, 1024));
  try {
    record(build_scene(read_deck(argv[1], {}, *Tpetra::getDefaultComm())), flowing, elastic);
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
  if (!write(argv[2], argv[1], flowing, elastic)) {
    std::cerr << "cannot write '" << argv[2] << "'; check that its folder exists.\n";
    return 2;
  }
  std::printf(
      "%zu updates that flow and %zu elastic ones in %s\n",
      flowing.rows().size(),
      elastic.rows().size(),
      argv[2]
  );
  return 0;
}
