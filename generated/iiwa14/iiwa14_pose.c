/* iiwa14_pose.c: manipulability (pose) of iiwa14.
 * Made from templates/kernel.c.j2; inputs c651bc750b16194a69b4fb16a3147b4955beefc4951f117b4404890e4ed85dd7.
 * 1726 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "iiwa14_pose.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char iiwa14_pose_digest[] = "c651bc750b16194a69b4fb16a3147b4955beefc4951f117b4404890e4ed85dd7";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "iiwa14_pose.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "iiwa14_pose.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(iiwa14_manipulability_pose)(const real *q, real *manipulability)
{
    iiwa14_manipulability_pose_one(q, manipulability);
}

void CHAINRULE_NAME(iiwa14_manipulability_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real manipulability[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_manipulability_pose_one(q, manipulability);
            chainrule_scatter(manipulability, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            iiwa14_manipulability_pose_tile(q, manipulability);
            chainrule_scatter(manipulability, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_manipulability_gradient_pose)(const real *q, real *manipulability, real *gradient, real *inverse_gradient, real *inverse_root_gradient)
{
    iiwa14_manipulability_gradient_pose_one(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
}

void CHAINRULE_NAME(iiwa14_manipulability_gradient_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real manipulability[1 * 64];
    real gradient[7 * 64];
    real inverse_gradient[7 * 64];
    real inverse_root_gradient[7 * 64];
    const int streaming = chainrule_streams(count, 22);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[5], steps[5]);
            iiwa14_manipulability_gradient_pose_one(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(gradient, 1, 1, args[2] + start * steps[2], steps[2], 1, 7, 7 * steps[6], steps[6], 0);
            chainrule_scatter(inverse_gradient, 1, 1, args[3] + start * steps[3], steps[3], 1, 7, 7 * steps[7], steps[7], 0);
            chainrule_scatter(inverse_root_gradient, 1, 1, args[4] + start * steps[4], steps[4], 1, 7, 7 * steps[8], steps[8], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 7, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 7, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 7, taken, 1);
            }
            iiwa14_manipulability_gradient_pose_tile(q, manipulability, gradient, inverse_gradient, inverse_root_gradient);
            chainrule_scatter(manipulability, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(gradient, 64, taken, args[2] + start * steps[2], steps[2], 1, 7, 7 * steps[6], steps[6], streaming);
            chainrule_scatter(inverse_gradient, 64, taken, args[3] + start * steps[3], steps[3], 1, 7, 7 * steps[7], steps[7], streaming);
            chainrule_scatter(inverse_root_gradient, 64, taken, args[4] + start * steps[4], steps[4], 1, 7, 7 * steps[8], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_minors_pose)(const real *q, real *minors)
{
    iiwa14_minors_pose_one(q, minors);
}

void CHAINRULE_NAME(iiwa14_minors_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real minors[7 * 64];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_minors_pose_one(q, minors);
            chainrule_scatter(minors, 1, 1, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 7, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 7, taken, 1);
            }
            iiwa14_minors_pose_tile(q, minors);
            chainrule_scatter(minors, 64, taken, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_null_vector_pose)(const real *q, real *null_vector)
{
    iiwa14_null_vector_pose_one(q, null_vector);
}

void CHAINRULE_NAME(iiwa14_null_vector_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real null_vector[7 * 64];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_null_vector_pose_one(q, null_vector);
            chainrule_scatter(null_vector, 1, 1, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 7, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 7, taken, 1);
            }
            iiwa14_null_vector_pose_tile(q, null_vector);
            chainrule_scatter(null_vector, 64, taken, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_null_projector_pose)(const real *q, real *null_projector)
{
    iiwa14_null_projector_pose_one(q, null_projector);
}

void CHAINRULE_NAME(iiwa14_null_projector_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real null_projector[49 * 64];
    const int streaming = chainrule_streams(count, 49);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_null_projector_pose_one(q, null_projector);
            chainrule_scatter(null_projector, 1, 1, args[1] + start * steps[1], steps[1], 7, 7, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 49, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 49, taken, 1);
            }
            iiwa14_null_projector_pose_tile(q, null_projector);
            chainrule_scatter(null_projector, 64, taken, args[1] + start * steps[1], steps[1], 7, 7, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}
