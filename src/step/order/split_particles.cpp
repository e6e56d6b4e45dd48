// SPDX-License-Identifier: BSD-3-Clause
#include "step/order/split_particles.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"

#include <cmath>

namespace barreno {
namespace {

/// A half edge of a particle's domain.
struct HalfEdge {
  int axis = -1;  ///< of the undeformed particle; -1: none is wider than a cell
  double along[3] = {};
};

/// Which rows are to be divided, and along what.
struct FindWide {
  CellLattice lattice;
  double cell_size;
  double lower[3], upper[3];
  int dimensions;
  SplitRule rule;
  FieldView position, deformation, half_size, count;
  ArrayView<Fault> fault;
  ArrayView<int> body;

  FindWide(const Grid& grid, const Particles& particles)
      : lattice(grid),
        cell_size(grid.cell_size),
        lower{grid.lower[0], grid.lower[1], grid.lower[2]},
        upper{grid.upper[0], grid.upper[1], grid.upper[2]},
        dimensions(grid.patch.dimensions),
        rule(particles.split_rule),
        position(particles.position.values),
        deformation(particles.deformation_gradient.values),
        half_size(particles.half_size.values),
        count(rule.column < 0 ? particles.splits.values : particles.history.values),
        fault(particles.fault),
        body(particles.body) {}

  /// How often a particle was divided.
  KOKKOS_INLINE_FUNCTION int splits(int p) const {
    if (rule.column >= 0) return static_cast<int>(count(p, rule.column));
    double sum = 0.0;
    for (int i = 0; i < dimensions; ++i) sum += count(p, i);
    return static_cast<int>(sum);
  }
  KOKKOS_INLINE_FUNCTION void count_split(int p, int axis) const {
    count(p, rule.column >= 0 ? rule.column : axis) += 1.0;
    if (rule.halves) half_size(p, axis) *= 0.5;
  }
  /// Half the edge of what a particle is now of the undeformed one.
  KOKKOS_INLINE_FUNCTION double half_edge(int p, int axis) const {
    return rule.halves ? half_size(p, axis)
                       : half_size(p, axis) / (1 << static_cast<int>(count(p, axis)));
  }
  KOKKOS_INLINE_FUNCTION bool holds(const double (&x)[3]) const {
    bool inside = true;
    for (int d = 0; d < dimensions; ++d) inside = inside && x[d] >= lower[d] && x[d] < upper[d];
    return inside;
  }
  KOKKOS_INLINE_FUNCTION double cell_at(int p) const {
    if (lattice.box.levels == 1) return cell_size;
    return cell_size / (1 << lattice.level_of_tile(lattice.cell_at(position, p).box_tile));
  }
  /// Both children are in the box.
  KOKKOS_INLINE_FUNCTION bool has_room(int p, const HalfEdge& edge) const {
    double before[3] = {}, after[3] = {};
    for (int d = 0; d < dimensions; ++d) {
      before[d] = position(p, d) - 0.5 * edge.along[d];
      after[d] = position(p, d) + 0.5 * edge.along[d];
    }
    return holds(before) && holds(after);
  }
  KOKKOS_INLINE_FUNCTION HalfEdge wide_edge(int p) const {
    HalfEdge longest;
    const bool divisible = rule.body < 0 ? (body(p) & debris_bit) == 0 : body(p) == rule.body;
    if (!divisible || splits(p) >= rule.most || fault(p) != Fault::none) return longest;
    double x[3] = {};
    for (int d = 0; d < dimensions; ++d) x[d] = position(p, d);
    if (!holds(x)) return longest;
    const double bearable = 0.5 * rule.width * cell_at(p);
    double most = bearable * bearable * (1.0 + 1e-12);
    for (int i = 0; i < dimensions; ++i) {
      HalfEdge edge{i, {}};
      double square = 0.0;
      const double half = half_edge(p, i);
      for (int d = 0; d < dimensions; ++d) {
        edge.along[d] = deformation(p, d * dimensions + i) * half;
        square += edge.along[d] * edge.along[d];
      }
      if (!(square > most)) continue;
      most = square;
      longest = edge;
    }
    if (longest.axis >= 0 && !has_room(p, longest)) longest.axis = -1;
    return longest;
  }
};

/// Makes row `child` the second half of row p, and row p the first.
struct Divide {
  FindWide wide;
  bool axisymmetric;
  Particles particles;

  KOKKOS_INLINE_FUNCTION void copy(int p, int child) const {
    particles.for_each_field([&](const Field& field) {
      for (int c = 0; c < field.components; ++c) field(child, c) = field(p, c);
    });
    particles.body(child) = particles.body(p);
    particles.fault(child) = Fault::none;
    particles.key(child) = CellKey::unplaced;
  }
  /// What the second child has of mass and volume.
  KOKKOS_INLINE_FUNCTION double share(int p, const HalfEdge& edge) const {
    return axisymmetric ? 0.5 * (1.0 + 0.5 * edge.along[0] / particles.position(p, 0)) : 0.5;
  }
  KOKKOS_INLINE_FUNCTION void operator()(int p, int child) const {
    const HalfEdge edge = wide.wide_edge(p);
    const double part = share(p, edge);
    copy(p, child);
    const int before = wide.splits(p);
    particles.id(child) = particles.id(p) + (ParticleId{1} << (wide.rule.most - 1 - before));
    for (const Field* field : {&particles.mass, &particles.volume}) {
      (*field)(child, 0) = part * (*field)(p, 0);
      (*field)(p, 0) -= (*field)(child, 0);
    }
    for (int d = 0; d < wide.dimensions; ++d) {
      particles.position(child, d) += 0.5 * edge.along[d];
      particles.position(p, d) -= 0.5 * edge.along[d];
    }
    for (const int row : {p, child}) wide.count_split(row, edge.axis);
  }
};

}  // namespace

int split_particles(const Grid& grid, Particles& particles) {
  if (particles.split_rule.most == 0 || particles.rigid || particles.count == 0) return 0;
  const Region region("split_particles");
  const int count = particles.count;
  int wide = 0;
  {
    const FindWide find(grid, particles);
    const ArrayView<int> marked = particles.spare;
    launch_reduction(
        "find_wide",
        range(count),
        KOKKOS_LAMBDA(const int p, int& sum) {
          marked(p) = find.wide_edge(p).axis >= 0 ? 1 : 0;
          sum += marked(p);
        },
        wide
    );
  }
  if (wide == 0) return 0;
  reserve(particles, count + wide);
  const Divide divide{FindWide(grid, particles), grid.mode == Mode::axisymmetric, particles};
  const ArrayView<int> marked = particles.spare;
  launch_scan(
      "divide_particles",
      range(count),
      KOKKOS_LAMBDA(const int p, int& sum, const bool last) {
        if (marked(p) == 0) return;
        if (last) divide(p, count + sum);
        ++sum;
      }
  );
  particles.count += wide;
  particles.sorted = false;
  particles.settled_chunks = 0;
  return wide;
}

}  // namespace barreno
