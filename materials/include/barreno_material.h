/* SPDX-License-Identifier: BSD-3-Clause */
#ifndef BARRENO_MATERIAL_H
#define BARRENO_MATERIAL_H

/* Barreno's materials for other codes: a material is opened from a card and updates batches of
 * points.
 *
 * Conventions. SI units. Symmetric tensors 11 22 33 12 13 23, tensor shears (half of engineering
 * ones), tension positive. Stress is Cauchy and corotational: the host removes the rotation from
 * strain increments and stresses. Strain increments are logarithmic; small-strain codes pass their
 * own. State variables are scalars, or components in the same unrotated axes (NAME_xx to NAME_zx).
 *
 * State. Variable 0 is `initialized`: a point whose state is all zero is virgin, and the library
 * fills in the rest (confined, if the host gives it an initial pressure). Old and new are separate
 * arrays, so that a step may be tried again; they may also be the same array. Rock whose card has
 * fluid_pressure_initial needs an initial stress: a point that starts without one is refused.
 *
 * A point that fails keeps its old stress and state; its tangent is the elastic one. No returned
 * value is NaN or infinite: a stress or state that was one on entry is returned as 0, with
 * BARRENO_BAD_INPUT.
 *
 * Threads. A material may be updated by several threads at once. Error messages belong to the
 * calling thread. */

/* C has names and forms of its own: NOLINTBEGIN(modernize-use-using,readability-identifier-naming)
 */

#ifdef __cplusplus
extern "C" {
#endif

/** Changes whenever a change to this header requires callers to be recompiled. */
#define BARRENO_ABI_VERSION 1
int barreno_abi_version(void);
/** Version of the library, "0.1.0". */
const char* barreno_version(void);

typedef struct barreno_material barreno_material;

/** Opens a card.
 *  @param card  a path; or the name of a card, in upper or lower case, with or without ".xml",
 * which is searched for in the directories of the environment variable BARRENO_MATERIALS (':'
 * between them) and then among the cards that come with the library
 *  @return NULL if that failed; barreno_last_error() says why */
barreno_material* barreno_material_open(const char* card);
void barreno_material_close(barreno_material* material);

/** The model of the card, "Arenisca"; "" if material is NULL. */
const char* barreno_material_model(const barreno_material* material);
/** The file that the material was read from. */
const char* barreno_material_file(const barreno_material* material);
/** Reference density [kg/m3]. */
double barreno_material_density(const barreno_material* material);

/** State variables of a point: how many, and of each its name, SI unit ("" for none), meaning, and
 * its value in a point without stress. NULL (or 0) for an index that is out of range. */
int barreno_material_state_count(const barreno_material* material);
const char* barreno_material_state_name(const barreno_material* material, int index);
const char* barreno_material_state_unit(const barreno_material* material, int index);
const char* barreno_material_state_meaning(const barreno_material* material, int index);
double barreno_material_state_initial(const barreno_material* material, int index);

/** K + 4G/3 of a point, which bounds its wave speed by sqrt(. / density) [Pa]; 0 for an impossible
 * state.
 *  @param stress  six components
 *  @param state   barreno_material_state_count() values */
double barreno_material_longitudinal_modulus(
    const barreno_material* material, const double* stress, const double* state
);

/** What to compute of the tangent. */
enum barreno_want {
  BARRENO_STRESS = 0,    /**< no tangent */
  BARRENO_ELASTIC = 1,   /**< the elastic stiffness at the start of the step */
  BARRENO_CONSISTENT = 2 /**< d stress_new / d strain_increment of the step that was taken */
};

/** Outcome of the update of a point. */
enum barreno_status {
  BARRENO_OK = 0,
  BARRENO_SUBSTEP_LIMIT = 1, /**< a smaller step may succeed */
  BARRENO_NOT_CONVERGED = 2, /**< a smaller step may succeed */
  BARRENO_BAD_INPUT = 3      /**< not finite, absurdly large, or an impossible state */
};

/** A step of `count` points. Arrays are by point: stress of point i is stress_old[6*i] to
 * stress_old[6*i+5]. */
typedef struct barreno_batch {
  int count;
  int want;                       /**< enum barreno_want */
  double time_increment;          /**< [s], 0 or more; 0 switches rate effects off */
  const double* strain_increment; /**< [count][6] */
  const double* stress_old;       /**< [count][6] [Pa] */
  double* stress_new;             /**< [count][6] [Pa] */
  const double* state_old;        /**< [count][state_count] */
  double* state_new;              /**< [count][state_count] */
  double* tangent; /**< [count][6][6] [Pa], tangent[i][j] = d stress_i / d gamma_j with gamma the
                        engineering strain: the components C_ijkl; not symmetric. NULL with
                        BARRENO_STRESS */
  double* work;    /**< [count][2] [J/m3], or NULL: recoverable and dissipated work of the step, per
                        reference volume */
  int* status;     /**< [count] enum barreno_status, or NULL */
} barreno_batch;

/** Advances a batch.
 *  @return number of points that failed; -1 if the call itself is invalid, and then nothing is
 * written */
int barreno_material_update(const barreno_material* material, const barreno_batch* batch);

/** A path of laboratory steps of `count` points. In each step every component of a point has its
 * strain increment given, or the stress that it reaches. */
typedef struct barreno_path {
  int count, steps;
  double time_increment;          /**< of each step [s], as in barreno_batch */
  const double* strain_increment; /**< [steps][count][6]; where a stress is wanted, a first guess of
                                     the increment */
  const double* stress_wanted;    /**< [steps][count][6] at the end of the step [Pa]; NaN where the
                                     strain increment is given */
  const double* stress_old;       /**< [count][6] before the path [Pa] */
  const double* state_old;        /**< [count][state_count] before the path */
  double* strain_taken;           /**< [steps][count][6] the increments of the steps */
  double* stress;                 /**< [steps][count][6] after the steps [Pa] */
  double* state_new;              /**< [count][state_count] after the path */
  int* status; /**< [count] enum barreno_status, or NULL; a point that fails stays where it was */
} barreno_path;

/** Takes points along a path: Newton's method finds the strains under which the wanted stresses are
 * met, to 1e-7 of the stress (to 1e-4 where the update jumps).
 *  @return number of points that failed; -1 if the call itself is invalid, and then nothing is
 * written */
int barreno_material_follow(const barreno_material* material, const barreno_path* path);

/** Why the last call of this thread failed, as one sentence; valid until its next call. "" if none
 * has failed. */
const char* barreno_last_error(void);

#ifdef __cplusplus
}
#endif

/* NOLINTEND(modernize-use-using,readability-identifier-naming) */

#endif
