// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/lanes.hpp"

#if BARRENO_HAS_LANES

/// Two Lanes that take every operation one after the other: an R (real.hpp) for laws whose update
/// is a long chain of divisions, logarithms and exponentials. A processor waits for each link of
/// the chain; meanwhile it works on the other half.
namespace barreno {

struct LanePair {
  Lanes low, high;
  double operator[](int i) const { return i < lane_count ? low[i] : high[i - lane_count]; }
};
struct LanePairMask {
  LaneMask low, high;
  long long operator[](int i) const { return i < lane_count ? low[i] : high[i - lane_count]; }
};

#define BARRENO_IN_BOTH(op)                                           \
  inline LanePair operator op(const LanePair& a, const LanePair& b) { \
    return {a.low op b.low, a.high op b.high};                        \
  }                                                                   \
  inline LanePair operator op(const LanePair& a, double b) {          \
    return {a.low op b, a.high op b};                                 \
  }                                                                   \
  inline LanePair operator op(double a, const LanePair& b) {          \
    return {a op b.low, a op b.high};                                 \
  }
BARRENO_IN_BOTH(+)
BARRENO_IN_BOTH(-)
BARRENO_IN_BOTH(*)
BARRENO_IN_BOTH(/)
#undef BARRENO_IN_BOTH
inline LanePair operator-(const LanePair& a) {
  return {-a.low, -a.high};
}
inline LanePair& operator+=(LanePair& a, const LanePair& b) {
  return a = a + b;
}

#define BARRENO_COMPARE_BOTH(op)                                          \
  inline LanePairMask operator op(const LanePair& a, const LanePair& b) { \
    return {a.low op b.low, a.high op b.high};                            \
  }                                                                       \
  inline LanePairMask operator op(const LanePair& a, double b) {          \
    return {a.low op b, a.high op b};                                     \
  }
BARRENO_COMPARE_BOTH(<)
BARRENO_COMPARE_BOTH(<=)
BARRENO_COMPARE_BOTH(>)
BARRENO_COMPARE_BOTH(>=)
#undef BARRENO_COMPARE_BOTH
inline LanePairMask operator&(const LanePairMask& a, const LanePairMask& b) {
  return {a.low & b.low, a.high & b.high};
}
inline LanePairMask operator|(const LanePairMask& a, const LanePairMask& b) {
  return {a.low | b.low, a.high | b.high};
}
inline LanePairMask operator!(const LanePairMask& a) {
  return {!a.low, !a.high};
}

namespace real {

inline const Lanes& low_half(const LanePair& x) {
  return x.low;
}
inline const Lanes& high_half(const LanePair& x) {
  return x.high;
}
inline double low_half(double x) {
  return x;
}
inline double high_half(double x) {
  return x;
}
template <class Yes, class No>
inline LanePair select(const LanePairMask& choice, const Yes& yes, const No& no) {
  return {
      select(choice.low, low_half(yes), low_half(no)),
      select(choice.high, high_half(yes), high_half(no))};
}
inline bool any(const LanePairMask& choice) {
  return any(choice.low | choice.high);
}
inline bool all(const LanePairMask& choice) {
  return all(choice.low & choice.high);
}
inline LanePair abs(const LanePair& x) {
  return {abs(x.low), abs(x.high)};
}
inline LanePair sqrt(const LanePair& x) {
  return {sqrt(x.low), sqrt(x.high)};
}
inline LanePair log(const LanePair& x) {
  return {log(x.low), log(x.high)};
}
inline LanePair exp(const LanePair& x) {
  return {exp(x.low), exp(x.high)};
}
inline LanePair pow(const LanePair& x, double y) {
  return {pow(x.low, y), pow(x.high, y)};
}

}  // namespace real
}  // namespace barreno

#endif
