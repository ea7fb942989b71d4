/* ur5e_position.c: manipulability (position) of ur5e.
 * Made from templates/kernel.c.j2; inputs aadd4c9853b241c514ca27ae82a3f2cb598febefd9711612d9090fdace4c3025.
 * 836 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "ur5e_position.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char ur5e_position_digest[] = "aadd4c9853b241c514ca27ae82a3f2cb598febefd9711612d9090fdace4c3025";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "ur5e_position.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "ur5e_position.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(ur5e_manipulability_position)(const real *q, real *manipulability)
{
    ur5e_manipulability_position_one(q, manipulability);
}

void CHAINRULE_NAME(ur5e_manipulability_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real manipulability[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            ur5e_manipulability_position_one(q, manipulability);
            chainrule_scatter(manipulability, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            ur5e_manipulability_position_tile(q, manipulability);
            chainrule_scatter(manipulability, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(ur5e_manipulability_gradient_position)(const real *q, real *manipulability, real *gradient, real *inverse_gradient, real *inverse_root_gradient)
{
    ur5e_manipulability_gradient_position_one(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
}

void CHAINRULE_NAME(ur5e_manipulability_gradient_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real manipulability[1 * 64];
    real gradient[6 * 64];
    real inverse_gradient[6 * 64];
    real inverse_root_gradient[6 * 64];
    const int streaming = chainrule_streams(count, 19);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[5], steps[5]);
            ur5e_manipulability_gradient_position_one(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(gradient, 1, 1, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[6], steps[6], 0);
            chainrule_scatter(inverse_gradient, 1, 1, args[3] + start * steps[3], steps[3], 1, 6, 6 * steps[7], steps[7], 0);
            chainrule_scatter(inverse_root_gradient, 1, 1, args[4] + start * steps[4], steps[4], 1, 6, 6 * steps[8], steps[8], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 6, taken, 1);
            }
            ur5e_manipulability_gradient_position_tile(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(gradient, 64, taken, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[6], steps[6], streaming);
            chainrule_scatter(inverse_gradient, 64, taken, args[3] + start * steps[3], steps[3], 1, 6, 6 * steps[7], steps[7], streaming);
            chainrule_scatter(inverse_root_gradient, 64, taken, args[4] + start * steps[4], steps[4], 1, 6, 6 * steps[8], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(ur5e_minors_position)(const real *q, real *minors)
{
    ur5e_minors_position_one(q, minors);
}

void CHAINRULE_NAME(ur5e_minors_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real minors[20 * 64];
    const int streaming = chainrule_streams(count, 20);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            ur5e_minors_position_one(q, minors);
            chainrule_scatter(minors, 1, 1, args[1] + start * steps[1], steps[1], 1, 20, 20 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 20, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 20, taken, 1);
            }
            ur5e_minors_position_tile(q, minors);
            chainrule_scatter(minors, 64, taken, args[1] + start * steps[1], steps[1], 1, 20, 20 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(ur5e_null_projector_position)(const real *q, real *null_projector)
{
    ur5e_null_projector_position_one(q, null_projector);
}

void CHAINRULE_NAME(ur5e_null_projector_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real null_projector[36 * 64];
    const int streaming = chainrule_streams(count, 36);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            ur5e_null_projector_position_one(q, null_projector);
            chainrule_scatter(null_projector, 1, 1, args[1] + start * steps[1], steps[1], 6, 6, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 36, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 36, taken, 1);
            }
            ur5e_null_projector_position_tile(q, null_projector);
            chainrule_scatter(null_projector, 64, taken, args[1] + start * steps[1], steps[1], 6, 6, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}
