/* gofa5_pose.h: manipulability (pose) of gofa5.
 * Made from templates/kernel.h.j2; inputs 19a46f4830bd55b319121950d891878cb2720671f096ba4458529eee0f50857c.
 * 507 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_GOFA5_POSE_H
#define CHAINRULE_GOFA5_POSE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char gofa5_pose_digest[];

/* manipulability H = sqrt(det(J J^T)) of the pose Jacobian.
 *   in   q[6]
 *   out  manipulability (one number)
 *   95 operations */
void gofa5_manipulability_pose(const double *q, double *manipulability);
void gofa5_manipulability_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void gofa5_manipulability_posef(const float *q, float *manipulability);
void gofa5_manipulability_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in
 * lexicographic order.
 *   in   q[6]
 *   out  manipulability (one number)
 *   out  gradient[6]
 *   out  inverse_gradient[6]
 *   out  inverse_root_gradient[6]
 *   317 operations */
void gofa5_manipulability_gradient_pose(const double *q, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void gofa5_manipulability_gradient_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void gofa5_manipulability_gradient_posef(const float *q, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void gofa5_manipulability_gradient_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the pose Jacobian, columns in lexicographic order.
 *   in   q[6]
 *   out  minors[1]
 *   95 operations */
void gofa5_minors_pose(const double *q, double *minors);
void gofa5_minors_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void gofa5_minors_posef(const float *q, float *minors);
void gofa5_minors_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_GOFA5_POSE_H */
