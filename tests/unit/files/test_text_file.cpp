// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "files/text_file.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <sys/stat.h>

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

namespace fs = std::filesystem;

/// A folder of rank 0 and a file outside of it that nobody may touch.
class PlantedFiles : public ::testing::Test {
protected:
  PlantedFiles() {
    if (mine) write_whole_file(victim, "keep");
  }
  /// The sentence of what is thrown; empty if nothing is.
  template <class Work>
  static std::string sentence_of(const Work& work) {
    try {
      work();
    } catch (const FileError& error) {
      return error.what();
    }
    return "";
  }
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Teuchos::DefaultComm<int>::getComm();
  const bool mine = comm->getRank() == 0;
  const synthetic::TemporaryFolder folder{*comm};
  const fs::path victim = folder.path() / "victim", file = folder.path() / "a.csv";
};

TEST_F(PlantedFiles, WhatIsWrittenAsideFollowsNoLink) {
  if (!mine) return;
  const fs::path aside = file.string() + ".tmp";
  fs::create_symlink(victim, aside);
  write_whole_file(file, "new");
  EXPECT_EQ(synthetic::read_text(file), "new");
  EXPECT_FALSE(fs::exists(fs::symlink_status(aside)));
  fs::create_hard_link(victim, aside);
  write_whole_file(file, "newer");
  EXPECT_EQ(synthetic::read_text(victim), "keep");
  write_whole_file(aside, "of a run that was killed");
  write_whole_file(file, "newest");
  EXPECT_EQ(synthetic::read_text(file), "newest");
  fs::create_symlink(folder.path() / "nowhere", aside);
  write_whole_file(file, "last");
  EXPECT_FALSE(fs::exists(folder.path() / "nowhere"));
  fs::create_directory(aside);
  EXPECT_NE(
      sentence_of([&] { write_whole_file(file, "x"); }).find("cannot replace"), std::string::npos
  );
  EXPECT_EQ(synthetic::read_text(file), "last");
}

TEST_F(PlantedFiles, LinesFollowNoLinkAndWaitForNoPipe) {
  if (!mine) return;
  fs::create_symlink(victim, file);
  EXPECT_NE(
      sentence_of([&] { LineFile lines(file); }).find("is a symbolic link"), std::string::npos
  );
  EXPECT_NE(
      sentence_of([&] { LineFile lines(file, 4); }).find("is a symbolic link"), std::string::npos
  );
  EXPECT_EQ(synthetic::read_text(victim), "keep");
  fs::remove(file);
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  EXPECT_NE(sentence_of([&] { LineFile lines(file); }), "");
}

TEST_F(PlantedFiles, LinesNoticeThatTheirFileIsGone) {
  if (!mine) return;
  const auto gone = [&](LineFile& lines) {
    return sentence_of([&] { lines.append("b"); }).find("removed, moved or replaced") !=
           std::string::npos;
  };
  for (int way = 0; way < 3; ++way) {
    LineFile lines(file);
    lines.append("a");
    if (way == 0) fs::remove(file);
    if (way == 1) fs::rename(file, folder.path() / "elsewhere");
    if (way == 2) write_whole_file(file, "another");
    EXPECT_TRUE(gone(lines)) << way;
  }
  EXPECT_EQ(synthetic::read_text(file), "another");
}

TEST_F(PlantedFiles, LinesGoOnWhereTheyWereLeft) {
  if (!mine) return;
  write_whole_file(file, "1\n2\n3\n");
  {
    LineFile lines(file, 4);
    lines.append("4");
    EXPECT_EQ(lines.bytes(), 6U);
  }
  EXPECT_EQ(synthetic::read_text(file), "1\n2\n4\n");
  EXPECT_NE(sentence_of([&] { LineFile lines(file, 7); }).find("is shorter"), std::string::npos);
  // Other ends of lines: six bytes are then two rows and a half.
  write_whole_file(file, "1\r\n2\r\n4\r\n");
  EXPECT_NE(
      sentence_of([&] { LineFile lines(file, 6); }).find("not what the run wrote"),
      std::string::npos
  );
  write_whole_file(file, "1,1\n2,2\n3,3\n");
  EXPECT_NE(
      sentence_of([&] { LineFile lines(file, 6); }).find("not what the run wrote"),
      std::string::npos
  );
  EXPECT_EQ(fs::file_size(file), 12U);
  fs::remove(file);
  EXPECT_NE(sentence_of([&] { LineFile lines(file, 7); }).find("is shorter"), std::string::npos);
}

}  // namespace
}  // namespace barreno
