// SPDX-License-Identifier: BSD-3-Clause
#include "host_material.hpp"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <mutex>

namespace barreno::hosts {
namespace {

std::string trimmed(const char* name) {
  std::string text(name, strnlen(name, name_length));
  const std::size_t last = text.find_last_not_of(" \t");
  text.resize(last == std::string::npos ? 0 : last + 1);
  const std::size_t first = text.find_first_not_of(" \t");
  return first == std::string::npos ? "" : text.substr(first);
}

std::string state_names(const barreno_material* m) {
  std::string names;
  for (int i = 0; i < barreno_material_state_count(m); ++i)
    names += (i == 0 ? "" : ", ") + std::string(barreno_material_state_name(m, i));
  return names;
}

void print_banner(const std::string& card, const barreno_material* m) {
  std::printf(
      " barreno %s: material %s is %s from %s; density %g kg/m3; %d state variables: %s\n",
      barreno_version(),
      card.c_str(),
      barreno_material_model(m),
      barreno_material_file(m),
      barreno_material_density(m),
      barreno_material_state_count(m),
      state_names(m).c_str()
  );
  std::fflush(stdout);
}

/// Opens a card once. Nothing is ever closed: a host may still call while it ends.
const barreno_material* open_once(const std::string& name) {
  static std::mutex mutex;
  static auto& opened = *new std::map<std::string, const barreno_material*>;
  const std::lock_guard<std::mutex> lock(mutex);
  const barreno_material*& material = opened[name];
  if (material == nullptr) {
    const std::size_t at = name.rfind('@');
    const std::string card = at == std::string::npos ? name : name.substr(at + 1);
    material = barreno_material_open(card.c_str());
    if (material == nullptr) stop("material '" + name + "': " + barreno_last_error());
    print_banner(card, material);
  }
  return material;
}

}  // namespace

void stop(const std::string& sentence) {
  std::fflush(stdout);
  std::fprintf(stderr, " *ERROR in barreno: %s\n", sentence.c_str());
  std::fflush(stderr);
  constexpr int job_failed = 201;
  std::_Exit(job_failed);
}

const barreno_material* material_of(const char* name) {
  // Points of one material follow each other: a look at the last name spares the lock.
  thread_local char last_name[name_length] = "";
  thread_local const barreno_material* last = nullptr;
  if (name == nullptr) name = std::getenv("BARRENO_CARD");
  if (name == nullptr) {
    stop(
        "the host passes no material name, which would select the card; name the card in the "
        "environment variable BARRENO_CARD."
    );
  }
  if (last != nullptr && std::strncmp(name, last_name, name_length) == 0) return last;
  last = open_once(trimmed(name));
  std::memcpy(last_name, name, strnlen(name, name_length - 1) + 1);
  return last;
}

void check_deck(const barreno_material* m, int state_count, int props_count, const double* props) {
  const int own = barreno_material_state_count(m);
  if (state_count != own) {
    stop(
        std::string(barreno_material_file(m)) + ": the deck gives this material " +
        std::to_string(state_count) + " state variables, but it has " + std::to_string(own) + " (" +
        state_names(m) + "); write *DEPVAR with " + std::to_string(own) + "."
    );
  }
  const bool version = props_count == 1 && props != nullptr && props[0] == BARRENO_ABI_VERSION;
  if (props_count == 0 || version) return;
  stop(
      std::string(barreno_material_file(m)) + ": the deck gives " + std::to_string(props_count) +
      " material constants, but the parameters of a material are in its card; write *USER MATERIAL "
      "with CONSTANTS=0, or one constant with the interface version " +
      std::to_string(BARRENO_ABI_VERSION) + "."
  );
}

}  // namespace barreno::hosts
