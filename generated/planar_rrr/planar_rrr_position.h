/* planar_rrr_position.h: manipulability (position) of planar_rrr.
 * Made from templates/kernel.h.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
 * 204 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_RRR_POSITION_H
#define CHAINRULE_PLANAR_RRR_POSITION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_rrr_position_digest[];

/* manipulability H = sqrt(det(J J^T)) of the position Jacobian.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  manipulability (one number)
 *   23 operations */
void planar_rrr_manipulability_position(const double *q, const double *parameters, double *manipulability);
void planar_rrr_manipulability_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_manipulability_positionf(const float *q, const float *parameters, float *manipulability);
void planar_rrr_manipulability_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the minors (1,2), (1,3), (2,3) of the position Jacobian, in
 * closed form.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  manipulability (one number)
 *   out  gradient[3]
 *   out  inverse_gradient[3]
 *   out  inverse_root_gradient[3]
 *   64 operations */
void planar_rrr_manipulability_gradient_position(const double *q, const double *parameters, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void planar_rrr_manipulability_gradient_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_manipulability_gradient_positionf(const float *q, const float *parameters, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void planar_rrr_manipulability_gradient_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* minors (1,2), (1,3), (2,3) of the position Jacobian, in closed form.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  minors[3]
 *   17 operations */
void planar_rrr_minors_position(const double *q, const double *parameters, double *minors);
void planar_rrr_minors_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_minors_positionf(const float *q, const float *parameters, float *minors);
void planar_rrr_minors_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* null vector of the position Jacobian from its signed minors, |N| = H.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  null_vector[3]
 *   18 operations */
void planar_rrr_null_vector_position(const double *q, const double *parameters, double *null_vector);
void planar_rrr_null_vector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_null_vector_positionf(const float *q, const float *parameters, float *null_vector);
void planar_rrr_null_vector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* projector I - J^+ J onto the null space of the position Jacobian.
 *   in   q[3]
 *   in   parameters[3] = (l1, l2, l3)
 *   out  null_projector[3][3]
 *   82 operations */
void planar_rrr_null_projector_position(const double *q, const double *parameters, double *null_projector);
void planar_rrr_null_projector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_null_projector_positionf(const float *q, const float *parameters, float *null_projector);
void planar_rrr_null_projector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_RRR_POSITION_H */
