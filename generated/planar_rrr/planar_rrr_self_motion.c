/* planar_rrr_self_motion.c: self motion of planar_rrr.
 * Made from templates/kernel.c.j2; inputs 2d6e0728d7e0471aa1f34711d97efcdc8ee46c6069e2bce80c53b394abd5f280.
 * 1479 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "planar_rrr_self_motion.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char planar_rrr_self_motion_digest[] = "2d6e0728d7e0471aa1f34711d97efcdc8ee46c6069e2bce80c53b394abd5f280";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "planar_rrr_self_motion.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "planar_rrr_self_motion.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(planar_rrr_self_motion_gaps_position)(const real *reach, const real *sums, const real *parameters, real *gaps, real *pattern)
{
    planar_rrr_self_motion_gaps_position_one(reach, sums, parameters, gaps, pattern);
}

void CHAINRULE_NAME(planar_rrr_self_motion_gaps_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real gaps[3 * 64];
    real pattern[2 * 64];
    const int streaming = chainrule_streams(count, 5);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(reach, 1, 1, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[5], steps[5]);
            chainrule_gather(sums, 1, 1, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[6], steps[6]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            planar_rrr_self_motion_gaps_position_one(reach, sums, parameters, gaps, pattern);
            chainrule_scatter(gaps, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], 0);
            chainrule_scatter(pattern, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(reach, 64, taken, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 1, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 8, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            planar_rrr_self_motion_gaps_position_tile(reach, sums, parameters, gaps, pattern);
            chainrule_scatter(gaps, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], streaming);
            chainrule_scatter(pattern, 64, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_speed_position)(const real *node, const real *reach, const real *sums, const real *parameters, real *speed)
{
    planar_rrr_self_motion_speed_position_one(node, reach, sums, parameters, speed);
}

void CHAINRULE_NAME(planar_rrr_self_motion_speed_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real node[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real speed[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(node, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_self_motion_speed_position_one(node, reach, sums, parameters, speed);
            chainrule_scatter(speed, 1, 1, args[4] + start * steps[4], steps[4], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(node, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 1, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 1, taken, 1);
            }
            planar_rrr_self_motion_speed_position_tile(node, reach, sums, parameters, speed);
            chainrule_scatter(speed, 64, taken, args[4] + start * steps[4], steps[4], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_turn_position)(const real *node, const real *reach, const real *sums, const real *parameters, real *phi)
{
    planar_rrr_self_motion_turn_position_one(node, reach, sums, parameters, phi);
}

void CHAINRULE_NAME(planar_rrr_self_motion_turn_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real node[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real phi[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(node, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_self_motion_turn_position_one(node, reach, sums, parameters, phi);
            chainrule_scatter(phi, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(node, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            planar_rrr_self_motion_turn_position_tile(node, reach, sums, parameters, phi);
            chainrule_scatter(phi, 64, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_point_position)(const real *turn, const real *reach, const real *sums, const real *parameters, real *q, real *rates, real *manipulability, real *speed)
{
    planar_rrr_self_motion_point_position_one(turn, reach, sums, parameters, q, rates, manipulability, speed);
}

void CHAINRULE_NAME(planar_rrr_self_motion_point_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real turn[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real q[3 * 64];
    real rates[3 * 64];
    real manipulability[1 * 64];
    real speed[1 * 64];
    const int streaming = chainrule_streams(count, 8);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(turn, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[8], steps[8]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[9], steps[9]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[10], steps[10]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[11], steps[11]);
            planar_rrr_self_motion_point_position_one(turn, reach, sums, parameters, q, rates, manipulability, speed);
            chainrule_scatter(q, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[12], steps[12], 0);
            chainrule_scatter(rates, 1, 1, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[13], steps[13], 0);
            chainrule_scatter(manipulability, 1, 1, args[6] + start * steps[6], steps[6], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(speed, 1, 1, args[7] + start * steps[7], steps[7], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(turn, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[8], steps[8]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[9], steps[9]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[10], steps[10]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[11], steps[11]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 1, taken, 1);
            }
            planar_rrr_self_motion_point_position_tile(turn, reach, sums, parameters, q, rates, manipulability, speed);
            chainrule_scatter(q, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[12], steps[12], streaming);
            chainrule_scatter(rates, 64, taken, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[13], steps[13], streaming);
            chainrule_scatter(manipulability, 64, taken, args[6] + start * steps[6], steps[6], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(speed, 64, taken, args[7] + start * steps[7], steps[7], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_phase_position)(const real *halves, const real *reach, const real *sums, const real *parameters, real *phase)
{
    planar_rrr_self_motion_phase_position_one(halves, reach, sums, parameters, phase);
}

void CHAINRULE_NAME(planar_rrr_self_motion_phase_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real halves[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real phase[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(halves, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_self_motion_phase_position_one(halves, reach, sums, parameters, phase);
            chainrule_scatter(phase, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(halves, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            planar_rrr_self_motion_phase_position_tile(halves, reach, sums, parameters, phase);
            chainrule_scatter(phase, 64, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_extremes_position)(const real *reach, const real *sums, const real *parameters, real *extremes)
{
    planar_rrr_self_motion_extremes_position_one(reach, sums, parameters, extremes);
}

void CHAINRULE_NAME(planar_rrr_self_motion_extremes_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real extremes[6 * 64];
    const int streaming = chainrule_streams(count, 6);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(reach, 1, 1, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[4], steps[4]);
            chainrule_gather(sums, 1, 1, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[5], steps[5]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6]);
            planar_rrr_self_motion_extremes_position_one(reach, sums, parameters, extremes);
            chainrule_scatter(extremes, 1, 1, args[3] + start * steps[3], steps[3], 3, 2, steps[7], steps[8], 0);
        } else {
            chainrule_gather(reach, 64, taken, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 1, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 8, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            planar_rrr_self_motion_extremes_position_tile(reach, sums, parameters, extremes);
            chainrule_scatter(extremes, 64, taken, args[3] + start * steps[3], steps[3], 3, 2, steps[7], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_stops_position)(const real *stops, const real *reach, const real *parameters, real *q, real *radicands)
{
    planar_rrr_self_motion_stops_position_one(stops, reach, parameters, q, radicands);
}

void CHAINRULE_NAME(planar_rrr_self_motion_stops_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real stops[3 * 64];
    real reach[1 * 64];
    real parameters[3 * 64];
    real q[18 * 64];
    real radicands[3 * 64];
    const int streaming = chainrule_streams(count, 21);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(stops, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            planar_rrr_self_motion_stops_position_one(stops, reach, parameters, q, radicands);
            chainrule_scatter(q, 1, 1, args[3] + start * steps[3], steps[3], 6, 3, steps[8], steps[9], 0);
            chainrule_scatter(radicands, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[10], steps[10], 0);
        } else {
            chainrule_gather(stops, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 18, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 18, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            planar_rrr_self_motion_stops_position_tile(stops, reach, parameters, q, radicands);
            chainrule_scatter(q, 64, taken, args[3] + start * steps[3], steps[3], 6, 3, steps[8], steps[9], streaming);
            chainrule_scatter(radicands, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[10], steps[10], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_gaps_x_alpha)(const real *reach, const real *sums, const real *parameters, real *gaps, real *pattern)
{
    planar_rrr_self_motion_gaps_x_alpha_one(reach, sums, parameters, gaps, pattern);
}

void CHAINRULE_NAME(planar_rrr_self_motion_gaps_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real gaps[3 * 64];
    real pattern[2 * 64];
    const int streaming = chainrule_streams(count, 5);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(reach, 1, 1, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[5], steps[5]);
            chainrule_gather(sums, 1, 1, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[6], steps[6]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            planar_rrr_self_motion_gaps_x_alpha_one(reach, sums, parameters, gaps, pattern);
            chainrule_scatter(gaps, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], 0);
            chainrule_scatter(pattern, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(reach, 64, taken, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 1, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 8, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            planar_rrr_self_motion_gaps_x_alpha_tile(reach, sums, parameters, gaps, pattern);
            chainrule_scatter(gaps, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], streaming);
            chainrule_scatter(pattern, 64, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_speed_x_alpha)(const real *node, const real *reach, const real *sums, const real *parameters, real *speed)
{
    planar_rrr_self_motion_speed_x_alpha_one(node, reach, sums, parameters, speed);
}

void CHAINRULE_NAME(planar_rrr_self_motion_speed_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real node[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real speed[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(node, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_self_motion_speed_x_alpha_one(node, reach, sums, parameters, speed);
            chainrule_scatter(speed, 1, 1, args[4] + start * steps[4], steps[4], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(node, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 1, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 1, taken, 1);
            }
            planar_rrr_self_motion_speed_x_alpha_tile(node, reach, sums, parameters, speed);
            chainrule_scatter(speed, 64, taken, args[4] + start * steps[4], steps[4], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_turn_x_alpha)(const real *node, const real *reach, const real *sums, const real *parameters, real *phi)
{
    planar_rrr_self_motion_turn_x_alpha_one(node, reach, sums, parameters, phi);
}

void CHAINRULE_NAME(planar_rrr_self_motion_turn_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real node[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real phi[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(node, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_self_motion_turn_x_alpha_one(node, reach, sums, parameters, phi);
            chainrule_scatter(phi, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(node, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            planar_rrr_self_motion_turn_x_alpha_tile(node, reach, sums, parameters, phi);
            chainrule_scatter(phi, 64, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_point_x_alpha)(const real *turn, const real *reach, const real *sums, const real *parameters, real *q, real *rates, real *manipulability, real *speed)
{
    planar_rrr_self_motion_point_x_alpha_one(turn, reach, sums, parameters, q, rates, manipulability, speed);
}

void CHAINRULE_NAME(planar_rrr_self_motion_point_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real turn[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real q[3 * 64];
    real rates[3 * 64];
    real manipulability[1 * 64];
    real speed[1 * 64];
    const int streaming = chainrule_streams(count, 8);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(turn, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[8], steps[8]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[9], steps[9]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[10], steps[10]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[11], steps[11]);
            planar_rrr_self_motion_point_x_alpha_one(turn, reach, sums, parameters, q, rates, manipulability, speed);
            chainrule_scatter(q, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[12], steps[12], 0);
            chainrule_scatter(rates, 1, 1, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[13], steps[13], 0);
            chainrule_scatter(manipulability, 1, 1, args[6] + start * steps[6], steps[6], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(speed, 1, 1, args[7] + start * steps[7], steps[7], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(turn, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[8], steps[8]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[9], steps[9]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[10], steps[10]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[11], steps[11]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 1, taken, 1);
            }
            planar_rrr_self_motion_point_x_alpha_tile(turn, reach, sums, parameters, q, rates, manipulability, speed);
            chainrule_scatter(q, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[12], steps[12], streaming);
            chainrule_scatter(rates, 64, taken, args[5] + start * steps[5], steps[5], 1, 3, 3 * steps[13], steps[13], streaming);
            chainrule_scatter(manipulability, 64, taken, args[6] + start * steps[6], steps[6], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(speed, 64, taken, args[7] + start * steps[7], steps[7], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_phase_x_alpha)(const real *halves, const real *reach, const real *sums, const real *parameters, real *phase)
{
    planar_rrr_self_motion_phase_x_alpha_one(halves, reach, sums, parameters, phase);
}

void CHAINRULE_NAME(planar_rrr_self_motion_phase_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real halves[2 * 64];
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real phase[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(halves, 1, 1, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(sums, 1, 1, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            chainrule_gather(parameters, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            planar_rrr_self_motion_phase_x_alpha_one(halves, reach, sums, parameters, phase);
            chainrule_scatter(phase, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(halves, 64, taken, args[0] + start * steps[0], steps[0], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[2] + start * steps[2], steps[2], 1, 8, 8 * steps[7], steps[7]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 2, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 8, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            planar_rrr_self_motion_phase_x_alpha_tile(halves, reach, sums, parameters, phase);
            chainrule_scatter(phase, 64, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_extremes_x_alpha)(const real *reach, const real *sums, const real *parameters, real *extremes)
{
    planar_rrr_self_motion_extremes_x_alpha_one(reach, sums, parameters, extremes);
}

void CHAINRULE_NAME(planar_rrr_self_motion_extremes_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real reach[1 * 64];
    real sums[8 * 64];
    real parameters[3 * 64];
    real extremes[6 * 64];
    const int streaming = chainrule_streams(count, 6);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(reach, 1, 1, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[4], steps[4]);
            chainrule_gather(sums, 1, 1, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[5], steps[5]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6]);
            planar_rrr_self_motion_extremes_x_alpha_one(reach, sums, parameters, extremes);
            chainrule_scatter(extremes, 1, 1, args[3] + start * steps[3], steps[3], 3, 2, steps[7], steps[8], 0);
        } else {
            chainrule_gather(reach, 64, taken, args[0] + start * steps[0], steps[0], 1, 1, 1 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(sums, 64, taken, args[1] + start * steps[1], steps[1], 1, 8, 8 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 1, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 8, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            planar_rrr_self_motion_extremes_x_alpha_tile(reach, sums, parameters, extremes);
            chainrule_scatter(extremes, 64, taken, args[3] + start * steps[3], steps[3], 3, 2, steps[7], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_self_motion_stops_x_alpha)(const real *stops, const real *reach, const real *parameters, real *q, real *radicands)
{
    planar_rrr_self_motion_stops_x_alpha_one(stops, reach, parameters, q, radicands);
}

void CHAINRULE_NAME(planar_rrr_self_motion_stops_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real stops[3 * 64];
    real reach[1 * 64];
    real parameters[3 * 64];
    real q[18 * 64];
    real radicands[3 * 64];
    const int streaming = chainrule_streams(count, 21);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(stops, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            chainrule_gather(reach, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            chainrule_gather(parameters, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            planar_rrr_self_motion_stops_x_alpha_one(stops, reach, parameters, q, radicands);
            chainrule_scatter(q, 1, 1, args[3] + start * steps[3], steps[3], 6, 3, steps[8], steps[9], 0);
            chainrule_scatter(radicands, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[10], steps[10], 0);
        } else {
            chainrule_gather(stops, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(reach, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 1, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 3, taken, 0);
            if (!chainrule_past(streaming, 18, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 18, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            planar_rrr_self_motion_stops_x_alpha_tile(stops, reach, parameters, q, radicands);
            chainrule_scatter(q, 64, taken, args[3] + start * steps[3], steps[3], 6, 3, steps[8], steps[9], streaming);
            chainrule_scatter(radicands, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[10], steps[10], streaming);
        }
    }
    chainrule_settle(streaming);
}
