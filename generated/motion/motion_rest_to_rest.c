/* motion_rest_to_rest.c: rest to rest of motion.
 * Made from templates/kernel.c.j2; inputs 71046b4df1d46617806e256601539406ec872670a5c40f2ec7ca65610b5bc45d.
 * 56 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "motion_rest_to_rest.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char motion_rest_to_rest_digest[] = "71046b4df1d46617806e256601539406ec872670a5c40f2ec7ca65610b5bc45d";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "motion_rest_to_rest.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "motion_rest_to_rest.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(motion_rest_to_rest)(const real *move, real *profile)
{
    motion_rest_to_rest_one(move, profile);
}

void CHAINRULE_NAME(motion_rest_to_rest_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real move[3 * 64];
    real profile[4 * 64];
    const int streaming = chainrule_streams(count, 4);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(move, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[2], steps[2]);
            motion_rest_to_rest_one(move, profile);
            chainrule_scatter(profile, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(move, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            if (!chainrule_past(streaming, 4, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 4, taken, 1);
            }
            motion_rest_to_rest_tile(move, profile);
            chainrule_scatter(profile, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(motion_rest_to_rest_in)(const real *move, real *profile)
{
    motion_rest_to_rest_in_one(move, profile);
}

void CHAINRULE_NAME(motion_rest_to_rest_in_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real move[3 * 64];
    real profile[4 * 64];
    const int streaming = chainrule_streams(count, 4);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(move, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[2], steps[2]);
            motion_rest_to_rest_in_one(move, profile);
            chainrule_scatter(profile, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(move, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            if (!chainrule_past(streaming, 4, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 4, taken, 1);
            }
            motion_rest_to_rest_in_tile(move, profile);
            chainrule_scatter(profile, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(motion_rest_to_rest_state)(const real *instant, real *state)
{
    motion_rest_to_rest_state_one(instant, state);
}

void CHAINRULE_NAME(motion_rest_to_rest_state_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real instant[4 * 64];
    real state[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(instant, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            motion_rest_to_rest_state_one(instant, state);
            chainrule_scatter(state, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(instant, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 2, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 2, taken, 1);
            }
            motion_rest_to_rest_state_tile(instant, state);
            chainrule_scatter(state, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}
