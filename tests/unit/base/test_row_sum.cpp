// SPDX-License-Identifier: BSD-3-Clause
#include "base/row_sum.hpp"
#include "base/split_scales.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace barreno {
namespace {

/// Numbers of both signs, most of about a size, some far smaller.
std::vector<double> numbers_of(double size, int count) {
  std::vector<double> numbers;
  numbers.reserve(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i)
    numbers.push_back(size * std::sin(1.7 * i + 0.3) * std::pow(10.0, -3.0 * (i % 5)));
  return numbers;
}

/// By runs of so many.
ReproducibleSum sum_of(
    const std::vector<double>& numbers, const SplitScales& sizes, std::size_t in_run
) {
  ReproducibleSum sum;
  for (std::size_t begin = 0; begin < numbers.size(); begin += in_run) {
    double run[rows_per_chunk];
    std::fill_n(run, rows_per_chunk, std::numeric_limits<double>::quiet_NaN());
    const std::size_t count = std::min(in_run, numbers.size() - begin);
    std::copy_n(numbers.begin() + static_cast<std::ptrdiff_t>(begin), count, run);
    add_chunk(run, static_cast<int>(count), sizes, sum);
  }
  return sum;
}

TEST(RowSum, IsTheSameInEveryOrderAndInRunsOfAnyLength) {
  for (const double size : {1.0, 3e-20, 7e11}) {
    std::vector<double> numbers = numbers_of(size, 5000);
    numbers[17] = 1e9 * size;  // too large to be split
    const SplitScales sizes(size);
    const double straight = sum_of(numbers, sizes, rows_per_chunk).value();
    for (const std::size_t in_run : {1U, 7U, 13U, 64U}) {
      std::reverse(numbers.begin(), numbers.end());
      EXPECT_EQ(sum_of(numbers, sizes, in_run).value(), straight);
    }
    std::rotate(numbers.begin(), numbers.begin() + 1234, numbers.end());
    EXPECT_EQ(sum_of(numbers, sizes, rows_per_chunk).value(), straight);
  }
}

/// Rounded at 2^-76 of the expected size each.
TEST(RowSum, IsExactToTheSmallQuantum) {
  for (const double size : {1.0, 3e-20, 7e11}) {
    const std::vector<double> numbers = numbers_of(size, 5000);
    ReproducibleSum exact;
    for (const double number : numbers) exact += number;
    const double found = sum_of(numbers, SplitScales(size), rows_per_chunk).value();
    EXPECT_NEAR(found, exact.value(), 5000.0 * std::ldexp(size, -76) + 2e-16 * std::abs(found));
  }
}

/// A wrong expectation costs digits or time, not the sum.
TEST(RowSum, HoldsWhatIsFarFromTheExpectedSize) {
  const std::vector<double> numbers = numbers_of(1.0, 640);
  ReproducibleSum exact;
  for (const double number : numbers) exact += number;
  EXPECT_EQ(sum_of(numbers, SplitScales(1e-30), rows_per_chunk).value(), exact.value());
  EXPECT_NEAR(sum_of(numbers, SplitScales(1e9), rows_per_chunk).value(), exact.value(), 1e-11);
}

TEST(RowSum, LeavesOutWhatIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sum_of({1.0, none, infinite, -infinite, 2.0}, SplitScales(1.0), 64).value(), 3.0);
}

TEST(SplitScales, RoundToAQuantumOfTheSize) {
  const SplitScales scales(3.0);  // counts as 4, the next power of two
  const double number = 1.0 / 3.0;
  const double high = (number + scales.first) - scales.first;
  const double low = (number - high + scales.second) - scales.second;
  EXPECT_EQ(std::fmod(high, std::ldexp(4.0, -31)), 0.0);
  EXPECT_LE(std::abs(number - high), std::ldexp(2.0, -31));
  EXPECT_EQ(high + low, number);
  EXPECT_EQ(scales.top, 4.0 * 8192.0);
  EXPECT_EQ(SplitScales(4.0).first, scales.first);
  EXPECT_EQ(SplitScales(4.1).first, 2.0 * scales.first);
}

}  // namespace
}  // namespace barreno
