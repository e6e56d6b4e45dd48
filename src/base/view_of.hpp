// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/types.hpp"

#include <string>
#include <vector>

namespace barreno {

/// A copy of values for kernels.
/// @param name  of the view, for Kokkos
template <class T>
ArrayView<T> view_of(const char* name, const std::vector<T>& values) {
  ArrayView<T> view(std::string(name), values.size());
  const auto host = Kokkos::create_mirror_view(view);
  for (std::size_t i = 0; i < values.size(); ++i) host(i) = values[i];
  Kokkos::deep_copy(view, host);
  return view;
}

/// A view of at least so many values, with room for more when it must grow; what was in it is then
/// lost.
template <class View>
void make_room(const char* name, std::size_t values, View& view) {
  if (view.extent(0) < values) view = View(std::string(name), 2 * values);
}

}  // namespace barreno
