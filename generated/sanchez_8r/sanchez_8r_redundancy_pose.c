/* sanchez_8r_redundancy_pose.c: redundancy pose of sanchez_8r.
 * Made from templates/kernel.c.j2; inputs a3461720e029606439d74c9aceb69ab6bcb720cd1f77b30f3d342ac79d53c7c9.
 * 2941 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "sanchez_8r_redundancy_pose.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char sanchez_8r_redundancy_pose_digest[] = "a3461720e029606439d74c9aceb69ab6bcb720cd1f77b30f3d342ac79d53c7c9";
#endif

#define LANES 8
#define TERMS(name) name##_tile
#include "sanchez_8r_redundancy_pose.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "sanchez_8r_redundancy_pose.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(sanchez_8r_step_pose)(const real *q, const real *held, const real *velocity, const real *push, const real *joints, const real *settings, real *q_next, real *rates, real *manipulability, real *error, real *null_motion)
{
    sanchez_8r_step_pose_one(q, held, velocity, push, joints, settings, q_next, rates, manipulability, error, null_motion);
}

void CHAINRULE_NAME(sanchez_8r_step_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 8];
    real held[16 * 8];
    real velocity[6 * 8];
    real push[8 * 8];
    real joints[32 * 8];
    real settings[12 * 8];
    real q_next[8 * 8];
    real rates[8 * 8];
    real manipulability[1 * 8];
    real error[6 * 8];
    real null_motion[8 * 8];
    const int streaming = chainrule_streams(count, 31);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 8);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[11], steps[11]);
            chainrule_gather(held, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[12], steps[13]);
            chainrule_gather(velocity, 1, 1, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[14], steps[14]);
            chainrule_gather(push, 1, 1, args[3] + start * steps[3], steps[3], 1, 8, 8 * steps[15], steps[15]);
            chainrule_gather(joints, 1, 1, args[4] + start * steps[4], steps[4], 4, 8, steps[16], steps[17]);
            chainrule_gather(settings, 1, 1, args[5] + start * steps[5], steps[5], 1, 12, 12 * steps[18], steps[18]);
            sanchez_8r_step_pose_one(q, held, velocity, push, joints, settings, q_next, rates, manipulability, error, null_motion);
            chainrule_scatter(q_next, 1, 1, args[6] + start * steps[6], steps[6], 1, 8, 8 * steps[19], steps[19], 0);
            chainrule_scatter(rates, 1, 1, args[7] + start * steps[7], steps[7], 1, 8, 8 * steps[20], steps[20], 0);
            chainrule_scatter(manipulability, 1, 1, args[8] + start * steps[8], steps[8], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(error, 1, 1, args[9] + start * steps[9], steps[9], 1, 6, 6 * steps[21], steps[21], 0);
            chainrule_scatter(null_motion, 1, 1, args[10] + start * steps[10], steps[10], 1, 8, 8 * steps[22], steps[22], 0);
        } else {
            chainrule_gather(q, 8, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[11], steps[11]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(held, 8, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[12], steps[13]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(velocity, 8, taken, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[14], steps[14]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(push, 8, taken, args[3] + start * steps[3], steps[3], 1, 8, 8 * steps[15], steps[15]);
            if (start == 0 || steps[4] != 0) /* the same for all: once */
                chainrule_gather(joints, 8, taken, args[4] + start * steps[4], steps[4], 4, 8, steps[16], steps[17]);
            if (start == 0 || steps[5] != 0) /* the same for all: once */
                chainrule_gather(settings, 8, taken, args[5] + start * steps[5], steps[5], 1, 12, 12 * steps[18], steps[18]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 16, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 6, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 8, taken, 0);
            chainrule_fetch(args[4] + (start + taken) * steps[4], steps[4], 32, taken, 0);
            chainrule_fetch(args[5] + (start + taken) * steps[5], steps[5], 12, taken, 0);
            if (!chainrule_past(streaming, 8, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 8, taken, 1);
            }
            if (!chainrule_past(streaming, 8, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 8, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[8])) {
                chainrule_fetch(args[8] + start * steps[8], steps[8], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[9])) {
                chainrule_fetch(args[9] + start * steps[9], steps[9], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 8, steps[10])) {
                chainrule_fetch(args[10] + start * steps[10], steps[10], 8, taken, 1);
            }
            sanchez_8r_step_pose_tile(q, held, velocity, push, joints, settings, q_next, rates, manipulability, error, null_motion);
            chainrule_scatter(q_next, 8, taken, args[6] + start * steps[6], steps[6], 1, 8, 8 * steps[19], steps[19], streaming);
            chainrule_scatter(rates, 8, taken, args[7] + start * steps[7], steps[7], 1, 8, 8 * steps[20], steps[20], streaming);
            chainrule_scatter(manipulability, 8, taken, args[8] + start * steps[8], steps[8], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(error, 8, taken, args[9] + start * steps[9], steps[9], 1, 6, 6 * steps[21], steps[21], streaming);
            chainrule_scatter(null_motion, 8, taken, args[10] + start * steps[10], steps[10], 1, 8, 8 * steps[22], steps[22], streaming);
        }
    }
    chainrule_settle(streaming);
}
