/* planar_rrr_self_motion.h: self motion of planar_rrr.
 * Made from templates/kernel.h.j2; inputs 2d6e0728d7e0471aa1f34711d97efcdc8ee46c6069e2bce80c53b394abd5f280.
 * 1479 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_RRR_SELF_MOTION_H
#define CHAINRULE_PLANAR_RRR_SELF_MOTION_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_rrr_self_motion_digest[];

/* differences a - b, b - c, c - d of the sorted roots, and whether b is A and c is B.
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  gaps[3]
 *   out  pattern[2]
 *   19 operations */
void planar_rrr_self_motion_gaps_position(const double *reach, const double *sums, const double *parameters, double *gaps, double *pattern);
void planar_rrr_self_motion_gaps_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_gaps_positionf(const float *reach, const float *sums, const float *parameters, float *gaps, float *pattern);
void planar_rrr_self_motion_gaps_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* ds/d theta of the self-motion, theta uniform in the elliptic parameter.
 *   in   node[2] = (ct, st)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  speed (one number)
 *   279 operations */
void planar_rrr_self_motion_speed_position(const double *node, const double *reach, const double *sums, const double *parameters, double *speed);
void planar_rrr_self_motion_speed_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_speed_positionf(const float *node, const float *reach, const float *sums, const float *parameters, float *speed);
void planar_rrr_self_motion_speed_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* cosine and sine of phi at a point theta of the elliptic parameter.
 *   in   node[2] = (ct, st)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  phi[2]
 *   208 operations */
void planar_rrr_self_motion_turn_position(const double *node, const double *reach, const double *sums, const double *parameters, double *phi);
void planar_rrr_self_motion_turn_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_turn_positionf(const float *node, const float *reach, const float *sums, const float *parameters, float *phi);
void planar_rrr_self_motion_turn_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* joint values, their rates dq/dw, H and ds/d phi at a point phi of the self-motion.
 *   in   turn[2] = (cp, sp)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  q[3]
 *   out  rates[3]
 *   out  manipulability (one number)
 *   out  speed (one number)
 *   110 operations */
void planar_rrr_self_motion_point_position(const double *turn, const double *reach, const double *sums, const double *parameters, double *q, double *rates, double *manipulability, double *speed);
void planar_rrr_self_motion_point_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_point_positionf(const float *turn, const float *reach, const float *sums, const float *parameters, float *q, float *rates, float *manipulability, float *speed);
void planar_rrr_self_motion_point_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* sqrt(x - c) and sqrt(b - x), with the signs of cos phi and sin phi, of a configuration.
 *   in   halves[2] = (h1, h2)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  phase[2]
 *   40 operations */
void planar_rrr_self_motion_phase_position(const double *halves, const double *reach, const double *sums, const double *parameters, double *phase);
void planar_rrr_self_motion_phase_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_phase_positionf(const float *halves, const float *reach, const float *sums, const float *parameters, float *phase);
void planar_rrr_self_motion_phase_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* least and greatest absolute angle of each joint along the self-motion.
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  extremes[3][2]
 *   79 operations */
void planar_rrr_self_motion_extremes_position(const double *reach, const double *sums, const double *parameters, double *extremes);
void planar_rrr_self_motion_extremes_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_extremes_positionf(const float *reach, const float *sums, const float *parameters, float *extremes);
void planar_rrr_self_motion_extremes_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* both configurations in which each joint has a given value, and the radicands, negative where there are none.
 *   in   stops[3] = (v1, v2, v3)
 *   in   reach[1] = (r)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  q[6][3]
 *   out  radicands[3]
 *   87 operations */
void planar_rrr_self_motion_stops_position(const double *stops, const double *reach, const double *parameters, double *q, double *radicands);
void planar_rrr_self_motion_stops_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_stops_positionf(const float *stops, const float *reach, const float *parameters, float *q, float *radicands);
void planar_rrr_self_motion_stops_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* differences a - b, b - c, c - d of the sorted roots, and whether b is A and c is B.
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  gaps[3]
 *   out  pattern[2]
 *   12 operations */
void planar_rrr_self_motion_gaps_x_alpha(const double *reach, const double *sums, const double *parameters, double *gaps, double *pattern);
void planar_rrr_self_motion_gaps_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_gaps_x_alphaf(const float *reach, const float *sums, const float *parameters, float *gaps, float *pattern);
void planar_rrr_self_motion_gaps_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* ds/d theta of the self-motion, theta uniform in the elliptic parameter.
 *   in   node[2] = (ct, st)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  speed (one number)
 *   244 operations */
void planar_rrr_self_motion_speed_x_alpha(const double *node, const double *reach, const double *sums, const double *parameters, double *speed);
void planar_rrr_self_motion_speed_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_speed_x_alphaf(const float *node, const float *reach, const float *sums, const float *parameters, float *speed);
void planar_rrr_self_motion_speed_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* cosine and sine of phi at a point theta of the elliptic parameter.
 *   in   node[2] = (ct, st)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  phi[2]
 *   201 operations */
void planar_rrr_self_motion_turn_x_alpha(const double *node, const double *reach, const double *sums, const double *parameters, double *phi);
void planar_rrr_self_motion_turn_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_turn_x_alphaf(const float *node, const float *reach, const float *sums, const float *parameters, float *phi);
void planar_rrr_self_motion_turn_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* joint values, their rates dq/dw, H and ds/d phi at a point phi of the self-motion.
 *   in   turn[2] = (cp, sp)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  q[3]
 *   out  rates[3]
 *   out  manipulability (one number)
 *   out  speed (one number)
 *   70 operations */
void planar_rrr_self_motion_point_x_alpha(const double *turn, const double *reach, const double *sums, const double *parameters, double *q, double *rates, double *manipulability, double *speed);
void planar_rrr_self_motion_point_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_point_x_alphaf(const float *turn, const float *reach, const float *sums, const float *parameters, float *q, float *rates, float *manipulability, float *speed);
void planar_rrr_self_motion_point_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* sqrt(x - c) and sqrt(b - x), with the signs of cos phi and sin phi, of a configuration.
 *   in   halves[2] = (h1, h2)
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  phase[2]
 *   35 operations */
void planar_rrr_self_motion_phase_x_alpha(const double *halves, const double *reach, const double *sums, const double *parameters, double *phase);
void planar_rrr_self_motion_phase_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_phase_x_alphaf(const float *halves, const float *reach, const float *sums, const float *parameters, float *phase);
void planar_rrr_self_motion_phase_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* least and greatest absolute angle of each joint along the self-motion.
 *   in   reach[1] = (r)
 *   in   sums[8] = (m0, m1, m2, m3, p0, p1, p2, p3)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  extremes[3][2]
 *   48 operations */
void planar_rrr_self_motion_extremes_x_alpha(const double *reach, const double *sums, const double *parameters, double *extremes);
void planar_rrr_self_motion_extremes_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_extremes_x_alphaf(const float *reach, const float *sums, const float *parameters, float *extremes);
void planar_rrr_self_motion_extremes_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* both configurations in which each joint has a given value, and the radicands, negative where there are none.
 *   in   stops[3] = (v1, v2, v3)
 *   in   reach[1] = (r)
 *   in   parameters[3] = (l1, l2, l3)
 *   out  q[6][3]
 *   out  radicands[3]
 *   47 operations */
void planar_rrr_self_motion_stops_x_alpha(const double *stops, const double *reach, const double *parameters, double *q, double *radicands);
void planar_rrr_self_motion_stops_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rrr_self_motion_stops_x_alphaf(const float *stops, const float *reach, const float *parameters, float *q, float *radicands);
void planar_rrr_self_motion_stops_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_RRR_SELF_MOTION_H */
