/* panda_continuation_pose.c: continuation pose of panda.
 * Made from templates/kernel.c.j2; inputs ffe24ac4057667bc0fdb3af44247cd0fc4e294e285c56b3e8e7834d10a9992fb.
 * 911 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#ifndef CHAINRULE_FLOAT
#define CHAINRULE_FOLLOWS
#define CHAINRULE_JOINTS 7
#endif
#include "panda_continuation_pose.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char panda_continuation_pose_digest[] = "ffe24ac4057667bc0fdb3af44247cd0fc4e294e285c56b3e8e7834d10a9992fb";
#endif

#define LANES 32
#define TERMS(name) name##_tile
#include "panda_continuation_pose.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "panda_continuation_pose.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(panda_continuation_pose)(const real *q, const real *held, real *error, real *jacobian, real *null_vector)
{
    panda_continuation_pose_one(q, held, error, jacobian, null_vector);
}

void CHAINRULE_NAME(panda_continuation_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 32];
    real held[16 * 32];
    real error[6 * 32];
    real jacobian[42 * 32];
    real null_vector[7 * 32];
    const int streaming = chainrule_streams(count, 55);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[5], steps[5]);
            chainrule_gather(held, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[6], steps[7]);
            panda_continuation_pose_one(q, held, error, jacobian, null_vector);
            chainrule_scatter(error, 1, 1, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[8], steps[8], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 6, 7, steps[9], steps[10], 0);
            chainrule_scatter(null_vector, 1, 1, args[4] + start * steps[4], steps[4], 1, 7, 7 * steps[11], steps[11], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(held, 32, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[6], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 16, taken, 0);
            if (!chainrule_past(streaming, 6, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 42, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 42, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 7, taken, 1);
            }
            panda_continuation_pose_tile(q, held, error, jacobian, null_vector);
            chainrule_scatter(error, 32, taken, args[2] + start * steps[2], steps[2], 1, 6, 6 * steps[8], steps[8], streaming);
            chainrule_scatter(jacobian, 32, taken, args[3] + start * steps[3], steps[3], 6, 7, steps[9], steps[10], streaming);
            chainrule_scatter(null_vector, 32, taken, args[4] + start * steps[4], steps[4], 1, 7, 7 * steps[11], steps[11], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(panda_continuation_pose_bending)(const real *q, real *null_vector, real *bending)
{
    panda_continuation_pose_bending_one(q, null_vector, bending);
}

void CHAINRULE_NAME(panda_continuation_pose_bending_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 32];
    real null_vector[7 * 32];
    real bending[7 * 32];
    const int streaming = chainrule_streams(count, 14);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[3], steps[3]);
            panda_continuation_pose_bending_one(q, null_vector, bending);
            chainrule_scatter(null_vector, 1, 1, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[4], steps[4], 0);
            chainrule_scatter(bending, 1, 1, args[2] + start * steps[2], steps[2], 1, 7, 7 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 7, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 7, taken, 1);
            }
            if (!chainrule_past(streaming, 7, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 7, taken, 1);
            }
            panda_continuation_pose_bending_tile(q, null_vector, bending);
            chainrule_scatter(null_vector, 32, taken, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[4], steps[4], streaming);
            chainrule_scatter(bending, 32, taken, args[2] + start * steps[2], steps[2], 1, 7, 7 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

#ifndef CHAINRULE_FLOAT
static void panda_continuation_pose_held(const chainrule_curve *curve, const double *q, double *error, double *jacobian, double *null_vector)
{
    panda_continuation_pose_one(q, curve->target, error, jacobian, null_vector);
}

static void panda_continuation_pose_turning(const chainrule_curve *curve, const double *q, double *null_vector, double *bending)
{
    (void)curve;
    panda_continuation_pose_bending_one(q, null_vector, bending);
}

static void panda_continuation_pose_curve(chainrule_curve *curve)
{
    memset(curve, 0, sizeof *curve);
    curve->positions = 3; /* the first rows are lengths */
    curve->whole = 1; /* and all of the tip's velocity */
    curve->spatial = 1;
    curve->kinds = "RRRRRRR";
    curve->held = panda_continuation_pose_held;
    curve->bending = panda_continuation_pose_turning;
}

ptrdiff_t panda_continuation_pose_follow(ptrdiff_t count, const chainrule_curve_inputs *inputs, const chainrule_curve_settings *settings,
    chainrule_curve_room *room, double *boxes, chainrule_curve_result *results)
{
    chainrule_curve curve;
    panda_continuation_pose_curve(&curve);
    return chainrule_follow_all(&curve, count, inputs, settings, room, boxes, results);
}

void panda_continuation_pose_correct(ptrdiff_t count, const chainrule_curve_inputs *inputs, int times, double *q, double *tangents)
{
    chainrule_curve curve;
    panda_continuation_pose_curve(&curve);
    chainrule_correct_all(&curve, count, inputs, times, q, tangents);
}
#endif
