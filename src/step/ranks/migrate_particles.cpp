// SPDX-License-Identifier: BSD-3-Clause
#include "step/ranks/migrate_particles.hpp"

#include "base/exchange.hpp"
#include "base/launch.hpp"
#include "base/region.hpp"

#include <cstring>
#include <utility>

namespace barreno {
namespace {

/// A particle on its way to another rank is a row of doubles: set, id, body, then its fields.
constexpr int first_field = 3;
int row_width(const Particles& particles) {
  int width = first_field;
  particles.for_each_field([&](const Field& field) { width += field.components; });
  return width;
}

static_assert(sizeof(ParticleId) == sizeof(double), "ids travel in the place of a double");
KOKKOS_INLINE_FUNCTION double as_double(ParticleId id) {
  double bits = 0.0;
  std::memcpy(&bits, &id, sizeof bits);
  return bits;
}
KOKKOS_INLINE_FUNCTION ParticleId as_id(double bits) {
  ParticleId id = 0;
  std::memcpy(&id, &bits, sizeof id);
  return id;
}

/// Rows of a set that leave.
struct Leaving {
  ArrayView<int> row, rank;  ///< by row that leaves; ranks: where to
  int count = 0;
};

/// Marks in `spare` what is in a tile of another rank: 1.
int mark_leaving(const Grid& grid, const Particles& particles) {
  const CellLattice lattice(grid);
  const TileOwners owner = grid.owner_of_tile;
  const ArrayView<CellKey> key = particles.key;
  const ArrayView<int> leaves = particles.spare;
  const FieldView position = particles.position.values;
  const int me = grid.comm->getRank();
  int count = 0;
  launch_reduction(
      "mark_leaving",
      range(particles.count),
      KOKKOS_LAMBDA(const int p, int& sum) {
        leaves(p) =
            !is_placed(key(p)) && owner(lattice.cell_at(position, p).box_tile) != me ? 1 : 0;
        sum += leaves(p);
      },
      count
  );
  return count;
}

/// The marked rows in their order, and where they go.
Leaving list_leaving(const Grid& grid, const Particles& particles, int count) {
  const auto rows = static_cast<std::size_t>(count);
  Leaving leaving{ArrayView<int>("row", rows), ArrayView<int>("rank", rows), count};
  const CellLattice lattice(grid);
  const TileOwners owner = grid.owner_of_tile;
  const ArrayView<int> leaves = particles.spare;
  const FieldView position = particles.position.values;
  launch_scan(
      "list_leaving",
      range(particles.count),
      KOKKOS_LAMBDA(const int p, int& sum, const bool last) {
        if (last && leaves(p) != 0) {
          leaving.row(sum) = p;
          leaving.rank(sum) = owner(lattice.cell_at(position, p).box_tile);
        }
        sum += leaves(p);
      }
  );
  return leaving;
}

/// Rows as doubles, one behind the other.
ArrayView<double> pack_rows(const Leaving& leaving, const Particles& particles) {
  const int width = row_width(particles);
  ArrayView<double> packed("packed", static_cast<std::size_t>(leaving.count * width));
  const ArrayView<ParticleId> id = particles.id;
  const ArrayView<int> body = particles.body;
  const auto set = static_cast<double>(particles.material);
  launch(
      "pack_ids",
      range(leaving.count),
      KOKKOS_LAMBDA(const int k) {
        packed(k * width) = set;
        packed(k * width + 1) = as_double(id(leaving.row(k)));
        packed(k * width + 2) = body(leaving.row(k));
      }
  );
  int at = first_field;
  particles.for_each_field([&](const Field& field) {
    const FieldView values = field.values;
    const int components = field.components, first = at;
    launch(
        "pack_field",
        range(leaving.count),
        KOKKOS_LAMBDA(const int k) {
          for (int c = 0; c < components; ++c)
            packed(k * width + first + c) = values(leaving.row(k), c);
        }
    );
    at += components;
  });
  return packed;
}

/// A set's rows that leave into the buffers of their ranks, which MPI sends from the host.
void take_out_leaving(
    const Grid& grid, Particles& particles, std::vector<std::vector<double>>& outgoing
) {
  const int count = mark_leaving(grid, particles);
  if (count == 0) return;
  const Leaving leaving = list_leaving(grid, particles, count);
  const auto packed =
      Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), pack_rows(leaving, particles));
  const auto rank = Kokkos::create_mirror_view_and_copy(Kokkos::HostSpace(), leaving.rank);
  const int width = row_width(particles);
  for (int k = 0; k < count; ++k) {
    std::vector<double>& buffer = outgoing[static_cast<std::size_t>(rank(k))];
    const double* const row = packed.data() + static_cast<std::ptrdiff_t>(k) * width;
    buffer.insert(buffer.end(), row, row + width);
  }
  remove_marked_rows(particles, count);
}

/// Adds packed rows to the end of their set.
void put_rows(const std::vector<double>& rows, Particles& particles) {
  if (rows.empty()) return;
  const int width = row_width(particles);
  const int count = static_cast<int>(rows.size()) / width;
  const Kokkos::View<const double*, Kokkos::HostSpace, Kokkos::MemoryUnmanaged> from(
      rows.data(), rows.size()
  );
  const auto packed = Kokkos::create_mirror_view_and_copy(MemorySpace(), from);
  const int first_row = particles.count;
  reserve(particles, first_row + count);
  particles.count += count;
  particles.sorted = false;
  const ArrayView<ParticleId> id = particles.id;
  const ArrayView<int> body = particles.body;
  const ArrayView<CellKey> key = particles.key;
  const ArrayView<Fault> fault = particles.fault;
  launch(
      "unpack_ids",
      range(count),
      KOKKOS_LAMBDA(const int k) {
        const int p = first_row + k;
        id(p) = as_id(packed(k * width + 1));
        body(p) = static_cast<int>(packed(k * width + 2));
        key(p) = CellKey::unplaced;
        fault(p) = Fault::none;
      }
  );
  int at = first_field;
  particles.for_each_field([&](Field& field) {
    const FieldView values = field.values;
    const int components = field.components, first = at;
    launch(
        "unpack_field",
        range(count),
        KOKKOS_LAMBDA(const int k) {
          for (int c = 0; c < components; ++c)
            values(first_row + k, c) = packed(k * width + first + c);
        }
    );
    at += components;
  });
}

}  // namespace

std::vector<int> migrate_particles(const Grid& grid, std::vector<Particles>& sets) {
  const Region region("migrate_particles");
  std::vector<std::vector<double>> outgoing(static_cast<std::size_t>(grid.comm->getSize()));
  for (Particles& particles : sets) take_out_leaving(grid, particles, outgoing);
  const std::vector<double> received = exchange_rows(*grid.comm, outgoing);

  std::vector<std::vector<double>> of_set(sets.size());
  for (auto row = received.begin(); row != received.end();) {
    const auto set = static_cast<std::size_t>(*row);
    const auto end = row + row_width(sets[set]);
    of_set[set].insert(of_set[set].end(), row, end);
    row = end;
  }
  std::vector<int> first_row;
  for (std::size_t s = 0; s < sets.size(); ++s) {
    first_row.push_back(sets[s].count);
    put_rows(of_set[s], sets[s]);
  }
  return first_row;
}

}  // namespace barreno
