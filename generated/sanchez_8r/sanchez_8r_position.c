/* sanchez_8r_position.c: manipulability (position) of sanchez_8r.
 * Made from templates/kernel.c.j2; inputs eeb6e159f30e282be02ccef25caa4195473462c7ef4cbbe95e0e7e7759cff87a.
 * 1893 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "sanchez_8r_position.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char sanchez_8r_position_digest[] = "eeb6e159f30e282be02ccef25caa4195473462c7ef4cbbe95e0e7e7759cff87a";
#endif

#define LANES 16
#define TERMS(name) name##_tile
#include "sanchez_8r_position.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "sanchez_8r_position.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(sanchez_8r_manipulability_position)(const real *q, real *manipulability)
{
    sanchez_8r_manipulability_position_one(q, manipulability);
}

void CHAINRULE_NAME(sanchez_8r_manipulability_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 16];
    real manipulability[1 * 16];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 16);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_manipulability_position_one(q, manipulability);
            chainrule_scatter(manipulability, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 16, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            sanchez_8r_manipulability_position_tile(q, manipulability);
            chainrule_scatter(manipulability, 16, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_manipulability_gradient_position)(const real *q, real *manipulability, real *gradient, real *inverse_gradient, real *inverse_root_gradient)
{
    sanchez_8r_manipulability_gradient_position_one(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
}

void CHAINRULE_NAME(sanchez_8r_manipulability_gradient_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 16];
    real manipulability[1 * 16];
    real gradient[8 * 16];
    real inverse_gradient[8 * 16];
    real inverse_root_gradient[8 * 16];
    const int streaming = chainrule_streams(count, 25);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 16);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[5], steps[5]);
            sanchez_8r_manipulability_gradient_position_one(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(gradient, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[6], steps[6], 0);
            chainrule_scatter(inverse_gradient, 1, 1, args[3] + start * steps[3], steps[3], 1, 8, 8 * steps[7], steps[7], 0);
            chainrule_scatter(inverse_root_gradient, 1, 1, args[4] + start * steps[4], steps[4], 1, 8, 8 * steps[8], steps[8], 0);
        } else {
            chainrule_gather(q, 16, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 8, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 8, taken, 1);
            }
            if (!chainrule_past(streaming, 8, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 8, taken, 1);
            }
            if (!chainrule_past(streaming, 8, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 8, taken, 1);
            }
            sanchez_8r_manipulability_gradient_position_tile(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 16, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(gradient, 16, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[6], steps[6], streaming);
            chainrule_scatter(inverse_gradient, 16, taken, args[3] + start * steps[3], steps[3], 1, 8, 8 * steps[7], steps[7], streaming);
            chainrule_scatter(inverse_root_gradient, 16, taken, args[4] + start * steps[4], steps[4], 1, 8, 8 * steps[8], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_minors_position)(const real *q, real *minors)
{
    sanchez_8r_minors_position_one(q, minors);
}

void CHAINRULE_NAME(sanchez_8r_minors_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 16];
    real minors[56 * 16];
    const int streaming = chainrule_streams(count, 56);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 16);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_minors_position_one(q, minors);
            chainrule_scatter(minors, 1, 1, args[1] + start * steps[1], steps[1], 1, 56, 56 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 16, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 56, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 56, taken, 1);
            }
            sanchez_8r_minors_position_tile(q, minors);
            chainrule_scatter(minors, 16, taken, args[1] + start * steps[1], steps[1], 1, 56, 56 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_null_projector_position)(const real *q, real *null_projector)
{
    sanchez_8r_null_projector_position_one(q, null_projector);
}

void CHAINRULE_NAME(sanchez_8r_null_projector_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 16];
    real null_projector[64 * 16];
    const int streaming = chainrule_streams(count, 64);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 16);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_null_projector_position_one(q, null_projector);
            chainrule_scatter(null_projector, 1, 1, args[1] + start * steps[1], steps[1], 8, 8, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 16, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 64, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 64, taken, 1);
            }
            sanchez_8r_null_projector_position_tile(q, null_projector);
            chainrule_scatter(null_projector, 16, taken, args[1] + start * steps[1], steps[1], 8, 8, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}
