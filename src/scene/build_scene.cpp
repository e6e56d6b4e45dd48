// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build_scene.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/head_section.hpp"
#include "scene/jet/jet_monitor.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <barreno/models.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <cstdio>

namespace barreno {

std::string text_of(const char* format, double x) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, x);
  return buffer;
}

namespace {

GridSpec read_grid(const Deck& deck) {
  auto grid = read_section<GridSpec>(deck);
  if (grid.mode == Mode::axisymmetric && grid.lower[0] < 0.0) {
    deck.refuse_value(
        path_of(&GridSpec::lower),
        "has a negative radius (the axis is at x = 0); start at 0 or at a positive radius"
    );
  }
  refuse_empty_box(deck, grid.lower, grid.upper);
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(grid.mode)); ++i) {
    const std::string axis(1, "xyz"[i]);
    const double cells = (grid.upper[i] - grid.lower[i]) / grid.cell_size;
    const double whole = std::max(1.0, std::round(cells));
    // Beyond 1e12 the fraction is round-off, and check_size refuses such a grid with its own
    // sentence.
    if (cells < 1e12 && std::abs(cells - whole) > 1e-6 * std::max(1.0, cells)) {
      deck.refuse_value(
          path_of(&GridSpec::cell_size),
          "does not divide the box along " + axis + " (" + text_of("%.6g", cells) +
              " cells); change the cell size or the corners of the box"
      );
    }
  }
  return grid;
}

/// The material of a list below Materials, its model's own rules checked.
Material material_in(const Deck& deck, const std::string& name) {
  const std::string path = list_of<MaterialSection>(name);
  Teuchos::ParameterList list = deck.list(path);
  // The deck's own words, which no model knows.
  list.remove(name_of(&MaterialSection::bad_particles));
  list.remove(name_of(&MaterialSection::largest_expansion), false);
  list.remove(name_of(&MaterialSection::volume_relaxation), false);
  return make_material(name, list, deck.name(), path);
}

void add_materials(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists(table_of<MaterialSection>().path)) {
    const auto said = read_list<MaterialSection>(deck, list_of<MaterialSection>(name));
    MaterialSpec& material =
        scene.materials.emplace_back(material_in(deck, name), said.bad_particles);
    if (said.largest_expansion) material.largest_expansion = said.largest_expansion;
    material.volume_relaxation = said.volume_relaxation.value_or(0.0);
    material.source = deck.list(list_of<MaterialSection>(name)).get("Source", std::string());
  }
}

/// PIC is the blend's end and APIC takes the grid's own velocity as PIC does.
void settle_transfer(const Deck& deck, StepSpec& step) {
  const std::string word = word_of(step.transfer);
  if (step.transfer != Transfer::flip && step.pic_fraction != StepSpec{}.pic_fraction) {
    deck.refuse_value(
        path_of(&StepSpec::pic_fraction),
        "applies to FLIP, but Transfer is " + word +
            " (which has no PIC fraction); remove one of the two"
    );
  }
  if (step.transfer == Transfer::pic || step.transfer == Transfer::apic) step.pic_fraction = 1.0;
  if (step.transfer != Transfer::xpic && step.xpic_order != StepSpec{}.xpic_order) {
    deck.refuse_value(
        path_of(&StepSpec::xpic_order),
        "applies to XPIC, but Transfer is " + word +
            " (which has no order); remove it or write Transfer = XPIC"
    );
  }
}

StepSpec read_step(const Deck& deck, Mode mode) {
  auto step = read_section<StepSpec>(deck);
  if (step.largest_domain == 0.0) step.largest_domain = farthest_domain(mode);
  if (step.largest_domain > farthest_domain(mode)) {
    deck.refuse_value(
        path_of(&StepSpec::largest_domain),
        "is longer than " + text_of("%.3g", farthest_domain(mode)) +
            " cells (the reach of a tile); choose at most that, or 0 for the largest possible"
    );
  }
  settle_transfer(deck, step);
  return step;
}

/// The losses of other schemes are not known particle by particle.
void check_returned_losses(const Deck& deck, const Scene& scene) {
  const StepSpec& step = scene.step;
  if (!step.return_losses) return;
  const bool flip = step.transfer == Transfer::flip && step.pic_fraction == 0.0;
  if (flip && step.order == Order::stress_last && step.damping == 0.0) return;
  deck.refuse_value(
      path_of(&StepSpec::return_losses),
      std::string(
          "needs Transfer FLIP without PIC Fraction, Order stress last and no Damping (with "
      ) +
          (!flip                              ? transfer_name(step)
           : step.order != Order::stress_last ? word_of(step.order)
                                              : "damping") +
          " it is not known which particle lost how much); remove it or those"
  );
}

}  // namespace

Scene build_scene(const Deck& deck) {
  Scene scene;
  // One line, as screens, run.log and files have it: a line end in it would begin a line of theirs.
  scene.title = input::on_one_line(read_section<HeadSection>(deck).title);
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
  add_end(deck, scene);
  add_detonation(deck, scene);
  jet_monitor_of(deck, scene);  // refuses; whoever monitors asks again
  add_body_force(deck, scene);
  check_rigid_bodies(deck, scene);
  add_contacts(deck, scene);
  add_pore_flow(deck, scene);
  scene.step = read_step(deck, scene.grid.mode);
  check_expansions(deck, scene);
  scene.output = read_section<OutputSpec>(deck);
  add_quasi_static(deck, scene);
  check_returned_losses(deck, scene);
  add_refinement(deck, scene);
  check_refinement(deck, scene);
  settle_subcycles(deck, scene);
  if (scene.bodies.empty() && !scene.jet.present) {
    deck.refuse(
        table_of<BodySpec>().path,
        "is empty and there is no Jet (nothing would move); add a body or a jet"
    );
  }
  check_size(deck, scene);
  check_magnitudes(deck, scene);
  return scene;
}

}  // namespace barreno
