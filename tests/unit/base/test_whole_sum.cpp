// SPDX-License-Identifier: BSD-3-Clause
#include "base/whole_sum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

namespace barreno {
namespace {

WholeSum sum_of(const std::vector<double>& numbers) {
  WholeSum sum;
  for (const double number : numbers) sum.add(number);
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

TEST(WholeSum, GivesBackOneNumber) {
  for (const double size : {1e-9, 0.1, 1.0, 1.0 / 3.0, 12345.678, 1e15})
    for (const double number : {size, -size, -size * (1.0 + 1e-15)}) {
      WholeSum sum;
      sum.add(number);
      EXPECT_NEAR(sum.value(), number, 1e-24 + 2e-16 * size);
    }
}

TEST(WholeSum, IsTheSameInEveryOrderAndInParts) {
  std::vector<double> numbers = various();
  const double straight = sum_of(numbers).value();
  std::reverse(numbers.begin(), numbers.end());
  EXPECT_EQ(sum_of(numbers).value(), straight);
  WholeSum whole;
  for (std::size_t begin = 0; begin < numbers.size(); begin += 7) {
    WholeSum part;
    for (std::size_t i = begin; i < std::min(begin + 7, numbers.size()); ++i) part.add(numbers[i]);
    part.carry();
    whole.add(part);
  }
  EXPECT_EQ(whole.value(), straight);
  whole.carry();
  EXPECT_EQ(whole.value(), straight);
  long double exact = 0.0L;
  for (const double number : numbers) exact += number;
  EXPECT_NEAR(straight / static_cast<double>(exact), 1.0, 1e-15);
}

TEST(WholeSum, SmallSumsOfLargeNumbersAreExact) {
  for (const double sign : {1.0, -1.0})
    EXPECT_NEAR(sum_of({1e9, sign * 1e-15, -1e9}).value() / (sign * 1e-15), 1.0, 1e-9);
  EXPECT_EQ(sum_of({0.1, -0.1}).value(), 0.0);
}

TEST(WholeSum, CarryHasOneForm) {
  WholeSum up, down;
  for (int i = 0; i < 1000; ++i) up.add(0.75);
  for (int i = 0; i < 1000; ++i) down.add(1.75);
  for (int i = 0; i < 1000; ++i) down.add(-1.0);
  up.carry();
  down.carry();
  EXPECT_TRUE(std::equal(std::begin(up.part), std::end(up.part), std::begin(down.part)));
}

TEST(WholeSum, LeavesOutWhatIsNoNumber) {
  const double none = std::numeric_limits<double>::quiet_NaN(),
               infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(sum_of({1.0, none, infinite, -infinite, 2.0}).value(), 3.0);
}

}  // namespace
}  // namespace barreno
