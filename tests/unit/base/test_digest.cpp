// SPDX-License-Identifier: BSD-3-Clause
#include "base/digest.hpp"
#include "base/numbers.hpp"
#include "base/run_numbers.hpp"
#include "base/utf8.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace barreno {
namespace {

TEST(Digest, IsTheCrcOfZip) {
  EXPECT_EQ(digest_of("123456789"), "cbf43926");  // the check value of CRC-32/ISO-HDLC
  EXPECT_EQ(digest_of(""), "00000000");
  EXPECT_NE(digest_of(std::string("a\0b", 3)), digest_of("a"));
}

TEST(Utf8, TellsHowLongACharacterIs) {
  EXPECT_EQ(character_bytes("a", 0), 1U);
  EXPECT_EQ(character_bytes("x\xC3\xA9", 1), 2U);
  EXPECT_EQ(character_bytes("\xE2\x82\xAC", 0), 3U);
  EXPECT_EQ(character_bytes("\xF0\x9F\x99\x82", 0), 4U);
  EXPECT_EQ(character_bytes("\xC3", 0), 0U);              // cut short
  EXPECT_EQ(character_bytes("\xED\xA0\x80", 0), 0U);      // half a surrogate
  EXPECT_EQ(character_bytes("\xC0\xAF", 0), 0U);          // overlong
  EXPECT_EQ(character_bytes("\xEF\xBF\xBF", 0), 0U);      // U+FFFF
  EXPECT_EQ(character_bytes("\xF4\x90\x80\x80", 0), 0U);  // beyond U+10FFFF
}

TEST(Utf8, TakesOtherBytesForLatin1) {
  EXPECT_EQ(as_utf8("plain \xC3\xA9"), "plain \xC3\xA9");
  EXPECT_EQ(as_utf8("a\xFF"), "a\xC3\xBF");
  EXPECT_EQ(as_utf8("\xC3\xA9\xC3"), "\xC3\xA9\xC3\x83");
  EXPECT_EQ(as_utf8("\xED\xA0\x80"), "\xC3\xAD\xC2\xA0\xC2\x80");
}

TEST(RunNumbers, AreZeroWhereThereIsNone) {
  const RunNumbers numbers{{"time", {2.5, 3.0}}, {"empty", {}}};
  EXPECT_EQ(number_of(numbers, "time"), 2.5);
  EXPECT_EQ(number_of(numbers, "empty"), 0.0);
  EXPECT_EQ(number_of(numbers, "step"), 0.0);
}

TEST(Numbers, AreThoseOfMathematicsAndPhysics) {
  EXPECT_EQ(pi, std::acos(-1.0));
  EXPECT_EQ(two_pi, 2.0 * pi);
  EXPECT_EQ(speed_of_light, 299792458.0);
}

}  // namespace
}  // namespace barreno
