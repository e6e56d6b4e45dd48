// SPDX-License-Identifier: BSD-3-Clause
// Particles turned inside out, of no finite motion, expanded too far or gone from the grid: the
// policy of their material acts, the cause is tallied, and the others go on.
#include "base/gather.hpp"
#include "output/history_writer.hpp"
#include "run.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace barreno {
namespace {

constexpr ParticleId bad = 7;
constexpr long steps = 5;

/// A block at rest in CPDI, 5 ranks of cells away from the grid's faces.
Scene block(Mode mode, BadParticlePolicy policy) {
  const double depth = dimensions(mode) == 3 ? 0.012 : 0.0;
  Scene scene = testing::box_scene(
      mode, 1e-3, {0.0, 0.0, 0.0}, {0.012, 0.012, depth}, testing::elastic(1e6, 0.2, 1000.0)
  );
  scene.materials.front().bad_particles = policy;
  testing::add_box(
      scene, "block", {0.004, 0.004, depth / 3.0}, {0.008, 0.008, 2.0 * depth / 3.0}, 2
  );
  if (mode == Mode::axisymmetric) testing::add_symmetry(scene, Face::x_lower);
  scene.step.shape = "CPDI";
  return scene;
}

/// Does `change(particles, row)` to the bad particle, on the rank that has it.
template <class F>
void harm(State& state, F&& change) {
  for (Particles& particles : state.particles)
    for (int p = 0; p < particles.count; ++p)
      if (particles.id(p) == bad) change(particles, p);
}
void turn_inside_out(Particles& particles, int p) {
  particles.deformation_gradient(p, 0) = -1.0;
}
void lose_volume(Particles& particles, int p) {
  particles.volume(p) = std::numeric_limits<double>::quiet_NaN();
}
void lose_stress(Particles& particles, int p) {
  particles.stress(p, 1) = std::numeric_limits<double>::quiet_NaN();
}
void lose_place(Particles& particles, int p) {
  particles.position(p, 1) = std::numeric_limits<double>::quiet_NaN();
}
void expand(Particles& particles, int p) {
  particles.volume(p) *= 20.0;
}
void run_away(Particles& particles, int p) {
  particles.position(p, 1) += 1.0;
}

struct Case {
  const char* name;
  RemovalCause cause;
  void (*change)(Particles&, int);
  const char* words;
};
const Case cases[] = {
    {"inverted", RemovalCause::inverted, turn_inside_out, "was inverted or flattened"},
    {"expanded", RemovalCause::expanded, expand, "expanded beyond \"Largest Expansion\""}};

StepResult take_steps(const Scene& scene, State& state) {
  StepResult result;
  for (long i = 0; i < steps && !result.stopped; ++i) result = advance(scene, 1.0, state);
  return result;
}

/// The last row of history.csv by its header.
std::map<std::string, double> history_row(const Scene& scene, const State& state) {
  const Comm& comm = *state.grid.comm;
  const std::filesystem::path path = std::filesystem::temp_directory_path() /
                                     ("bad_particles_" + std::to_string(comm.getSize()) + ".csv");
  HistoryWriter(scene, comm, path).write(comm, state.clock, sum_totals(state));
  comm.barrier();
  std::ifstream file(path);
  std::string comment, header, row, name, value;
  std::getline(file, comment);
  std::getline(file, header);
  std::getline(file, row);
  std::istringstream names(header), values(row);
  std::map<std::string, double> out;
  while (std::getline(names, name, ',') && std::getline(values, value, ','))
    out[name] = std::stod(value);
  comm.barrier();
  if (is_root(comm)) std::filesystem::remove(path);
  return out;
}

class BadParticles : public ::testing::TestWithParam<Mode> {};

TEST_P(BadParticles, AreRemovedAndTalliedByTheirCause) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Scene scene = block(GetParam(), BadParticlePolicy::remove);
    State state = testing::start(scene);
    const double before = sum_totals(state).particles;
    harm(state, c.change);
    EXPECT_FALSE(take_steps(scene, state).stopped);
    EXPECT_EQ(state.clock.step, steps);
    const std::map<std::string, double> row = history_row(scene, state);
    for (int cause = 0; cause < removal_causes; ++cause)
      EXPECT_EQ(
          row.at(std::string("removed_") + removal_names[static_cast<std::size_t>(cause)]),
          cause == static_cast<int>(c.cause) ? 1.0 : 0.0
      );
    EXPECT_EQ(row.at("particles"), before - 1.0);
    EXPECT_LT(std::abs(row.at("mass_error")), 1e-14);
  }
}

/// A step goes on with a particle that it has found bad: its tile stays known, in every order of
/// the step, under a load on its faces and in tiles that may be at rest.
TEST_P(BadParticles, StayInTheirTileUntilTheyAreRemoved) {
  for (const Case& c : cases)
    for (const Order order :
         {Order::stress_last, Order::modified_stress_last, Order::stress_first}) {
      SCOPED_TRACE(c.name);
      Scene scene = block(GetParam(), BadParticlePolicy::remove);
      scene.step.order = order;
      PressureLoadSpec load;
      load.faces.fill(true);
      load.pressure = {{0.0}, {1e3}};
      scene.loads.push_back(load);
      State state = testing::start(scene);
      advance(scene, 1.0, state);  // the first step strains last, whatever the order
      const double before = sum_totals(state).particles;
      harm(state, c.change);
      advance(scene, 1.0, state);
      double marked = 0.0;
      for (const Particles& particles : state.particles)
        for (int p = 0; p < particles.count; ++p) {
          ASSERT_TRUE(is_placed(particles.key(p)));
          ASSERT_LT(tile_of(state.grid.patch, particles, p), state.grid.active);
          if (particles.fault(p) != Fault::none) marked += 1.0;
        }
      std::vector<double> sum{marked};
      sum_over_ranks(*state.grid.comm, sum);
      EXPECT_EQ(sum[0], 1.0);
      EXPECT_EQ(sum_totals(state).particles, before);
      advance(scene, 1.0, state);
      EXPECT_EQ(sum_totals(state).particles, before - 1.0);
    }
}

TEST_P(BadParticles, AreHeldWithoutStressOnce) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Scene scene = block(GetParam(), BadParticlePolicy::hold);
    State state = testing::start(scene);
    const double before = sum_totals(state).particles;
    harm(state, c.change);
    EXPECT_FALSE(take_steps(scene, state).stopped);
    const std::map<std::string, double> row = history_row(scene, state);
    EXPECT_EQ(row.at("held"), 1.0);
    EXPECT_EQ(row.at("particles"), before);
    harm(state, [](Particles& particles, int p) {
      EXPECT_TRUE(particles.body(p) & debris_bit);
      for (int k = 0; k < particles.stress.components; ++k) EXPECT_EQ(particles.stress(p, k), 0.0);
    });
  }
}

TEST_P(BadParticles, StopTheRunWithASentenceThatNamesTheCause) {
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const Scene scene = block(GetParam(), BadParticlePolicy::stop);
    State state = testing::start(scene);
    harm(state, c.change);
    const StepResult result = take_steps(scene, state);
    EXPECT_TRUE(result.stopped);
    EXPECT_EQ(result.failed, bad);
    EXPECT_EQ(state.clock.step, 1);
    const std::string sentence = failure_sentence(scene, state, result);
    EXPECT_NE(sentence.find("Particle 7 of material 'elastic' "), std::string::npos) << sentence;
    EXPECT_NE(sentence.find(c.words), std::string::npos) << sentence;
  }
}

/// NaN spreads to the neighbours within the step, so the run must not continue.
TEST_P(BadParticles, StopTheRunWhereTheirMotionIsNotFinite) {
  const Scene scene = block(GetParam(), BadParticlePolicy::stop);
  State state = testing::start(scene);
  harm(state, lose_volume);
  const StepResult result = take_steps(scene, state);
  EXPECT_TRUE(result.stopped);
  EXPECT_EQ(state.clock.step, 1);
  const std::string sentence = failure_sentence(scene, state, result);
  EXPECT_NE(sentence.find("velocity that is not a finite number"), std::string::npos) << sentence;
}

/// Its neighbours fail with it, but it is the one to name. The whole run, with its output.
TEST_P(BadParticles, StopTheRunWithinAStepOfAStressThatIsNoNumber) {
  Scene scene = block(GetParam(), BadParticlePolicy::stop);
  scene.end_time = 1.0;
  State state = testing::start(scene);
  const Comm& comm = *state.grid.comm;
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("lost_stress_" + std::to_string(comm.getSize()));
  if (is_root(comm)) std::filesystem::create_directories(folder);
  comm.barrier();
  RunDescription description{folder, "deck.xml", "<ParameterList/>", "test", {}, {}};
  description.ids = particle_id_ranges(scene, first_ids(scene, particle_counts(scene)));
  Output output(scene, state, description);
  Checkpoints checkpoints(scene, description);
  harm(state, lose_stress);
  const RunVerdict verdict = run(scene, state, output, checkpoints);
  EXPECT_FALSE(verdict.finished);
  EXPECT_EQ(verdict.exit_code, 3);
  EXPECT_EQ(state.clock.step, 1);
  EXPECT_NE(
      verdict.reason.find(
          "Particle 7 of material 'elastic' has a stress that is not a finite number at t = "
      ),
      std::string::npos
  ) << verdict.reason;
  comm.barrier();
  if (is_root(comm)) std::filesystem::remove_all(folder);
}

TEST_P(BadParticles, WithoutAPlaceAreRemoved) {
  const Scene scene = block(GetParam(), BadParticlePolicy::hold);
  State state = testing::start(scene);
  const double before = sum_totals(state).particles;
  harm(state, lose_place);
  EXPECT_FALSE(take_steps(scene, state).stopped);
  const std::map<std::string, double> row = history_row(scene, state);
  EXPECT_EQ(row.at("removed_not_finite"), 1.0);
  EXPECT_EQ(row.at("particles"), before - 1.0);
}

TEST_P(BadParticles, AreRemovedWhereTheyLeaveTheGridWhateverThePolicy) {
  for (const BadParticlePolicy policy :
       {BadParticlePolicy::remove, BadParticlePolicy::hold, BadParticlePolicy::stop}) {
    const Scene scene = block(GetParam(), policy);
    State state = testing::start(scene);
    const double before = sum_totals(state).particles;
    harm(state, run_away);
    EXPECT_FALSE(take_steps(scene, state).stopped);
    const std::map<std::string, double> row = history_row(scene, state);
    EXPECT_EQ(row.at("removed_left_grid"), 1.0);
    EXPECT_EQ(row.at("particles"), before - 1.0);
    EXPECT_EQ(row.at("held"), 0.0);
  }
}

INSTANTIATE_TEST_SUITE_P(Modes, BadParticles, ::testing::ValuesIn(testing::all_modes));

}  // namespace
}  // namespace barreno
