// SPDX-License-Identifier: BSD-3-Clause
#include "deck/files/read_deck.hpp"

#include "base/digest.hpp"
#include "base/error.hpp"
#include "deck/cells_of_jet.hpp"
#include "deck/deck_schema.hpp"
#include "deck/fidelity.hpp"
#include "deck/files/assumptions_of.hpp"
#include "deck/files/find_run.hpp"
#include "deck/files/jet_breaks.hpp"
#include "deck/files/jet_table.hpp"
#include "deck/files/read_on_root.hpp"
#include "deck/files/read_solver_lists.hpp"
#include "deck/files/read_surface.hpp"
#include "deck/section_table.hpp"
#include "deck/sections/body_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/head_section.hpp"
#include "deck/sections/jet_profile_section.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/material_section.hpp"
#include "deck/sections/refinement_section.hpp"
#include "deck/sections/shape_section.hpp"
#include "deck/slugs_of_profile.hpp"

#include <algorithm>
#include <array>
#include <barreno/find_card.hpp>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>
#include <filesystem>
#include <optional>

namespace barreno {
namespace {

using input::join;
using Teuchos::ParameterList;
using Teuchos::XMLObject;

struct Reading {
  input::Source source;
  std::string directory;  ///< of the deck
  const Teuchos::Comm<int>& comm;
  Fidelity fidelity;
  std::vector<std::string> notes;
};

/// How sentences name a file that the deck includes.
std::string included(const Reading& reading, const std::string& path, const std::string& file) {
  return reading.source.name + ": " + path + " = " + input::shown(file);
}

const ModelDescription& model_of(
    const XMLObject& xml, const std::string& path, const std::string& source
) {
  const auto word = input::find_text(xml, "Model");
  if (!word) {
    input::refuse(
        source, path, "has neither Card nor Model (the material is not defined); add one of the two"
    );
  }
  try {
    return find_model(*word);
  } catch (const InputError& error) {
    input::refuse_value(source, join(path, "Model"), *word, error.what());
  }
}

/// How far the model lets the error of its integration go; nothing if it does not control that.
const input::Entry* find_tolerance(const input::Section& section) {
  for (const input::Entry& entry : section.entries)
    if (entry.name == "Tolerance") return &entry;
  return nullptr;
}

std::string load_card(const std::string& card, const std::string& path, const Reading& reading) {
  const auto read = [&] {
    try {
      return read_file(
          find_card(card, reading.directory, "beside the deck"), input::largest_text, "a card"
      );
    } catch (const FileError& error) {
      throw FileError(
          included(reading, join(path, name_of(&MaterialSection::card)), card) + " " + error.what()
      );
    } catch (const DeckError& error) {
      throw DeckError(
          included(reading, join(path, name_of(&MaterialSection::card)), card) + " " + error.what()
      );
    }
  };
  return read_on_root(read, reading.comm);
}

XMLObject parse_card(const std::string& card, const std::string& path, const Reading& reading) {
  return input::parse_xml(
      load_card(card, path, reading),
      included(reading, join(path, name_of(&MaterialSection::card)), card)
  );
}

/// A card is complete in itself; values in the deck beside it replace single ones.
ParameterList read_card_material(
    const XMLObject& xml, const std::string& card, const std::string& path, Reading& reading
) {
  const std::string source = included(reading, join(path, name_of(&MaterialSection::card)), card);
  const XMLObject card_xml = parse_card(card, path, reading);
  for (const std::string& note : assumptions_of(card_xml, card)) reading.notes.push_back(note);
  ParameterList list = scan_card(card_xml, source);
  const auto model = list.get<std::string>("Model");
  const input::Section section = material_section(find_model(model));
  if (const input::Entry* const tolerance = find_tolerance(section))
    reading.fidelity.choose_tolerance(
        xml, path, *tolerance, input::find_text(card_xml, tolerance->name)
    );
  ParameterList overrides =
      input::scan_list(xml, section, path, reading.source, input::Completeness::partial);
  if (overrides.isParameter("Model") && overrides.get<std::string>("Model") != model) {
    input::refuse_value(
        reading.source.name,
        join(path, "Model"),
        overrides.get<std::string>("Model"),
        "is not the model of the card ('" + model +
            "'); remove it or write all parameters instead of the card"
    );
  }
  overrides.remove(name_of(&MaterialSection::card));
  list.remove(name_of(&HeadSection::units));
  list.remove(name_of(&HeadSection::schema_version));
  // The effective deck names no card, so the card is remembered as the source of the numbers.
  if (!list.isParameter("Source")) list.set("Source", "card " + card);
  const input::Entry& policy = row_of<MaterialSection>(&MaterialSection::bad_particles).entry;
  list.set(policy.name, policy.default_text);
  list.setParameters(overrides);
  return list;
}

ParameterList read_material(const XMLObject& xml, const std::string& path, Reading& reading) {
  if (const auto card = input::find_text(xml, name_of(&MaterialSection::card)))
    return read_card_material(xml, *card, path, reading);
  const input::Section section = material_section(model_of(xml, path, reading.source.name));
  if (const input::Entry* const tolerance = find_tolerance(section))
    reading.fidelity.choose_tolerance(xml, path, *tolerance, {});
  return input::scan_list(xml, section, path, reading.source);
}

void read_materials(const XMLObject& root, Reading& reading, ParameterList& values) {
  const std::string& path = table_of<MaterialSection>().path;
  ParameterList& materials = values.sublist(path);
  const auto xml = input::find_list(root, path);
  for (const XMLObject& child : input::sub_lists(*xml, path, reading.source.name)) {
    const std::string& name = child.getAttribute("name");
    materials.sublist(name) = read_material(child, join(path, name), reading);
  }
}

/// The text of a file whose path is relative to the deck. @param source  how sentences name it
std::string load_beside(
    const Reading& reading,
    const std::string& file,
    const std::string& source,
    std::size_t largest,
    const char* what
) {
  const auto read = [&] {
    const auto path = std::filesystem::path(reading.directory) / file;
    std::error_code ignored;  // a name that no file can have is one that no file has
    if (!std::filesystem::exists(path, ignored))
      throw FileError(source + " names no file (paths are relative to the deck); check the path.");
    try {
      return read_file(path.string(), largest, what);
    } catch (const FileError& error) {
      throw FileError(source + ": " + error.what());
    } catch (const DeckError& error) {
      throw DeckError(source + ": " + error.what());
    }
  };
  return read_on_root(read, reading.comm);
}

/// The name of the list within Jet.
std::string profile_list() {
  const std::string& path = table_of<JetProfileSpec>().path;
  return path.substr(path.rfind('/') + 1);
}

/// A profile becomes the slugs that it stands for.
void include_jet_profile(
    const Reading& reading, const XMLObject& root, ParameterList& values, ParameterList& jet
) {
  const std::string& path = table_of<JetProfileSpec>().path;
  const std::string& source = reading.source.name;
  const Deck deck(source, values, root);
  if (mode_of(deck) == Mode::plane_strain)
    input::refuse(
        source, path, "has no meaning in plane strain (such a jet is round); give Table or Slugs"
    );
  material_at(deck, path_of(&JetSpec::material));  // refuses one that is in no list
  const auto profile = read_section<JetProfileSpec>(deck);
  const ParameterList& materials = values.sublist(table_of<MaterialSection>().path);
  const auto material = jet.get<std::string>(name_of(&JetSpec::material));
  const auto density = materials.sublist(material).get<double>("Density");
  const ProfileProblem problem = problem_of_profile(profile, density);
  if (!problem.sentence.empty() && problem.entry.empty())
    input::refuse(source, path, problem.sentence);
  if (!problem.sentence.empty()) deck.refuse_value(join(path, problem.entry), problem.sentence);
  const std::vector<JetSlug> slugs = slugs_of_profile(profile, density);
  Teuchos::TwoDArray<double> table(static_cast<int>(slugs.size()), 5);
  for (int i = 0; i < table.getNumRows(); ++i) {
    const JetSlug& slug = slugs[static_cast<std::size_t>(i)];
    const std::array row{slug.time, slug.velocity, slug.radius, slug.length, slug.density};
    std::copy(row.begin(), row.end(), table[i].begin());
  }
  jet.set(name_of(&JetSpec::slugs), table);
  jet.set(name_of(&JetSpec::pieces_below), pieces_below(profile));
  jet.remove(profile_list());
}

/// The table's rows become part of the deck, so that the effective deck needs no other file.
std::string include_jet_table(Reading& reading, const XMLObject& root, ParameterList& values) {
  const std::string &path = table_of<JetSpec>().path, &file = name_of(&JetSpec::table_file);
  const std::string& slugs = name_of(&JetSpec::slugs);
  if (!values.isSublist(path)) return {};
  ParameterList& jet = values.sublist(path);
  const std::string profile = profile_list();
  const bool has_profile = jet.isSublist(profile);
  if (int(jet.isParameter(file)) + int(jet.isParameter(slugs)) + int(has_profile) != 1) {
    input::refuse(
        reading.source.name,
        path,
        "needs " + file + ", " + slugs + " or " + profile +
            " (one of them must say what is launched); give exactly one of the three"
    );
  }
  if (has_profile) include_jet_profile(reading, root, values, jet);
  if (!jet.isParameter(file)) return {};
  auto table = jet.get<std::string>(file);
  const std::string source = included(reading, join(path, file), table);
  const std::string text = load_beside(reading, table, source, input::largest_text, "a jet table");
  std::vector<std::string> notes;
  jet.set(slugs, read_jet_table(text, source, &notes));
  for (const std::string& note : notes)
    reading.notes.push_back(std::string(table).append(": ").append(note));
  jet.remove(file);
  return table;
}

/// The digest of a surface file; one that the deck gives must be it.
std::string check_digest(
    const std::string& text, const std::string& source, const ParameterList& list
) {
  std::string digest = digest_of(text);
  if (!list.isParameter(name_of(&ShapeSection::file_digest))) return digest;
  const auto& wanted = list.get<std::string>(name_of(&ShapeSection::file_digest));
  if (wanted != digest)
    throw DeckError(
        source + " has the digest " + digest + " instead of " + input::shown(wanted) +
        " (it is not the file that the deck was written for); put that file back, or remove File "
        "Digest to take this one."
    );
  return digest;
}

/// Names the copy in the run folder for the effective deck, which lies there.
std::shared_ptr<const Surface> load_surface(
    const Reading& reading,
    const std::string& path,
    ParameterList& list,
    std::vector<SurfaceFile>& files
) {
  const auto file = list.get<std::string>(name_of(&ShapeSection::file));
  const auto place = std::filesystem::path(reading.directory) / file;
  const std::string source = included(reading, join(path, name_of(&ShapeSection::file)), file);
  const std::string text = load_beside(reading, file, source, largest_surface, "an STL surface");
  Vector shift{};
  if (list.isParameter(name_of(&ShapeSection::shift))) {
    const auto given = list.get<Teuchos::Array<double>>(name_of(&ShapeSection::shift));
    std::copy_n(
        given.begin(),
        std::min<std::size_t>(3, static_cast<std::size_t>(given.size())),
        shift.begin()
    );
  }
  const std::string digest = check_digest(text, source, list);
  files.push_back({place.string(), digest, "surface_" + digest + ".stl"});
  list.set(name_of(&ShapeSection::file), files.back().copy);
  list.set(name_of(&ShapeSection::file_digest), digest);
  const std::string& unit_entry = name_of(&ShapeSection::file_unit);
  const double unit =
      list.isParameter(unit_entry) ? list.get<double>(unit_entry) : ShapeSection{}.file_unit;
  return read_surface(text, unit, shift, source);
}

using Surfaces = std::map<std::string, std::shared_ptr<const Surface>>;

/// Surfaces of all lists that name a file; whether the list may name one is for the scene to say.
Surfaces read_surfaces(
    const Reading& reading, ParameterList& values, std::vector<SurfaceFile>& files
) {
  Surfaces surfaces;
  for (const std::string& section :
       {table_of<ShapeSection>().path, table_of<RefinedRegion>().path, table_of<BodySpec>().path}) {
    ParameterList& lists = values.sublist(section);
    std::vector<std::string> names;
    for (auto item = lists.begin(); item != lists.end(); ++item) names.push_back(lists.name(item));
    for (const std::string& name : names) {
      ParameterList& list = lists.sublist(name);
      const std::string path = join(section, name);
      if (list.isParameter(name_of(&ShapeSection::file)))
        surfaces[path] = load_surface(reading, path, list, files);
    }
  }
  return surfaces;
}

void check_version(const ParameterList& values, const std::string& source) {
  const int version = values.get<int>(name_of(&HeadSection::schema_version));
  if (version == deck_schema_version) return;
  input::refuse_value(
      source,
      name_of(&HeadSection::schema_version),
      std::to_string(version),
      "is not the version that this program reads (" + std::to_string(deck_schema_version) +
          "); convert the deck or use the program that it was written for"
  );
}

/// A list that an assignment makes beside those of the deck, one of which has nearly its name.
struct NewList {
  std::string assignment, path, nearest;
};

std::vector<std::string> lists_in(const XMLObject& list) {
  std::vector<std::string> names;
  for (int i = 0; i < list.numChildren(); ++i) {
    const XMLObject& child = list.getChild(i);
    if (child.getTag() == "ParameterList" && child.hasAttribute("name"))
      names.push_back(child.getAttribute("name"));
  }
  return names;
}

/// None at the top of the deck, where all names are known.
std::optional<NewList> new_list(const XMLObject& root, const std::string& assignment) {
  const std::string path = assignment.substr(0, assignment.find('='));
  XMLObject list = root;
  std::size_t begin = 0;
  for (std::size_t end = path.find('/'); end != std::string::npos; end = path.find('/', begin)) {
    const std::string name = path.substr(begin, end - begin);
    const auto inner = input::find_list(list, name);
    if (!inner && begin == 0) return std::nullopt;
    if (!inner) {
      const std::string nearest = input::nearest_name(name, lists_in(list));
      if (nearest.empty()) return std::nullopt;
      return NewList{assignment, path.substr(0, end), nearest};
    }
    list = *inner;
    begin = end + 1;
  }
  return std::nullopt;
}

/// What is wrong with a list that an assignment made is most likely its name.
void refuse_new_list(const std::vector<NewList>& made, const std::string& said) {
  for (const NewList& one : made) {
    const std::string named = ": " + one.path;
    if (said.find(named + "/") == std::string::npos && said.find(named + " ") == std::string::npos)
      continue;
    throw DeckError(
        "--set " + input::shown(one.assignment) + " names a list that the deck does not have (" +
        one.path + ", and a new one needs more than this); did you mean '" + one.nearest + "'?"
    );
  }
}

/// A deck with a jet may leave Grid/Cell Size open. @return what to say of it then
std::optional<std::string> settle_cell_size(
    const Reading& reading, const XMLObject& root, ParameterList& values
) {
  ParameterList& grid = values.sublist(table_of<GridSpec>().path);
  const std::string& cell_size = name_of(&GridSpec::cell_size);
  if (grid.isParameter(cell_size)) return {};
  Deck open(reading.source.name, values, root);
  open.chosen_by_fidelity = reading.fidelity.chosen_paths();
  const JetCells cells = cells_of_jet(open);
  grid.set(cell_size, cells.size);
  return cells.note;
}

/// A fidelity gives bodies few particles where it refines the jet's path. Where that does not work
/// they get as many as with equal cells. @return what to say of it then
std::optional<std::string> settle_particles(
    const Reading& reading, const XMLObject& root, ParameterList& values
) {
  const std::set<std::string>& chosen = reading.fidelity.chosen_paths();
  if (chosen.count(path_of(&JetSpec::cells_per_radius)) == 0) return {};
  const Deck open(reading.source.name, values, root);
  const std::string conflict = conflict_with_levels(open);
  if (conflict.empty()) return {};
  const int count = reading.fidelity.particles_without_path();
  const std::string& name = name_of(&BodySpec::particles_per_cell);
  ParameterList& bodies = values.sublist(table_of<BodySpec>().path);
  int few = 0;
  for (const std::string& body : open.lists(table_of<BodySpec>().path)) {
    const std::string path = join(list_of<BodySpec>(body), name);
    if (chosen.count(path) == 0 || open.integer(path) == count) continue;
    few = open.integer(path);
    bodies.sublist(body).set(name, count);
  }
  if (few == 0) return {};
  return "Bodies have " + std::to_string(count) + " particles per cell and direction, not " +
         std::to_string(few) + " as the fidelity chose for a refined path: " + conflict +
         " does not work across cells of different sizes yet.";
}

ParameterList read_values(
    const XMLObject& root, Reading& reading, const std::vector<NewList>& made
) {
  try {
    ParameterList values = input::scan_list(root, deck_schema(), "", reading.source);
    check_version(values, reading.source.name);
    values.set(name_of(&HeadSection::units), HeadSection{}.units);
    read_materials(root, reading, values);
    return values;
  } catch (const InputError& error) {
    refuse_new_list(made, error.what());
    throw;
  }
}

}  // namespace

Deck read_deck(
    const std::string& file,
    const std::vector<std::string>& overrides,
    const Teuchos::Comm<int>& comm
) {
  const std::string text =
      read_on_root([&] { return read_file(file, input::largest_text, "the deck"); }, comm);
  const std::filesystem::path path(file);
  const std::string name = path.filename().string();
  XMLObject root = input::parse_xml(text, name);
  std::vector<NewList> made;
  for (const std::string& assignment : overrides) {
    if (const auto one = new_list(root, assignment)) made.push_back(*one);
    root = input::override_value(root, assignment);
  }
  const input::UnitSystem units = input::units_of(root, name);
  Reading reading{
      {name, units},
      path.has_parent_path() ? path.parent_path().string() : ".",
      comm,
      {input::find_text(root, name_of(&HeadSection::fidelity)).value_or(""), units},
      {}};
  const bool chooses = input::find_text(root, name_of(&HeadSection::fidelity)).has_value();
  const auto parsed_card = [&](const std::string& card, const std::string& material) {
    return parse_card(card, material, reading);
  };
  reading.fidelity.choose_for_deck(root, chooses && jet_breaks(root, parsed_card));

  ParameterList values = read_values(root, reading, made);
  read_solver_lists(root, name, values);
  find_run(name, reading.directory, comm, values);
  const std::string jet_table = include_jet_table(reading, root, values);
  std::vector<SurfaceFile> surface_files;
  const auto surfaces = read_surfaces(reading, values, surface_files);
  std::vector<std::string> notes = reading.fidelity.notes();
  if (const auto note = settle_particles(reading, root, values)) notes.push_back(*note);
  if (const auto note = settle_cell_size(reading, root, values)) notes.push_back(*note);
  Deck deck(name, values, root);
  deck.surfaces = surfaces;
  deck.surface_files = surface_files;
  deck.jet_table = jet_table;
  deck.notes = notes;
  deck.chosen_by_fidelity = reading.fidelity.chosen_paths();
  deck.notes.insert(deck.notes.end(), reading.notes.begin(), reading.notes.end());
  return deck;
}

}  // namespace barreno
