// SPDX-License-Identifier: BSD-3-Clause
#include "scene/explosive_traits.hpp"
#include "scene/scene.hpp"
#include "scene/voids.hpp"

#include <barreno/models.hpp>
#include <barreno/pore_point.hpp>
#include <limits>
#include <type_traits>
#include <variant>

namespace barreno {

MaterialSpec::MaterialSpec(const Material& material, BadParticlePolicy policy)
    : bad_particles(policy),
      density_(material.density),
      material_(std::make_shared<const Material>(material)) {
  const double own = std::visit(
      [](const auto& model) { return own_largest_expansion<std::decay_t<decltype(model)>>; },
      material.model
  );
  if (own > 0.0) largest_expansion = own;
}

const std::string& MaterialSpec::name() const {
  return material_->name;
}

std::string MaterialSpec::model_name() const {
  return std::visit([](const auto& model) { return std::string(model.name); }, material_->model);
}

std::vector<HistoryField> MaterialSpec::history_table() const {
  return std::visit([](const auto& model) { return model.history_table(); }, material_->model);
}

std::optional<int> MaterialSpec::history_column(std::string_view field) const {
  const std::vector<HistoryField> table = history_table();
  for (std::size_t i = 0; i < table.size(); ++i)
    if (field == table[i].name) return static_cast<int>(i);
  return {};
}

bool MaterialSpec::is_porous() const {
  return std::visit(
      [](const auto& model) { return is_drainable<std::decay_t<decltype(model)>>; },
      material_->model
  );
}

bool MaterialSpec::holds_voids() const {
  return std::visit(
      [](const auto& model) { return barreno::holds_voids<std::decay_t<decltype(model)>>; },
      material_->model
  );
}

double MaterialSpec::largest_porous_expansion() const {
  return std::visit(
      [](const auto& model) {
        if constexpr (barreno::holds_voids<std::decay_t<decltype(model)>>)
          return model.largest_porous_expansion();
        else
          return std::numeric_limits<double>::infinity();
      },
      material_->model
  );
}

std::optional<double> MaterialSpec::detonation_speed() const {
  return std::visit(
      [](const auto& model) {
        std::optional<double> speed;
        if constexpr (burns_by_program<std::decay_t<decltype(model)>>)
          speed = model.parameters().detonation_speed;
        return speed;
      },
      material_->model
  );
}

int MaterialSpec::splits() const {
  return std::visit(
      [](const auto& model) {
        if constexpr (divides_particles<std::decay_t<decltype(model)>>)
          return static_cast<int>(model.parameters().splits);
        return 0;
      },
      material_->model
  );
}

int MaterialSpec::splits_column() const {
  return std::visit(
      [](const auto& model) {
        using Model = std::decay_t<decltype(model)>;
        if constexpr (divides_particles<Model>) return Model::splits_column;
        return -1;
      },
      material_->model
  );
}

void MaterialSpec::scale_density(double factor) {
  Material scaled = *material_;
  scaled.density *= factor;
  const std::optional<double> expansion = largest_expansion;
  const double relaxation = volume_relaxation;
  const std::string said = source;
  *this = MaterialSpec(scaled, bad_particles);
  largest_expansion = expansion;
  volume_relaxation = relaxation;
  source = said;
}

}  // namespace barreno
