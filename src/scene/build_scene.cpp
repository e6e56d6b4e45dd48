// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build_scene.hpp"

#include "base/process.hpp"
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <variant>

namespace barreno {
namespace {

/// Per direction; the grid keeps a directory of tiles.
constexpr int tile_cells(int dimensions) {
  return dimensions == 3 ? 4 : 8;
}
constexpr double bytes_per_tile = 8.0;  ///< owner and local index of every tile of the box
/// State arrays and their share of active tiles.
constexpr double estimated_particle_bytes(int dimensions) {
  return dimensions == 3 ? 500.0 : 250.0;
}

std::string text_of(const char* format, double x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

Mode mode_of(const std::string& word) {
  if (word == "axisymmetric") return Mode::axisymmetric;
  return word == "3D" ? Mode::three_dimensional : Mode::plane_strain;
}

GridSpec read_grid(const Deck& deck) {
  GridSpec grid;
  grid.mode = mode_of(deck.word("Grid/Mode"));
  grid.lower = vector_at(deck, "Grid/Lower", grid.mode);
  grid.upper = vector_at(deck, "Grid/Upper", grid.mode);
  grid.cell_size = deck.number("Grid/Cell Size");
  if (grid.mode == Mode::axisymmetric && grid.lower[0] < 0.0) {
    deck.refuse_value(
        "Grid/Lower", "has a negative radius (the axis is at x = 0); begin at 0 or outside the axis"
    );
  }
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    const std::string axis(1, "xyz"[i]);
    const double cells = (grid.upper[i] - grid.lower[i]) / grid.cell_size;
    if (!(cells > 0.0)) {
      deck.refuse_value(
          "Grid/Upper",
          "is not above Grid/Lower along " + axis + " (the box is empty); exchange the two"
      );
    }
    // Beyond 1e12 the fraction is round-off, and memory refuses such a grid with its own sentence.
    if (cells < 1e12 && std::abs(cells - std::round(cells)) > 1e-6 * std::max(1.0, cells)) {
      deck.refuse_value(
          "Grid/Cell Size",
          "does not divide the box along " + axis + " (" + text_of("%.6g", cells) +
              " cells); change the cell size or the corners of the box"
      );
    }
  }
  return grid;
}

double tiles_of(const GridSpec& grid) {
  double tiles = 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    tiles *= std::ceil(
        (grid.upper[i] - grid.lower[i]) / (grid.cell_size * tile_cells(dimensions(grid.mode)))
    );
  }
  return tiles;
}

BadParticlePolicy policy_of(const std::string& word) {
  if (word == "stop") return BadParticlePolicy::stop;
  return word == "hold" ? BadParticlePolicy::hold : BadParticlePolicy::remove;
}

void add_materials(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists("Materials")) {
    scene.materials.push_back(
        {deck.material(name), policy_of(deck.word("Materials/" + name + "/Bad Particles"))}
    );
  }
}

/// PIC is the blend's end and APIC takes the grid's own velocity as PIC does.
void read_transfer(const Deck& deck, StepSpec& step) {
  const std::string word = deck.word("Step/Transfer");
  if (word == "XPIC") step.transfer = Transfer::xpic;
  if (word == "APIC") step.transfer = Transfer::apic;
  step.pic_fraction = deck.number("Step/PIC Fraction");
  if (word != "FLIP" && step.pic_fraction != 0.0) {
    deck.refuse_value(
        "Step/PIC Fraction",
        "belongs to FLIP, but Transfer is " + word +
            " (which has no share of PIC to choose); remove one of the two"
    );
  }
  if (word == "PIC" || word == "APIC") step.pic_fraction = 1.0;
  step.xpic_order = deck.integer("Step/XPIC Order");
  if (word != "XPIC" && step.xpic_order != StepSpec{}.xpic_order) {
    deck.refuse_value(
        "Step/XPIC Order",
        "belongs to XPIC, but Transfer is " + word +
            " (which has no order); remove it or write Transfer = XPIC"
    );
  }
  const std::string order = deck.word("Step/Order");
  if (order == "modified stress last") step.order = Order::modified_stress_last;
  if (order == "stress first") step.order = Order::stress_first;
}

StepSpec read_step(const Deck& deck, Mode mode) {
  StepSpec step;
  step.shape = deck.word("Step/Shape Function");
  step.largest_domain = deck.number("Step/Largest Domain");
  if (step.largest_domain == 0.0) step.largest_domain = farthest_domain(mode);
  if (step.largest_domain > farthest_domain(mode)) {
    deck.refuse_value(
        "Step/Largest Domain",
        "is longer than " + text_of("%.3g", farthest_domain(mode)) +
            " cells (a tile sees no further); choose at most that, or 0 for as far as it goes"
    );
  }
  step.courant_fraction = deck.number("Step/Courant Fraction");
  step.stable_alone = deck.flag("Step/Stable Alone");
  step.growth_limit = deck.number("Step/Growth Limit");
  step.largest_strain = deck.number("Step/Largest Strain");
  step.largest_expansion = deck.number("Step/Largest Expansion");
  read_transfer(deck, step);
  step.damping = deck.number("Step/Damping");
  step.linear_viscosity = deck.number("Step/Linear Viscosity");
  step.quadratic_viscosity = deck.number("Step/Quadratic Viscosity");
  step.initial_step = deck.number("Step/Initial Step");
  step.largest_step = deck.number("Step/Largest Step");
  step.skip_dormant = deck.flag("Step/Skip Dormant Tiles");
  if (deck.has("Step/Rest Motion")) step.rest_motion = deck.number("Step/Rest Motion");
  return step;
}

OutputSpec read_output(const Deck& deck) {
  OutputSpec output;
  output.field_interval = deck.number("Output/Field Interval");
  output.history_interval = deck.number("Output/History Interval");
  output.checkpoint = {
      deck.number("Output/Checkpoint Wall Interval"),
      deck.number("Output/Checkpoint Interval"),
      deck.integer("Output/Checkpoint Steps")};
  output.glyph = deck.word("Output/Particle Glyph") == "point" ? Glyph::point : Glyph::deformed;
  output.files = deck.word("Output/Particle Files") == "one" ? ParticleFiles::one
                                                             : ParticleFiles::one_per_rank;
  return output;
}

/// Of the lattices that are walked through to fill bodies, all that are no boxes: one of a thin
/// body across the grid is far larger than what it holds.
double filling_bytes(const Scene& scene) {
  constexpr double bytes_per_cell = 8.0;
  double cells = 0.0;
  for (const BodySpec& body : scene.bodies) {
    if (std::holds_alternative<Box>(body.shape)) continue;
    const Box around = box_around(body.shape, scene.grid);
    const double size = scene.grid.cell_size / body.particles_per_cell;
    double count = 1.0;
    for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(scene.grid.mode)); ++i)
      count *= std::max(0.0, around.upper[i] - around.lower[i]) / size;
    cells = std::max(cells, count);
  }
  return bytes_per_cell * cells;
}

/// Refused before anything is allocated; the grid is counted first, because its size needs no
/// bodies.
void check_memory(const Deck& deck, const Scene& scene) {
  const double bytes = memory_estimate(scene) + filling_bytes(scene);
  const double available = machine_bytes();
  // Tiles are numbered with int.
  const bool countable =
      tiles_of(scene.grid) < static_cast<double>(std::numeric_limits<int>::max());
  if (bytes <= available && countable) return;
  deck.refuse_value(
      "Grid/Cell Size",
      "makes the run too large for memory (grid and particles need " + text_of("%.0f", bytes) +
          " bytes, more than this machine has); choose larger cells or a smaller box" +
          (countable ? ", or ranks on " + text_of("%.0f", std::ceil(bytes / available)) +
                           " machines of this size"
                     : "")
  );
}

}  // namespace

double particle_estimate(const Scene& scene) {
  const int d = dimensions(scene.grid.mode);
  double particles = 0.0;
  for (const BodySpec& body : scene.bodies) {
    const double size = scene.grid.cell_size / body.particles_per_cell;
    particles += most_measure(body.shape, scene.grid) / std::pow(size, d);
  }
  for (const JetSlug& slug : scene.jet.slugs) {
    const double per_length = scene.jet.particles_per_cell / scene.grid.cell_size;
    // A slug thinner than a particle is still one.
    const double across = std::max(1.0, slug.radius * per_length);
    particles +=
        (d == 3 ? 4.0 * across * across : across) * std::max(1.0, slug.length * per_length);
  }
  return particles;
}

double memory_estimate(const Scene& scene) {
  return bytes_per_tile * tiles_of(scene.grid) +
         estimated_particle_bytes(dimensions(scene.grid.mode)) * particle_estimate(scene);
}

Scene build_scene(const Deck& deck) {
  Scene scene;
  scene.title = deck.word("Title");
  scene.end_time = deck.number("Time/End Time");
  scene.grid = read_grid(deck);
  add_materials(deck, scene);
  add_bodies(deck, scene);
  // Before lattices are filled.
  check_memory(deck, scene);
  check_bodies(deck, scene);
  add_conditions(deck, scene);
  add_loads(deck, scene);
  add_confinement(deck, scene);
  check_pore_pressures(deck, scene);
  add_jet(deck, scene);
  add_body_force(deck, scene);
  check_rigid_bodies(deck, scene);
  add_contacts(deck, scene);
  add_pore_flow(deck, scene);
  scene.step = read_step(deck, scene.grid.mode);
  scene.output = read_output(deck);
  add_quasi_static(deck, scene);
  if (scene.bodies.empty() && !scene.jet.present) {
    deck.refuse("Bodies", "is empty and there is no Jet (nothing would move); add a body or a jet");
  }
  check_memory(deck, scene);
  return scene;
}

}  // namespace barreno
