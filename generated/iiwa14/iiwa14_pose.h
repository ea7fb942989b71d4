/* iiwa14_pose.h: manipulability (pose) of iiwa14.
 * Made from templates/kernel.h.j2; inputs c651bc750b16194a69b4fb16a3147b4955beefc4951f117b4404890e4ed85dd7.
 * 1726 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_IIWA14_POSE_H
#define CHAINRULE_IIWA14_POSE_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char iiwa14_pose_digest[];

/* manipulability H = sqrt(det(J J^T)) of the pose Jacobian.
 *   in   q[7]
 *   out  manipulability (one number)
 *   147 operations */
void iiwa14_manipulability_pose(const double *q, double *manipulability);
void iiwa14_manipulability_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_manipulability_posef(const float *q, float *manipulability);
void iiwa14_manipulability_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the pose Jacobian, columns in
 * lexicographic order.
 *   in   q[7]
 *   out  manipulability (one number)
 *   out  gradient[7]
 *   out  inverse_gradient[7]
 *   out  inverse_root_gradient[7]
 *   473 operations */
void iiwa14_manipulability_gradient_pose(const double *q, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void iiwa14_manipulability_gradient_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_manipulability_gradient_posef(const float *q, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void iiwa14_manipulability_gradient_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the pose Jacobian, columns in lexicographic order.
 *   in   q[7]
 *   out  minors[7]
 *   139 operations */
void iiwa14_minors_pose(const double *q, double *minors);
void iiwa14_minors_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_minors_posef(const float *q, float *minors);
void iiwa14_minors_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* null vector of the pose Jacobian from its signed minors, |N| = H.
 *   in   q[7]
 *   out  null_vector[7]
 *   136 operations */
void iiwa14_null_vector_pose(const double *q, double *null_vector);
void iiwa14_null_vector_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_null_vector_posef(const float *q, float *null_vector);
void iiwa14_null_vector_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* projector I - J^+ J onto the null space of the pose Jacobian.
 *   in   q[7]
 *   out  null_projector[7][7]
 *   831 operations */
void iiwa14_null_projector_pose(const double *q, double *null_projector);
void iiwa14_null_projector_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_null_projector_posef(const float *q, float *null_projector);
void iiwa14_null_projector_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_IIWA14_POSE_H */
