/* sanchez_8r_kinematics.c: kinematics of sanchez_8r.
 * Made from templates/kernel.c.j2; inputs ea1915cebf250136869b75260a5279fbcc7811012321df8ff8d574ba7e264fc3.
 * 1102 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "sanchez_8r_kinematics.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char sanchez_8r_kinematics_digest[] = "ea1915cebf250136869b75260a5279fbcc7811012321df8ff8d574ba7e264fc3";
#endif

#define LANES 32
#define TERMS(name) name##_tile
#include "sanchez_8r_kinematics.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "sanchez_8r_kinematics.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(sanchez_8r_position)(const real *q, real *position)
{
    sanchez_8r_position_one(q, position);
}

void CHAINRULE_NAME(sanchez_8r_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 32];
    real position[3 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_position_one(q, position);
            chainrule_scatter(position, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 3, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 3, taken, 1);
            }
            sanchez_8r_position_tile(q, position);
            chainrule_scatter(position, 32, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_pose)(const real *q, real *pose)
{
    sanchez_8r_pose_one(q, pose);
}

void CHAINRULE_NAME(sanchez_8r_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 32];
    real pose[16 * 32];
    const int streaming = chainrule_streams(count, 16);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_pose_one(q, pose);
            chainrule_scatter(pose, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 16, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 16, taken, 1);
            }
            sanchez_8r_pose_tile(q, pose);
            chainrule_scatter(pose, 32, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_jacobian_position)(const real *q, real *jacobian)
{
    sanchez_8r_jacobian_position_one(q, jacobian);
}

void CHAINRULE_NAME(sanchez_8r_jacobian_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 32];
    real jacobian[24 * 32];
    const int streaming = chainrule_streams(count, 24);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_jacobian_position_one(q, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[1] + start * steps[1], steps[1], 3, 8, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 24, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 24, taken, 1);
            }
            sanchez_8r_jacobian_position_tile(q, jacobian);
            chainrule_scatter(jacobian, 32, taken, args[1] + start * steps[1], steps[1], 3, 8, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_jacobian_pose)(const real *q, real *jacobian)
{
    sanchez_8r_jacobian_pose_one(q, jacobian);
}

void CHAINRULE_NAME(sanchez_8r_jacobian_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 32];
    real jacobian[48 * 32];
    const int streaming = chainrule_streams(count, 48);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            sanchez_8r_jacobian_pose_one(q, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[1] + start * steps[1], steps[1], 6, 8, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 48, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 48, taken, 1);
            }
            sanchez_8r_jacobian_pose_tile(q, jacobian);
            chainrule_scatter(jacobian, 32, taken, args[1] + start * steps[1], steps[1], 6, 8, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_kinematics_position)(const real *q, real *position, real *jacobian)
{
    sanchez_8r_kinematics_position_one(q, position, jacobian);
}

void CHAINRULE_NAME(sanchez_8r_kinematics_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 32];
    real position[3 * 32];
    real jacobian[24 * 32];
    const int streaming = chainrule_streams(count, 27);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[3], steps[3]);
            sanchez_8r_kinematics_position_one(q, position, jacobian);
            chainrule_scatter(position, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4], 0);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 3, 8, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 3, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 24, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 24, taken, 1);
            }
            sanchez_8r_kinematics_position_tile(q, position, jacobian);
            chainrule_scatter(position, 32, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4], streaming);
            chainrule_scatter(jacobian, 32, taken, args[2] + start * steps[2], steps[2], 3, 8, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(sanchez_8r_kinematics_pose)(const real *q, real *pose, real *jacobian)
{
    sanchez_8r_kinematics_pose_one(q, pose, jacobian);
}

void CHAINRULE_NAME(sanchez_8r_kinematics_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[8 * 32];
    real pose[16 * 32];
    real jacobian[48 * 32];
    const int streaming = chainrule_streams(count, 64);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[3], steps[3]);
            sanchez_8r_kinematics_pose_one(q, pose, jacobian);
            chainrule_scatter(pose, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[4], steps[5], 0);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 6, 8, steps[6], steps[7], 0);
        } else {
            chainrule_gather(q, 32, taken, args[0] + start * steps[0], steps[0], 1, 8, 8 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 8, taken, 0);
            if (!chainrule_past(streaming, 16, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 16, taken, 1);
            }
            if (!chainrule_past(streaming, 48, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 48, taken, 1);
            }
            sanchez_8r_kinematics_pose_tile(q, pose, jacobian);
            chainrule_scatter(pose, 32, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[4], steps[5], streaming);
            chainrule_scatter(jacobian, 32, taken, args[2] + start * steps[2], steps[2], 6, 8, steps[6], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}
