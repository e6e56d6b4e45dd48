// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build_scene.hpp"

#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace barreno {

std::string text_of(const char* format, double x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

namespace {

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
    const double whole = std::max(1.0, std::round(cells));
    // Beyond 1e12 the fraction is round-off, and check_size refuses such a grid with its own
    // sentence.
    if (cells < 1e12 && std::abs(cells - whole) > 1e-6 * std::max(1.0, cells)) {
      deck.refuse_value(
          "Grid/Cell Size",
          "does not divide the box along " + axis + " (" + text_of("%.6g", cells) +
              " cells); change the cell size or the corners of the box"
      );
    }
  }
  return grid;
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
  step.return_losses = deck.flag("Step/Return Losses");
  step.skip_dormant = deck.flag("Step/Skip Dormant Tiles");
  if (deck.has("Step/Rest Motion")) step.rest_motion = deck.number("Step/Rest Motion");
  return step;
}

/// The losses of other schemes are not known particle by particle.
void check_returned_losses(const Deck& deck, const Scene& scene) {
  const StepSpec& step = scene.step;
  if (!step.return_losses) return;
  const bool flip = step.transfer == Transfer::flip && step.pic_fraction == 0.0;
  if (flip && step.order == Order::stress_last && step.damping == 0.0) return;
  deck.refuse_value(
      "Step/Return Losses",
      std::string("needs Transfer FLIP without PIC Fraction, Order stress last and no Damping (of "
      ) +
          (!flip                              ? transfer_name(step)
           : step.order != Order::stress_last ? order_name(step.order)
                                              : "damping") +
          " it is not known which particle lost what); remove it or those"
  );
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

}  // namespace

Scene build_scene(const Deck& deck) {
  Scene scene;
  scene.title = deck.word("Title");
  scene.end_time = deck.number("Time/End Time");
  scene.grid = read_grid(deck);
  add_materials(deck, scene);
  add_bodies(deck, scene);
  check_size(deck, scene);  // before lattices are filled
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
  check_returned_losses(deck, scene);
  if (scene.bodies.empty() && !scene.jet.present) {
    deck.refuse("Bodies", "is empty and there is no Jet (nothing would move); add a body or a jet");
  }
  check_size(deck, scene);
  check_magnitudes(deck, scene);
  return scene;
}

}  // namespace barreno
