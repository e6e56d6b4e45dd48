// SPDX-License-Identifier: BSD-3-Clause
#include "files/installed_file.hpp"
#include "files/measured_table.hpp"
#include "files/text_file.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <filesystem>

namespace barreno {
namespace {

const std::vector<std::string> columns{"update", "first", "over"};
const std::string whole =
    "# times\nupdate,first,over\nmetal,28,52\nrock, plastic,1.24e3,5240\n# end of 2 rows\n";

class Measured : public ::testing::Test {
protected:
  /// What is read of a file with this text.
  MeasuredTable read(const std::string& text) {
    if (comm->getRank() == 0) write_whole_file(folder.path() / "costs.csv", text);
    comm->barrier();
    return read_measured("costs.csv", columns, folder.path());
  }
  /// The same, which must be a problem, and then no number.
  std::string problem_of(const std::string& text) {
    comm->barrier();
    const MeasuredTable table = read(text);
    EXPECT_TRUE(table.rows.empty()) << text;
    return table.problem;
  }
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
};

bool says(const std::string& text, const std::string& words) {
  return text.find(words) != std::string::npos;
}

TEST_F(Measured, IsReadInWholeANameMayHoldACommaToo) {
  const MeasuredTable table = read(whole);
  EXPECT_EQ(table.problem, "");
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[1].name, "rock, plastic");
  EXPECT_EQ(table.rows[1].numbers, (std::vector<double>{1240.0, 5240.0}));
}

TEST_F(Measured, AMissingFileIsAProblemAndNoError) {
  EXPECT_TRUE(says(
      read_measured("none.csv", columns, folder.path()).problem,
      "the measured numbers of none.csv are not installed"
  ));
  EXPECT_TRUE(says(read_measured("none.csv", columns).problem, "none.csv are not installed"));
}

TEST_F(Measured, AMissingRowIsAProblem) {
  EXPECT_TRUE(says(
      problem_of("update,first,over\nmetal,28,52\n# end of 2 rows\n"),
      "does not end with \"# end of 1 rows\": rows are missing"
  ));
  EXPECT_TRUE(says(problem_of(whole.substr(0, whole.find("# end"))), "rows are missing"));
  EXPECT_TRUE(says(problem_of(""), "rows are missing"));
}

TEST_F(Measured, ABrokenRowIsAProblemWithItsLine) {
  for (const char* row :
       {"metal,28", "metal,28,x", "metal,28,nan", "metal,28,", "metal,28,5 2", ",1,2"})
    EXPECT_TRUE(says(
        problem_of("update,first,over\n" + std::string(row) + "\n# end of 1 rows\n"),
        "costs.csv' cannot be used: line 2 is no row of update,first,over"
    )) << row;
  EXPECT_TRUE(says(
      problem_of("update,over,first\n# end of 0 rows\n"), "line 1 is not \"update,first,over\""
  ));
}

TEST(InstalledFile, IsFoundInTheFirstFolderThatHasIt) {
  const InstalledFolders folders{"no/such", BARRENO_SOURCE_DIR "/src/measured", "/no/such"};
  EXPECT_EQ(
      installed_file(folders, "update_costs.csv"),
      std::filesystem::path(BARRENO_SOURCE_DIR "/src/measured/update_costs.csv")
  );
  EXPECT_TRUE(installed_file(folders, "none.csv").empty());
}

}  // namespace
}  // namespace barreno
