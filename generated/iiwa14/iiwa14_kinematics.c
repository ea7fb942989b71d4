/* iiwa14_kinematics.c: kinematics of iiwa14.
 * Made from templates/kernel.c.j2; inputs ef4e01d1cda97e55e2643a34b278d96d99713179d8788b08f5ad0b6dde005d6b.
 * 801 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "iiwa14_kinematics.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char iiwa14_kinematics_digest[] = "ef4e01d1cda97e55e2643a34b278d96d99713179d8788b08f5ad0b6dde005d6b";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "iiwa14_kinematics.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "iiwa14_kinematics.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(iiwa14_position)(const real *q, real *position)
{
    iiwa14_position_one(q, position);
}

void CHAINRULE_NAME(iiwa14_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real position[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_position_one(q, position);
            chainrule_scatter(position, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 3, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 3, taken, 1);
            }
            iiwa14_position_tile(q, position);
            chainrule_scatter(position, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_pose)(const real *q, real *pose)
{
    iiwa14_pose_one(q, pose);
}

void CHAINRULE_NAME(iiwa14_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real pose[16 * 64];
    const int streaming = chainrule_streams(count, 16);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_pose_one(q, pose);
            chainrule_scatter(pose, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 16, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 16, taken, 1);
            }
            iiwa14_pose_tile(q, pose);
            chainrule_scatter(pose, 64, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_jacobian_position)(const real *q, real *jacobian)
{
    iiwa14_jacobian_position_one(q, jacobian);
}

void CHAINRULE_NAME(iiwa14_jacobian_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real jacobian[21 * 64];
    const int streaming = chainrule_streams(count, 21);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_jacobian_position_one(q, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[1] + start * steps[1], steps[1], 3, 7, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 21, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 21, taken, 1);
            }
            iiwa14_jacobian_position_tile(q, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[1] + start * steps[1], steps[1], 3, 7, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_jacobian_pose)(const real *q, real *jacobian)
{
    iiwa14_jacobian_pose_one(q, jacobian);
}

void CHAINRULE_NAME(iiwa14_jacobian_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real jacobian[42 * 64];
    const int streaming = chainrule_streams(count, 42);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            iiwa14_jacobian_pose_one(q, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[1] + start * steps[1], steps[1], 6, 7, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 42, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 42, taken, 1);
            }
            iiwa14_jacobian_pose_tile(q, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[1] + start * steps[1], steps[1], 6, 7, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_kinematics_position)(const real *q, real *position, real *jacobian)
{
    iiwa14_kinematics_position_one(q, position, jacobian);
}

void CHAINRULE_NAME(iiwa14_kinematics_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real position[3 * 64];
    real jacobian[21 * 64];
    const int streaming = chainrule_streams(count, 24);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[3], steps[3]);
            iiwa14_kinematics_position_one(q, position, jacobian);
            chainrule_scatter(position, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4], 0);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 3, 7, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 3, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 21, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 21, taken, 1);
            }
            iiwa14_kinematics_position_tile(q, position, jacobian);
            chainrule_scatter(position, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4], streaming);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 3, 7, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(iiwa14_kinematics_pose)(const real *q, real *pose, real *jacobian)
{
    iiwa14_kinematics_pose_one(q, pose, jacobian);
}

void CHAINRULE_NAME(iiwa14_kinematics_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[7 * 64];
    real pose[16 * 64];
    real jacobian[42 * 64];
    const int streaming = chainrule_streams(count, 58);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[3], steps[3]);
            iiwa14_kinematics_pose_one(q, pose, jacobian);
            chainrule_scatter(pose, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[4], steps[5], 0);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 6, 7, steps[6], steps[7], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 7, 7 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 7, taken, 0);
            if (!chainrule_past(streaming, 16, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 16, taken, 1);
            }
            if (!chainrule_past(streaming, 42, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 42, taken, 1);
            }
            iiwa14_kinematics_pose_tile(q, pose, jacobian);
            chainrule_scatter(pose, 64, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[4], steps[5], streaming);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 6, 7, steps[6], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}
