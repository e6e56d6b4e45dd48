// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/deck.hpp"
#include "deck/sections/jet_monitor_section.hpp"
#include "scene/scene.hpp"

namespace barreno {

/// The plane that a deck asks for, its bodies found and its place checked; not present() without
/// a list Jet Monitor.
/// @throws DeckError  with one sentence
JetMonitorSpec jet_monitor_of(const Deck& deck, const Scene& scene);

}  // namespace barreno
