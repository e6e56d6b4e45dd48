// SPDX-License-Identifier: BSD-3-Clause
#include "step/migrate_particles.hpp"

#include "base/region.hpp"
#include "grid/migrate.hpp"

#include <cstring>
#include <vector>

namespace barreno {
namespace {

/// A particle as doubles on its way to another rank: set, id, body, then its fields.
void pack_row(Particles& particles, int p, std::vector<double>& out) {
  double id = 0.0;
  static_assert(sizeof(ParticleId) == sizeof(double), "ids travel in the place of a double");
  std::memcpy(&id, &particles.id(p), sizeof(id));
  out.push_back(particles.material);
  out.push_back(id);
  out.push_back(particles.body(p));
  particles.for_each_field([&](Field& field) {
    for (int c = 0; c < field.components; ++c) out.push_back(field(p, c));
  });
}

const double* unpack_row(const double* row, Particles& particles) {
  reserve(particles, particles.count + 1);
  const int p = particles.count++;
  std::memcpy(&particles.id(p), row + 1, sizeof(ParticleId));
  particles.body(p) = static_cast<int>(row[2]);
  put_unplaced(particles, p);
  row += 3;
  particles.for_each_field([&](Field& field) {
    for (int c = 0; c < field.components; ++c) field(p, c) = *row++;
  });
  particles.sorted = false;
  return row;
}

/// The last row takes the place of one that has gone: with particles that leave in nearly every
/// step, closing ranks would move the whole set each time. Storage order has no meaning.
void take_out_row(Particles& particles, int p) {
  const int last = --particles.count;
  particles.sorted = false;
  if (p == last) return;
  particles.id(p) = particles.id(last);
  particles.body(p) = particles.body(last);
  particles.key(p) = particles.key(last);
  particles.fault(p) = particles.fault(last);
  particles.for_each_field([=](Field& field) {
    for (int c = 0; c < field.components; ++c) field(p, c) = field(last, c);
  });
}

}  // namespace

void migrate_particles(State& state) {
  const Region region("migrate_particles");
  const Grid& grid = state.grid;
  const int me = grid.comm->getRank();
  std::vector<std::vector<double>> outgoing(static_cast<std::size_t>(grid.comm->getSize()));
  for (Particles& particles : state.particles)
    for (int p = particles.count - 1; p >= 0; --p) {
      if (particles.key(p) != unplaced_key) continue;
      const int owner = owner_of(grid, vector_of(particles.position, p));
      if (owner == me) continue;
      pack_row(particles, p, outgoing[static_cast<std::size_t>(owner)]);
      take_out_row(particles, p);
    }
  const std::vector<double> received = exchange_rows(*grid.comm, outgoing);
  for (const double* row = received.data(); row < received.data() + received.size();)
    row = unpack_row(row, state.particles[static_cast<std::size_t>(*row)]);
}

}  // namespace barreno
