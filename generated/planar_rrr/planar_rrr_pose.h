/* planar_rrr_pose.h: manipulability (pose) of planar_rrr.
 * Made from templates/kernel.h.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
 * 138 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_RRR_POSE_H
#define CHAINRULE_PLANAR_RRR_POSE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_rrr_pose_digest[];

/* manipulability H = sqrt(det(J J^T)) of the pose Jacobian.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  manipulability (one number)
 *   29 operations */
void planar_rrr_manipulability_pose(const double *q, const double *parameters, double *manipulability);
void planar_rrr_manipulability_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_manipulability_posef(const float *q, const float *parameters, float *manipulability);
void planar_rrr_manipulability_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in
 * lexicographic order.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  manipulability (one number)
 *   out  gradient[3]
 *   out  inverse_gradient[3]
 *   out  inverse_root_gradient[3]
 *   81 operations */
void planar_rrr_manipulability_gradient_pose(const double *q, const double *parameters, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void planar_rrr_manipulability_gradient_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_manipulability_gradient_posef(const float *q, const float *parameters, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void planar_rrr_manipulability_gradient_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the pose Jacobian, columns in lexicographic order.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  minors[1]
 *   28 operations */
void planar_rrr_minors_pose(const double *q, const double *parameters, double *minors);
void planar_rrr_minors_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_minors_posef(const float *q, const float *parameters, float *minors);
void planar_rrr_minors_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_RRR_POSE_H */
