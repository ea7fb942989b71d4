/* panda_dynamics.h: dynamics of panda.
 * Made from templates/kernel.h.j2; inputs bd15a8c9134bbab55d51bc366aa09c6a4a25f11da641bc777846aa4be347c394.
 * 845 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PANDA_DYNAMICS_H
#define CHAINRULE_PANDA_DYNAMICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char panda_dynamics_digest[];

/* torques and forces of the joints for a motion, under gravity and a wrench of the tip.
 *   in   q[7]
 *   in   rates[7] = (dq1, dq2, dq3, dq4, dq5, dq6, dq7)
 *   in   accelerations[7] = (ddq1, ddq2, ddq3, ddq4, ddq5, ddq6, ddq7)
 *   in   inertias[7][10] = (m1, hx1, hy1, hz1, Ixx1, Ixy1, Ixz1, Iyy1, Iyz1, Izz1, m2, hx2, hy2, hz2, Ixx2, Ixy2, Ixz2, Iyy2, Iyz2, Izz2, m3, hx3, hy3, hz3, Ixx3, Ixy3, Ixz3, Iyy3, Iyz3, Izz3, m4, hx4, hy4, hz4, Ixx4, Ixy4, Ixz4, Iyy4, Iyz4, Izz4, m5, hx5, hy5, hz5, Ixx5, Ixy5, Ixz5, Iyy5, Iyz5, Izz5, m6, hx6, hy6, hz6, Ixx6, Ixy6, Ixz6, Iyy6, Iyz6, Izz6, m7, hx7, hy7, hz7, Ixx7, Ixy7, Ixz7, Iyy7, Iyz7, Izz7)
 *   in   gravity[3] = (gx, gy, gz)
 *   in   wrench[6] = (fx, fy, fz, mx, my, mz)
 *   out  torque[7]
 *   845 operations */
void panda_inverse_dynamics(const double *q, const double *rates, const double *accelerations, const double *inertias, const double *gravity, const double *wrench, double *torque);
void panda_inverse_dynamics_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_inverse_dynamicsf(const float *q, const float *rates, const float *accelerations, const float *inertias, const float *gravity, const float *wrench, float *torque);
void panda_inverse_dynamics_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PANDA_DYNAMICS_H */
