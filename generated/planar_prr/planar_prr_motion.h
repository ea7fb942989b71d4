/* planar_prr_motion.h: motion of planar_prr.
 * Made from templates/kernel.h.j2; inputs 3ba599d5b18781c5deed40d4b80666fc484cf95312cb60aaabb89a9bcc40aa47.
 * 203 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_PRR_MOTION_H
#define CHAINRULE_PLANAR_PRR_MOTION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_prr_motion_digest[];

/* derivatives of the tip along a joint motion, and the path's speed, curvature, dk/ds and d^2k/ds^2.
 *   in   q[3]
 *   in   parameters[4] = (l1, l2, l3, heading1)
 *   in   rates[3] = (dq1, dq2, dq3)
 *   in   second[3] = (ddq1, ddq2, ddq3)
 *   in   third[3] = (dddq1, dddq2, dddq3)
 *   out  derivatives[5][2]
 *   out  path[4]
 *   203 operations */
void planar_prr_tip_motion(const double *q, const double *parameters, const double *rates, const double *second, const double *third, double *derivatives, double *path);
void planar_prr_tip_motion_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_prr_tip_motionf(const float *q, const float *parameters, const float *rates, const float *second, const float *third, float *derivatives, float *path);
void planar_prr_tip_motion_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_PRR_MOTION_H */
