// SPDX-License-Identifier: BSD-3-Clause
// The impulse at one node: free, stuck, sliding, bonded.
#include "step/contact/contact_law.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

constexpr double up[2] = {0.0, 1.0};

TEST(ContactLaw, SurfacesThatPartOrAreApartAreFree) {
  const double parting[2] = {3.0, 1.0}, closing[2] = {3.0, -1.0}, none[2] = {0.0, 0.0};
  for (const auto kind : {ContactKind::stick, ContactKind::friction, ContactKind::frictionless}) {
    EXPECT_EQ(contact_impulse<2>(kind, 0.5, 2.0, parting, up, 0.0).total[1], 0.0);
    EXPECT_EQ(contact_impulse<2>(kind, 0.5, 2.0, closing, up, 1.5).total[0], 0.0);
    EXPECT_EQ(contact_impulse<2>(kind, 0.5, 2.0, closing, none, 0.0).total[1], 0.0);
  }
}

TEST(ContactLaw, BondedBodiesMoveAsOneWhateverTheNormalAndTheGap) {
  const double w[2] = {3.0, 1.0}, none[2] = {0.0, 0.0};
  const auto bonded = contact_impulse<2>(ContactKind::bonded, 0.0, 2.0, w, none, 9.0);
  EXPECT_EQ(bonded.total[0], 6.0);
  EXPECT_EQ(bonded.total[1], 2.0);
}

/// They close with 1, of which 1/4 is free until the step ends: the push is 2 x 3/4, and friction
/// at most half of it.
TEST(ContactLaw, AGapIsClosedBeforeTheyPush) {
  const double w[2] = {-3.0, -1.0};
  const auto slides = contact_impulse<2>(ContactKind::friction, 0.5, 2.0, w, up, 0.25);
  EXPECT_DOUBLE_EQ(slides.total[1], -1.5);
  EXPECT_DOUBLE_EQ(slides.total[0], -0.75);
}

TEST(ContactLaw, FrictionIsTheSmallerOfStickAndItsCoefficientTimesThePush) {
  const double w[2] = {3.0, -1.0};
  const auto slides = contact_impulse<2>(ContactKind::friction, 0.5, 2.0, w, up, 0.0);
  EXPECT_DOUBLE_EQ(slides.total[0], 1.0);
  EXPECT_DOUBLE_EQ(slides.total[1], -2.0);
  EXPECT_DOUBLE_EQ(slides.tangential[0], 1.0);
  EXPECT_EQ(slides.tangential[1], 0.0);
  const auto sticks = contact_impulse<2>(ContactKind::friction, 5.0, 2.0, w, up, 0.0);
  const auto stuck = contact_impulse<2>(ContactKind::stick, 0.0, 2.0, w, up, 0.0);
  EXPECT_DOUBLE_EQ(sticks.total[0], 6.0);
  EXPECT_DOUBLE_EQ(stuck.total[0], 6.0);
  const auto smooth = contact_impulse<2>(ContactKind::frictionless, 0.0, 2.0, w, up, 0.25);
  EXPECT_EQ(smooth.total[0], 0.0);
  EXPECT_DOUBLE_EQ(smooth.total[1], -1.5);
}

}  // namespace
}  // namespace barreno
