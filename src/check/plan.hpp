// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "check/notes.hpp"
#include "check/probe_cost.hpp"
#include "deck/deck.hpp"
#include "deck/sections/jet_monitor_section.hpp"
#include "scene/scene.hpp"

#include <functional>
#include <string>
#include <vector>

namespace barreno {

/// @throws DeckError if Largest Domain would cut particles that have not deformed yet
void refuse_short_domains(const Deck& deck, const Scene& scene);

/// Refuses an end that no number of steps reaches. @throws DeckError
void refuse_unreachable_end(const Deck& deck, const Scene& scene);

/// Refuses a run to rest whose jet meets nothing. @throws DeckError
void refuse_rest_without_target(const Deck& deck, const Scene& scene);

/// What the run would cost with each fidelity, a line each.
/// @param scene_with  the scene of the same deck with that fidelity
std::string fidelity_lines(const std::function<Scene(const std::string&)>& scene_with, int ranks);

/// What a run of this scene will do: bodies, what is modelled and what is not and why, particles,
/// memory, step size and number of steps. Nothing is written and no particle is kept.
/// @param ranks  of the run that is asked for; the probe is of one
/// @param monitor  of a jet that is formed in the run
std::string plan_text(
    const Scene& scene,
    const Probe& probe,
    int ranks,
    const std::vector<std::string>& notes,
    const JetMonitorSpec& monitor = {}
);

}  // namespace barreno
