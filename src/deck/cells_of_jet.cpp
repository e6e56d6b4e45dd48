// SPDX-License-Identifier: BSD-3-Clause
#include "deck/cells_of_jet.hpp"

#include "deck/deck.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/pore_flow_section.hpp"
#include "deck/sections/step_section.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace barreno {
namespace {

constexpr double round_off = 1e-9;

double thinnest_radius(const Deck& deck) {
  double thinnest = std::numeric_limits<double>::infinity();
  for (const std::vector<double>& row : deck.rows(path_of(&JetSpec::slugs)))
    thinnest = std::min(thinnest, row[2]);
  return thinnest;
}

/// Cells that the radius of the thinnest slug is to have along the jet's path.
double wanted_cells(const Deck& deck) {
  const std::string path = path_of(&JetSpec::cells_per_radius);
  const double wanted = deck.number(path);
  const bool left_out =
      deck.chosen_by_fidelity.count(path) > 0 && !conflict_with_levels(deck).empty();
  return wanted > 0.0 && !left_out ? wanted : 1.0;
}

bool divides(double size, double length) {
  const double cells = length / size;
  return std::abs(cells - std::round(cells)) <= round_off * cells;
}

std::string note_of(double size, double cells, double radius) {
  char text[160];
  std::snprintf(
      text,
      sizeof text,
      " = %.6g m follows from the jet (%.3g %s in the radius of its thinnest slug, %.6g m).",
      size,
      cells,
      cells == 1.0 ? "cell" : "cells",
      radius
  );
  return path_of(&GridSpec::cell_size) + text;
}

}  // namespace

std::string conflict_with_levels(const Deck& deck, bool flow_decided) {
  const std::string drainage = path_of(&PoreFlowSpec::drainage);
  if (deck.has(table_of<PoreFlowSpec>().path)) {
    const auto asked = DeckValue<Drainage>::read(deck, drainage);
    if (asked == Drainage::on || (asked == Drainage::automatic && !flow_decided))
      return drainage + " = " + word_of(asked);
  }
  const auto step = read_section<StepSpec>(deck);
  if (step.transfer == Transfer::xpic || step.transfer == Transfer::apic)
    return path_of(&StepSpec::transfer) + " = " + word_of(step.transfer);
  if (step.shape == "linear") return path_of(&StepSpec::shape) + " = linear";
  if (step.return_losses && mode_of(deck) == Mode::three_dimensional)
    return path_of(&StepSpec::return_losses) + " in three dimensions";
  return {};
}

JetCells cells_of_jet(const Deck& deck) {
  const std::string path = path_of(&GridSpec::cell_size);
  if (!deck.has(path_of(&JetSpec::slugs)))
    deck.refuse(
        path, "is missing (without a Jet nothing tells how fine the grid should be); add it"
    );
  const double cells = wanted_cells(deck);
  const double level =
      std::clamp(std::ceil(std::log2(cells) - round_off), 0.0, static_cast<double>(max_level));
  const double radius = thinnest_radius(deck);
  if (!(radius > 0.0))
    deck.refuse(
        path_of(&JetSpec::slugs),
        "has a slug with a radius of " + DeckValue<double>::text(radius) +
            " m (it must be above 0); correct the table"
    );
  const double most = std::exp2(level) * radius / cells;
  const Vector lower = vector_at(deck, path_of(&GridSpec::lower));
  const Vector upper = vector_at(deck, path_of(&GridSpec::upper));
  const auto axes = static_cast<std::size_t>(dimensions(mode_of(deck)));
  refuse_empty_box(deck, lower, upper);
  // At least so many cells, and at most twice; of a box of very many the first sizes will do.
  const double first = std::ceil((upper[0] - lower[0]) / most * (1.0 - round_off));
  const int tries = static_cast<int>(std::min(first, 1e4)) + 1;
  for (int more = 0; more < tries; ++more) {
    const double size = (upper[0] - lower[0]) / (first + more);
    bool all = true;
    for (std::size_t i = 1; i < axes; ++i) all = all && divides(size, upper[i] - lower[i]);
    if (all) return {size, note_of(size, cells, radius)};
  }
  deck.refuse(
      path,
      "is missing, and no size of the jet's cells divides the box along all axes; add it, or "
      "change the corners of the box"
  );
}

}  // namespace barreno
