// SPDX-License-Identifier: BSD-3-Clause
#include "step/contact/fit_surface_normals.hpp"

#include "base/launch.hpp"
#include "base/region.hpp"
#include "grid/halo.hpp"
#include "shape/visit_kernels.hpp"
#include "step/contact/particles_at_nodes.hpp"
#include "step/contact/separating_normal.hpp"
#include "step/nodes/node_copies.hpp"

namespace barreno {
namespace {

template <class M, class S>
struct ProjectMoments {
  static constexpr unsigned extent = M::dimensions;
  static constexpr int dimensions = M::dimensions;
  static constexpr int components = moment_components(dimensions);
  Patch patch;
  NodeCopies copies;
  ParticlesAtNodes<M, S> particles;
  ArrayView<unsigned char> shared_tile, fields;
  ArrayView<double> moments;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (shared_tile(tile) == 0) return;
    double* const values = &moments(first_value(patch, tile, components));
    particles.for_each(tile, [&](const ParticleEllipse<extent>& ellipse, int slot, double s) {
      if (fields(tile * patch.size + slot) != 0) add(ellipse, s, slot, values + slot * components);
    });
  }

  KOKKOS_INLINE_FUNCTION void add(
      const ParticleEllipse<extent>& ellipse, double s, int slot, double* out
  ) const {
    int at[3];
    copies.position(slot, at);
    double x[extent];
    for (int d = 0; d < dimensions; ++d) x[d] = ellipse.x[d] - at[d];
    *out++ += s;
    for (int d = 0; d < dimensions; ++d) *out++ += s * x[d];
    for (int i = 0; i < dimensions; ++i)
      for (int j = i; j < dimensions; ++j) {
        double own = 0.0;  // of a box about its centre: a third of its half edges' products
        for (int k = 0; k < dimensions; ++k) own += ellipse.axis[k][i] * ellipse.axis[k][j];
        *out++ += s * (x[i] * x[j] + own / 3.0);
      }
  }
};

template <unsigned D>
struct FitSurfaceNormals {
  static constexpr int dimensions = D;
  static constexpr int components = moment_components(D);
  static constexpr std::size_t extent = moment_components(D);
  NodeCopies copies;
  ArrayView<TileFrame> tile_frame;
  SymmetryPlanes planes;
  unsigned bits;  ///< of both fields
  ArrayView<unsigned char> shared_tile, fields;
  ArrayView<double> first, second, normal;

  KOKKOS_INLINE_FUNCTION void operator()(int tile) const {
    if (shared_tile(tile) == 0) return;
    const Patch& patch = copies.patch;
    for (int slot = 0; slot < patch.size; ++slot) {
      double* const n =
          &normal(first_value(patch, tile, normal_components(D))) + slot * normal_components(D);
      for (int d = 0; d < dimensions; ++d) n[d] = 0.0;
      if ((fields(tile * patch.size + slot) & bits) == bits) fit(tile, slot, n);
    }
  }
  KOKKOS_INLINE_FUNCTION void fit(int tile, int slot, double* n) const {
    double a[extent], b[extent];
    copies.add(first, components, tile, slot, a);
    copies.add(second, components, tile, slot, b);
    if (!(a[0] > 0.0) || !(b[0] > 0.0)) return;  // mass from images alone
    int at[3];
    copies.position(slot, at);
    bool mirrored[D];
    for (int d = 0; d < dimensions; ++d)
      mirrored[d] = planes.holds(d, copies.patch, tile_frame(tile).position, at[d]);
    separating_normal<D>(a, b, mirrored, n);
  }
};

template <int Components>
void clear_moments(const Grid& grid, const ContactNodes& contact) {
  const Patch patch = grid.patch;
  for (const auto& moments : contact.moments)
    launch(
        "clear_moments",
        range(grid.active),
        KOKKOS_LAMBDA(const int tile) {
          const int count = patch.size * Components;
          double* const values = &moments(first_value(patch, tile, Components));
          for (int i = 0; i < count; ++i) values[i] = 0.0;
        }
    );
}

template <class M, class S>
void project_moments(
    const Grid& grid, const std::vector<Particles>& sets, const ContactNodes& contact
) {
  constexpr int dimensions = M::dimensions;
  clear_moments<moment_components(dimensions)>(grid, contact);
  for (const Particles& particles : sets)
    launch(
        "project_moments",
        range(grid.active),
        ProjectMoments<M, S>{
            grid.patch,
            NodeCopies(grid),
            ParticlesAtNodes<M, S>(grid, contact.passes_up, particles),
            contact.shared_tile,
            contact.fields,
            contact.moments[static_cast<std::size_t>(particles.field)]}
    );
  for (const auto& moments : contact.moments)
    exchange_halo(grid, moments, moment_components(dimensions));
}

}  // namespace

void fit_surface_normals(const ContactBodies& bodies, const ContactNodes& contact) {
  const Grid& grid = bodies.grid;
  const VelocityFields& fields = bodies.fields;
  if (!has_surfaces(fields)) return;
  const Region region("fit_surface_normals");
  visit_kernels(grid, [&](auto mode, auto shape) {
    using M = decltype(mode);
    project_moments<M, decltype(shape)>(grid, bodies.sets, contact);
    for (std::size_t i = 0; i < fields.pairs.size(); ++i) {
      const FieldPair& pair = fields.pairs[i];
      if (pair.kind == ContactKind::bonded) continue;
      launch(
          "fit_surface_normals",
          range(grid.active),
          FitSurfaceNormals<M::dimensions>{
              NodeCopies(grid),
              grid.tile_frame,
              bodies.planes,
              bits_of(pair),
              contact.shared_tile,
              contact.fields,
              contact.moments[static_cast<std::size_t>(pair.a)],
              contact.moments[static_cast<std::size_t>(pair.b)],
              contact.normal[i]}
      );
    }
  });
}

}  // namespace barreno
