/* motion_rest_to_rest.h: rest to rest of motion.
 * Made from templates/kernel.h.j2; inputs 71046b4df1d46617806e256601539406ec872670a5c40f2ec7ca65610b5bc45d.
 * 56 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_MOTION_REST_TO_REST_H
#define CHAINRULE_MOTION_REST_TO_REST_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char motion_rest_to_rest_digest[];

/* peak speed, ramp, cruise and duration of the fastest move from rest to rest.
 *   in   move[3] = (distance, velocity, acceleration)
 *   out  profile[4]
 *   11 operations */
void motion_rest_to_rest(const double *move, double *profile);
void motion_rest_to_rest_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void motion_rest_to_restf(const float *move, float *profile);
void motion_rest_to_rest_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* peak speed, ramp and cruise of a move from rest to rest in a given time, with the acceleration given.
 *   in   move[3] = (distance, acceleration, duration)
 *   out  profile[4]
 *   19 operations */
void motion_rest_to_rest_in(const double *move, double *profile);
void motion_rest_to_rest_in_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void motion_rest_to_rest_inf(const float *move, float *profile);
void motion_rest_to_rest_in_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* distance and speed at a time of a move from rest to rest.
 *   in   instant[4] = (peak, ramp, cruise, time)
 *   out  state[2]
 *   26 operations */
void motion_rest_to_rest_state(const double *instant, double *state);
void motion_rest_to_rest_state_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void motion_rest_to_rest_statef(const float *instant, float *state);
void motion_rest_to_rest_state_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_MOTION_REST_TO_REST_H */
