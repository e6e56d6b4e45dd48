// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"
#include "state/build_state.hpp"
#include "step/advance.hpp"

#include <functional>
#include <string>
#include <vector>

namespace barreno::testing {

constexpr Mode all_modes[] = {Mode::axisymmetric, Mode::plane_strain, Mode::three_dimensional};

/// Copper with a Mie-Grueneisen pressure; strength off if `strength` is 0.
MaterialSpec copper(double strength = 1.0);

/// Linear elastic with the given Young's modulus and Poisson's ratio.
MaterialSpec elastic(double young, double poisson, double density);

/// Empty grid box [lower, upper] with cells of size h; one material, whose failure stops the run.
Scene box_scene(Mode mode, double h, Vector lower, Vector upper, const MaterialSpec& material);

/// Adds a box body of material 0.
BodySpec& add_box(
    Scene& scene, const std::string& name, Vector lower, Vector upper, int particles_per_cell
);
void add_symmetry(Scene& scene, Face face);

/// State at t = 0 on all ranks, or on this rank alone.
State start(const Scene& scene);
State start_alone(const Scene& scene);

/// Whether the program has one rank only.
bool is_alone();

/// Does `check` on the root, with a run of its own for example; the other ranks sleep meanwhile.
void on_root(const std::function<void()>& check);

/// Steps until `time`, at most `steps` of them.
void advance_to(const Scene& scene, double time, State& state, long steps = 1000000000);

/// All particles of the run sorted by id, on every rank: one row per particle, columns
/// x y vx vy sxx syy szz sxy detF and, in three dimensions, z vz syz szx.
std::vector<std::vector<double>> all_rows(const State& state);

}  // namespace barreno::testing
