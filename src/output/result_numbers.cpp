// SPDX-License-Identifier: BSD-3-Clause
#include "output/result_numbers.hpp"

#include "output/progress.hpp"
#include "output/text_file.hpp"
#include "state/balance.hpp"

namespace barreno {

std::vector<std::string> result_numbers(
    const Scene& scene,
    const RunTotals& totals,
    const Penetration& penetration,
    const RunSummary& summary,
    const Prediction& prediction
) {
  std::vector<std::string> lines;
  if (scene.jet.present)
    lines.push_back(
        penetration.met ? number_line(
                              "depth %.2f mm, open channel %.2f mm",
                              1e3 * penetration.depth,
                              1e3 * penetration.channel_depth
                          )
                        : "no depth: the jet has met no target"
    );
  const Ledger& ledger = totals.ledger;
  lines.push_back(
      number_line(
          "errors: energy %+.2e, mass %+.1e",
          energy_balance(ledger).error(),
          mass_balance(ledger).error()
      ) +
      number_line(", axial momentum %+.1e", momentum_balance(ledger).error())
  );
  lines.push_back(
      number_line("%.0f particles removed, %.0f held", total_removed(ledger).count, ledger.held)
  );
  lines.push_back(
      duration_text(summary.wall_seconds) +
      number_line(
          ", %.0f ns per particle-step, %.0f MB at most",
          totals.particle_steps > 0.0 ? 1e9 * summary.wall_seconds / totals.particle_steps : 0.0,
          1e-6 * summary.peak_resident_bytes
      )
  );
  if (prediction.seconds > 0.0)
    lines.push_back(
        "predicted: " + cost_text(prediction.seconds) +
        number_line(
            ", %.0f ns per particle-step, %.3g particle-steps (%.3g came)",
            prediction.nanoseconds,
            prediction.particle_steps,
            totals.particle_steps
        )
    );
  if (totals.skipped_steps > 0.0)
    lines.push_back(number_line(
        "%.0f %% of all particle-steps were skipped: in tiles at rest",
        100.0 * totals.skipped_steps / (totals.skipped_steps + totals.particle_steps)
    ));
  return lines;
}

}  // namespace barreno
