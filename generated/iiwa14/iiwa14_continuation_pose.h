/* iiwa14_continuation_pose.h: continuation pose of iiwa14.
 * Made from templates/kernel.h.j2; inputs 52afdf81e06041abada4d18d0b5430b44c7119945475fc1d6222f9f0024c56ba.
 * 766 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_IIWA14_CONTINUATION_POSE_H
#define CHAINRULE_IIWA14_CONTINUATION_POSE_H

#include <stddef.h>

#include "../chainrule_continuation.h"

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char iiwa14_continuation_pose_digest[];

/* error of the pose, its Jacobian, and the null vector from its signed minors.
 *   in   q[7]
 *   in   held[4][4] = (target_00, target_01, target_02, target_03, target_10, target_11, target_12, target_13, target_20, target_21, target_22, target_23, target_30, target_31, target_32, target_33)
 *   out  error[6]
 *   out  jacobian[6][7]
 *   out  null_vector[7]
 *   344 operations */
void iiwa14_continuation_pose(const double *q, const double *held, double *error, double *jacobian, double *null_vector);
void iiwa14_continuation_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_continuation_posef(const float *q, const float *held, float *error, float *jacobian, float *null_vector);
void iiwa14_continuation_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* null vector of the pose Jacobian, and its derivative along itself.
 *   in   q[7]
 *   out  null_vector[7]
 *   out  bending[7]
 *   422 operations */
void iiwa14_continuation_pose_bending(const double *q, double *null_vector, double *bending);
void iiwa14_continuation_pose_bending_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_continuation_pose_bendingf(const float *q, float *null_vector, float *bending);
void iiwa14_continuation_pose_bending_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* The curves on which the pose is held, from a start each (chainrule_continuation.h says how).
 *   in   inputs (starts[count][7], targets, units, links, sizes), settings
 *   out  room (points and extrema, curve after curve), boxes[count][7][2], results[count]
 * Returns how many curves were followed; less than count where there was no room for the next one. */
ptrdiff_t iiwa14_continuation_pose_follow(ptrdiff_t count, const chainrule_curve_inputs *inputs, const chainrule_curve_settings *settings,
    chainrule_curve_room *room, double *boxes, chainrule_curve_result *results);

/* Configurations q[count][7] near such curves moved onto them by Newton's method, the shortest way, some times; with unit
 * tangents[count][7] (of joints over units) there. `inputs` as above, without starts. */
void iiwa14_continuation_pose_correct(ptrdiff_t count, const chainrule_curve_inputs *inputs, int times, double *q, double *tangents);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_IIWA14_CONTINUATION_POSE_H */
