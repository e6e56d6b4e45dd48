// SPDX-License-Identifier: BSD-3-Clause
#include "output/exodus_writer.hpp"

#include "base/region.hpp"
#include "output/copy_exodus_steps.hpp"
#include "output/particle_fields.hpp"
#include "shape/shape_facts.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace barreno {

ExodusWriter::ExodusWriter(
    const Scene& scene,
    const std::vector<SlotRange>& slots,
    const State& state,
    const std::filesystem::path& path,
    const std::string& version,
    const std::vector<std::string>& information,
    int kept
)
    : dimensions_(dimensions(scene.grid.mode)),
      nodes_(
          scene.output.glyph == Glyph::point ? 1
          : dimensions_ == 3                 ? 8
                                             : 4
      ),
      steps_(kept) {
  lay_out(scene, slots);
  ExodusLayout layout = describe(scene, version);
  layout.information = information;
  record_start(scene, state, layout);
  RootWork work(*state.grid.comm);
  work.run([&] {
    file_ = std::make_unique<ExodusFile>(path, layout, std::max(kept, 1));
    if (kept > 0) displacement_ = copy_exodus_steps(path, layout, kept, *file_);
  });
  work.agree();
}

void ExodusWriter::lay_out(const Scene& scene, const std::vector<SlotRange>& slots) {
  std::vector<SlotRange> sorted = slots;
  std::sort(sorted.begin(), sorted.end(), [](const SlotRange& a, const SlotRange& b) {
    return a.first < b.first;
  });
  blocks_.resize(scene.materials.size());
  for (const SlotRange& slot : sorted) {
    if (slot.first < 1) throw std::logic_error("particle ids must be positive");
    Block& block = blocks_[static_cast<std::size_t>(slot.material)];
    block.ranges.push_back({slot.first, slot.count, block.count});
    block.count += static_cast<std::size_t>(slot.count);
  }
  for (std::size_t b = 1; b < blocks_.size(); ++b)
    blocks_[b].begin = blocks_[b - 1].begin + blocks_[b - 1].count;
}

ExodusLayout ExodusWriter::describe(const Scene& scene, const std::string& version) const {
  ExodusLayout layout;
  layout.title = scene.title;
  layout.version = version;
  layout.topology = nodes_ == 1 ? "SPHERE" : nodes_ == 4 ? "QUAD4" : "HEX8";
  layout.nodes_per_element = nodes_;
  layout.global_variables = {"step", "time_step", "particles"};
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Material& material = scene.materials[b].material;
    ExodusBlock block{
        material.name,
        {},
        particle_field_names(material, dimensions_, optional_fields(scene, material))};
    for (const Range& range : blocks_[b].ranges)
      for (long long i = 0; i < range.count; ++i) block.ids.push_back(range.first + i);
    layout.blocks.push_back(std::move(block));
  }
  return layout;
}

void ExodusWriter::record_start(const Scene& scene, const State& state, ExodusLayout& layout) {
  const std::size_t elements = blocks_.empty() ? 0 : blocks_.back().begin + blocks_.back().count;
  const std::size_t nodes = elements * static_cast<std::size_t>(nodes_);
  const bool root = is_root(*state.grid.comm);
  const auto directions = static_cast<std::size_t>(dimensions_);
  if (root) {
    start_.assign(directions, std::vector<double>(nodes, 0.0));
    displacement_ = start_;
    std::fill(start_[1].begin(), start_[1].end(), scene.jet.launch_position);
    const double launched_size = scene.grid.cell_size / (2.0 * scene.jet.particles_per_cell);
    if (nodes_ == 1) layout.radius.assign(elements, launched_size);
  }
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Rows rows = gather_rows(scene, state, b);
    for (std::size_t r = 0; r < rows.elements.size(); ++r) {
      const std::size_t e = rows.elements[r];
      const double* values = &rows.values[r * rows.width];
      for (std::size_t v = 0; v < node_values(); ++v)
        start_[v % directions][e * static_cast<std::size_t>(nodes_) + v / directions] = values[v];
      if (nodes_ == 1) layout.radius[e] = values[rows.width - 1];
    }
  }
  if (root) layout.coordinates = start_;
}

/// Node positions, then the element variables, then the radius of a point.
ExodusWriter::Rows ExodusWriter::gather_rows(
    const Scene& scene, const State& state, std::size_t set
) const {
  const HostParticles particles(state.particles[set]);
  const Material& material = scene.materials[set].material;
  Rows rows;
  rows.width =
      node_values() +
      particle_field_names(material, dimensions_, optional_fields(scene, material)).size() + 1;
  std::vector<ParticleId> ids;
  std::vector<double> values;
  ids.reserve(static_cast<std::size_t>(particles.count));
  values.reserve(static_cast<std::size_t>(particles.count) * rows.width);
  for (int p = 0; p < particles.count; ++p) {
    ids.push_back(particles.id(p));
    if (nodes_ == 1) {
      for (int d = 0; d < dimensions_; ++d) values.push_back(particles.position(p, d));
    } else {
      particles.append_corners(p, values);
    }
    append_particle_fields(particles, p, material.density, values);
    double size = 1.0;
    for (int d = 0; d < dimensions_; ++d) size *= particles.half_size(p, d);
    values.push_back(std::pow(size, 1.0 / dimensions_));
  }
  for (const ParticleId id : gather_to_root(*state.grid.comm, ids))
    rows.elements.push_back(element(blocks_[set], id));
  rows.values = gather_to_root(*state.grid.comm, values);
  return rows;
}

std::size_t ExodusWriter::element(const Block& block, ParticleId id) const {
  auto after = std::upper_bound(
      block.ranges.begin(),
      block.ranges.end(),
      id,
      [](ParticleId value, const Range& range) { return value < range.first; }
  );
  if (after == block.ranges.begin() || id >= std::prev(after)->first + std::prev(after)->count)
    throw std::logic_error("particle " + std::to_string(id) + " has no place in the files");
  --after;
  return block.begin + after->begin + static_cast<std::size_t>(id - after->first);
}

void ExodusWriter::move_nodes(const Rows& rows) {
  const auto directions = static_cast<std::size_t>(dimensions_);
  for (std::size_t r = 0; r < rows.elements.size(); ++r) {
    const std::size_t e = rows.elements[r];
    for (std::size_t v = 0; v < node_values(); ++v) {
      const std::size_t d = v % directions;
      const std::size_t node = e * static_cast<std::size_t>(nodes_) + v / directions;
      displacement_[d][node] = rows.values[r * rows.width + v] - start_[d][node];
    }
  }
}

void ExodusWriter::put_block(const Scene& scene, std::size_t set, const Rows& rows) {
  const Block& block = blocks_[set];
  const std::vector<std::string> names = particle_field_names(
      scene.materials[set].material,
      dimensions_,
      optional_fields(scene, scene.materials[set].material)
  );
  std::vector<double> values(block.count);
  for (std::size_t v = 0; v < names.size(); ++v) {
    std::fill(values.begin(), values.end(), 0.0);
    for (std::size_t r = 0; r < rows.elements.size(); ++r)
      values[rows.elements[r] - block.begin] = rows.values[r * rows.width + node_values() + v];
    file_->put_variable(set, names[v], values);
  }
}

void ExodusWriter::write(const Scene& scene, const State& state) {
  const Region region("write_fields");
  const Clock& clock = state.clock;
  RootWork work(*state.grid.comm);
  work.run([&] { file_->begin_step(clock.time); });
  double present = 0.0;
  for (std::size_t b = 0; b < blocks_.size(); ++b) {
    const Rows rows = gather_rows(scene, state, b);
    present += static_cast<double>(rows.elements.size());
    work.run([&] {
      move_nodes(rows);
      put_block(scene, b, rows);
    });
  }
  work.run([&] {
    for (int d = 0; d < dimensions_; ++d)
      file_->put_displacement(d, displacement_[static_cast<std::size_t>(d)]);
    file_->put_globals({static_cast<double>(clock.step), clock.dt, present});
    file_->end_step();
  });
  work.agree();
  ++steps_;
}

void ExodusWriter::close(const Comm& comm) {
  RootWork work(comm);
  work.run([&] { file_->close(); });
  work.agree();
}

}  // namespace barreno
