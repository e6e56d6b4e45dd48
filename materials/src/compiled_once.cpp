// SPDX-License-Identifier: BSD-3-Clause
#include "barreno/arenisca/compiled_once.hpp"

#include "barreno/models.hpp"

#if BARRENO_HAS_LANES && defined(BARRENO_COMPILED_ONCE)

namespace barreno::arenisca {

BARRENO_STEPS_OF_ALL_FORMS(template)

}  // namespace barreno::arenisca

#endif
