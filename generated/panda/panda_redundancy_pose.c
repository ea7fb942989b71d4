/* panda_redundancy_pose.c: redundancy pose of panda.
 * Made from templates/kernel.c.j2; inputs da0c610228a53b08ea4db89ad40eb469e2694046aadb32376aeecc53b7c3992f.
 * 2211 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "panda_redundancy_pose.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char panda_redundancy_pose_digest[] = "da0c610228a53b08ea4db89ad40eb469e2694046aadb32376aeecc53b7c3992f";
#endif

#define LANES 16
#define TERMS(name) name##_tile
#include "panda_redundancy_pose.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "panda_redundancy_pose.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(panda_step_pose)(const real *q, const real *held, const real *velocity, const real *push, const real *joints, const real *settings, real *q_next, real *rates, real *manipulability, real *error, real *null_motion)
{
    panda_step_pose_one(q, held, velocity, push, joints, settings, q_next, rates, manipulability, error, null_motion);
}

void CHAINRULE_NAME(panda_step_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 16];
    real held[16 * 16];
    real velocity[6 * 16];
    real push[7 * 16];
    real joints[28 * 16];
    real settings[12 * 16];
    real q_next[7 * 16];
    real rates[7 * 16];
    real manipulability[1 * 16];
    real error[6 * 16];
    real null_motion[7 * 16];
    const int streaming = chainrule_streams(count, 28);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 16);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[11], steps[11]);
            chainrule_gather(held, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[12], steps[13]);
            chainrule_gather(velocity, 1, 1, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[14], steps[14]);
            chainrule_gather(push, 1, 1, args[3] + start * steps[3], steps[3], 1, 7, 7 * steps[15], steps[15]);
            chainrule_gather(joints, 1, 1, args[4] + start * steps[4], steps[4], 4, 7, steps[16], steps[17]);
            chainrule_gather(settings, 1, 1, args[5] + start * steps[5], steps[5], 1, 12, 12 * steps[18], steps[18]);
            panda_step_pose_one(q, held, velocity, push, joints, settings, q_next, rates, manipulability, error, null_motion);
            chainrule_scatter(q_next, 1, 1, args[6] + start * steps[6], steps[6], 1, 7, 7 * steps[19], steps[19], 0);
            chainrule_scatter(rates, 1, 1, args[7] + start * steps[7], steps[7], 1, 7, 7 * steps[20], steps[20], 0);
            chainrule_scatter(manipulability, 1, 1, args[8] + start * steps[8], steps[8], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(error, 1, 1, args[9] + start * steps[9], steps[9], 1, 6, 6 * steps[21], steps[21], 0);
            chainrule_scatter(null_motion, 1, 1, args[10] + start * steps[10], steps[10], 1, 7, 7 * steps[22], steps[22], 0);
        } else {
            chainrule_gather(q, 16, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[11], steps[11]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(held, 16, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[12], steps[13]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(velocity, 16, taken, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[14], steps[14]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(push, 16, taken, args[3] + start * steps[3], steps[3], 1, 7, 7 * steps[15], steps[15]);
            if (start == 0 || steps[4] != 0) /* the same for all: once */
                chainrule_gather(joints, 16, taken, args[4] + start * steps[4], steps[4], 4, 7, steps[16], steps[17]);
            if (start == 0 || steps[5] != 0) /* the same for all: once */
                chainrule_gather(settings, 16, taken, args[5] + start * steps[5], steps[5], 1, 12, 12 * steps[18], steps[18]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 16, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 6, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 7, taken, 0);
            chainrule_fetch(args[4] + (start + taken) * steps[4], steps[4], 28, taken, 0);
            chainrule_fetch(args[5] + (start + taken) * steps[5], steps[5], 12, taken, 0);
            if (!chainrule_past(streaming, 7, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 7, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 7, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[8])) {
                chainrule_fetch(args[8] + start * steps[8], steps[8], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[9])) {
                chainrule_fetch(args[9] + start * steps[9], steps[9], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[10])) {
                chainrule_fetch(args[10] + start * steps[10], steps[10], 7, taken, 1);
            }
            panda_step_pose_tile(q, held, velocity, push, joints, settings, q_next, rates, manipulability, error, null_motion);
            chainrule_scatter(q_next, 16, taken, args[6] + start * steps[6], steps[6], 1, 7, 7 * steps[19], steps[19], streaming);
            chainrule_scatter(rates, 16, taken, args[7] + start * steps[7], steps[7], 1, 7, 7 * steps[20], steps[20], streaming);
            chainrule_scatter(manipulability, 16, taken, args[8] + start * steps[8], steps[8], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(error, 16, taken, args[9] + start * steps[9], steps[9], 1, 6, 6 * steps[21], steps[21], streaming);
            chainrule_scatter(null_motion, 16, taken, args[10] + start * steps[10], steps[10], 1, 7, 7 * steps[22], steps[22], streaming);
        }
    }
    chainrule_settle(streaming);
}
