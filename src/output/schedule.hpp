// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace barreno {

/// Multiples of an interval that are reached: the next one is `count * interval`. Every rank counts
/// alike.
class Schedule {
public:
  explicit Schedule(double interval) : interval_(interval) {}
  bool due(double time) const {
    return interval_ > 0.0 && time / interval_ > static_cast<double>(count_) - round_off;
  }
  void done(double time) { count_ = index_after(time); }
  double next(double time) const { return static_cast<double>(index_after(time)) * interval_; }
  /// The next multiple, or the end. A multiple may be a rounding before the end, which would take a
  /// step of its own, and rows and fields twice.
  double next_until(double now, double end) const {
    if (!on()) return end;
    constexpr double small = 1e-9;
    const double multiple = next(now);
    return end - multiple > small * end ? multiple : end;
  }
  bool on() const { return interval_ > 0.0; }

private:
  static constexpr double round_off = 1e-6;
  long index_after(double time) const {
    return static_cast<long>(std::floor(time / interval_ + round_off)) + 1;
  }
  double interval_;
  long count_ = 0;
};

}  // namespace barreno
