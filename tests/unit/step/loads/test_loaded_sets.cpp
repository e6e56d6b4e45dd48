// SPDX-License-Identifier: BSD-3-Clause
#include "step/loads/loaded_sets.hpp"
#include "step/loads/tractions.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace barreno {
namespace {

TEST(LoadTraits, EveryKindOfTheDeckHasItsRow) {
  EXPECT_EQ(load_traits.size(), all_words<LoadKind>().size());
  for (const Word<LoadKind>& word : words_of(LoadKind{}))
    EXPECT_EQ(traits_of(word.value).kind, word.value) << word.word;
}

TEST(LoadTraits, EveryKindActsSomewhere) {
  for (const LoadTraits& traits : load_traits) {
    EXPECT_TRUE(traits.why_no_box == nullptr || traits.why_no_ball == nullptr) << traits.word;
    EXPECT_TRUE(traits.why_no_ball == nullptr || !traits.fills_hollow) << traits.word;
    EXPECT_STRNE(traits.meaning, "") << traits.word;
  }
}

/// How many sets of a state have loads by that field.
int visits(const State& state, const std::vector<Particles>& sets, Field Particles::*needed) {
  int count = 0;
  const Tractions tractions{state.grid, state.loads, sets, state.nodes, state.subcycling};
  for_each_loaded_set(tractions, needed, [&](const auto& set) {
    EXPECT_EQ(set.particles.count, sets[0].count);
    ++count;
  });
  return count;
}

TEST(LoadedSets, AreTheDeformableOnesThatHaveTheField) {
  Scene scene =
      testing::box_scene(Mode::plane_strain, 0.1, {0, 0, 0}, {1, 1, 0}, testing::copper());
  testing::add_box(scene, "block", {0, 0, 0}, {0.5, 0.5, 0}, 2);
  const State state = testing::start(scene);
  std::vector<Particles> sets{state.particles[0]};
  EXPECT_EQ(visits(state, sets, &Particles::loaded_faces), 0);
  sets[0].loaded_faces.components = 1;
  EXPECT_EQ(visits(state, sets, &Particles::loaded_faces), 1);
  EXPECT_EQ(visits(state, sets, &Particles::surface_share), 0);
  sets[0].rigid = true;
  EXPECT_EQ(visits(state, sets, &Particles::loaded_faces), 0);
}

}  // namespace
}  // namespace barreno
