// SPDX-License-Identifier: BSD-3-Clause
#include "readers.hpp"

#include "base/error.hpp"
#include "deck/files/jet_table.hpp"
#include "deck/files/load_material.hpp"
#include "deck/files/read_deck.hpp"
#include "deck/files/read_on_root.hpp"
#include "deck/files/read_surface.hpp"
#include "drive/mixed_path.hpp"
#include "drive/path_table.hpp"
#include "scene/build_scene.hpp"

#include <Teuchos_DefaultSerialComm.hpp>

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <fstream>
#include <sys/stat.h>

namespace barreno::fuzz {
namespace {

namespace fs = std::filesystem;

const char* file_of(Reader reader) {
  static const char* const names[reader_count] = {
      "deck.xml", "card.xml", "jet.csv", "path.csv", "part.stl"};
  return names[static_cast<int>(reader)];
}

/// Of deformation, or of strain and stress.
void read_any_path(const std::string& text, const std::string& name) {
  if (is_mixed_path(text, name))
    read_mixed_path(text, name);
  else
    read_path(text, name);
}

void read(Reader reader, const std::string& file, const std::string& name) {
  const Teuchos::SerialComm<int> comm;
  switch (reader) {
    case Reader::deck:
      build_scene(read_deck(file, {}, comm));
      break;
    case Reader::card:
      load_material(file, {}, comm);
      break;
    case Reader::jet:
      read_jet_table(read_file(file, input::largest_text, "a jet table"), name);
      break;
    case Reader::path:
      read_any_path(read_file(file, input::largest_text, "a path"), name);
      break;
    case Reader::surface:
      read_surface(read_file(file, largest_surface, "an STL surface"), 1.0, {}, name);
      break;
  }
}

/// One line that begins with the file's name, gives a reason, and says what to do.
std::string fault_of(
    const std::string& sentence, const std::string& file, const std::string& name
) {
  constexpr std::size_t longest = 3000;
  const auto begins_with = [&](const std::string& word) { return sentence.rfind(word, 0) == 0; };
  if (!begins_with(name) && !begins_with(file)) return "does not begin with the file's name";
  const auto control = [](char c) { return static_cast<unsigned char>(c) < ' '; };
  if (std::any_of(sentence.begin(), sentence.end(), control)) return "is more than one line";
  if (sentence.back() != '.' && sentence.back() != '?') return "does not end";
  if (sentence.find("; ") == std::string::npos) return "does not say what to do";
  if (sentence.size() > longest) return "is too long";
  return {};
}

}  // namespace

const char* name_of(Reader reader) {
  static const char* const names[reader_count] = {"deck", "card", "jet", "path", "surface"};
  return names[static_cast<int>(reader)];
}

Reader reader_of(const fs::path& file, const std::string& bytes) {
  const std::string ending = file.extension().string();
  if (ending == ".stl") return Reader::surface;
  if (ending == ".csv") {
    for (const char* word : {"F11", "strain_", "stress_"})
      if (bytes.find(word) != std::string::npos) return Reader::path;
    return Reader::jet;
  }
  if (ending == ".card" || file.parent_path().filename() == "cards") return Reader::card;
  return Reader::deck;
}

void prepare_folder(const fs::path& folder) {
  fs::remove_all(folder);
  const fs::path source(BARRENO_SOURCE_DIR);
  fs::create_directories(folder / "a_folder");
  fs::copy(source / "input_xml" / "jets", folder / "jets", fs::copy_options::recursive);
  for (const auto& file : fs::directory_iterator(source / "tests" / "decks" / "bad")) {
    const std::string ending = file.path().extension().string();
    if (ending != ".xml" && ending != ".expected") fs::copy(file.path(), folder);
  }
  mkfifo((folder / "a_pipe").c_str(), 0600);
  fs::create_symlink("/dev/zero", folder / "a_device");
  std::ofstream(folder / "a_gigabyte") << "x";
  fs::resize_file(folder / "a_gigabyte", 1U << 30U);
}

Answer read_input(Reader reader, const std::string& bytes, const fs::path& folder) {
  const std::string name = file_of(reader), file = (folder / name).string();
  std::ofstream(file, std::ios::binary) << bytes;
  Answer answer;
  try {
    read(reader, file, name);
    answer.accepted = true;
  } catch (const std::exception& error) {
    answer.sentence = error.what();
    const ExitCode code = exit_code_of(error);
    answer.fault = code == ExitCode::deck || code == ExitCode::file
                       ? fault_of(answer.sentence, file, name)
                       : "is no error that a user should meet";
  }
  return answer;
}

}  // namespace barreno::fuzz
