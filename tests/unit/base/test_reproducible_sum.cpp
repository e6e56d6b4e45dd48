// SPDX-License-Identifier: BSD-3-Clause
#include "base/reproducible_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace barreno {
namespace {

ReproducibleSum sum_of(const std::vector<double>& numbers) {
  ReproducibleSum sum;
  for (const double number : numbers) sum += number;
  return sum;
}

/// Numbers of many sizes and both signs.
std::vector<double> various() {
  std::vector<double> numbers;
  numbers.reserve(2000);
  for (int i = 0; i < 2000; ++i)
    numbers.push_back(std::sin(1.7 * i + 0.3) * std::pow(10.0, 12.0 * std::sin(0.9 * i)));
  return numbers;
}

TEST(ReproducibleSum, GivesBackOneNumber) {
  for (const double size : {1e-40, 1e-20, 1e-9, 0.1, 1.0, 1.0 / 3.0, 12345.678, 1e15, 1e30})
    for (const double number : {size, -size, -size * (1.0 + 1e-15)}) {
      ReproducibleSum sum;
      sum += number;
      EXPECT_EQ(sum.value(), number);
    }
}

TEST(ReproducibleSum, IsTheSameInEveryOrderAndInParts) {
  std::vector<double> numbers = various();
  const double straight = sum_of(numbers).value();
  std::reverse(numbers.begin(), numbers.end());
  EXPECT_EQ(sum_of(numbers).value(), straight);
  ReproducibleSum whole;
  for (std::size_t begin = 0; begin < numbers.size(); begin += 7) {
    ReproducibleSum part;
    for (std::size_t i = begin; i < std::min(begin + 7, numbers.size()); ++i) part += numbers[i];
    part.carry();
    whole += part;
  }
  EXPECT_EQ(whole.value(), straight);
  whole.carry();
  EXPECT_EQ(whole.value(), straight);
  long double exact = 0.0L;
  for (const double number : numbers) exact += number;
  EXPECT_NEAR(straight / static_cast<double>(exact), 1.0, 1e-15);
}

TEST(ReproducibleSum, SmallSumsOfLargeNumbersAreExact) {
  for (const double sign : {1.0, -1.0})
    EXPECT_EQ(sum_of({1e9, sign * 1e-35, -1e9}).value(), sign * 1e-35);
  EXPECT_EQ(sum_of({0.1, -0.1}).value(), 0.0);
}

TEST(ReproducibleSum, CarryHasOneForm) {
  ReproducibleSum up, down;
  for (int i = 0; i < 1000; ++i) up += 0.75;
  for (int i = 0; i < 1000; ++i) down += 1.75;
  for (int i = 0; i < 1000; ++i) down += -1.0;
  up.carry();
  down.carry();
  EXPECT_TRUE(std::equal(std::begin(up.part), std::end(up.part), std::begin(down.part)));
}

TEST(ReproducibleSum, LeavesOutWhatIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sum_of({1.0, none, infinite, -infinite, 2.0}).value(), 3.0);
}

}  // namespace
}  // namespace barreno
