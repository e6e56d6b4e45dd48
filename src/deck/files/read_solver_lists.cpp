// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/read_solver_lists.hpp"

#include "deck/section_table.hpp"
#include "deck/sections/pore_flow_section.hpp"

#include <Teuchos_XMLParameterListReader.hpp>

#include <barreno/input/scan_xml.hpp>
#include <sstream>

namespace barreno {
namespace {

using input::join;
using Teuchos::ParameterList;
using Teuchos::XMLObject;

/// The type of a value that a deck, or a --set, gives without one: these lists have no table.
std::string type_of_text(const std::string& text) {
  if (text == "true" || text == "false") return "bool";
  const auto reads_as = [&](auto value) {
    std::istringstream stream(text);
    return stream >> value && stream.eof();
  };
  if (reads_as(0)) return "int";
  return reads_as(0.0) ? "double" : "string";
}

void add_types(const XMLObject& list) {
  for (int i = 0; i < list.numChildren(); ++i) {
    XMLObject child = list.getChild(i);
    if (child.getTag() == "ParameterList")
      add_types(child);
    else if (child.hasAttribute("value") && !child.hasAttribute("type"))
      child.addAttribute("type", type_of_text(child.getAttribute("value")));
  }
}

ParameterList read_foreign_list(
    const XMLObject& list, const std::string& name, const std::string& source
) {
  try {
    return Teuchos::XMLParameterListReader().toParameterList(list);
  } catch (const std::exception&) {
    input::refuse(
        source,
        join(table_of<PoreFlowSpec>().path, name),
        "is not a list that Teuchos can read (a type may not fit its value); write type=\"int\", "
        "\"double\", \"bool\" or \"string\" and a value of that type"
    );
  }
}

}  // namespace

void read_solver_lists(const XMLObject& root, const std::string& source, ParameterList& values) {
  const std::string& path = table_of<PoreFlowSpec>().path;
  const auto flow = input::find_list(root, path);
  if (!flow) return;
  for (const std::string& name : solver_lists())
    if (const auto list = input::find_list(*flow, name)) {
      add_types(*list);
      values.sublist(path).sublist(name) = read_foreign_list(*list, name, source);
    }
}

}  // namespace barreno
