/* sanchez_8r_position.h: manipulability (position) of sanchez_8r.
 * Made from templates/kernel.h.j2; inputs eeb6e159f30e282be02ccef25caa4195473462c7ef4cbbe95e0e7e7759cff87a.
 * 1893 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_SANCHEZ_8R_POSITION_H
#define CHAINRULE_SANCHEZ_8R_POSITION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char sanchez_8r_position_digest[];

/* manipulability H = sqrt(det(J J^T)) of the position Jacobian.
 *   in   q[8]
 *   out  manipulability (one number)
 *   306 operations */
void sanchez_8r_manipulability_position(const double *q, double *manipulability);
void sanchez_8r_manipulability_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_manipulability_positionf(const float *q, float *manipulability);
void sanchez_8r_manipulability_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in
 * lexicographic order.
 *   in   q[8]
 *   out  manipulability (one number)
 *   out  gradient[8]
 *   out  inverse_gradient[8]
 *   out  inverse_root_gradient[8]
 *   909 operations */
void sanchez_8r_manipulability_gradient_position(const double *q, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void sanchez_8r_manipulability_gradient_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_manipulability_gradient_positionf(const float *q, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void sanchez_8r_manipulability_gradient_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the position Jacobian, columns in lexicographic order.
 *   in   q[8]
 *   out  minors[56]
 *   245 operations */
void sanchez_8r_minors_position(const double *q, double *minors);
void sanchez_8r_minors_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_minors_positionf(const float *q, float *minors);
void sanchez_8r_minors_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* projector I - J^+ J onto the null space of the position Jacobian.
 *   in   q[8]
 *   out  null_projector[8][8]
 *   433 operations */
void sanchez_8r_null_projector_position(const double *q, double *null_projector);
void sanchez_8r_null_projector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_null_projector_positionf(const float *q, float *null_projector);
void sanchez_8r_null_projector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_SANCHEZ_8R_POSITION_H */
