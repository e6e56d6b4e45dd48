// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/find_run.hpp"

#include "deck/files/read_on_root.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/continue_section.hpp"

#include <barreno/input/scan_xml.hpp>
#include <filesystem>

namespace barreno {

void find_run(
    const std::string& source,
    const std::string& directory,
    const Teuchos::Comm<int>& comm,
    Teuchos::ParameterList& values
) {
  const std::string& path = table_of<ContinueSpec>().path;
  if (!values.isSublist(path)) return;
  Teuchos::ParameterList& list = values.sublist(path);
  const std::string& name = name_of(&ContinueSpec::run);
  const std::filesystem::path run = list.get<std::string>(name);
  if (run.empty())
    input::refuse(source, path_of(&ContinueSpec::run), "is empty; write the folder of a run");
  const auto absolute = [&] {
    const auto folder =
        std::filesystem::absolute(std::filesystem::path(directory) / run).lexically_normal();
    return (folder.has_filename() ? folder : folder.parent_path()).string();
  };
  list.set(name, read_on_root(absolute, comm));
}

}  // namespace barreno
