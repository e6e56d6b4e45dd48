// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/select_members.hpp"

namespace barreno::arenisca {

// Selections between numbers of one point or several (real.hpp).

template <class R>
BARRENO_FUNCTION R smaller_of(const R& a, const R& b) {
  return real::select(a < b, a, b);
}
template <class R>
BARRENO_FUNCTION R larger_of(const R& a, const R& b) {
  return real::select(a > b, a, b);
}
template <class R>
BARRENO_FUNCTION MaskOf<R> none_of() {
  return R{} > 0.0;
}

}  // namespace barreno::arenisca
