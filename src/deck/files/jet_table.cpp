// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/jet_table.hpp"

#include "deck/files/read_table.hpp"

#include <barreno/input/scan_xml.hpp>

namespace barreno {

Teuchos::TwoDArray<double> read_jet_table(
    const std::string& text, const std::string& source, std::vector<std::string>* notes
) {
  const std::vector<TableColumn> columns = {
      {"time", dimension::time},
      {"velocity", dimension::velocity},
      {"radius", dimension::length},
      {"length", dimension::length},
      {"density", dimension::density}};
  const TableRows rows = read_table(text, columns, "a jet table", source);
  if (notes != nullptr) *notes = rows.notes;
  if (rows.lines.empty()) {
    input::refuse(
        source,
        "",
        "contains no slug (a jet needs at least one row below the header); add rows or remove Jet"
    );
  }
  using Index = Teuchos::TwoDArray<double>::size_type;
  const auto count = static_cast<Index>(columns.size());
  Teuchos::TwoDArray<double> table(static_cast<Index>(rows.lines.size()), count);
  for (std::size_t i = 0; i < rows.values.size(); ++i) {
    table(static_cast<Index>(i) / count, static_cast<Index>(i) % count) = rows.values[i];
  }
  return table;
}

}  // namespace barreno
