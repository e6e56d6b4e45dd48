// SPDX-License-Identifier: BSD-3-Clause
// Nodes at which two velocity fields have mass.
#include "unit/step/contact/two_blocks.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

unsigned fields_at(const State& state, int tile, const std::vector<int>& node) {
  const int slot = testing::slot_of(state.grid, tile, node);
  return state.contact.fields(tile * state.grid.patch.size + slot);
}

void detect(State& state) {
  detect_contact_nodes(state.grid, state.fields, state.particles, state.nodes, state.contact);
}

TEST(DetectContactNodes, AreThoseWithMassOfBothFields) {
  State state =
      testing::in_tiles(testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::stick), 1.0);
  for (const std::vector<int>& node : {std::vector<int>{4, 2}, {4, 3}, {3, 3}})
    testing::sums_at(state, 0, 0, node)[0] = 1.0;
  for (const std::vector<int>& node : {std::vector<int>{4, 2}, {4, 3}, {5, 3}})
    testing::sums_at(state, 1, 0, node)[0] = 1e-300;
  detect(state);
  EXPECT_EQ(state.contact.shared_tile(0), 1);
  EXPECT_EQ(fields_at(state, 0, {4, 2}), 3U);
  EXPECT_EQ(fields_at(state, 0, {4, 3}), 3U);
  for (const std::vector<int>& node : {std::vector<int>{3, 3}, {5, 3}, {4, 4}})
    EXPECT_EQ(fields_at(state, 0, node), 0U);
}

TEST(DetectContactNodes, ATileWhoseFieldsDoNotMeetIsNotShared) {
  State state =
      testing::in_tiles(testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::stick), 1.0);
  testing::sums_at(state, 0, 0, {3, 3})[0] = 1.0;
  testing::sums_at(state, 1, 0, {5, 3})[0] = 1.0;
  detect(state);
  EXPECT_EQ(state.contact.shared_tile(0), 0);
}

/// A field that reaches a node of the tile from the tile beside it alone.
TEST(DetectContactNodes, PartsOfNeighbouringTilesCount) {
  Scene scene = testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::stick);
  scene.grid.upper[0] = 16.0;
  scene.bodies[0].shape = Box{{6.0, 2.0, 0.0}, {8.0, 6.0, 0.0}};
  scene.bodies[1].shape = Box{{8.0, 2.0, 0.0}, {10.0, 6.0, 0.0}};
  State state = testing::in_tiles(scene, 1.0);
  ASSERT_EQ(state.grid.active, 2);
  testing::sums_at(state, 0, 0, {8, 3})[0] = 1.0;
  testing::sums_at(state, 1, 1, {8, 3})[0] = 1.0;
  detect(state);
  for (int tile = 0; tile < 2; ++tile) {
    EXPECT_EQ(state.contact.shared_tile(tile), 1);
    EXPECT_EQ(fields_at(state, tile, {8, 3}), 3U);
  }
}

TEST(DetectContactNodes, WithOneFieldThereIsNothingToDo) {
  Scene scene = testing::two_blocks(Mode::plane_strain, 1.0, 0.0, ContactKind::stick);
  scene.contacts.clear();
  State state = testing::in_tiles(scene, 1.0);
  detect(state);
  EXPECT_EQ(state.fields.count, 1);
  EXPECT_EQ(state.contact.shared_tile.extent(0), 0U);
}

}  // namespace
}  // namespace barreno
