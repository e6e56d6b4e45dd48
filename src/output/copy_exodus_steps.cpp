// SPDX-License-Identifier: BSD-3-Clause
#include "output/copy_exodus_steps.hpp"

#include "base/error.hpp"

#include <exodusII.h>
// The header defines these two words as numbers, TRUE even as -1.
#undef TRUE
#undef FALSE

namespace barreno {
namespace {

/// An old file, open for reading.
class OldFile {
public:
  explicit OldFile(const std::filesystem::path& path) : path_(path) {
    int computed_size = 8, stored_size = 0;
    float version = 0.0F;
    ex_opts(EX_DEFAULT);
    file_ =
        ex_open(path.c_str(), EX_READ | EX_ALL_INT64_API, &computed_size, &stored_size, &version);
    if (file_ < 0) refuse("it cannot be opened");
  }
  ~OldFile() {
    if (file_ >= 0) ex_close(file_);
  }
  OldFile(const OldFile&) = delete;
  OldFile& operator=(const OldFile&) = delete;

  long long steps() const { return ex_inquire_int(file_, EX_INQ_TIME); }
  double time(int step) const {
    double time = 0.0;
    if (ex_get_time(file_, step, &time) < 0) refuse("a time is missing");
    return time;
  }
  std::vector<double> read(
      int step, ex_entity_type type, int index, long long id, std::size_t count
  ) const {
    std::vector<double> values(count);
    if (count > 0 &&
        ex_get_var(file_, step, type, index, id, static_cast<int64_t>(count), values.data()) < 0)
      refuse("a variable is missing");
    return values;
  }
  /// Of every node, one list per direction.
  std::vector<std::vector<double>> coordinates(int dimensions, std::size_t nodes) const {
    const auto found = static_cast<std::size_t>(ex_inquire_int(file_, EX_INQ_NODES));
    if (found != nodes || ex_inquire_int(file_, EX_INQ_DIM) != dimensions)
      refuse(
          "it has " + std::to_string(found) + " nodes instead of " + std::to_string(nodes) +
          ", or another number of dimensions"
      );
    std::vector<std::vector<double>> x(
        static_cast<std::size_t>(dimensions), std::vector<double>(nodes, 0.0)
    );
    double* const z = dimensions == 3 ? x.back().data() : nullptr;
    if (nodes > 0 && ex_get_coord(file_, x[0].data(), x[1].data(), z) < 0)
      refuse("its coordinates are missing");
    return x;
  }
  /// The first attribute of a block's elements.
  std::vector<double> attribute(long long block, std::size_t elements) const {
    std::vector<double> values(elements);
    if (elements > 0 &&
        ex_get_partial_one_attr(
            file_, EX_ELEM_BLOCK, block, 1, static_cast<int64_t>(elements), 1, values.data()
        ) < 0)
      refuse("the radii of its particles are missing");
    return values;
  }
  void refuse_fewer(int steps) const {
    if (this->steps() < steps)
      refuse(
          "it has " + std::to_string(this->steps()) + " time steps, but the checkpoint records " +
          std::to_string(steps)
      );
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw FileError(
        "cannot continue '" + path_.string() + "' (" + what +
        "); put the file back as the run left it, or start again with barreno run."
    );
  }

private:
  std::filesystem::path path_;
  int file_ = -1;
};

}  // namespace

void read_exodus_start(
    const std::filesystem::path& from, int steps, int dimensions, ExodusLayout& layout
) {
  const OldFile old(from);
  old.refuse_fewer(steps);
  std::size_t elements = 0;
  for (const ExodusBlock& block : layout.blocks) elements += block.ids.size();
  layout.coordinates =
      old.coordinates(dimensions, elements * static_cast<std::size_t>(layout.nodes_per_element));
  layout.radius.clear();
  for (std::size_t b = 0; layout.nodes_per_element == 1 && b < layout.blocks.size(); ++b)
    for (const double radius :
         old.attribute(static_cast<long long>(b) + 1, layout.blocks[b].ids.size()))
      layout.radius.push_back(radius);
}

std::vector<std::vector<double>> copy_exodus_steps(
    const std::filesystem::path& from, const ExodusLayout& layout, int steps, ExodusFile& to
) {
  const OldFile old(from);
  old.refuse_fewer(steps);
  std::vector<std::vector<double>> displacement(layout.coordinates.size());
  for (int step = 1; step <= steps; ++step) {
    to.begin_step(old.time(step));
    for (std::size_t b = 0; b < layout.blocks.size(); ++b)
      for (const std::string& name : layout.blocks[b].variables)
        to.put_variable(
            b,
            name,
            old.read(
                step,
                EX_ELEM_BLOCK,
                to.index_of(name),
                static_cast<long long>(b) + 1,
                layout.blocks[b].ids.size()
            )
        );
    for (std::size_t d = 0; d < displacement.size(); ++d) {
      displacement[d] =
          old.read(step, EX_NODAL, static_cast<int>(d) + 1, 1, layout.coordinates[d].size());
      to.put_displacement(static_cast<int>(d), displacement[d]);
    }
    to.put_globals(old.read(step, EX_GLOBAL, 1, 1, layout.global_variables.size()));
    to.end_step();
  }
  return displacement;
}

}  // namespace barreno
