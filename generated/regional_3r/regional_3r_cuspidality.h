/* regional_3r_cuspidality.h: cuspidality of regional_3r.
 * Made from templates/kernel.h.j2; inputs 75e033e629be7085bf11ded7e3a5804c34f745dda6e84345d76a89b262b8c17c.
 * 5743 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_REGIONAL_3R_CUSPIDALITY_H
#define CHAINRULE_REGIONAL_3R_CUSPIDALITY_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char regional_3r_cuspidality_digest[];

/* coefficients, lowest power of tan(theta3/2) first, of the quartic whose roots are the postures at a target.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   target[2] = (rho_squared, z)
 *   out  quartic[5]
 *   95 operations */
void regional_3r_quartic(const double *parameters, const double *target, double *quartic);
void regional_3r_quartic_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_quarticf(const float *parameters, const float *target, float *quartic);
void regional_3r_quartic_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   out  polynomial[13]
 *   246 operations */
void regional_3r_cusp_polynomial(const double *parameters, double *polynomial);
void regional_3r_cusp_polynomial_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_cusp_polynomialf(const float *parameters, float *polynomial);
void regional_3r_cusp_polynomial_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients, lowest power first, of the polynomial in tan(theta3/2) whose roots are the cusps, for alpha2 =
 * +-90 deg: those with z^2 >= 0.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   out  polynomial[7]
 *   44 operations */
void regional_3r_cusp_polynomial_right_angle(const double *parameters, double *polynomial);
void regional_3r_cusp_polynomial_right_angle_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_cusp_polynomial_right_anglef(const float *parameters, float *polynomial);
void regional_3r_cusp_polynomial_right_angle_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients, lowest power first, of the polynomial in tan(theta3/2) that is (a^2 + b^2 - c^2)/d4^2.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   out  polynomial[9]
 *   115 operations */
void regional_3r_aspect_polynomial(const double *parameters, double *polynomial);
void regional_3r_aspect_polynomial_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_aspect_polynomialf(const float *parameters, float *polynomial);
void regional_3r_aspect_polynomial_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* a, b, c of det J = a cos(theta2) + b sin(theta2) + c, from cos(theta3) and sin(theta3).
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   elbow[2] = (c3, s3)
 *   out  terms[3]
 *   36 operations */
void regional_3r_determinant_terms(const double *parameters, const double *elbow, double *terms);
void regional_3r_determinant_terms_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_determinant_termsf(const float *parameters, const float *elbow, float *terms);
void regional_3r_determinant_terms_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* det J, the determinant of the position Jacobian.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   shoulder[2] = (c2, s2)
 *   in   elbow[2] = (c3, s3)
 *   out  determinant (one number)
 *   39 operations */
void regional_3r_determinant(const double *parameters, const double *shoulder, const double *elbow, double *determinant);
void regional_3r_determinant_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_determinantf(const float *parameters, const float *shoulder, const float *elbow, float *determinant);
void regional_3r_determinant_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients of 1 and t^2 in (1 + t^2) f1, t = tan(theta3/2), which is 0 where the point is on axis 2.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   out  polynomial[2]
 *   2 operations */
void regional_3r_second_axis(const double *parameters, double *polynomial);
void regional_3r_second_axis_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_second_axisf(const float *parameters, float *polynomial);
void regional_3r_second_axis_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* invariants I, J of a quartic, 27 times its discriminant, and what tells four real roots from none.
 *   in   coefficients[5] = (e0, e1, e2, e3, e4)
 *   out  invariants[2]
 *   out  discriminating[3]
 *   53 operations */
void regional_3r_quartic_invariants(const double *coefficients, double *invariants, double *discriminating);
void regional_3r_quartic_invariants_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_quartic_invariantsf(const float *coefficients, float *invariants, float *discriminating);
void regional_3r_quartic_invariants_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* numerators of rho^2 and of z of the cusp at a root of the cusp polynomial, and their denominator.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   elbow[2] = (c3, s3)
 *   out  cusp[3]
 *   92 operations */
void regional_3r_triple_point(const double *parameters, const double *elbow, double *cusp);
void regional_3r_triple_point_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_triple_pointf(const float *parameters, const float *elbow, float *cusp);
void regional_3r_triple_point_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* numerators of rho^2 and of z^2 of the cusp at a root of the cusp polynomial, and their denominator.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   elbow[2] = (c3, s3)
 *   out  cusp[3]
 *   77 operations */
void regional_3r_triple_point_right_angle(const double *parameters, const double *elbow, double *cusp);
void regional_3r_triple_point_right_angle_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_triple_point_right_anglef(const float *parameters, const float *elbow, float *cusp);
void regional_3r_triple_point_right_angle_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* rho^2 and z of the point, from the cosines and sines of theta2 and theta3.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   shoulder[2] = (c2, s2)
 *   in   elbow[2] = (c3, s3)
 *   out  target[2]
 *   27 operations */
void regional_3r_image(const double *parameters, const double *shoulder, const double *elbow, double *target);
void regional_3r_image_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_imagef(const float *parameters, const float *shoulder, const float *elbow, float *target);
void regional_3r_image_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the conic E whose double contact with the unit circle is a node, by powers of R and z.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   out  conic[6][5]
 *   188 operations */
void regional_3r_conic_terms(const double *parameters, double *conic);
void regional_3r_conic_terms_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_conic_termsf(const float *parameters, float *conic);
void regional_3r_conic_terms_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* numbers in the ratio of cos(theta2) and sin(theta2) of a posture at a target, and W.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   target[2] = (rho_squared, z)
 *   in   elbow[2] = (c3, s3)
 *   out  ratio[3]
 *   51 operations */
void regional_3r_shoulder(const double *parameters, const double *target, const double *elbow, double *ratio);
void regional_3r_shoulder_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_shoulderf(const float *parameters, const float *target, const float *elbow, float *ratio);
void regional_3r_shoulder_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the point at theta1 = 0, from the cosines and sines of theta2 and theta3.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   shoulder[2] = (c2, s2)
 *   in   elbow[2] = (c3, s3)
 *   out  point[3]
 *   24 operations */
void regional_3r_unturned(const double *parameters, const double *shoulder, const double *elbow, double *point);
void regional_3r_unturned_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_unturnedf(const float *parameters, const float *shoulder, const float *elbow, float *point);
void regional_3r_unturned_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* how many postures reach a target; in double precision certainly so where the margin exceeds 1.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   target[2] = (rho_squared, z)
 *   out  number (one number)
 *   out  margin (one number)
 *   260 operations */
void regional_3r_number_of_postures(const double *parameters, const double *target, double *number, double *margin);
void regional_3r_number_of_postures_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_number_of_posturesf(const float *parameters, const float *target, float *number, float *margin);
void regional_3r_number_of_postures_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* two pairs of postures at a point, the room of each (real if positive), the distances left, the slopes of E.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   point[3] = (x, y, z)
 *   out  angles[4][3]
 *   out  room[2]
 *   out  closure[4]
 *   out  slope[4]
 *   out  number (one number)
 *   out  margin (one number)
 *   2243 operations */
void regional_3r_postures(const double *parameters, const double *point, double *angles, double *room, double *closure, double *slope, double *number, double *margin);
void regional_3r_postures_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_posturesf(const float *parameters, const float *point, float *angles, float *room, float *closure, float *slope, float *number, float *margin);
void regional_3r_postures_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the postures of an arm with axes 1 and 2 intersecting, the distance each leaves, and W.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   point[3] = (x, y, z)
 *   out  angles[4][3]
 *   out  closure[4]
 *   out  width[4]
 *   884 operations */
void regional_3r_postures_intersecting(const double *parameters, const double *point, double *angles, double *closure, double *width);
void regional_3r_postures_intersecting_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_postures_intersectingf(const float *parameters, const float *point, float *angles, float *closure, float *width);
void regional_3r_postures_intersecting_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* the postures of an arm with axes 1 and 2 parallel, the distance each leaves, and W.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   point[3] = (x, y, z)
 *   out  angles[4][3]
 *   out  closure[4]
 *   out  width[4]
 *   878 operations */
void regional_3r_postures_parallel(const double *parameters, const double *point, double *angles, double *closure, double *width);
void regional_3r_postures_parallel_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_postures_parallelf(const float *parameters, const float *point, float *angles, float *closure, float *width);
void regional_3r_postures_parallel_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* coefficients, lowest power of t = tan(theta3/2) first, of (1 + t^2) U, (1 + t^2) V and (1 + t^2)^2 W.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   target[2] = (rho_squared, z)
 *   out  U[3]
 *   out  V[3]
 *   out  W[5]
 *   57 operations */
void regional_3r_sweep_conditions(const double *parameters, const double *target, double *U, double *V, double *W);
void regional_3r_sweep_conditions_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_sweep_conditionsf(const float *parameters, const float *target, float *U, float *V, float *W);
void regional_3r_sweep_conditions_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* U and V, and f1 and f2, the point in the frame of joint 2, from cos(theta3), sin(theta3) and a target.
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   elbow[2] = (c3, s3)
 *   in   target[2] = (rho_squared, z)
 *   out  mismatch[2]
 *   out  point[2]
 *   36 operations */
void regional_3r_sweep_elbow(const double *parameters, const double *elbow, const double *target, double *mismatch, double *point);
void regional_3r_sweep_elbow_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_sweep_elbowf(const float *parameters, const float *elbow, const float *target, float *mismatch, float *point);
void regional_3r_sweep_elbow_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* x and y of the point at theta1 = 0, from A, B and cos(theta3), sin(theta3).
 *   in   parameters[9] = (ca2, sa2, ca3, sa3, d2, d3, d4, r2, r3)
 *   in   elbow[2] = (c3, s3)
 *   in   turned[2] = (A, B)
 *   out  xy[2]
 *   9 operations */
void regional_3r_sweep_base(const double *parameters, const double *elbow, const double *turned, double *xy);
void regional_3r_sweep_base_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_sweep_basef(const float *parameters, const float *elbow, const float *turned, float *xy);
void regional_3r_sweep_base_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* angles a, b, c with Rz(a) second Rz(b) third Rz(c) = wanted, in two ways; real where |share| <= 1.
 *   in   second[3][3] = (second_11, second_12, second_13, second_21, second_22, second_23, second_31, second_32, second_33)
 *   in   third[3][3] = (third_11, third_12, third_13, third_21, third_22, third_23, third_31, third_32, third_33)
 *   in   wanted[3][3] = (wanted_11, wanted_12, wanted_13, wanted_21, wanted_22, wanted_23, wanted_31, wanted_32, wanted_33)
 *   out  angles[2][3]
 *   out  share[1]
 *   230 operations */
void regional_3r_spherical_orientations(const double *second, const double *third, const double *wanted, double *angles, double *share);
void regional_3r_spherical_orientations_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_spherical_orientationsf(const float *second, const float *third, const float *wanted, float *angles, float *share);
void regional_3r_spherical_orientations_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* angles of a joint, in two ways, at which a point behind it is sqrt(square) from one before it.
 *   in   before[3] = (s1, s2, s3)
 *   in   behind[3] = (w1, w2, w3)
 *   in   square[1] = (distance_squared)
 *   out  angles[2]
 *   out  share[1]
 *   57 operations */
void regional_3r_spherical_elbow(const double *before, const double *behind, const double *square, double *angles, double *share);
void regional_3r_spherical_elbow_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void regional_3r_spherical_elbowf(const float *before, const float *behind, const float *square, float *angles, float *share);
void regional_3r_spherical_elbow_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_REGIONAL_3R_CUSPIDALITY_H */
