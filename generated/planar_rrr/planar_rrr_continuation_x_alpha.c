/* planar_rrr_continuation_x_alpha.c: continuation x alpha of planar_rrr.
 * Made from templates/kernel.c.j2; inputs f29b1b245621ebe2effe4dc47543535c5f273522534b650aa5e0573e5f938bfd.
 * 102 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#ifndef CHAINRULE_FLOAT
#define CHAINRULE_FOLLOWS
#define CHAINRULE_JOINTS 3
#endif
#include "planar_rrr_continuation_x_alpha.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char planar_rrr_continuation_x_alpha_digest[] = "f29b1b245621ebe2effe4dc47543535c5f273522534b650aa5e0573e5f938bfd";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "planar_rrr_continuation_x_alpha.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "planar_rrr_continuation_x_alpha.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(planar_rrr_continuation_x_alpha)(const real *q, const real *held, const real *parameters, real *error, real *jacobian, real *null_vector)
{
    planar_rrr_continuation_x_alpha_one(q, held, parameters, error, jacobian, null_vector);
}

void CHAINRULE_NAME(planar_rrr_continuation_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real held[2 * 64];
    real parameters[3 * 64];
    real error[2 * 64];
    real jacobian[6 * 64];
    real null_vector[3 * 64];
    const int streaming = chainrule_streams(count, 11);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[6], steps[6]);
            chainrule_gather(held, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_continuation_x_alpha_one(q, held, parameters, error, jacobian, null_vector);
            chainrule_scatter(error, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[9], steps[9], 0);
            chainrule_scatter(jacobian, 1, 1, args[4] + start * steps[4], steps[4], 2, 3, steps[10], steps[11], 0);
            chainrule_scatter(null_vector, 1, 1, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[12], steps[12], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[6], steps[6]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(held, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[7], steps[7]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 3, taken, 1);
            }
            planar_rrr_continuation_x_alpha_tile(q, held, parameters, error, jacobian, null_vector);
            chainrule_scatter(error, 64, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[9], steps[9], streaming);
            chainrule_scatter(jacobian, 64, taken, args[4] + start * steps[4], steps[4], 2, 3, steps[10], steps[11], streaming);
            chainrule_scatter(null_vector, 64, taken, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[12], steps[12], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_continuation_x_alpha_bending)(const real *q, const real *parameters, real *null_vector, real *bending)
{
    planar_rrr_continuation_x_alpha_bending_one(q, parameters, null_vector, bending);
}

void CHAINRULE_NAME(planar_rrr_continuation_x_alpha_bending_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real null_vector[3 * 64];
    real bending[3 * 64];
    const int streaming = chainrule_streams(count, 6);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            planar_rrr_continuation_x_alpha_bending_one(q, parameters, null_vector, bending);
            chainrule_scatter(null_vector, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6], 0);
            chainrule_scatter(bending, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            planar_rrr_continuation_x_alpha_bending_tile(q, parameters, null_vector, bending);
            chainrule_scatter(null_vector, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6], streaming);
            chainrule_scatter(bending, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

#ifndef CHAINRULE_FLOAT
static void planar_rrr_continuation_x_alpha_held(const chainrule_curve *curve, const double *q, double *error, double *jacobian, double *null_vector)
{
    planar_rrr_continuation_x_alpha_one(q, curve->target, curve->parameters, error, jacobian, null_vector);
}

static void planar_rrr_continuation_x_alpha_turning(const chainrule_curve *curve, const double *q, double *null_vector, double *bending)
{
    planar_rrr_continuation_x_alpha_bending_one(q, curve->parameters, null_vector, bending);
}

static void planar_rrr_continuation_x_alpha_curve(chainrule_curve *curve)
{
    memset(curve, 0, sizeof *curve);
    curve->positions = 1; /* the first rows are lengths */
    curve->whole = 0; /* and all of the tip's velocity */
    curve->spatial = 0;
    curve->kinds = "RRR";
    curve->held = planar_rrr_continuation_x_alpha_held;
    curve->bending = planar_rrr_continuation_x_alpha_turning;
}

ptrdiff_t planar_rrr_continuation_x_alpha_follow(ptrdiff_t count, const chainrule_curve_inputs *inputs, const chainrule_curve_settings *settings,
    chainrule_curve_room *room, double *boxes, chainrule_curve_result *results)
{
    chainrule_curve curve;
    planar_rrr_continuation_x_alpha_curve(&curve);
    return chainrule_follow_all(&curve, count, inputs, settings, room, boxes, results);
}

void planar_rrr_continuation_x_alpha_correct(ptrdiff_t count, const chainrule_curve_inputs *inputs, int times, double *q, double *tangents)
{
    chainrule_curve curve;
    planar_rrr_continuation_x_alpha_curve(&curve);
    chainrule_correct_all(&curve, count, inputs, times, q, tangents);
}
#endif
