// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/real.hpp"
#include "barreno/tensor.hpp"

#include <type_traits>

namespace barreno::arenisca {

// Shear stresses and strains of one or several points during a step.

/// A deviator in the plane that the stress deviator and the strain increment of a step span, in an
/// orthogonal basis of it, scaled so that sqrt(J2) is the length: a step never leaves that plane.
template <class R>
struct ShearOf {
  R a{}, b{};
};
template <class R>
BARRENO_FUNCTION ShearOf<R> operator+(const ShearOf<R>& s, const ShearOf<R>& t) {
  return {s.a + t.a, s.b + t.b};
}
template <class R>
BARRENO_FUNCTION ShearOf<R> operator-(const ShearOf<R>& s, const ShearOf<R>& t) {
  return {s.a - t.a, s.b - t.b};
}
template <class C, class R>
BARRENO_FUNCTION ShearOf<R> operator*(const C& c, const ShearOf<R>& s) {
  return {c * s.a, c * s.b};
}
/// s : t / 2, so that squared(s) = J2.
template <class R>
BARRENO_FUNCTION R dot(const ShearOf<R>& s, const ShearOf<R>& t) {
  return s.a * t.a + s.b * t.b;
}
template <class R>
BARRENO_FUNCTION R squared(const ShearOf<R>& s) {
  return s.a * s.a + s.b * s.b;
}
/// A deviator in full, for rock whose strength depends on the third invariant: its flow leaves that
/// plane.
template <class R>
struct DeviatorOf {
  Sym3Of<R> tensor;
};
template <class R>
BARRENO_FUNCTION DeviatorOf<R> operator+(const DeviatorOf<R>& s, const DeviatorOf<R>& t) {
  return {s.tensor + t.tensor};
}
template <class R>
BARRENO_FUNCTION DeviatorOf<R> operator-(const DeviatorOf<R>& s, const DeviatorOf<R>& t) {
  return {s.tensor - t.tensor};
}
template <class C, class R>
BARRENO_FUNCTION DeviatorOf<R> operator*(const C& c, const DeviatorOf<R>& s) {
  return {c * s.tensor};
}
template <class R>
BARRENO_FUNCTION R dot(const DeviatorOf<R>& s, const DeviatorOf<R>& t) {
  return 0.5 * contract(s.tensor, t.tensor);
}
template <class R>
BARRENO_FUNCTION R squared(const DeviatorOf<R>& s) {
  return 0.5 * contract(s.tensor, s.tensor);
}
/// The one that a law asks for.
template <class R, class Law>
using ShearIn = std::conditional_t<Law::angled, DeviatorOf<R>, ShearOf<R>>;

/// A shear stress of the given size made as long as `wanted`.
template <class R, template <class> class Shear>
BARRENO_FUNCTION Shear<R> lengthened(const Shear<R>& s, const R& size, const R& wanted) {
  const MaskOf<R> sheared = size > 0.0;
  return R(real::select(sheared, wanted / real::select(sheared, size, 1.0), 0.0)) * s;
}

}  // namespace barreno::arenisca
