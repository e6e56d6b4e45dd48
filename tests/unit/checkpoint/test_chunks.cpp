// SPDX-License-Identifier: BSD-3-Clause
// Tables that are written chunk by chunk are what HDF5 reads, with the checksums that it compares.
#include "base/error.hpp"
#include "checkpoint/fletcher32.hpp"
#include "checkpoint/hdf5_file.hpp"
#include "checkpoint/write_rows.hpp"
#include "support/scenes.hpp"
#include "unit/output/synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <iterator>
#include <random>

namespace barreno {
namespace {

namespace fs = std::filesystem;

/// Word after word, as the definition has it.
std::uint32_t plain_fletcher32(const std::vector<unsigned char>& bytes) {
  std::uint64_t sum = 0, weighted = 0;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const std::uint64_t word = bytes[i] * 256U + bytes[i + 1];
    // 65535 stays: only a sum of zeros is 0.
    sum = sum + word > 65535 ? sum + word - 65535 : sum + word;
    weighted = weighted + sum > 65535 ? weighted + sum - 65535 : weighted + sum;
  }
  return static_cast<std::uint32_t>(weighted << 16 | sum);
}

TEST(Fletcher32, IsTheSumOfItsDefinition) {
  const unsigned char two_words[] = {0, 1, 0, 2};
  EXPECT_EQ(fletcher32(two_words, 4), 0x00040003U);  // 1 + 2, and 2 1 + 1 2
  EXPECT_EQ(fletcher32(nullptr, 0), 0U);
  std::mt19937 random(1);
  for (const std::size_t count : {2U, 6U, 510U, 512U, 514U, 8000U, 1U << 20U}) {
    std::vector<unsigned char> bytes(count);
    for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random());
    EXPECT_EQ(fletcher32(bytes.data(), count), plain_fletcher32(bytes)) << count << " bytes";
    bytes.assign(count, 255);
    EXPECT_EQ(fletcher32(bytes.data(), count), 0xffffffffU) << count << " bytes of ones";
    bytes.assign(count, 0);
    EXPECT_EQ(fletcher32(bytes.data(), count), 0U) << count << " zeros";
  }
}

/// Numbers of all sorts, zeros and all bits set among them.
long long number(std::size_t row, std::size_t column) {
  if (row % 5 == 0) return 0;
  if (row % 7 == 0) return -1;
  return static_cast<long long>((row * 2654435761U) << 20U ^ column * 40503U);
}

class ChunksTest : public ::testing::Test {
protected:
  /// A table of so many rows of each rank; row r of all is number(r, c).
  void write(const std::vector<int>& counts, std::size_t columns) {
    const auto rank = static_cast<std::size_t>(comm->getRank());
    const std::vector<std::size_t> first = first_rows(*comm, counts.at(rank));
    RootWork work(*comm);
    std::unique_ptr<Hdf5File> file;
    work.run([&] { file = std::make_unique<Hdf5File>(path, Hdf5File::Mode::create); });
    const SharedTable<long long> table{
        "rows", "", columns, [&](std::size_t begin, std::size_t count, long long* values) {
          for (std::size_t i = 0; i < count * columns; ++i)
            values[i] = number(first[rank] + begin + i / columns, i % columns);
        }};
    write_rows(*comm, first, table, work, file);
    work.run([&] { file->close(); });
    work.agree();
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
    EXPECT_NO_THROW(file.check("rows"));
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

TEST_F(ChunksTest, AreTheRowsOfAllRanks) {
  const auto ranks = static_cast<std::size_t>(comm->getSize());
  constexpr int most = (1 << 17) / 9;  // in one chunk
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

TEST_F(ChunksTest, EveryWrongBitOfAChunkIsFound) {
  const std::size_t rows = (1 << 16) + 100;
  std::vector<int> counts(static_cast<std::size_t>(comm->getSize()), 0);
  counts.back() = static_cast<int>(rows);
  write(counts, 2);
  if (!is_root(*comm)) return;  // one process reads
  std::ifstream stream(path, std::ios::binary);
  const std::string whole{std::istreambuf_iterator<char>(stream), {}};
  for (std::size_t row : {std::size_t{1}, rows / 2, rows - 20}) {
    while (number(row, 0) == 0 || number(row, 0) == -1) ++row;
    const long long wanted = number(row, 0);
    const std::string bytes(reinterpret_cast<const char*>(&wanted), sizeof wanted);
    const std::size_t place = whole.find(bytes);
    ASSERT_NE(place, std::string::npos);
    std::string wrong = whole;
    wrong[place] = static_cast<char>(wrong[place] ^ 4);
    std::ofstream(path, std::ios::binary) << wrong;
    const Hdf5File file(path, Hdf5File::Mode::read);
    EXPECT_THROW(file.check("rows"), FileError) << row;
    EXPECT_THROW(file.read_integers("rows"), FileError) << row;
  }
}

TEST_F(ChunksTest, AFileThatCannotBeMadeLeavesNoRankWaiting) {
  const std::vector<int> counts(static_cast<std::size_t>(comm->getSize()), 50000);
  comm->barrier();
  path = folder.path() / "none" / "table.h5";
  EXPECT_THROW(write(counts, 9), FileError);
}

}  // namespace
}  // namespace barreno
