// SPDX-License-Identifier: BSD-3-Clause
#include "output/cavities.hpp"

#include "base/region.hpp"
#include "step/loads/load_pressures.hpp"

namespace barreno {

std::vector<int> pore_fluids(const Scene& scene) {
  std::vector<int> fluids;
  for (std::size_t l = 0; l < scene.loads.size(); ++l)
    if (traits_of(scene.loads[l].kind).fills_hollow) fluids.push_back(static_cast<int>(l));
  return fluids;
}

CavitiesWriter::CavitiesWriter(
    const Scene& scene, const Comm& comm, const std::filesystem::path& path, std::uintmax_t kept
) {
  std::string header = "time";
  for (const int load : pore_fluids(scene)) {
    const std::string name = column_name(scene.loads[static_cast<std::size_t>(load)].name);
    for (const char* column : {"_volume", "_pressure"}) header.append(",").append(name + column);
  }
  RootWork work(comm);
  work.run([&] {
    file_ = std::make_unique<LineFile>(path, kept);
    if (kept > 0) return;  // it has its header
    file_->append("# SI units: time s; volume m3 of the part inside the grid; pressure Pa");
    file_->append(header);
  });
  work.agree();
}

void CavitiesWriter::write(const Scene& scene, const State& state) {
  const Region region("write_cavities");
  std::vector<double> row{state.clock.time};
  for (const int load : pore_fluids(scene)) {
    const auto l = static_cast<std::size_t>(load);
    row.push_back(state.cavities[l].volume);
    row.push_back(load_pressure(scene.loads[l], state.cavities[l], state.clock.time));
  }
  RootWork work(*state.grid.comm);
  work.run([&] { file_->append(csv_line(row)); });
  work.agree();
}

}  // namespace barreno
