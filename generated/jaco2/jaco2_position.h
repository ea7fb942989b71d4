/* jaco2_position.h: manipulability (position) of jaco2.
 * Made from templates/kernel.h.j2; inputs 1ad93e3c11b867e4c607122d6c1c8fda72f2a60d9e7231f3d78e1cc06c98b3ce.
 * 1134 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_JACO2_POSITION_H
#define CHAINRULE_JACO2_POSITION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char jaco2_position_digest[];

/* manipulability H = sqrt(det(J J^T)) of the position Jacobian.
 *   in   q[6]
 *   out  manipulability (one number)
 *   166 operations */
void jaco2_manipulability_position(const double *q, double *manipulability);
void jaco2_manipulability_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_manipulability_positionf(const float *q, float *manipulability);
void jaco2_manipulability_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in
 * lexicographic order.
 *   in   q[6]
 *   out  manipulability (one number)
 *   out  gradient[6]
 *   out  inverse_gradient[6]
 *   out  inverse_root_gradient[6]
 *   484 operations */
void jaco2_manipulability_gradient_position(const double *q, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void jaco2_manipulability_gradient_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_manipulability_gradient_positionf(const float *q, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void jaco2_manipulability_gradient_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the position Jacobian, columns in lexicographic order.
 *   in   q[6]
 *   out  minors[20]
 *   148 operations */
void jaco2_minors_position(const double *q, double *minors);
void jaco2_minors_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_minors_positionf(const float *q, float *minors);
void jaco2_minors_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* projector I - J^+ J onto the null space of the position Jacobian.
 *   in   q[6]
 *   out  null_projector[6][6]
 *   336 operations */
void jaco2_null_projector_position(const double *q, double *null_projector);
void jaco2_null_projector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_null_projector_positionf(const float *q, float *null_projector);
void jaco2_null_projector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_JACO2_POSITION_H */
