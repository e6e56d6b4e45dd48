// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <barreno/find_card.hpp>
#include <barreno/input/error.hpp>
#include <barreno/models.hpp>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace barreno {
namespace {

namespace fs = std::filesystem;

const fs::path shipped = fs::path(BARRENO_SOURCE_DIR) / "materials" / "cards";

/// A directory of cards that a user has, copies of a shipped one under other names.
fs::path own_cards(const std::string& name, const std::vector<std::string>& files) {
  fs::path folder = fs::path(::testing::TempDir()) / name;
  fs::remove_all(folder);
  fs::create_directories(folder);
  for (const std::string& file : files) fs::copy_file(shipped / "tungsten.xml", folder / file);
  return folder;
}

std::string refusal(const std::string& card, const std::string& directory = "") {
  try {
    find_card(card, directory, "beside the deck");
  } catch (const FileError& error) {
    return error.what();
  }
  return "found";
}

TEST(FindCard, TakesShippedCardsByNameInAnyCase) {
  for (const char* name : {"berea_sandstone", "berea_sandstone.xml", "BEREA_SANDSTONE"}) {
    EXPECT_TRUE(fs::equivalent(find_card(name, "/nowhere"), shipped / "berea_sandstone.xml"));
    EXPECT_EQ(material_open(name).name, "berea_sandstone");
  }
}

TEST(FindCard, TakesAPathThenTheUsersDirectoriesThenTheShippedCards) {
  const fs::path beside = own_cards("beside", {"copper.xml", "brick.xml"});
  const fs::path listed = own_cards("listed", {"copper.xml", "Brick.xml", "BRICK.xml"});
  setenv("BARRENO_MATERIALS", ("/nowhere:" + listed.string()).c_str(), 1);
  EXPECT_EQ(find_card("copper", beside.string()), beside / "copper.xml");
  EXPECT_EQ(find_card((beside / "brick.xml").string()), beside / "brick.xml");
  EXPECT_EQ(find_card("copper", "/nowhere"), listed / "copper.xml");
  EXPECT_EQ(find_card("Brick", "/nowhere"), listed / "Brick.xml") << "the same case goes first";
  EXPECT_EQ(find_card("brick", "/nowhere"), listed / "BRICK.xml")
      << "else the first of a sorted list";
  unsetenv("BARRENO_MATERIALS");
  EXPECT_TRUE(fs::equivalent(find_card("copper", "/nowhere"), shipped / "copper.xml"));
}

TEST(FindCard, NamesTheNearestCard) {
  EXPECT_NE(
      refusal("berea_sandstoen.xml").find("did you mean 'berea_sandstone'?"), std::string::npos
  );
  const fs::path beside = own_cards("near", {"my_marble.xml"});
  const std::string mine = refusal("my_marbel", beside.string());
  EXPECT_NE(mine.find("beside the deck"), std::string::npos) << mine;
  EXPECT_NE(mine.find("did you mean 'my_marble'?"), std::string::npos) << mine;
  const std::string far = refusal("granite", beside.string());
  EXPECT_NE(far.find("choose one of 'aluminium_6061_fracture', "), std::string::npos) << far;
  EXPECT_EQ(far.find("my_marble"), std::string::npos) << "files of the user's may be no cards";
}

TEST(MaterialOpen, RefusesInOneSentence) {
  for (const char* card : {"", "granite"}) {
    try {
      material_open(card);
      FAIL() << "opened";
    } catch (const FileError& error) {
      EXPECT_EQ(std::string(error.what()).back(), '.') << error.what();
    }
  }
}

}  // namespace
}  // namespace barreno
