/* planar_ppr_motion.c: motion of planar_ppr.
 * Made from templates/kernel.c.j2; inputs 18b1241e3541d21e565a17924e6723715e4f0ff2f740f05ea3a4f07b096ae92a.
 * 161 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "planar_ppr_motion.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char planar_ppr_motion_digest[] = "18b1241e3541d21e565a17924e6723715e4f0ff2f740f05ea3a4f07b096ae92a";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "planar_ppr_motion.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "planar_ppr_motion.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(planar_ppr_tip_motion)(const real *q, const real *parameters, const real *rates, const real *second, const real *third, real *derivatives, real *path)
{
    planar_ppr_tip_motion_one(q, parameters, rates, second, third, derivatives, path);
}

void CHAINRULE_NAME(planar_ppr_tip_motion_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[5 * 64];
    real rates[3 * 64];
    real second[3 * 64];
    real third[3 * 64];
    real derivatives[10 * 64];
    real path[4 * 64];
    const int streaming = chainrule_streams(count, 14);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 5, 5 * steps[8], steps[8]);
            chainrule_gather(rates, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[9], steps[9]);
            chainrule_gather(second, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[10], steps[10]);
            chainrule_gather(third, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[11], steps[11]);
            planar_ppr_tip_motion_one(q, parameters, rates, second, third, derivatives, path);
            chainrule_scatter(derivatives, 1, 1, args[5] + start * steps[5], steps[5], 5, 2, steps[12], steps[13], 0);
            chainrule_scatter(path, 1, 1, args[6] + start * steps[6], steps[6], 1, 4, 4 * steps[14], steps[14], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[7], steps[7]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 5, 5 * steps[8], steps[8]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(rates, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[9], steps[9]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(second, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[10], steps[10]);
            if (start == 0 || steps[4] != 0) /* the same for all: once */
                chainrule_gather(third, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[11], steps[11]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 5, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            chainrule_fetch(args[4] + (start + taken) * steps[4], steps[4], 3, taken, 0);
            if (!chainrule_past(streaming, 10, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 10, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 4, taken, 1);
            }
            planar_ppr_tip_motion_tile(q, parameters, rates, second, third, derivatives, path);
            chainrule_scatter(derivatives, 64, taken, args[5] + start * steps[5], steps[5], 5, 2, steps[12], steps[13], streaming);
            chainrule_scatter(path, 64, taken, args[6] + start * steps[6], steps[6], 1, 4, 4 * steps[14], steps[14], streaming);
        }
    }
    chainrule_settle(streaming);
}
