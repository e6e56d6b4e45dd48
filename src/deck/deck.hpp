// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Teuchos_ParameterList.hpp>
#include <Teuchos_XMLObject.hpp>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace barreno {

class Surface;

/// A file of a surface, and what the folder of a run has of it.
struct SurfaceFile {
  std::string original;  ///< path
  std::string digest;    ///< digest_of() its bytes
  std::string copy;      ///< name in the run folder, which deck.xml gives it
};

/// A deck that was read: every value checked against the tables, in SI, defaults filled, cards,
/// jet table and surfaces included. Paths are "Sub List/Parameter".
class Deck {
public:
  Deck(std::string name, const Teuchos::ParameterList& values, Teuchos::XMLObject xml)
      : name_(std::move(name)), values_(values), xml_(std::move(xml)) {}

  const std::string& name() const { return name_; }
  const Teuchos::ParameterList& values() const { return values_; }
  /// What the user should know besides errors, a sentence each.
  std::vector<std::string> notes;
  /// Paths of what a fidelity chose: where it does not work, the scene leaves it out.
  std::set<std::string> chosen_by_fidelity;
  /// File of the jet table that Jet/Slugs came from; empty without one.
  std::string jet_table;
  /// What the File of a list holds, by the path of the list: "Bodies/Charge".
  std::map<std::string, std::shared_ptr<const Surface>> surfaces;
  std::vector<SurfaceFile> surface_files;

  /// A parameter or a list of that path is there (given, included or by default).
  bool has(const std::string& path) const;
  /// Names of the lists below a list, in the order of the deck.
  std::vector<std::string> lists(const std::string& path) const;

  double number(const std::string& path) const;
  int integer(const std::string& path) const;
  bool flag(const std::string& path) const;
  std::string word(const std::string& path) const;
  /// Whether a word stands where a number could.
  bool holds_word(const std::string& path) const;
  std::vector<std::string> words(const std::string& path) const;
  std::vector<double> vector(const std::string& path) const;
  std::vector<std::vector<double>> rows(const std::string& path) const;

  /// A list as it is; empty if there is none.
  Teuchos::ParameterList list(const std::string& path) const;

  /// Throws DeckError: path, the value as the user wrote it, the problem.
  [[noreturn]] void refuse_value(const std::string& path, const std::string& problem) const;
  /// Throws DeckError: path, the problem.
  [[noreturn]] void refuse(const std::string& path, const std::string& problem) const;

private:
  template <class T>
  T get(const std::string& path) const;

  std::string name_;
  Teuchos::ParameterList values_;
  Teuchos::XMLObject xml_;  ///< as the user wrote it, for sentences
};

}  // namespace barreno
