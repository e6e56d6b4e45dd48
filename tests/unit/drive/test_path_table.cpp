// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "drive/path_table.hpp"

#include <gtest/gtest.h>

namespace barreno {
namespace {

const std::string header = "time,F11,F12,F13,F21,F22,F23,F31,F32,F33\n";
const std::string start = "0,1,0,0,0,1,0,0,0,1\n";

std::string problem_of(const std::string& text) {
  try {
    read_path(text, "path.csv");
  } catch (const DeckError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(PathTable, RowsColumnsAndLines) {
  const auto path = read_path("# note\n" + header + start + "\n2 us,1,2,3,0,4,5,0,0,6\n", "p");
  ASSERT_EQ(path.size(), 2u);
  EXPECT_DOUBLE_EQ(path[1].time, 2e-6);
  EXPECT_EQ(path[1].line, 5);
  const Mat3& f = path[1].deformation_gradient;
  EXPECT_EQ(f(0, 1), 2.0);
  EXPECT_EQ(f(1, 2), 5.0);
  EXPECT_EQ(f(2, 2), 6.0);
  EXPECT_EQ(f(2, 0), 0.0);
}

TEST(PathTable, ACommentMayNameTheUnitsOfTime) {
  const auto path = read_path("# units: mm-us-g\n" + header + start + "3,1,0,0,0,1,0,0,0,1\n", "p");
  EXPECT_DOUBLE_EQ(path[1].time, 3e-6);
}

TEST(PathTable, OneSentenceForEachFault) {
  EXPECT_EQ(
      problem_of("t,F11\n" + start),
      "path.csv: line 1 = \"t,F11\" is not the header of a path (the header identifies the "
      "columns); write "
      "\"time,F11,F12,F13,F21,F22,F23,F31,F32,F33\"."
  );
  EXPECT_EQ(
      problem_of(header + start),
      "path.csv: too few rows: 1 below the header (a path leads from one instant to another); "
      "give at least two."
  );
  EXPECT_EQ(
      problem_of(header + start + "1,1,0,x,0,1,0,0,0,1\n"),
      "path.csv: line 3, F13 = \"x\" is not a number (a number without unit is expected here); "
      "write "
      "for example \"0.5\"."
  );
  EXPECT_EQ(
      problem_of(header + start + "0,1,0,0,0,1,0,0,0,1\n"),
      "path.csv: line 3, time = 0 is not after 0 of line 2 (times must increase); sort the rows or "
      "correct the time."
  );
  EXPECT_EQ(
      problem_of(header + start + "1,-2,0,0,0,1,0,0,0,1\n"),
      "path.csv: line 3 has det F = -2 (volumes are positive); correct F11 to F33 of that "
      "row."
  );
  EXPECT_EQ(
      problem_of(header + "0,0,0,0,0,1,0,0,0,1\n" + start),
      "path.csv: line 2 has det F = 0 (volumes are positive); correct F11 to F33 of that "
      "row."
  );
  EXPECT_EQ(
      problem_of(header + start + "1,1,0,0\n"),
      "path.csv: line 3 has 4 values (10 are expected); write a row as "
      "time,F11,F12,F13,F21,F22,F23,F31,F32,F33."
  );
}

}  // namespace
}  // namespace barreno
