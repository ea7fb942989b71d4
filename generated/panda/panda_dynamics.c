/* panda_dynamics.c: dynamics of panda.
 * Made from templates/kernel.c.j2; inputs bd15a8c9134bbab55d51bc366aa09c6a4a25f11da641bc777846aa4be347c394.
 * 845 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "panda_dynamics.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char panda_dynamics_digest[] = "bd15a8c9134bbab55d51bc366aa09c6a4a25f11da641bc777846aa4be347c394";
#endif

#define LANES 32
#define TERMS(name) name##_tile
#include "panda_dynamics.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "panda_dynamics.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(panda_inverse_dynamics)(const real *q, const real *rates, const real *accelerations, const real *inertias, const real *gravity, const real *wrench, real *torque)
{
    panda_inverse_dynamics_one(q, rates, accelerations, inertias, gravity, wrench, torque);
}

void CHAINRULE_NAME(panda_inverse_dynamics_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 32];
    real rates[7 * 32];
    real accelerations[7 * 32];
    real inertias[70 * 32];
    real gravity[3 * 32];
    real wrench[6 * 32];
    real torque[7 * 32];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[7], steps[7]);
            chainrule_gather(rates, 1, 1, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[8], steps[8]);
            chainrule_gather(accelerations, 1, 1, args[2] + start * steps[2], steps[2], 1, 7, 7 * steps[9], steps[9]);
            chainrule_gather(inertias, 1, 1, args[3] + start * steps[3], steps[3], 7, 10, steps[10], steps[11]);
            chainrule_gather(gravity, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[12], steps[12]);
            chainrule_gather(wrench, 1, 1, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[13], steps[13]);
            panda_inverse_dynamics_one(q, rates, accelerations, inertias, gravity, wrench, torque);
            chainrule_scatter(torque, 1, 1, args[6] + start * steps[6], steps[6], 1, 7, 7 * steps[14], steps[14], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[7], steps[7]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(rates, 32, taken, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[8], steps[8]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(accelerations, 32, taken, args[2] + start * steps[2], steps[2], 1, 7, 7 * steps[9], steps[9]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(inertias, 32, taken, args[3] + start * steps[3], steps[3], 7, 10, steps[10], steps[11]);
            if (start == 0 || steps[4] != 0) /* the same for all: once */
                chainrule_gather(gravity, 32, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[12], steps[12]);
            if (start == 0 || steps[5] != 0) /* the same for all: once */
                chainrule_gather(wrench, 32, taken, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[13], steps[13]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 7, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 7, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 70, taken, 0);
            chainrule_fetch(args[4] + (start + taken) * steps[4], steps[4], 3, taken, 0);
            chainrule_fetch(args[5] + (start + taken) * steps[5], steps[5], 6, taken, 0);
            if (!chainrule_past(streaming, 7, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 7, taken, 1);
            }
            panda_inverse_dynamics_tile(q, rates, accelerations, inertias, gravity, wrench, torque);
            chainrule_scatter(torque, 32, taken, args[6] + start * steps[6], steps[6], 1, 7, 7 * steps[14], steps[14], streaming);
        }
    }
    chainrule_settle(streaming);
}
