// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_XMLObject.hpp>

#include <barreno/input/schema.hpp>
#include <barreno/input/units.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace barreno {

/// Named sets of choices between error and cost, cheapest first. What each buys is measured in
/// docs/trade.md.
std::vector<std::string> fidelity_words();

/// These, and the word for no choices at all, which takes those of a deck away.
std::vector<std::string> fidelity_choices();

/// What errors were measured with a set, in one line for `check`: pressures of a shock, smooth
/// strains of 0.3.
std::string fidelity_errors(const std::string& name);

/// All sets in one line, for the manual.
std::string fidelity_text();

/// A set of choices at work on a deck: it fills what the deck does not say, and remembers both.
class Fidelity {
public:
  /// @param name  empty: no choices are made
  /// @param units  of the deck's plain numbers
  Fidelity(const std::string& name, const input::UnitSystem& units);

  /// Everything but the materials. Bodies, jet and step are chosen for where the deck has no word
  /// of its own; the intervals of the output are parts of the run's time.
  /// @param jet_breaks  whether the jet's metal breaks
  void choose_for_deck(const Teuchos::XMLObject& root, bool jet_breaks);

  /// The tolerance of a material whose model has one.
  /// @param tolerance  the model's entry
  /// @param card  what its card says, if it has one that does
  void choose_tolerance(
      const Teuchos::XMLObject& material,
      const std::string& path,
      const input::Entry& tolerance,
      const std::optional<std::string>& card
  );

  /// All choices in force, and where the deck has other words of its own: a sentence each.
  std::vector<std::string> notes() const;
  /// Paths of the values in force that it would choose itself: a scene that cannot have one of them
  /// may leave it out.
  const std::set<std::string>& chosen_paths() const { return chosen_paths_; }
  /// Per cell and direction of bodies, where the jet's path cannot be refined; 0 without a name.
  int particles_without_path() const;

private:
  void choose_for_step(const Teuchos::XMLObject& list, const std::string& path, bool jet);
  void choose_for_jet(const Teuchos::XMLObject& list, bool given_size, bool breaks);
  void choose(
      const Teuchos::XMLObject& list,
      const std::string& path,
      const input::Entry& entry,
      const std::string& value
  );
  /// The value of a member's entry.
  template <class Spec, class T>
  void choose(
      const Teuchos::XMLObject& list, const std::string& path, T Spec::*member, const T& value
  );
  void keep(const std::string& path, const std::string& said, const std::string& value);

  std::string name_;
  input::UnitSystem units_;
  std::vector<std::string> chosen_, kept_;
  std::set<std::string> chosen_paths_;
};

}  // namespace barreno
