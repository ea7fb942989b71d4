/* planar_ppp_position.h: manipulability (position) of planar_ppp.
 * Made from templates/kernel.h.j2; inputs e8de7972500fc2ac9db48b6896fe5887084ff24da5b5799e1f4b1aac4902d217.
 * 243 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_PPP_POSITION_H
#define CHAINRULE_PLANAR_PPP_POSITION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_ppp_position_digest[];

/* manipulability H = sqrt(det(J J^T)) of the position Jacobian.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   out  manipulability (one number)
 *   19 operations */
void planar_ppp_manipulability_position(const double *q, const double *parameters, double *manipulability);
void planar_ppp_manipulability_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_manipulability_positionf(const float *q, const float *parameters, float *manipulability);
void planar_ppp_manipulability_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in
 * lexicographic order.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   out  manipulability (one number)
 *   out  gradient[3]
 *   out  inverse_gradient[3]
 *   out  inverse_root_gradient[3]
 *   19 operations */
void planar_ppp_manipulability_gradient_position(const double *q, const double *parameters, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void planar_ppp_manipulability_gradient_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_manipulability_gradient_positionf(const float *q, const float *parameters, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void planar_ppp_manipulability_gradient_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H^2, its gradient and its Hessian, through the maximal minors of the position Jacobian, columns in lexicographic
 * order.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   out  square (one number)
 *   out  gradient[3]
 *   out  hessian[3][3]
 *   18 operations */
void planar_ppp_manipulability_hessian_position(const double *q, const double *parameters, double *square, double *gradient, double *hessian);
void planar_ppp_manipulability_hessian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_manipulability_hessian_positionf(const float *q, const float *parameters, float *square, float *gradient, float *hessian);
void planar_ppp_manipulability_hessian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the position Jacobian, columns in lexicographic order.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   out  minors[3]
 *   14 operations */
void planar_ppp_minors_position(const double *q, const double *parameters, double *minors);
void planar_ppp_minors_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_minors_positionf(const float *q, const float *parameters, float *minors);
void planar_ppp_minors_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* null vector of the position Jacobian from its signed minors, |N| = H.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   out  null_vector[3]
 *   15 operations */
void planar_ppp_null_vector_position(const double *q, const double *parameters, double *null_vector);
void planar_ppp_null_vector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_null_vector_positionf(const float *q, const float *parameters, float *null_vector);
void planar_ppp_null_vector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* projector I - J^+ J onto the null space of the position Jacobian.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   out  null_projector[3][3]
 *   158 operations */
void planar_ppp_null_projector_position(const double *q, const double *parameters, double *null_projector);
void planar_ppp_null_projector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_null_projector_positionf(const float *q, const float *parameters, float *null_projector);
void planar_ppp_null_projector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_PPP_POSITION_H */
