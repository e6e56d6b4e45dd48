// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/input/schema.hpp>
#include <barreno/registry.hpp>

namespace barreno {

inline constexpr int deck_schema_version = 1;

/// The table of a deck: validation, defaults, effective deck and manual follow from it.
/// The lists below Materials depend on their model: material_section.
const input::Section& deck_schema();

/// The table of one list below Materials.
input::Section material_section(const ModelDescription& model);

}  // namespace barreno
