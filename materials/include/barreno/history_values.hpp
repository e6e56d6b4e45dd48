// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/portability.hpp"

#include <type_traits>

namespace barreno {

/// A structure that consists of members of type R alone (double or Lanes), as an array of them in
/// the order of its bases and members. The one place where this is taken for granted, and asserted;
/// that bases come in their order every compiler's interface says, and tests hold.
template <class R, class Structure>
BARRENO_FUNCTION auto* reals_of(Structure& structure) {
  static_assert(
      std::is_trivially_copyable_v<Structure>,
      "members one after the other, without a copy of their own or a table of functions"
  );
  static_assert(
      sizeof(Structure) % sizeof(R) == 0 && alignof(Structure) == alignof(R), "reals alone"
  );
  using Value = std::conditional_t<std::is_const_v<Structure>, const R, R>;
  return reinterpret_cast<Value*>(&structure);
}

/// The Model::history_count internal variables of one point, or of several (R = Lanes), in the
/// order of Model::history_table(); a null pointer where a model has none.
template <class Model, class R = double, class History>
BARRENO_FUNCTION auto* history_values(History& history) {
  using Value = std::conditional_t<std::is_const_v<History>, const R, R>;
  if constexpr (Model::history_count == 0) {
    return static_cast<Value*>(nullptr);
  } else {
    static_assert(
        sizeof(History) == sizeof(R) * Model::history_count,
        "a History holds as many reals as its model says"
    );
    return reals_of<R>(history);
  }
}

}  // namespace barreno
