// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "output/particle_fields.hpp"

#include <barreno/tensor.hpp>
#include <string>
#include <vector>

namespace barreno {

/// What a field is read from: a particle of a set on the host.
struct ParticleRow {
  const HostParticles& particles;
  int p;
  double reference_density;
  const CellsAndSteps& own;
  Sym3 stress;  ///< in the space frame
};

/// Ends of a field's names: none, those of a vector, or those of a symmetric tensor.
enum class Components { one, vector, tensor };

/// A field of particles.e: this row is all that is known of it. Names and values in the file,
/// docs/output.md and the report's units follow from it.
struct ParticleField {
  const char* name;
  Components components;
  const char* unit;
  const char* meaning;
  bool (*present)(const OptionalFields&);
  void (*read)(const ParticleRow&, std::vector<double>&);  ///< nothing where it is not present
};
const std::vector<ParticleField>& particle_field_table();

/// Names of a field's components in a plane or in space.
std::vector<std::string> component_names(const ParticleField& field, int dimensions);

/// The table of docs/output.md: these fields, then the history of all models.
std::string particle_fields_markdown();

}  // namespace barreno
