/* planar_rrr_continuation_x_alpha.h: continuation x alpha of planar_rrr.
 * Made from templates/kernel.h.j2; inputs f29b1b245621ebe2effe4dc47543535c5f273522534b650aa5e0573e5f938bfd.
 * 102 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_RRR_CONTINUATION_X_ALPHA_H
#define CHAINRULE_PLANAR_RRR_CONTINUATION_X_ALPHA_H

#include <stddef.h>

#include "../chainrule_continuation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_rrr_continuation_x_alpha_digest[];

/* error of the x_alpha, its Jacobian, and the null vector from its signed minors.
 *   in   q[3]
 *   in   held[2] = (target_x, target_alpha)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  error[2]
 *   out  jacobian[2][3]
 *   out  null_vector[3]
 *   44 operations */
void planar_rrr_continuation_x_alpha(const double *q, const double *held, const double *parameters, double *error, double *jacobian, double *null_vector);
void planar_rrr_continuation_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_continuation_x_alphaf(const float *q, const float *held, const float *parameters, float *error, float *jacobian, float *null_vector);
void planar_rrr_continuation_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* null vector of the x_alpha Jacobian, and its derivative along itself.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  null_vector[3]
 *   out  bending[3]
 *   58 operations */
void planar_rrr_continuation_x_alpha_bending(const double *q, const double *parameters, double *null_vector, double *bending);
void planar_rrr_continuation_x_alpha_bending_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_continuation_x_alpha_bendingf(const float *q, const float *parameters, float *null_vector, float *bending);
void planar_rrr_continuation_x_alpha_bending_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* The curves on which the x_alpha is held, from a start each (chainrule_continuation.h says how).
 *   in   inputs (starts[count][3], targets, parameters, units, links, sizes), settings
 *   out  room (points and extrema, curve after curve), boxes[count][3][2], results[count]
 * Returns how many curves were followed; less than count where there was no room for the next one. */
ptrdiff_t planar_rrr_continuation_x_alpha_follow(ptrdiff_t count, const chainrule_curve_inputs *inputs, const chainrule_curve_settings *settings,
    chainrule_curve_room *room, double *boxes, chainrule_curve_result *results);

/* Configurations q[count][3] near such curves moved onto them by Newton's method, the shortest way, some times; with unit
 * tangents[count][3] (of joints over units) there. `inputs` as above, without starts. */
void planar_rrr_continuation_x_alpha_correct(ptrdiff_t count, const chainrule_curve_inputs *inputs, int times, double *q, double *tangents);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_RRR_CONTINUATION_X_ALPHA_H */
