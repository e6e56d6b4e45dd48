// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "output/json.hpp"
#include "output/text_file.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace barreno {
namespace {

TEST(Text, NumbersReadBackAsTheyWere) {
  EXPECT_EQ(to_text(0.1), "0.1");
  EXPECT_EQ(std::stod(to_text(1.0 / 3.0)), 1.0 / 3.0);
  EXPECT_EQ(to_text(std::numeric_limits<double>::infinity()), "inf");
  EXPECT_EQ(csv_line({1.0, -2.5e-7}), "1,-2.5e-07");
}

TEST(Text, IsNotCutInsideACharacter) {
  const std::string text = "ab\xC3\xA9z";  // e with an accent takes two bytes
  EXPECT_EQ(cut_text(text, 3), "ab");
  EXPECT_EQ(cut_text(text, 4), "ab\xC3\xA9");
  EXPECT_EQ(cut_text(text, 9), text);
  EXPECT_EQ(
      split_lines("one\n\n" + text, 3), (std::vector<std::string>{"one", "", "ab", "\xC3\xA9z"})
  );
}

TEST(Json, EscapesAndNests) {
  JsonWriter json;
  json.text("a", "quote \" back \\ line\n");
  json.begin_object("o");
  json.number("x", 0.5);
  json.number("bad", std::numeric_limits<double>::quiet_NaN());
  json.end_object();
  json.begin_object("empty");
  json.end_object();
  json.flag("f", true);
  EXPECT_EQ(
      json.finish(),
      "{\n  \"a\": \"quote \\\" back \\\\ line\\u000a\",\n  \"o\": {\n    \"x\": 0.5,\n    "
      "\"bad\": null\n  },\n"
      "  \"empty\": {},\n  \"f\": true\n}\n"
  );
}

TEST(TextFile, AppearsWholeOrNotAtAll) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (comm->getRank() != 0) return;
  write_whole_file(folder.path() / "a.txt", "first");
  write_whole_file(folder.path() / "a.txt", "second");
  EXPECT_EQ(synthetic::read_text(folder.path() / "a.txt"), "second");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.txt.tmp"));
  EXPECT_THROW(write_whole_file(folder.path() / "none" / "a.txt", "x"), FileError);
  EXPECT_THROW(LineFile(folder.path() / "none" / "a.csv"), FileError);
  LineFile lines(folder.path() / "b.csv");
  lines.append("1,2");
  EXPECT_EQ(synthetic::read_text(folder.path() / "b.csv"), "1,2\n");
}

TEST(TextFile, ReportsAFullDisk) {
  LineFile full("/dev/full");
  EXPECT_THROW(full.append("a row"), FileError);
}

}  // namespace
}  // namespace barreno
