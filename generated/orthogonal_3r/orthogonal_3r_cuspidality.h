/* orthogonal_3r_cuspidality.h: cuspidality of orthogonal_3r.
 * Made from templates/kernel.h.j2; inputs 5115df605f1fdc3d6f77f19223b735215dc80e9e1f9a9d3ac278a83f3c8911a8.
 * 707 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_ORTHOGONAL_3R_CUSPIDALITY_H
#define CHAINRULE_ORTHOGONAL_3R_CUSPIDALITY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char orthogonal_3r_cuspidality_digest[];

/* coefficients, lowest power of tan(theta3/2) first, of the quartic whose roots are the postures at a target.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   target[2] = (rho_squared, z)
 *   out  quartic[5]
 *   48 operations */
void orthogonal_3r_quartic(const double *parameters, const double *target, double *quartic);
void orthogonal_3r_quartic_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_quarticf(const float *parameters, const float *target, float *quartic);
void orthogonal_3r_quartic_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps, for alpha2 =
 * +-90 deg: those with z^2 >= 0.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  polynomial[7]
 *   36 operations */
void orthogonal_3r_cusp_polynomial(const double *parameters, double *polynomial);
void orthogonal_3r_cusp_polynomial_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_cusp_polynomialf(const float *parameters, float *polynomial);
void orthogonal_3r_cusp_polynomial_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients, lowest power first, of the polynomial in tan(theta3/2) that is (a^2 + b^2 - c^2)/d4^2, divided by
 * (d3 + d4 c3)^2.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  polynomial[5]
 *   14 operations */
void orthogonal_3r_aspect_polynomial(const double *parameters, double *polynomial);
void orthogonal_3r_aspect_polynomial_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_aspect_polynomialf(const float *parameters, float *polynomial);
void orthogonal_3r_aspect_polynomial_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* a, b, c of det J = a cos(theta2) + b sin(theta2) + c, from cos(theta3) and sin(theta3).
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   elbow[2] = (c3, s3)
 *   out  terms[3]
 *   12 operations */
void orthogonal_3r_determinant_terms(const double *parameters, const double *elbow, double *terms);
void orthogonal_3r_determinant_terms_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_determinant_termsf(const float *parameters, const float *elbow, float *terms);
void orthogonal_3r_determinant_terms_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* det J, the determinant of the position Jacobian.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   shoulder[2] = (c2, s2)
 *   in   elbow[2] = (c3, s3)
 *   out  determinant (one number)
 *   13 operations */
void orthogonal_3r_determinant(const double *parameters, const double *shoulder, const double *elbow, double *determinant);
void orthogonal_3r_determinant_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_determinantf(const float *parameters, const float *shoulder, const float *elbow, float *determinant);
void orthogonal_3r_determinant_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients of 1 and t^2 in (1 + t^2) f1, t = tan(theta3/2), which is 0 where the point is on axis 2.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  polynomial[2]
 *   2 operations */
void orthogonal_3r_second_axis(const double *parameters, double *polynomial);
void orthogonal_3r_second_axis_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_second_axisf(const float *parameters, float *polynomial);
void orthogonal_3r_second_axis_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* numerators of rho^2 and of z^2 of the cusp at a root of the cusp polynomial, and their denominator.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   elbow[2] = (c3, s3)
 *   out  cusp[3]
 *   45 operations */
void orthogonal_3r_triple_point(const double *parameters, const double *elbow, double *cusp);
void orthogonal_3r_triple_point_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_triple_pointf(const float *parameters, const float *elbow, float *cusp);
void orthogonal_3r_triple_point_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* rho^2 and z of the point, from the cosines and sines of theta2 and theta3.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   shoulder[2] = (c2, s2)
 *   in   elbow[2] = (c3, s3)
 *   out  target[2]
 *   11 operations */
void orthogonal_3r_image(const double *parameters, const double *shoulder, const double *elbow, double *target);
void orthogonal_3r_image_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_imagef(const float *parameters, const float *shoulder, const float *elbow, float *target);
void orthogonal_3r_image_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the conic E whose double contact with the unit circle is a node, by powers of R and z.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  conic[6][5]
 *   55 operations */
void orthogonal_3r_conic_terms(const double *parameters, double *conic);
void orthogonal_3r_conic_terms_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_conic_termsf(const float *parameters, float *conic);
void orthogonal_3r_conic_terms_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* numbers in the ratio of cos(theta2) and sin(theta2) of a posture at a target, and W.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   target[2] = (rho_squared, z)
 *   in   elbow[2] = (c3, s3)
 *   out  ratio[3]
 *   24 operations */
void orthogonal_3r_shoulder(const double *parameters, const double *target, const double *elbow, double *ratio);
void orthogonal_3r_shoulder_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_shoulderf(const float *parameters, const float *target, const float *elbow, float *ratio);
void orthogonal_3r_shoulder_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the point at theta1 = 0, from the cosines and sines of theta2 and theta3.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   shoulder[2] = (c2, s2)
 *   in   elbow[2] = (c3, s3)
 *   out  point[3]
 *   8 operations */
void orthogonal_3r_unturned(const double *parameters, const double *shoulder, const double *elbow, double *point);
void orthogonal_3r_unturned_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_unturnedf(const float *parameters, const float *shoulder, const float *elbow, float *point);
void orthogonal_3r_unturned_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* how many postures reach a target; in double precision certainly so where the margin exceeds 1.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   in   target[2] = (rho_squared, z)
 *   out  number (one number)
 *   out  margin (one number)
 *   172 operations */
void orthogonal_3r_number_of_postures(const double *parameters, const double *target, double *number, double *margin);
void orthogonal_3r_number_of_postures_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_number_of_posturesf(const float *parameters, const float *target, float *number, float *margin);
void orthogonal_3r_number_of_postures_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the domain 1 to 5 and the topology 1 to 9 of a design, each 0 where rounding would decide it.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  domain (one number)
 *   out  topology (one number)
 *   161 operations */
void orthogonal_3r_classify(const double *parameters, double *domain, double *topology);
void orthogonal_3r_classify_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_classifyf(const float *parameters, float *domain, float *topology);
void orthogonal_3r_classify_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* on which side of C1, C2, C3 or C4, E1, E2, E3 a design lies: above is positive, at most 1.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  sides[6]
 *   72 operations */
void orthogonal_3r_sides(const double *parameters, double *sides);
void orthogonal_3r_sides_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_sidesf(const float *parameters, float *sides);
void orthogonal_3r_sides_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* polynomials whose signs tell on which side of the surfaces a design lies: C1_whole, C1_factor, C1_radicand, C2,
 * C3, E, middle, E2, gap.
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  sides[9]
 *   34 operations */
void orthogonal_3r_exact_sides(const double *parameters, double *sides);
void orthogonal_3r_exact_sides_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_exact_sidesf(const float *parameters, float *sides);
void orthogonal_3r_exact_sides_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_ORTHOGONAL_3R_CUSPIDALITY_H */
