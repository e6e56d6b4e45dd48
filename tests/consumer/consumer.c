/* SPDX-License-Identifier: BSD-3-Clause */
/* A finite element code in C: one point of a card, squeezed along 11 in ten steps. Prints the stress. */
#include <barreno_material.h>
#include <stdio.h>
#include <stdlib.h>

int main(int argc, char** argv) {
  double strain[6] = {-1e-3, 0, 0, 0, 0, 0}, stress[6] = {0}, tangent[36];
  double* state;
  int i, failed = 0;
  barreno_batch batch = {0};
  barreno_material* material = barreno_material_open(argc > 1 ? argv[1] : "berea_sandstone");
  if (material == NULL) {
    fprintf(stderr, "%s\n", barreno_last_error());
    return 1;
  }
  state = calloc((size_t)barreno_material_state_count(material), sizeof *state);
  batch.count = 1;
  batch.want = BARRENO_CONSISTENT;
  batch.time_increment = 1e-3;
  batch.strain_increment = strain;
  batch.stress_old = stress; /* in place: this code never repeats a step */
  batch.stress_new = stress;
  batch.state_old = state;
  batch.state_new = state;
  batch.tangent = tangent;
  for (i = 0; i < 10; ++i) failed += barreno_material_update(material, &batch);
  printf("%s %.17g %.17g %.17g\n", barreno_material_model(material), stress[0], stress[1], tangent[0]);
  free(state);
  barreno_material_close(material);
  return failed;
}
