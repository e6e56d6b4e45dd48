// SPDX-License-Identifier: BSD-3-Clause
// Tables whose rows are written by the ranks that have them are what HDF5 reads.
#include "base/error.hpp"
#include "base/rank_work.hpp"
#include "base/work_counts.hpp"
#include "checkpoint/crc32.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/own_rows.hpp"
#include "checkpoint/row_file.hpp"
#include "checkpoint/seal.hpp"
#include "checkpoint/write_rows.hpp"
#include "support/scenes.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>
#include <Teuchos_DefaultSerialComm.hpp>

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <libdeflate.h>
#include <random>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// Numbers of all sorts, zeros and all bits set among them.
long long number(std::size_t row, std::size_t column) {
  if (row % 5 == 0) return 0;
  if (row % 7 == 0) return -1;
  return static_cast<long long>((row * 2654435761U) << 20U ^ column * 40503U);
}

class RowsTest : public ::testing::Test {
protected:
  /// A table of so many rows of each rank; row r of all is number(r, c).
  void write(const std::vector<int>& counts, std::size_t columns) {
    const auto rank = static_cast<std::size_t>(comm->getRank());
    const std::vector<std::size_t> first = first_rows(*comm, counts.at(rank));
    RootWork begin(*comm);
    long long place = 0;
    begin.run([&] {
      Hdf5File file(path, Hdf5File::Mode::create);
      file.write("before", Hdf5Table<long long>{2, 1, {1, 2}});
      place = static_cast<long long>(file.lay_out<long long>("rows", first.back(), columns, "m"));
      file.write("behind", Hdf5Table<long long>{2, 1, {3, 4}});
      file.close();
    });
    begin.agree();
    std::vector<long long> places{place};
    max_over_ranks(*comm, places);
    const SharedTable<long long> table{
        "rows", "m", columns, [&](std::size_t begin_row, std::size_t count, long long* values) {
          for (std::size_t i = 0; i < count * columns; ++i)
            values[i] = number(first[rank] + begin_row + i / columns, i % columns);
        }};
    RankWork work(*comm);
    work.run([&] {
      RowFile rows(path);
      write_rows(
          table, static_cast<unsigned long long>(places[0]), {first[rank], first[rank + 1]}, rows
      );
      rows.read_back();
      rows.sync();
    });
    work.agree();
    seal_checkpoint(*comm, path);
  }
  void expect_rows(std::size_t rows, std::size_t columns) const {
    if (!is_root(*comm)) return;
    const Hdf5File file(path, Hdf5File::Mode::read);
    const Hdf5Table<long long> table = file.read_integers("rows");
    ASSERT_EQ(table.rows, rows);
    ASSERT_EQ(table.columns, columns);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < rows * columns; ++i)
      if (table.values[i] != number(i / columns, i % columns)) ++wrong;
    EXPECT_EQ(wrong, 0U);
    EXPECT_EQ(file.read_integers("before").values, (std::vector<long long>{1, 2}));
    EXPECT_EQ(file.read_integers("behind").values, (std::vector<long long>{3, 4}));
    EXPECT_EQ(SealedFile(Teuchos::SerialComm<int>(), path).fault(), "");
  }
  const Teuchos::RCP<const Comm> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  fs::path path = folder.path() / "table.h5";
};

TEST(RowsPerChunk, AreEvenAndOneMegabyteAtMost) {
  EXPECT_EQ(rows_of_chunk(0, 3), 1U);
  EXPECT_EQ(rows_of_chunk(7, 0), 7U);
  for (const std::size_t columns : {1U, 3U, 9U, 1000U})
    for (const std::size_t rows : {1U, 1000U, 131073U, 524288U, 3000017U}) {
      const std::size_t chunk = rows_of_chunk(rows, columns);
      const std::size_t chunks = (rows + chunk - 1) / chunk;
      EXPECT_LE(8 * chunk * columns, 1U << 20U);
      EXPECT_LT(chunks * chunk - rows, chunks) << rows << " rows of " << columns;
    }
}

TEST_F(RowsTest, AreTheRowsOfAllRanks) {
  const auto ranks = static_cast<std::size_t>(comm->getSize());
  constexpr int most = (1 << 17) / 9;  // packed at once
  for (const int count : {0, 1, most - 1, most, 3 * most + 5}) {
    // The first and the last rank have most of them; one may have none.
    for (const bool last : {false, true}) {
      std::vector<int> counts(ranks, count / 3);
      (last ? counts.back() : counts.front()) = count;
      std::size_t all = 0;
      for (const int one : counts) all += static_cast<std::size_t>(one);
      write(counts, 9);
      expect_rows(all, 9);
    }
  }
}

std::string whole_file(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST_F(RowsTest, TheSealOfAllRanksIsThatOfOne) {
  write(std::vector<int>(static_cast<std::size_t>(comm->getSize()), 20011), 3);
  if (!is_root(*comm)) return;
  const std::string by_all = whole_file(path);
  seal_checkpoint(path);
  EXPECT_EQ(by_all, whole_file(path));
}

TEST_F(RowsTest, EveryWrongBitIsFoundByTheSeal) {
  write(std::vector<int>(static_cast<std::size_t>(comm->getSize()), 70001), 2);
  comm->barrier();
  const std::string whole = whole_file(path);
  EXPECT_EQ(SealedFile(*comm, path).fault(), "");
  std::mt19937 random(1);
  for (int trial = 0; trial < 20; ++trial) {
    std::string wrong = whole;
    const std::size_t place = random() % whole.size();
    wrong[place] = static_cast<char>(wrong[place] ^ (1 << random() % 8));
    comm->barrier();
    if (is_root(*comm)) std::ofstream(path, std::ios::binary) << wrong;
    comm->barrier();
    EXPECT_NE(SealedFile(*comm, path).fault(), "") << place;
  }
}

TEST_F(RowsTest, EveryRankReadsItsPartOfTheFileForTheSeal) {
  write(std::vector<int>(static_cast<std::size_t>(comm->getSize()), 70001), 2);
  comm->barrier();
  const auto size = static_cast<long long>(fs::file_size(path) - user_block);
  const long long before = work_counts().checkpoint_bytes;
  EXPECT_EQ(SealedFile(*comm, path).fault(), "");
  std::vector<long long> read{work_counts().checkpoint_bytes - before};
  EXPECT_LE(read[0], size / comm->getSize() + comm->getSize());
  sum_over_ranks(*comm, read);
  EXPECT_EQ(read[0], size);
}

TEST_F(RowsTest, WhatIsNotReadBackAsWrittenIsRefused) {
  if (!is_root(*comm)) return;
  std::ofstream(path, std::ios::binary) << std::string(4096, 'a');
  RowFile rows(path);
  const std::string bytes(2000, 'b');
  rows.write(bytes.data(), bytes.size(), 1000);
  EXPECT_NO_THROW(rows.read_back());
  std::fstream(path, std::ios::binary | std::ios::in | std::ios::out).seekp(2999) << 'c';
  EXPECT_THROW(rows.read_back(), FileError);
  fs::resize_file(path, 2500);
  EXPECT_THROW(rows.read_back(), FileError);
}

/// A table in chunks with checksums, as rank 0 wrote all of them before, read by all ranks.
class OwnRowsTest : public RowsTest {
protected:
  static constexpr std::size_t rows = 70001, columns = 3;
  void SetUp() override {
    if (is_root(*comm)) {
      Hdf5File file(path, Hdf5File::Mode::create);
      Hdf5Table<double> table{rows, columns, std::vector<double>(rows * columns)};
      for (std::size_t i = 0; i < table.values.size(); ++i) table.values[i] = 0.5 * double(i);
      file.write("rows", table, "m");
      file.close();
    }
    comm->barrier();
  }
  /// Most rows stay together, some lie far from their like.
  int owner(std::size_t row) const {
    const auto ranks = static_cast<std::size_t>(comm->getSize());
    return static_cast<int>(row % 1000 == 0 ? row / 1000 % ranks : row * ranks / rows);
  }
};

TEST_F(OwnRowsTest, AreFoundByTheirOwnersAndReadByTheirRankAlone) {
  const Hdf5File file(path, Hdf5File::Mode::read);
  std::size_t looked_at = 0;
  const std::vector<std::size_t> found = rows_by_owner(*comm, rows, [&](std::size_t row) {
    ++looked_at;
    return owner(row);
  });
  EXPECT_LE(looked_at, rows / static_cast<std::size_t>(comm->getSize()) + 1);
  std::vector<std::size_t> wanted;
  for (std::size_t row = 0; row < rows; ++row)
    if (owner(row) == comm->getRank()) wanted.push_back(row);
  EXPECT_EQ(found, wanted);
  std::size_t next = 0, wrong = 0;
  for_own_rows<double>(found, file, "rows", [&](int p, const double* x) {
    if (static_cast<std::size_t>(p) != next++) ++wrong;
    for (std::size_t c = 0; c < columns; ++c)
      if (x[c] != 0.5 * double(found[static_cast<std::size_t>(p)] * columns + c)) ++wrong;
  });
  EXPECT_EQ(next, found.size());
  EXPECT_EQ(wrong, 0U);
}

TEST(Crc32, OfTwoPartsIsThatOfTheWhole) {
  std::mt19937 random(1);
  std::string bytes(100003, ' ');
  for (char& byte : bytes) byte = static_cast<char>(random());
  const std::uint32_t whole = libdeflate_crc32(0, bytes.data(), bytes.size());
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{1}, std::size_t{255}, bytes.size() / 3, bytes.size()}) {
    const std::uint32_t first = libdeflate_crc32(0, bytes.data(), length);
    const std::uint32_t second = libdeflate_crc32(0, bytes.data() + length, bytes.size() - length);
    EXPECT_EQ(combined_crc32(first, second, bytes.size() - length), whole) << length;
  }
}

TEST_F(RowsTest, AFileThatCannotBeMadeLeavesNoRankWaiting) {
  const std::vector<int> counts(static_cast<std::size_t>(comm->getSize()), 50000);
  comm->barrier();
  path = folder.path() / "none" / "table.h5";
  EXPECT_THROW(write(counts, 9), FileError);
}

}  // namespace
}  // namespace barreno
