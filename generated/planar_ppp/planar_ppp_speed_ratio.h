/* planar_ppp_speed_ratio.h: speed ratio of planar_ppp.
 * Made from templates/kernel.h.j2; inputs ed99f203c53e369bbff1ddfeafc564f17a2be190cc8c2e4f9796913b98fb7552.
 * 583 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_PPP_SPEED_RATIO_H
#define CHAINRULE_PLANAR_PPP_SPEED_RATIO_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_ppp_speed_ratio_digest[];

/* A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 1 leading.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   in   tangent[2] = (tx, ty)
 *   in   curvature[2] = (kappa, kappa_s)
 *   out  A[3]
 *   out  B[6]
 *   out  B0[6]
 *   out  B1[6]
 *   out  a[3]
 *   out  b[3]
 *   out  C (one number)
 *   out  D (one number)
 *   out  discriminant (one number)
 *   105 operations */
void planar_ppp_speed_ratio_terms_1(const double *q, const double *parameters, const double *tangent, const double *curvature, double *A, double *B, double *B0, double *B1, double *a, double *b, double *C, double *D, double *discriminant);
void planar_ppp_speed_ratio_terms_1_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_speed_ratio_terms_1f(const float *q, const float *parameters, const float *tangent, const float *curvature, float *A, float *B, float *B0, float *B1, float *a, float *b, float *C, float *D, float *discriminant);
void planar_ppp_speed_ratio_terms_1_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 2 leading.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   in   tangent[2] = (tx, ty)
 *   in   curvature[2] = (kappa, kappa_s)
 *   out  A[3]
 *   out  B[6]
 *   out  B0[6]
 *   out  B1[6]
 *   out  a[3]
 *   out  b[3]
 *   out  C (one number)
 *   out  D (one number)
 *   out  discriminant (one number)
 *   105 operations */
void planar_ppp_speed_ratio_terms_2(const double *q, const double *parameters, const double *tangent, const double *curvature, double *A, double *B, double *B0, double *B1, double *a, double *b, double *C, double *D, double *discriminant);
void planar_ppp_speed_ratio_terms_2_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_speed_ratio_terms_2f(const float *q, const float *parameters, const float *tangent, const float *curvature, float *A, float *B, float *B0, float *B1, float *a, float *b, float *C, float *D, float *discriminant);
void planar_ppp_speed_ratio_terms_2_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* A, B = B0 + kappa B1, a, b, C, D and the discriminant of Ambike's (5) to (9), joint 3 leading.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   in   tangent[2] = (tx, ty)
 *   in   curvature[2] = (kappa, kappa_s)
 *   out  A[3]
 *   out  B[6]
 *   out  B0[6]
 *   out  B1[6]
 *   out  a[3]
 *   out  b[3]
 *   out  C (one number)
 *   out  D (one number)
 *   out  discriminant (one number)
 *   105 operations */
void planar_ppp_speed_ratio_terms_3(const double *q, const double *parameters, const double *tangent, const double *curvature, double *A, double *B, double *B0, double *B1, double *a, double *b, double *C, double *D, double *discriminant);
void planar_ppp_speed_ratio_terms_3_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_speed_ratio_terms_3f(const float *q, const float *parameters, const float *tangent, const float *curvature, float *A, float *B, float *B0, float *B1, float *a, float *b, float *C, float *D, float *discriminant);
void planar_ppp_speed_ratio_terms_3_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* joint rates along the tangent with the curvature kappa or the nearest possible, with the curvature's rates.
 *   in   q[3]
 *   in   parameters[6] = (l1, l2, l3, heading1, heading2, heading3)
 *   in   tangent[2] = (tx, ty)
 *   in   curvature[2] = (kappa, kappa_s)
 *   in   leading[3] = (leads1, leads2, leads3)
 *   out  rates[2][3]
 *   out  ratios[2][2]
 *   out  tracked[2]
 *   out  tracked_rate[2]
 *   out  verdict[5]
 *   out  parabola[3]
 *   out  slack (one number)
 *   out  least[3]
 *   out  null[3]
 *   268 operations */
void planar_ppp_speed_ratio_rates(const double *q, const double *parameters, const double *tangent, const double *curvature, const double *leading, double *rates, double *ratios, double *tracked, double *tracked_rate, double *verdict, double *parabola, double *slack, double *least, double *null);
void planar_ppp_speed_ratio_rates_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_ppp_speed_ratio_ratesf(const float *q, const float *parameters, const float *tangent, const float *curvature, const float *leading, float *rates, float *ratios, float *tracked, float *tracked_rate, float *verdict, float *parabola, float *slack, float *least, float *null);
void planar_ppp_speed_ratio_rates_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_PPP_SPEED_RATIO_H */
