// SPDX-License-Identifier: BSD-3-Clause
// Every checkpoint that a run with a jet writes is one that it resumes from: steps of several
// lengths, cells of several sizes, each kind of jet.
#include "checkpoint/check_values.hpp"
#include "checkpoint/find_checkpoint.hpp"
#include "checkpoint/read_checkpoint.hpp"
#include "checkpoint/write_checkpoint.hpp"
#include "scene/jet.hpp"
#include "state/build_state.hpp"
#include "state/last_tile_steps.hpp"
#include "support/scenes.hpp"
#include "unit/output/synthetic_run.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

/// A jet of ten slugs into a block of copper whose cells near the axis are half as large.
Scene jet_scene(JetKind kind, bool refined) {
  Scene scene = testing::box_scene(
      Mode::axisymmetric, 1e-3, {0.0, 0.0, 0.0}, {0.016, 0.032, 0.0}, testing::copper()
  );
  testing::add_box(scene, "block", {0.0, 0.016, 0.0}, {0.016, 0.032, 0.0}, 2);
  scene.jet.present = true;
  scene.jet.kind = kind;
  scene.jet.material = 0;
  scene.jet.launch_position = 0.008;
  scene.jet.direction = 1.0;
  scene.jet.particles_per_cell = 2;
  for (int n = 0; n < 10; ++n)
    scene.jet.slugs.push_back({3.1e-7 * n, 4000.0 - 100.0 * n, 1e-3, 1e-3, 8930.0});
  if (refined) {
    scene.grid.level_of_tile.assign(static_cast<std::size_t>(2 * 4), static_cast<unsigned char>(0));
    for (std::size_t y = 0; y < 4; ++y) scene.grid.level_of_tile[2 * y] = 1;
  }
  scene.step.subcycles = 8;
  scene.end_time = 4e-6;
  return scene;
}

class LaunchChecks : public ::testing::TestWithParam<std::tuple<JetKind, bool>> {};

TEST_P(LaunchChecks, NeverRefuseWhatTheProgramWrote) {
  const Scene scene = jet_scene(std::get<0>(GetParam()), std::get<1>(GetParam()));
  State state = testing::start(scene);
  const Comm& comm = *state.grid.comm;
  const synthetic::TemporaryFolder folder{comm};
  RunNumbers output{{"seconds", {0.0}}};
  int divided = 0;
  while (state.clock.time < scene.end_time) {
    testing::advance_to(scene, scene.end_time, state, 1);
    divided += state.subcycling.parts > 1 ? 1 : 0;
    write_checkpoint(folder.path(), "deck", output, state);
    comm.barrier();
    const Checkpoint found = find_checkpoint(comm, folder.path());
    std::string fault;
    if (comm.getRank() == 0) fault = fault_of_run_numbers(scene, state, found);
    EXPECT_EQ(fault, "") << "step " << state.clock.step;
    const BodyCensus census = take_census(scene, state.grid.comm);
    State other = build_empty_state(scene, census, state.grid.comm);
    read_checkpoint(scene, particle_id_ranges(scene, census.first), found, other);
    EXPECT_EQ(last_tile_steps(other), last_tile_steps(state));
    comm.barrier();
  }
  // Else this would say nothing of steps with parts; and nothing is left for a step of its own.
  EXPECT_GT(divided, 5);
  EXPECT_EQ(state.clock.time, scene.end_time);
  EXPECT_EQ(state.jet.next_slug, 10U);
}

// A tile that its last particle has left stays active until tiles are numbered anew, but not in a
// resumed run: the steps that are kept must not tell.
TEST_P(LaunchChecks, StepsOfTilesAreThoseOfAResumedRun) {
  const Scene scene = jet_scene(std::get<0>(GetParam()), std::get<1>(GetParam()));
  State state = testing::start(scene);
  const Comm& comm = *state.grid.comm;
  const synthetic::TemporaryFolder folder{comm};
  testing::advance_to(scene, scene.end_time, state, 1);
  int compared = 0;
  while (state.clock.time < scene.end_time) {
    testing::advance_to(scene, scene.end_time, state, 1);
    write_checkpoint(folder.path(), "deck", {{"seconds", {0.0}}}, state);
    comm.barrier();
    const Checkpoint found = find_checkpoint(comm, folder.path());
    const BodyCensus census = take_census(scene, state.grid.comm);
    State resumed = build_empty_state(scene, census, state.grid.comm);
    read_checkpoint(scene, particle_id_ranges(scene, census.first), found, resumed);
    testing::advance_to(scene, scene.end_time, resumed, 1);
    testing::advance_to(scene, scene.end_time, state, 1);
    ASSERT_EQ(resumed.clock.time, state.clock.time);
    EXPECT_EQ(last_tile_steps(resumed), last_tile_steps(state)) << "step " << state.clock.step;
    ++compared;
    comm.barrier();
  }
  EXPECT_GT(compared, 5);  // else nothing was compared
}

INSTANTIATE_TEST_SUITE_P(
    Jets,
    LaunchChecks,
    ::testing::Combine(
        ::testing::Values(JetKind::discrete, JetKind::thinned, JetKind::continuous),
        ::testing::Bool()
    )
);

}  // namespace
}  // namespace barreno
