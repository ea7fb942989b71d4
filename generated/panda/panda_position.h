/* panda_position.h: manipulability (position) of panda.
 * Made from templates/kernel.h.j2; inputs e6c4c77e8f404cf284ca42a0ff2b6a23389b6d8d94d0eb61c7056142a3802c50.
 * 1522 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PANDA_POSITION_H
#define CHAINRULE_PANDA_POSITION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char panda_position_digest[];

/* manipulability H = sqrt(det(J J^T)) of the position Jacobian.
 *   in   q[7]
 *   out  manipulability (one number)
 *   237 operations */
void panda_manipulability_position(const double *q, double *manipulability);
void panda_manipulability_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_manipulability_positionf(const float *q, float *manipulability);
void panda_manipulability_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* H and the gradients of H, 1/H and H^(-1/2), through the maximal minors of the position Jacobian, columns in
 * lexicographic order.
 *   in   q[7]
 *   out  manipulability (one number)
 *   out  gradient[7]
 *   out  inverse_gradient[7]
 *   out  inverse_root_gradient[7]
 *   702 operations */
void panda_manipulability_gradient_position(const double *q, double *manipulability, double *gradient, double *inverse_gradient, double *inverse_root_gradient);
void panda_manipulability_gradient_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_manipulability_gradient_positionf(const float *q, float *manipulability, float *gradient, float *inverse_gradient, float *inverse_root_gradient);
void panda_manipulability_gradient_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* maximal minors of the position Jacobian, columns in lexicographic order.
 *   in   q[7]
 *   out  minors[35]
 *   202 operations */
void panda_minors_position(const double *q, double *minors);
void panda_minors_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_minors_positionf(const float *q, float *minors);
void panda_minors_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* projector I - J^+ J onto the null space of the position Jacobian.
 *   in   q[7]
 *   out  null_projector[7][7]
 *   381 operations */
void panda_null_projector_position(const double *q, double *null_projector);
void panda_null_projector_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_null_projector_positionf(const float *q, float *null_projector);
void panda_null_projector_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PANDA_POSITION_H */
