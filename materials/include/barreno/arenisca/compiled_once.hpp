// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_angle.hpp"
#include "barreno/arenisca/points_damage.hpp"
#include "barreno/arenisca/points_heat.hpp"
#include "barreno/arenisca/points_step.hpp"

// The steps of the library's own forms, which are long, are compiled once (src/compiled_once.cpp)
// and not in every file of this build that asks a model for an update. Forms of parts from outside
// are compiled where they are used, and so are all of them in a program that includes the installed
// headers: its compiler's flags, and with them its vectors, may be others than those of the
// library.

#if BARRENO_HAS_LANES && defined(BARRENO_COMPILED_ONCE)

namespace barreno::arenisca {

#define BARRENO_STEP_OF(KEYWORDS, ...)                                    \
  KEYWORDS void advance_step<Lanes, __VA_ARGS__>(                         \
      const __VA_ARGS__&, StepOf<Lanes, __VA_ARGS__>&, OwnSubsteps        \
  );                                                                      \
  KEYWORDS void advance_step<Lanes, __VA_ARGS__>(                         \
      const __VA_ARGS__&, StepOf<Lanes, __VA_ARGS__>&, SubstepsOfTheFirst \
  );
#define BARRENO_STEPS_OF_ALL_FORMS(KEYWORDS)       \
  BARRENO_STEP_OF(KEYWORDS, Rock)                  \
  BARRENO_STEP_OF(KEYWORDS, WetRock)               \
  BARRENO_STEP_OF(KEYWORDS, ScatteredRock<Rock>)   \
  BARRENO_STEP_OF(KEYWORDS, RatedRock<Rock>)       \
  BARRENO_STEP_OF(KEYWORDS, RatedRock<WetRock>)    \
  BARRENO_STEP_OF(KEYWORDS, AngledRock<Rock>)      \
  BARRENO_STEP_OF(KEYWORDS, AngledRock<WetRock>)   \
  BARRENO_STEP_OF(KEYWORDS, DamagedRock<Rock>)     \
  BARRENO_STEP_OF(KEYWORDS, DamagedRock<WetRock>)  \
  BARRENO_STEP_OF(KEYWORDS, HeatedRock<Rock>)      \
  BARRENO_STEP_OF(KEYWORDS, HeatedRock<WetRock>)   \
  BARRENO_STEP_OF(KEYWORDS, RatedHeatedRock<Rock>) \
  BARRENO_STEP_OF(KEYWORDS, RatedHeatedRock<WetRock>)

BARRENO_STEPS_OF_ALL_FORMS(extern template)

}  // namespace barreno::arenisca

#endif
