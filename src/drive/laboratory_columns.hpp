// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/files/read_table.hpp"

#include <string>
#include <vector>

namespace barreno {

/// A column of a path as laboratories write it: along the axis of the specimen, which is x, or on
/// its side, y and z.
struct LaboratoryColumn {
  const char* name;
  std::vector<std::size_t> components;  ///< that it prescribes, as in component_names
  bool is_strain;
};

const std::vector<LaboratoryColumn>& laboratory_columns();
const LaboratoryColumn* find_laboratory_column(const std::string& name);

/// Brings these columns to logarithmic strains and stresses with tension positive. The comments
/// "# compression: positive" (or negative) and "# strain: logarithmic" (default engineering) mean
/// what they mean in the files of `fit`.
/// @throws DeckError where the sign convention or a unit is not said, or a strain cannot be
void from_laboratory(const TableText& table, TableRows& rows, const std::string& source);

}  // namespace barreno
