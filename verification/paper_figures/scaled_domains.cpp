// SPDX-License-Identifier: BSD-3-Clause
// Corners of CPDI's domains as the code integrates over them: reads a domain per line, its two half
// edges in cells and l_crit (e0x e0y e1x e1y l_crit), and prints the corners e0 + e1, e0 - e1, -e0
// - e1, -e0 + e1 after domain scaling. For figure 1 of docs/paper.md.
#include "shape/domain.hpp"

#include <cstdio>
#include <iostream>

int main() {
  barreno::Domain<2> domain;
  double largest = 0.0;
  while (std::cin >> domain.e[0][0] >> domain.e[0][1] >> domain.e[1][0] >> domain.e[1][1] >> largest
  ) {
    const auto corner = barreno::corner_vectors(barreno::scale_domain(domain, largest));
    for (const double sign : {1.0, -1.0})
      for (const auto& l : {corner.l[0], corner.l[1]})
        std::printf("%.17g %.17g ", sign * l[0], sign * l[1]);
    std::printf("\n");
  }
  return 0;
}
