/* orthogonal_3r_position.h: manipulability (position) of orthogonal_3r.
 * Made from templates/kernel.h.j2; inputs acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe.
 * 87 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_ORTHOGONAL_3R_POSITION_H
#define CHAINRULE_ORTHOGONAL_3R_POSITION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char orthogonal_3r_position_digest[];

/* manipulability H = sqrt(det(J J^T)) of the position Jacobian.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  manipulability (one number)
 *   18 operations */
void orthogonal_3r_manipulability_position(const double *q, const double *parameters, double *manipulability);
void orthogonal_3r_manipulability_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_manipulability_positionf(const float *q, const float *parameters, float *manipulability);
void orthogonal_3r_manipulability_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the determinant of the position Jacobian, factored.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  manipulability (one number)
 *   out  gradient[3]
 *   out  inverse_gradient[3]
 *   out  inverse_root_gradient[3]
 *   54 operations */
void orthogonal_3r_manipulability_gradient_position(const double *q, const double *parameters, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void orthogonal_3r_manipulability_gradient_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_manipulability_gradient_positionf(const float *q, const float *parameters, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void orthogonal_3r_manipulability_gradient_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* determinant of the position Jacobian, factored.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  minors[1]
 *   15 operations */
void orthogonal_3r_minors_position(const double *q, const double *parameters, double *minors);
void orthogonal_3r_minors_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_minors_positionf(const float *q, const float *parameters, float *minors);
void orthogonal_3r_minors_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_ORTHOGONAL_3R_POSITION_H */
