// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/continued_tables.hpp"

#include "checkpoint/check_values.hpp"
#include "checkpoint/first_fault.hpp"
#include "files/text_file.hpp"
#include "output/radii.hpp"

#include <barreno/input/scan_xml.hpp>
#include <cmath>
#include <set>
#include <sstream>

namespace barreno {
namespace {

/// A column of a table of bodies: its name and its place in a body.
struct BodyColumn {
  const char* name;
  double CountedMass::*value;
  CountedMass ContinuedBody::*part;
};
constexpr BodyColumn body_columns[] = {
    {"taken_particles", &CountedMass::particles, &ContinuedBody::taken},
    {"taken_mass", &CountedMass::mass, &ContinuedBody::taken},
    {"left_particles", &CountedMass::particles, &ContinuedBody::left},
    {"left_mass", &CountedMass::mass, &ContinuedBody::left}};

/// Larger whole numbers are not exact as doubles.
constexpr double largest_whole = 9007199254740992.0;

/// Tables of the group, one by one.
class Tables {
public:
  explicit Tables(const RunNumbers& numbers) : numbers_(numbers) {}
  /// @throws WrongTable  if it has not so many rows, or a value that is negative or not finite
  const std::vector<double>& rows(const std::string& name, std::size_t count) const {
    const auto found = numbers_.find(name);
    if (found == numbers_.end()) throw WrongTable{"continued/" + name + " is missing", 0};
    if (found->second.size() != count)
      throw WrongTable{
          "continued/" + name + " has " + std::to_string(found->second.size()) +
              " values instead of " + std::to_string(count),
          0};
    for (const double value : found->second)
      if (!(value >= 0.0 && std::isfinite(value))) refuse(name, value);
    return found->second;
  }
  /// The same of whole numbers below a bound.
  const std::vector<double>& whole_rows(const std::string& name, std::size_t count, double bound)
      const {
    for (const double value : rows(name, count))
      if (value != std::floor(value) || value >= bound) refuse(name, value);
    return rows(name, count);
  }
  [[noreturn]] static void refuse(const std::string& name, double value) {
    throw WrongTable{"continued/" + name + " holds " + to_text(value), 0};
  }

private:
  const RunNumbers& numbers_;
};

/// Names and numbers of the bodies, without their ids.
std::vector<ContinuedBody> bodies_of(const Checkpoint& checkpoint, const Tables& tables) {
  std::vector<ContinuedBody> bodies;
  const std::string& text = checkpoint.continued_names;
  if (text.empty() || text.back() != '\n')
    throw WrongTable{text.empty() ? "continued_names is missing" : "continued_names is cut", 0};
  std::istringstream names(text);
  for (std::string name; std::getline(names, name);) {
    ContinuedBody body;
    body.name = name;
    bodies.push_back(body);
  }
  const std::vector<double>& in_deck = tables.whole_rows("in_deck", bodies.size(), 2.0);
  for (std::size_t b = 0; b < bodies.size(); ++b) bodies[b].in_deck = in_deck[b] == 1.0;
  for (const BodyColumn& column : body_columns) {
    const std::vector<double>& rows = tables.rows(column.name, bodies.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) bodies[b].*column.part.*column.value = rows[b];
  }
  return bodies;
}

/// Every body of the scene is one of them, once.
void check_names(const Scene& scene, const std::vector<ContinuedBody>& bodies) {
  std::multiset<std::string> in_deck, wanted;
  for (const ContinuedBody& body : bodies)
    if (body.in_deck) in_deck.insert(body.name);
  for (const BodySpec& body : scene.bodies) wanted.insert(input::on_one_line(body.name));
  if (in_deck != wanted)
    throw WrongTable{"continued_names are not those of the bodies of the deck", 0};
}

/// Ranges of ids, which share none.
std::vector<IdRange> ids_of(const Scene& scene, std::size_t count, const Tables& tables) {
  const auto materials = static_cast<double>(scene.materials.size());
  const std::vector<double>& material = tables.whole_rows("id_material", count, materials);
  const std::vector<double>& first = tables.whole_rows("id_first", count, largest_whole);
  const std::vector<double>& counts = tables.whole_rows("id_count", count, largest_whole);
  std::vector<IdRange> ids;
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < i; ++j)
      if (first[i] < first[j] + counts[j] && first[j] < first[i] + counts[i])
        Tables::refuse("id_first", first[i]);
    if (first[i] < 1.0) Tables::refuse("id_first", first[i]);
    ids.push_back(
        {static_cast<int>(material[i]),
         static_cast<ParticleId>(first[i]),
         static_cast<long long>(counts[i])}
    );
  }
  return ids;
}

}  // namespace

RunNumbers numbers_of(const Continued& continued) {
  RunNumbers numbers;
  if (!continued.on()) return numbers;
  numbers["time"] = {continued.time};
  numbers["half_sizes"] = continued.half_sizes;
  numbers["radii_start"] = continued.radii_start;
  for (const char* name : {"id_material", "id_first", "id_count"}) numbers[name] = {};
  for (const IdRange& range : continued.ids) {
    numbers["id_material"].push_back(range.material);
    numbers["id_first"].push_back(static_cast<double>(range.first));
    numbers["id_count"].push_back(static_cast<double>(range.count));
  }
  for (const ContinuedBody& body : continued.bodies) {
    numbers["in_deck"].push_back(body.in_deck ? 1.0 : 0.0);
    for (const BodyColumn& column : body_columns)
      numbers[column.name].push_back(body.*column.part.*column.value);
  }
  return numbers;
}

std::string names_of(const Continued& continued) {
  std::string names;
  for (const ContinuedBody& body : continued.bodies) names += body.name + "\n";
  return names;
}

Continued read_continued(const Scene& scene, const Checkpoint& checkpoint) {
  Continued continued;
  name_checkpoint(checkpoint, [&] {
    const Tables tables(checkpoint.continued);
    continued.time = tables.rows("time", 1).front();
    continued.bodies = bodies_of(checkpoint, tables);
    check_names(scene, continued.bodies);
    continued.ids = ids_of(scene, scene.bodies.size(), tables);
    continued.half_sizes = tables.rows("half_sizes", scene.materials.size());
    continued.radii_start = tables.rows("radii_start", 2 * hollow_balls(scene).size());
  });
  return continued;
}

}  // namespace barreno
