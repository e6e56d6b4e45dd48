// SPDX-License-Identifier: BSD-3-Clause
#include "support/scenes.hpp"

#include "base/gather.hpp"
#include "step/stable_step.hpp"

#include <Teuchos_DefaultMpiComm.hpp>
#include <Tpetra_Core.hpp>

#include <algorithm>
#include <barreno/models.hpp>
#include <chrono>
#include <exception>
#include <limits>
#include <map>
#include <thread>

namespace barreno::testing {

MaterialSpec copper(double strength) {
  JohnsonCook::Parameters p;
  p.shear_modulus = 47.7e9;
  p.a = 90e6 * strength;
  p.b = 292e6 * strength;
  p.c = 0.025;
  p.n = 0.31;
  p.m = 1.09;
  p.melt_temperature = 1356.0;
  p.specific_heat = 383.0;
  p.sound_speed = 3940.0;
  p.slope = 1.489;
  p.gamma = 2.02;
  return Material{"copper", 8930.0, JohnsonCook(p, 8930.0)};
}

MaterialSpec elastic(double young, double poisson, double density) {
  const double bulk = young / (3.0 * (1.0 - 2.0 * poisson));
  const double shear = young / (2.0 * (1.0 + poisson));
  return Material{"elastic", density, LinearElastic({bulk, shear}, density)};
}

Scene box_scene(Mode mode, double h, Vector lower, Vector upper, const MaterialSpec& material) {
  Scene scene;
  scene.grid = {mode, lower, upper, h, {}};
  scene.materials.push_back(material);
  scene.materials[0].bad_particles = BadParticlePolicy::stop;
  return scene;
}

BodySpec& add_box(
    Scene& scene, const std::string& name, Vector lower, Vector upper, int particles_per_cell
) {
  BodySpec body;
  body.name = name;
  body.shape = Box{lower, upper};
  body.particles_per_cell = particles_per_cell;
  scene.bodies.push_back(body);
  return scene.bodies.back();
}

void add_symmetry(Scene& scene, Face face) {
  scene.conditions.push_back({"symmetry", face, ConditionKind::symmetry, {}});
}

namespace {

State start_on(const Scene& scene, const Teuchos::RCP<const Comm>& comm) {
  State state = build_state(scene, comm);
  for (const Particles& particles : state.particles)
    state.stable_step =
        std::min(state.stable_step, stable_step_of_rows(scene.step, state.grid, particles, 0));
  return state;
}

}  // namespace

State start(const Scene& scene) {
  return start_on(scene, Tpetra::getDefaultComm());
}

State start_alone(const Scene& scene) {
  return start_on(scene, Teuchos::rcp(new Teuchos::MpiComm<int>(MPI_COMM_SELF)));
}

bool is_alone() {
  return Tpetra::getDefaultComm()->getSize() == 1;
}

void on_root(const std::function<void()>& check) {
  std::exception_ptr thrown;
  if (is_root(*Tpetra::getDefaultComm())) {
    try {
      check();
    } catch (...) {
      thrown = std::current_exception();
    }
  }
  MPI_Request arrived{};
  MPI_Ibarrier(MPI_COMM_WORLD, &arrived);
  for (int all = 0; all == 0; MPI_Test(&arrived, &all, MPI_STATUS_IGNORE))
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  if (thrown) std::rethrow_exception(thrown);
}

void advance_to(const Scene& scene, double time, State& state, long steps) {
  for (long i = 0; i < steps && state.clock.time < time; ++i) {
    const StepResult result = advance(scene, time, state);
    if (result.stopped) return;
  }
}

namespace {

/// Determinant of F; `f` in the order of the field.
double determinant_of(const Field& f, int i) {
  if (f.components == 9)
    return f(i, 0) * (f(i, 4) * f(i, 8) - f(i, 5) * f(i, 7)) -
           f(i, 1) * (f(i, 3) * f(i, 8) - f(i, 5) * f(i, 6)) +
           f(i, 2) * (f(i, 3) * f(i, 7) - f(i, 4) * f(i, 6));
  const double hoop = f.components == 5 ? f(i, 4) : 1.0;
  return (f(i, 0) * f(i, 3) - f(i, 1) * f(i, 2)) * hoop;
}

}  // namespace

std::vector<std::vector<double>> all_rows(const State& state) {
  const Comm& comm = *state.grid.comm;
  std::vector<double> mine;
  std::size_t width = 10;
  for (const Particles& p : state.particles) {
    if (p.position.components == 3) width = 14;
    for (int i = 0; i < p.count; ++i) {
      for (const double value :
           {static_cast<double>(p.id(static_cast<std::size_t>(i))),
            p.position(i, 0),
            p.position(i, 1),
            p.velocity(i, 0),
            p.velocity(i, 1),
            p.stress(i, 0),
            p.stress(i, 1),
            p.stress(i, 2),
            p.stress(i, 3),
            determinant_of(p.deformation_gradient, i)})
        mine.push_back(value);
      if (p.position.components == 2) continue;
      for (const double value :
           {p.position(i, 2), p.velocity(i, 2), p.stress(i, 4), p.stress(i, 5)})
        mine.push_back(value);
    }
  }
  std::vector<double> size{static_cast<double>(mine.size())};
  sum_over_ranks(comm, size);
  const std::vector<double> root = gather_to_root(comm, mine);
  std::vector<double> all(static_cast<std::size_t>(size[0]), 0.0);
  std::copy(root.begin(), root.end(), all.begin());
  sum_over_ranks(comm, all);  // only the root holds values
  std::map<long long, std::vector<double>> rows;
  for (std::size_t i = 0; i < all.size(); i += width)
    rows[static_cast<long long>(all[i])].assign(
        all.begin() + static_cast<long>(i) + 1, all.begin() + static_cast<long>(i + width)
    );
  std::vector<std::vector<double>> sorted;
  sorted.reserve(rows.size());
  for (auto& row : rows) sorted.push_back(row.second);
  return sorted;
}

}  // namespace barreno::testing
