/* sanchez_8r_redundancy_pose.h: redundancy pose of sanchez_8r.
 * Made from templates/kernel.h.j2; inputs a3461720e029606439d74c9aceb69ab6bcb720cd1f77b30f3d342ac79d53c7c9.
 * 2941 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_SANCHEZ_8R_REDUNDANCY_POSE_H
#define CHAINRULE_SANCHEZ_8R_REDUNDANCY_POSE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char sanchez_8r_redundancy_pose_digest[];

/* step along the pose.
 *   in   q[8]
 *   in   held[4][4] = (target_00, target_01, target_02, target_03, target_10, target_11, target_12, target_13, target_20, target_21, target_22, target_23, target_30, target_31, target_32, target_33)
 *   in   velocity[6] = (velocity1, velocity2, velocity3, velocity4, velocity5, velocity6)
 *   in   push[8] = (push1, push2, push3, push4, push5, push6, push7, push8)
 *   in   joints[4][8] = (mobility1, mobility2, mobility3, mobility4, mobility5, mobility6, mobility7, mobility8, stiffness1, stiffness2, stiffness3, stiffness4, stiffness5, stiffness6, stiffness7, stiffness8, middle1, middle2, middle3, middle4, middle5, middle6, middle7, middle8, narrowness1, narrowness2, narrowness3, narrowness4, narrowness5, narrowness6, narrowness7, narrowness8)
 *   in   settings[12] = (feedback_position, feedback_orientation, gain_H, gain_inverse_H, gain_inverse_root_H, gain_limits, damping_constant, damping_nakamura, inverse_threshold_H, damping_chiaverini, inverse_threshold_s, dt)
 *   out  q_next[8]
 *   out  rates[8]
 *   out  manipulability (one number)
 *   out  error[6]
 *   out  null_motion[8]
 *   2941 operations */
void sanchez_8r_step_pose(const double *q, const double *held, const double *velocity, const double *push, const double *joints, const double *settings, double *q_next, double *rates, double *manipulability, double *error, double *null_motion);
void sanchez_8r_step_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_step_posef(const float *q, const float *held, const float *velocity, const float *push, const float *joints, const float *settings, float *q_next, float *rates, float *manipulability, float *error, float *null_motion);
void sanchez_8r_step_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_SANCHEZ_8R_REDUNDANCY_POSE_H */
