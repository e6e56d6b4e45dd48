// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/piece.hpp"

namespace barreno {

double measure_of(const Box& box, int dimension) {
  double measure = 1.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    measure *= box.upper[i] - box.lower[i];
  return measure;
}

Piece whole(const Box& box, int dimension) {
  Piece piece{measure_of(box, dimension), {}};
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimension); ++i)
    piece.centroid[i] = 0.5 * (box.lower[i] + box.upper[i]);
  return piece;
}

void add(Piece& sum, const Piece& piece) {
  if (!(piece.measure > 0.0)) return;
  const double measure = sum.measure + piece.measure;
  for (std::size_t i = 0; i < 3; ++i)
    sum.centroid[i] += piece.measure / measure * (piece.centroid[i] - sum.centroid[i]);
  sum.measure = measure;
}

Piece rest_of(const Box& box, const Piece& piece, int dimension) {
  if (!(piece.measure > 0.0)) return whole(box, dimension);
  Piece rest = whole(box, dimension);
  const double measure = rest.measure - piece.measure;
  // Less than this is round-off of the difference.
  constexpr double least = 1e-12;
  if (!(measure > least * rest.measure)) return {};
  for (std::size_t i = 0; i < 3; ++i)
    rest.centroid[i] += piece.measure / measure * (rest.centroid[i] - piece.centroid[i]);
  rest.measure = measure;
  return rest;
}

}  // namespace barreno
