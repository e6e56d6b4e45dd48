// SPDX-License-Identifier: BSD-3-Clause
/// Random bad calls of the C interface: none may crash, return a value that is not finite, or
/// change a point that failed.
///
///     fuzz_c_interface CALLS SEED CARD...
///
/// A card is a name or a path, or CARD+WORD+WORD with the words of general_words.hpp.
#include "general_words.hpp"

#include <barreno_material.h>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace {

using Engine = std::mt19937_64;

bool chance(Engine& engine, double probability) {
  return std::uniform_real_distribution<double>(0.0, 1.0)(engine) < probability;
}

/// A number that a broken host may hand over.
double bad_number(Engine& engine) {
  static const double bad[] = {
      std::nan(""),
      HUGE_VAL,
      -HUGE_VAL,
      0.0,
      -0.0,
      1.0,
      -1.0,
      0.5,
      10.0,
      -10.0,
      1e-320,
      1e-200,
      1e8,
      -1e8,
      1e30,
      -1e30,
      1e155,
      -1e155,
      1e300,
      -1e300,
      std::numeric_limits<double>::max(),
      -std::numeric_limits<double>::max()};
  return bad[engine() % (sizeof bad / sizeof *bad)];
}

/// Any bits at all.
double any_bits(Engine& engine) {
  const std::uint64_t bits = engine();
  double value = 0.0;
  static_assert(sizeof value == sizeof bits, "a double of 64 bits");
  __builtin_memcpy(&value, &bits, sizeof value);
  return value;
}

void spoil(Engine& engine, std::vector<double>& values, double probability) {
  for (double& v : values) {
    if (!chance(engine, probability)) continue;
    v = chance(engine, 0.2) ? any_bits(engine) : bad_number(engine);
  }
}

struct Call {
  int count = 0, states = 0;
  std::vector<double> strain, stress, state, new_stress, new_state, tangent, work;
  std::vector<int> status;
};

double spread(Engine& engine, double smallest, double largest) {
  std::uniform_real_distribution<double> exponent(std::log10(smallest), std::log10(largest));
  const double size = std::pow(10.0, exponent(engine));
  return chance(engine, 0.5) ? size : -size;
}

/// Points in states that a run could have, most of them.
Call random_call(Engine& engine, const barreno_material* m) {
  Call c;
  c.count = static_cast<int>(engine() % 4);
  c.states = barreno_material_state_count(m);
  const auto n = static_cast<std::size_t>(c.count);
  const auto states = static_cast<std::size_t>(c.states);
  c.strain.resize(6 * n);
  c.stress.resize(6 * n);
  c.state.assign(states * n, 0.0);
  // Filled with what nobody may see.
  c.new_stress.assign(6 * n, std::nan(""));
  c.new_state.assign(states * n, std::nan(""));
  c.tangent.assign(36 * n, std::nan(""));
  c.work.assign(2 * n, std::nan(""));
  c.status.assign(n, -7);
  for (std::size_t p = 0; p < n; ++p) {
    // Large in one of them is large: the sizes of whole increments are spread, not of components.
    const double size = std::fabs(spread(engine, 1e-9, 0.3));
    for (std::size_t i = 6 * p; i < 6 * p + 6; ++i) c.strain[i] = spread(engine, 1e-3 * size, size);
  }
  for (double& v : c.stress) v = chance(engine, 0.3) ? 0.0 : spread(engine, 1.0, 1e10);
  for (std::size_t p = 0; p < n; ++p) {
    if (chance(engine, 0.5)) continue;  // virgin
    for (std::size_t i = 0; i < states; ++i) {
      const double initial = barreno_material_state_initial(m, static_cast<int>(i));
      c.state[states * p + i] =
          i == 0 ? 1.0 : initial + spread(engine, 1e-6, 0.3) * (initial + 1.0);
    }
  }
  const double share = chance(engine, 0.5) ? 0.0 : 0.05;
  spoil(engine, c.strain, share);
  spoil(engine, c.stress, share);
  spoil(engine, c.state, share);
  return c;
}

bool finite(const std::vector<double>& values) {
  for (const double v : values) {
    if (!std::isfinite(v)) return false;
  }
  return true;
}

/// What is wrong with an answer; empty if nothing.
std::string problem(const Call& c, int failed, int want) {
  if (!finite(c.new_stress) || !finite(c.new_state) || !finite(c.work))
    return "a value is not finite";
  if (want != BARRENO_STRESS && !finite(c.tangent)) return "a tangent is not finite";
  int counted = 0;
  const auto states = static_cast<std::size_t>(c.states);
  for (std::size_t p = 0; p < c.status.size(); ++p) {
    if (c.status[p] == BARRENO_OK) continue;
    if (c.status[p] < 0 || c.status[p] > BARRENO_BAD_INPUT) return "a status is unknown";
    ++counted;
    const auto kept = [](double old, double now) {
      return now == (std::isfinite(old) ? old : 0.0);
    };
    for (std::size_t i = 6 * p; i < 6 * p + 6; ++i) {
      if (!kept(c.stress[i], c.new_stress[i])) return "a failed point has another stress";
    }
    for (std::size_t i = states * p; i < states * (p + 1); ++i) {
      if (!kept(c.state[i], c.new_state[i])) return "a failed point has another state";
    }
  }
  return counted == failed ? "" : "the number of failed points is wrong";
}

struct Tally {
  long points = 0, failed = 0, refused = 0;
};

/// One call; some are spoilt beyond use. What is wrong, or nothing.
std::string one_call(Engine& engine, const barreno_material* m, Tally& tally) {
  Call c = random_call(engine, m);
  const int want = static_cast<int>(engine() % 3);
  const double dt =
      chance(engine, 0.9) ? std::fabs(spread(engine, 1e-12, 1.0)) : bad_number(engine);
  barreno_batch b{
      c.count,
      want,
      dt,
      c.strain.data(),
      c.stress.data(),
      c.new_stress.data(),
      c.state.data(),
      c.new_state.data(),
      c.tangent.data(),
      c.work.data(),
      c.status.data()};
  if (chance(engine, 0.02)) {
    barreno_batch unusable = b;
    switch (engine() % 4) {
      case 0:
        unusable.count = -1 - static_cast<int>(engine() % 1000);
        break;
      case 1:
        unusable.want = 3 + static_cast<int>(engine() % 1000);
        break;
      case 2:
        unusable.count = 1;
        unusable.state_new = nullptr;
        break;
      default:
        m = nullptr;
    }
    ++tally.refused;
    if (barreno_material_update(m, &unusable) != -1) return "an unusable call was served";
    return *barreno_last_error() == '\0' ? "a refusal without a sentence" : "";
  }
  const int failed = barreno_material_update(m, &b);
  tally.points += c.count;
  tally.failed += failed;
  for (std::size_t p = 0; p < static_cast<std::size_t>(c.count); ++p) {
    const double modulus = barreno_material_longitudinal_modulus(
        m, &c.stress[6 * p], &c.state[static_cast<std::size_t>(c.states) * p]
    );
    if (!std::isfinite(modulus) || modulus < 0.0) return "a modulus is not finite";
  }
  return failed < 0 ? "a good call was refused" : problem(c, failed, want);
}

barreno_material* open(const std::string& asked) {
  if (asked.find('+') == std::string::npos) return barreno_material_open(asked.c_str());
  const std::string file = barreno::test::card_with_words(asked);
  if (file.empty()) {
    std::fprintf(stderr, "%s: no such card, or no such word (general_words.hpp)\n", asked.c_str());
    return nullptr;
  }
  barreno_material* m = barreno_material_open(file.c_str());
  std::filesystem::remove(file);
  return m;
}

/// So many calls on one card; how many went wrong.
int fuzz_card(const std::string& card, long calls, std::uint64_t seed) {
  barreno_material* m = open(card);
  if (m == nullptr) {
    std::fprintf(stderr, "%s\n", barreno_last_error());
    return 1;
  }
  Engine engine(seed);
  Tally tally;
  int problems = 0;
  constexpr int max_problems = 20;
  for (long call = 0; call < calls && problems < max_problems; ++call) {
    const std::string wrong = one_call(engine, m, tally);
    if (wrong.empty()) continue;
    std::printf("%s, call %ld: %s\n", card.c_str(), call, wrong.c_str());
    ++problems;
  }
  std::printf(
      "%s (%s): %ld calls, %ld points, %ld failed, %ld calls refused\n",
      card.c_str(),
      barreno_material_model(m),
      calls,
      tally.points,
      tally.failed,
      tally.refused
  );
  std::fflush(stdout);
  // Calls that all fail, or all succeed, would show little.
  if (tally.failed * 50 < tally.points || tally.failed * 10 > tally.points * 9) {
    std::printf("the share of failures is no good for a test\n");
    ++problems;
  }
  barreno_material_close(m);
  return problems;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 4) {
    std::fprintf(stderr, "fuzz_c_interface CALLS SEED CARD...\n");
    return 1;
  }
  int problems = 0;
  for (int i = 3; i < argc; ++i)
    problems +=
        fuzz_card(argv[i], std::atol(argv[1]), static_cast<std::uint64_t>(std::atol(argv[2])));
  return problems == 0 ? 0 : 1;
}
