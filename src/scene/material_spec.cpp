// SPDX-License-Identifier: BSD-3-Clause
#include "scene/scene.hpp"

#include <barreno/models.hpp>

namespace barreno {

MaterialSpec::MaterialSpec(const Material& material, BadParticlePolicy policy)
    : bad_particles(policy),
      density_(material.density),
      material_(std::make_shared<const Material>(material)) {}

const std::string& MaterialSpec::name() const {
  return material_->name;
}

void MaterialSpec::scale_density(double factor) {
  Material scaled = *material_;
  scaled.density *= factor;
  *this = MaterialSpec(scaled, bad_particles);
}

}  // namespace barreno
