// SPDX-License-Identifier: BSD-3-Clause
#include "output/particle_field_table.hpp"

#include <barreno/input/units.hpp>
#include <barreno/registry.hpp>
#include <cmath>
#include <map>
#include <sstream>

namespace barreno {
namespace {

using Values = std::vector<double>;

bool always(const OptionalFields& /*scene*/) {
  return true;
}

void read_velocity(const ParticleRow& row, Values& values) {
  for (int d = 0; d < row.particles.dimensions(); ++d)
    values.push_back(row.particles.velocity(row.p, d));
}

void read_stress(const ParticleRow& row, Values& values) {
  const Sym3& s = row.stress;
  values.insert(values.end(), {s.xx, s.yy, s.zz, s.xy});
  if (row.particles.dimensions() == 3) values.insert(values.end(), {s.yz, s.zx});
}

void read_shear_stress(const ParticleRow& row, Values& values) {
  const Sym3 shear = deviator(row.stress);
  values.push_back(std::sqrt(0.5 * contract(shear, shear)));
}

double density_of(const ParticleRow& row) {
  return row.particles.mass(row.p, 0) / row.particles.volume(row.p, 0);
}

void read_darcy_velocity(const ParticleRow& row, Values& values) {
  for (std::size_t d = 0; d < row.particles.darcy_velocity.extent(1); ++d)
    values.push_back(row.particles.darcy_velocity(row.p, d));
}

std::vector<ParticleField> common_fields() {
  using C = Components;
  return {
      {"status",
       C::one,
       "-",
       "1 while the particle exists, 0 before its launch and after its removal",
       always,
       [](const ParticleRow&, Values& values) { values.push_back(1.0); }},
      {"velocity", C::vector, "m/s", "of the particle's centre", always, read_velocity},
      {"stress",
       C::tensor,
       "Pa",
       "stress; in axisymmetry xx is radial, yy axial, zz hoop",
       always,
       read_stress},
      {"pressure",
       C::one,
       "Pa",
       "minus the mean of xx, yy and zz",
       always,
       [](const ParticleRow& row, Values& values) { values.push_back(-trace(row.stress) / 3.0); }},
      {"shear_stress",
       C::one,
       "Pa",
       "sqrt(J2), the second invariant of the stress deviator",
       always,
       read_shear_stress},
      {"density",
       C::one,
       "kg/m3",
       "mass over volume",
       always,
       [](const ParticleRow& row, Values& values) { values.push_back(density_of(row)); }},
      {"volume_ratio",
       C::one,
       "-",
       "volume over the volume at the material's reference density",
       always,
       [](const ParticleRow& row, Values& values) {
         values.push_back(row.reference_density / density_of(row));
       }},
      {"viscous_pressure",
       C::one,
       "Pa",
       "artificial viscosity q, which acts beside the stress",
       always,
       [](const ParticleRow& row, Values& values) {
         values.push_back(row.particles.viscous_pressure(row.p, 0));
       }}};
}

std::vector<ParticleField> fields_of_some_scenes() {
  using C = Components;
  return {
      {"domain_clipped",
       C::one,
       "-",
       "1 if the particle's domain is cut at `Step/Largest Domain` (CPDI, contiguous GIMP)",
       [](const OptionalFields& scene) { return scene.clipped; },
       [](const ParticleRow& row, Values& values) {
         if (row.particles.clipped.extent(1) > 0) values.push_back(row.particles.clipped(row.p, 0));
       }},
      {"darcy_velocity",
       C::vector,
       "m/s",
       "volume of pore fluid that flows past the rock, per area and time",
       [](const OptionalFields& scene) { return scene.darcy_velocity; },
       read_darcy_velocity},
      {"cell_size",
       C::one,
       "m",
       "size of the cells around the particle, where a deck has several sizes (`Refinement`, "
       "`Jet/Cells Per Radius`)",
       [](const OptionalFields& scene) { return scene.cell_size; },
       [](const ParticleRow& row, Values& values) { row.own.append_cell_size(row.p, values); }},
      {"step_length",
       C::one,
       "s",
       "length of the last step of the tile that the particle is in, with `Step/Subcycles`: slow "
       "tiles take several parts of a step at once; 0 before the first. A tile that was not active "
       "has the longest. The step that meets a time of the output may be cut short, and then have "
       "fewer parts",
       [](const OptionalFields& scene) { return scene.step_length; },
       [](const ParticleRow& row, Values& values) { row.own.append_step_length(row.p, values); }}};
}

/// "`stress_xx`, `_yy`": the names as the page lists them, in space.
std::string names_on_page(const ParticleField& field) {
  const std::vector<std::string> names = component_names(field, 3);
  std::string out;
  for (const std::string& name : names)
    out += (out.empty() ? "`" + name : ", `" + name.substr(name.rfind('_'))) + "`";
  return out;
}

/// A variable of a model's history on the page, with those that differ in the last word only.
struct HistoryRow {
  std::string names, unit, meaning;
  std::vector<std::string> models;
};
bool is_component(const std::string& name) {
  const std::size_t at = name.rfind('_');
  return at != std::string::npos && name.find_first_not_of("xyz", at + 1) == std::string::npos &&
         name.size() - at == 3;
}
void add_history(
    const ModelDescription& model, const HistoryField& field, std::vector<HistoryRow>& rows
) {
  const std::string name = field.name;
  const std::string base = is_component(name) ? name.substr(0, name.rfind('_')) : name;
  for (HistoryRow& row : rows) {
    const bool same = row.names.rfind("`" + name + "`", 0) == 0;
    const bool other = base != name && row.names.rfind("`" + base + "_xx`", 0) == 0;
    if (other && !same) row.names += ", `" + name.substr(base.size()) + "`";
    if (same && row.models.back() != model.name) row.models.push_back(model.name);
    if (same || other) return;
  }
  const std::string unit = input::si_unit_of(field.dimension);
  rows.push_back({"`" + name + "`", unit.empty() ? "-" : unit, field.meaning, {model.name}});
}

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (std::size_t i = 0; i < words.size(); ++i)
    out += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return out;
}

}  // namespace

const std::vector<ParticleField>& particle_field_table() {
  static const std::vector<ParticleField> table = [] {
    std::vector<ParticleField> all = common_fields();
    for (const ParticleField& field : fields_of_some_scenes()) all.push_back(field);
    return all;
  }();
  return table;
}

std::vector<std::string> component_names(const ParticleField& field, int dimensions) {
  if (field.components == Components::one) return {field.name};
  std::vector<const char*> ends{"_x", "_y"};
  if (field.components == Components::tensor) ends = {"_xx", "_yy", "_zz", "_xy"};
  if (dimensions == 3 && field.components == Components::vector) ends.push_back("_z");
  if (dimensions == 3 && field.components == Components::tensor)
    ends.insert(ends.end(), {"_yz", "_zx"});
  std::vector<std::string> names;
  names.reserve(ends.size());
  for (const char* end : ends) names.push_back(std::string(field.name) + end);
  return names;
}

std::string particle_fields_markdown() {
  std::ostringstream out;
  out << "| field | unit | meaning |\n|---|---|---|\n";
  for (const ParticleField& field : particle_field_table())
    out << "| " << names_on_page(field) << " | " << field.unit << " | " << field.meaning << " |\n";
  std::vector<HistoryRow> rows;
  for (const ModelDescription& model : describe_models()) {
    for (const HistoryField& field : model.history) add_history(model, field, rows);
    for (const HistoryField& field : model.more_history) add_history(model, field, rows);
  }
  for (const HistoryRow& row : rows)
    out << "| " << row.names << " | " << row.unit << " | " << joined(row.models) << ": "
        << row.meaning << " |\n";
  out << "| `displacement_x`, `_y`, `_z` | m | of the corners of particles, nodes of the file: "
         "ParaView moves them by it |\n"
         "| `step`, `time_step`, `particles` | -, s, - | once per time: number of steps, size of "
         "the last step, particles that exist |\n";
  return out.str();
}

}  // namespace barreno
