// SPDX-License-Identifier: BSD-3-Clause
#include "output/exodus_writer.hpp"

#include "base/error.hpp"
#include "base/region.hpp"
#include "output/copy_exodus_steps.hpp"
#include "output/particle_fields.hpp"
#include "scene/jet.hpp"
#include "shape/shape_facts.hpp"
#include "state/last_tile_steps.hpp"

#include <algorithm>
#include <array>
#include <limits>

namespace barreno {
namespace {

long long count_places(const std::vector<IdRange>& ranges) {
  long long places = 0;
  for (const IdRange& range : ranges) places += range.count;
  return places;
}

/// A rank receives at most as many values at once as MPI counts with int. Every rank finds the
/// same.
void refuse_too_many(
    const Scene& scene, const FileShares& shares, std::size_t set, int ranks, std::size_t width
) {
  const long long share = (shares.blocks[set].count + shares.files - 1) / shares.files;
  const long long open = (shares.files + ranks - 1) / ranks;
  if (share * open <= std::numeric_limits<int>::max() / static_cast<long long>(width)) return;
  throw DeckError(
      "Output/Particle Files: " + std::to_string(shares.blocks[set].count) + " particles of '" +
      scene.materials[set].name() + "' are more than one rank can write (" +
      std::to_string(shares.files) + " files on " + std::to_string(ranks) +
      " ranks); choose \"one per rank\" and more ranks."
  );
}

int nodes_of(Glyph glyph, int dimensions) {
  if (glyph == Glyph::point) return 1;
  return dimensions == 3 ? 8 : 4;
}

}  // namespace

ExodusWriter::ExodusWriter(
    const Scene& scene,
    const std::vector<IdRange>& ranges,
    const State& state,
    const std::filesystem::path& path,
    const std::string& version,
    const std::vector<std::string>& information,
    const KeptFields& kept
)
    : dimensions_(dimensions(scene.grid.mode)),
      nodes_(nodes_of(scene.output.glyph, dimensions_)),
      steps_(kept.steps),
      shares_(divide_among_files(
          ranges,
          scene.materials.size(),
          kept.files > 0
              ? kept.files
              : count_files(scene.output.files, count_places(ranges), state.grid.comm->getSize())
      )) {
  const Comm& comm = *state.grid.comm;
  for (std::size_t b = 0; b < shares_.blocks.size(); ++b)
    refuse_too_many(scene, shares_, b, comm.getSize(), row_width(scene, b));
  for (int file = 0; file < shares_.files; ++file)
    if (writing_rank(shares_, file, comm.getSize()) == comm.getRank())
      open_files_.push_back(open_file(file));
  ExodusLayout common = describe(scene, version);
  common.information = information;
  const std::vector<ExodusLayout> layouts =
      steps_ > 0 ? read_start(comm, path, common) : record_start(scene, state, common);
  RankWork open(comm);
  open.run([&] { open_files(path, layouts, steps_); });
  open.agree();
}

void ExodusWriter::open_files(
    const std::filesystem::path& path, const std::vector<ExodusLayout>& layouts, int kept
) {
  for (std::size_t h = 0; h < open_files_.size(); ++h) {
    OpenFile& open = open_files_[h];
    const std::filesystem::path name = name_in_set(path, shares_, open.number);
    open.file = std::make_unique<ExodusFile>(name, layouts[h], std::max(kept, 1));
    if (kept > 0) open.displacement = copy_exodus_steps(name, layouts[h], kept, *open.file);
  }
}

ExodusWriter::OpenFile ExodusWriter::open_file(int file) const {
  OpenFile open;
  open.number = file;
  open.begin.push_back(0);
  for (std::size_t b = 0; b < shares_.blocks.size(); ++b)
    open.begin.push_back(
        open.begin.back() +
        static_cast<std::size_t>(share_begin(shares_, b, file + 1) - share_begin(shares_, b, file))
    );
  return open;
}

/// What all files have alike.
ExodusLayout ExodusWriter::describe(const Scene& scene, const std::string& version) const {
  ExodusLayout layout;
  layout.title = scene.title;
  layout.version = version;
  layout.topology = nodes_ == 1 ? "SPHERE" : nodes_ == 4 ? "QUAD4" : "HEX8";
  layout.nodes_per_element = nodes_;
  layout.global_variables = {"step", "time_step", "particles"};
  layout.set.files = shares_.files;
  for (std::size_t b = 0; b < shares_.blocks.size(); ++b) {
    const FileShares::Block& block = shares_.blocks[b];
    layout.blocks.push_back({scene.materials[b].name(), {}, variables(scene, b)});
    layout.set.block_elements.push_back(block.count);
    if (!block.ranges.empty())
      layout.largest_id =
          std::max(layout.largest_id, block.ranges.back().first + block.ranges.back().count - 1);
  }
  return layout;
}

ExodusLayout ExodusWriter::layout_of(const OpenFile& open, const ExodusLayout& common) const {
  ExodusLayout layout = common;
  layout.set.file = open.number;
  for (std::size_t b = 0; b < layout.blocks.size(); ++b)
    layout.blocks[b].ids = ids_of(shares_, b, open.number);
  return layout;
}

std::vector<ExodusLayout> ExodusWriter::record_start(
    const Scene& scene, const State& state, const ExodusLayout& common
) {
  const auto directions = static_cast<std::size_t>(dimensions_);
  const auto nodes = static_cast<std::size_t>(nodes_);
  const double launched_size =
      grid_of_jet(scene.grid, scene.jet).cell_size / (2.0 * scene.jet.particles_per_cell);
  std::vector<ExodusLayout> layouts;
  for (OpenFile& open : open_files_) {
    layouts.push_back(layout_of(open, common));
    open.start.assign(directions, std::vector<double>(open.begin.back() * nodes, 0.0));
    open.displacement = open.start;
    std::fill(open.start[1].begin(), open.start[1].end(), scene.jet.launch_position);
    if (nodes_ == 1) layouts.back().radius.assign(open.begin.back(), launched_size);
  }
  for (std::size_t b = 0; b < shares_.blocks.size(); ++b) {
    const Rows rows = bring_rows(scene, state, {}, b);
    const std::size_t radius = node_values() + common.blocks[b].variables.size();
    for (std::size_t h = 0; h < open_files_.size(); ++h)
      for (const Rows::Row& row : rows.of_file[h]) {
        const double* values = &rows.values[row.begin];
        for (std::size_t v = 0; v < node_values(); ++v)
          open_files_[h].start[v % directions][row.element * nodes + v / directions] = values[v];
        if (nodes_ == 1) layouts[h].radius[row.element] = values[radius];
      }
  }
  for (std::size_t h = 0; h < open_files_.size(); ++h)
    layouts[h].coordinates = open_files_[h].start;
  return layouts;
}

/// That of the files as they are: particles have moved since. No file is touched unless all that
/// shall go on are there.
std::vector<ExodusLayout> ExodusWriter::read_start(
    const Comm& comm, const std::filesystem::path& path, const ExodusLayout& common
) {
  std::vector<ExodusLayout> layouts;
  RankWork find(comm);
  find.run([&] {
    for (OpenFile& open : open_files_) {
      ExodusLayout& layout = layouts.emplace_back(layout_of(open, common));
      read_exodus_start(name_in_set(path, shares_, open.number), steps_, dimensions_, layout);
      open.start = layout.coordinates;
    }
  });
  find.agree();
  return layouts;
}

std::vector<std::string> ExodusWriter::variables(const Scene& scene, std::size_t set) const {
  const MaterialSpec& material = scene.materials[set];
  return particle_field_names(material, dimensions_, optional_fields(scene, material));
}

std::size_t ExodusWriter::row_width(const Scene& scene, std::size_t set) const {
  return 1 + node_values() + variables(scene, set).size() + 1;
}

void ExodusWriter::move_nodes(const Rows& rows, std::size_t h) {
  const auto directions = static_cast<std::size_t>(dimensions_);
  OpenFile& open = open_files_[h];
  for (const Rows::Row& row : rows.of_file[h])
    for (std::size_t v = 0; v < node_values(); ++v) {
      const std::size_t d = v % directions;
      const std::size_t node = row.element * static_cast<std::size_t>(nodes_) + v / directions;
      open.displacement[d][node] = rows.values[row.begin + v] - open.start[d][node];
    }
}

void ExodusWriter::put_block(const Scene& scene, std::size_t set, const Rows& rows, std::size_t h) {
  const OpenFile& open = open_files_[h];
  const std::vector<std::string> names = variables(scene, set);
  std::vector<double> values(open.begin[set + 1] - open.begin[set]);
  for (std::size_t v = 0; v < names.size(); ++v) {
    std::fill(values.begin(), values.end(), 0.0);
    for (const Rows::Row& row : rows.of_file[h])
      values[row.element - open.begin[set]] = rows.values[row.begin + node_values() + v];
    open.file->put_variable(set, names[v], values);
  }
}

void ExodusWriter::end_step(const State& state, double present) {
  for (const OpenFile& open : open_files_) {
    for (int d = 0; d < dimensions_; ++d)
      open.file->put_displacement(d, open.displacement[static_cast<std::size_t>(d)]);
    open.file->put_globals({static_cast<double>(state.clock.step), state.clock.dt, present});
    open.file->end_step();
  }
}

void ExodusWriter::write(const Scene& scene, const State& state) {
  const Region region("write_fields");
  RankWork work(*state.grid.comm);
  work.run([&] {
    for (const OpenFile& open : open_files_) open.file->begin_step(state.clock.time);
  });
  std::array<double, 1> present{0.0};
  std::vector<double> tile_steps;
  if (scene.step.subcycles > 1) tile_steps = last_tile_steps(state);
  for (std::size_t b = 0; b < shares_.blocks.size(); ++b) {
    const Rows rows = bring_rows(scene, state, tile_steps, b);
    present[0] += static_cast<double>(state.particles[b].count);
    work.run([&] {
      for (std::size_t h = 0; h < open_files_.size(); ++h) {
        move_nodes(rows, h);
        put_block(scene, b, rows, h);
      }
    });
  }
  sum_over_ranks(*state.grid.comm, present);
  work.run([&] { end_step(state, present[0]); });
  work.agree();
  ++steps_;
}

void ExodusWriter::close(const Comm& comm) {
  RankWork work(comm);
  work.run([&] {
    for (const OpenFile& open : open_files_) open.file->close();
  });
  work.agree();
}

}  // namespace barreno
