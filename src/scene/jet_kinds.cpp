// SPDX-License-Identifier: BSD-3-Clause
#include "scene/jet_kinds.hpp"

#include "deck/touching_duration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace barreno {
namespace {

/// A thousandth allows for the digits of a table.
constexpr double table_digits = 1.001;

std::string digits_of(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.6g", x);
  return buffer;
}

/// The whole mass at the material's density: the length that is left.
JetSlug with_gap(const JetSlug& row, double material_density) {
  JetSlug slug = row;
  slug.length *= slug.density / material_density;
  slug.density = material_density;
  return slug;
}

JetSlug thinned(const JetSlug& touching, Mode mode, double material_density) {
  JetSlug slug = touching;
  const double filled = slug.density / material_density;
  slug.radius *= mode == Mode::plane_strain ? filled : std::sqrt(filled);
  slug.density = material_density;
  return slug;
}

}  // namespace

std::vector<JetSlug> touching_slugs(const std::vector<JetSlug>& table) {
  std::vector<JetSlug> slugs = table;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const std::optional<double> duration = touching_duration(table, i);
    if (!duration) continue;
    slugs[i].length = *duration * table[i].velocity;
    slugs[i].density = table[i].density * table[i].length / slugs[i].length;
  }
  return slugs;
}

std::vector<JetSlug> slugs_of_kind(
    const std::vector<JetSlug>& table, JetKind kind, Mode mode, double material_density
) {
  if (!traits_of(kind).touching) {
    std::vector<JetSlug> slugs;
    slugs.reserve(table.size());
    for (const JetSlug& row : table) slugs.push_back(with_gap(row, material_density));
    return slugs;
  }
  std::vector<JetSlug> slugs = touching_slugs(table);
  for (JetSlug& slug : slugs) {
    if (kind == JetKind::thinned && !slug.piece) slug = thinned(slug, mode, material_density);
    // Denser by the digits of the table only: its mass is kept by its length.
    if (slug.density > material_density) slug = with_gap(slug, material_density);
  }
  return slugs;
}

std::string problem_of_kind(
    const std::vector<JetSlug>& table, JetKind kind, double material_density
) {
  if (!traits_of(kind).touching) return {};
  const std::string name = word_of(kind);
  for (std::size_t i = 1; i < table.size(); ++i)
    if (!(table[i].time > table[i - 1].time))
      return "launches slugs " + std::to_string(i) + " and " + std::to_string(i + 1) +
             " at the same time, " + digits_of(table[i].time) + " s (a " + name +
             " jet is whole: its slugs follow each other); correct the table or "
             "write Jet/Kind = discrete";
  const std::vector<JetSlug> touching = touching_slugs(table);
  for (std::size_t i = 0; i < touching.size(); ++i)
    if (touching[i].density > table_digits * material_density)
      return "gives slug " + std::to_string(i + 1) + " a length of " + digits_of(table[i].length) +
             " m and " + digits_of(touching[i].length) + " m of room between its neighbours (a " +
             name +
             " jet is whole: its slugs would have to be denser than their material); correct the "
             "table or write Jet/Kind = discrete";
  return {};
}

}  // namespace barreno
