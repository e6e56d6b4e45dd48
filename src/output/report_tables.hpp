// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// src/python/barreno/report/run_tables.json: units of all fields of particles.e, the energies of
/// the ledger by their part in its balance, and the entries of a rock whose surface is the
/// published one, as particle_field_table(), the models and ledger_table() have them. The report
/// reads it, whichever version wrote the run.
std::string report_tables();

}  // namespace barreno
