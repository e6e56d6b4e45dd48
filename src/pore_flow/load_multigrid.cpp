// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "pore_flow/multigrid.hpp"

#include <dlfcn.h>
#include <filesystem>
#include <string>

namespace barreno {
namespace {

/// Beside the program, as it is installed; else where it was built.
std::filesystem::path find_multigrid() {
  const char* const name = "barreno_multigrid.so";
  std::error_code ignored;
  auto beside = std::filesystem::canonical("/proc/self/exe", ignored).parent_path() / name;
  if (std::filesystem::exists(beside, ignored)) return beside;
  return std::filesystem::path(BARRENO_BUILD_FOLDER) / name;
}

MakeMultigrid load_multigrid() {
  void* const library = dlopen(find_multigrid().c_str(), RTLD_NOW | RTLD_LOCAL);
  const void* const found = library == nullptr ? nullptr : dlsym(library, "barreno_multigrid");
  if (found == nullptr) {
    throw FileError(
        std::string("the multigrid preconditioner of the pore flow cannot be loaded (") +
        dlerror() + "); build or install Barreno again, or give Pore Flow an Ifpack2 list."
    );
  }
  return *static_cast<const MakeMultigrid*>(found);
}

}  // namespace

Teuchos::RCP<SparseOperator> make_multigrid(
    const Teuchos::RCP<SparseMatrix>& matrix,
    const Teuchos::ParameterList& lists,
    const Teuchos::RCP<SparseOperator>& old
) {
  static const MakeMultigrid make = load_multigrid();
  return make(matrix, lists, old);
}

}  // namespace barreno
