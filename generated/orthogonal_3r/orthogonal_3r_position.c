/* orthogonal_3r_position.c: manipulability (position) of orthogonal_3r.
 * Made from templates/kernel.c.j2; inputs acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe.
 * 87 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "orthogonal_3r_position.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char orthogonal_3r_position_digest[] = "acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "orthogonal_3r_position.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "orthogonal_3r_position.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(orthogonal_3r_manipulability_position)(const real *q, const real *parameters, real *manipulability)
{
    orthogonal_3r_manipulability_position_one(q, parameters, manipulability);
}

void CHAINRULE_NAME(orthogonal_3r_manipulability_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real manipulability[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            orthogonal_3r_manipulability_position_one(q, parameters, manipulability);
            chainrule_scatter(manipulability, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 1, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 1, taken, 1);
            }
            orthogonal_3r_manipulability_position_tile(q, parameters, manipulability);
            chainrule_scatter(manipulability, 64, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_manipulability_gradient_position)(const real *q, const real *parameters, real *manipulability, real *gradient, real *inverse_gradient, real *inverse_root_gradient)
{
    orthogonal_3r_manipulability_gradient_position_one(q, parameters, manipulability, gradient, inverse_gradient, inverse_root_gradient);
}

void CHAINRULE_NAME(orthogonal_3r_manipulability_gradient_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real manipulability[1 * 64];
    real gradient[3 * 64];
    real inverse_gradient[3 * 64];
    real inverse_root_gradient[3 * 64];
    const int streaming = chainrule_streams(count, 10);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[6], steps[6]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[7], steps[7]);
            orthogonal_3r_manipulability_gradient_position_one(q, parameters, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(gradient, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], 0);
            chainrule_scatter(inverse_gradient, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[9], steps[9], 0);
            chainrule_scatter(inverse_root_gradient, 1, 1, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[10], steps[10], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[6], steps[6]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 1, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 3, taken, 1);
            }
            orthogonal_3r_manipulability_gradient_position_tile(q, parameters, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 64, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(gradient, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], streaming);
            chainrule_scatter(inverse_gradient, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[9], steps[9], streaming);
            chainrule_scatter(inverse_root_gradient, 64, taken, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[10], steps[10], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_minors_position)(const real *q, const real *parameters, real *minors)
{
    orthogonal_3r_minors_position_one(q, parameters, minors);
}

void CHAINRULE_NAME(orthogonal_3r_minors_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real minors[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            orthogonal_3r_minors_position_one(q, parameters, minors);
            chainrule_scatter(minors, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 1, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 1, taken, 1);
            }
            orthogonal_3r_minors_position_tile(q, parameters, minors);
            chainrule_scatter(minors, 64, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}
