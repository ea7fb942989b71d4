/* jaco2_kinematics.c: kinematics of jaco2.
 * Made from templates/kernel.c.j2; inputs 877d116cceea710cb04a9dcc8e044e2a80fc3ec6eac77bc800d6c1992b0822ea.
 * 949 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "jaco2_kinematics.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char jaco2_kinematics_digest[] = "877d116cceea710cb04a9dcc8e044e2a80fc3ec6eac77bc800d6c1992b0822ea";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "jaco2_kinematics.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "jaco2_kinematics.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(jaco2_position)(const real *q, real *position)
{
    jaco2_position_one(q, position);
}

void CHAINRULE_NAME(jaco2_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real position[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            jaco2_position_one(q, position);
            chainrule_scatter(position, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 3, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 3, taken, 1);
            }
            jaco2_position_tile(q, position);
            chainrule_scatter(position, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(jaco2_pose)(const real *q, real *pose)
{
    jaco2_pose_one(q, pose);
}

void CHAINRULE_NAME(jaco2_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real pose[16 * 64];
    const int streaming = chainrule_streams(count, 16);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            jaco2_pose_one(q, pose);
            chainrule_scatter(pose, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 16, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 16, taken, 1);
            }
            jaco2_pose_tile(q, pose);
            chainrule_scatter(pose, 64, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(jaco2_jacobian_position)(const real *q, real *jacobian)
{
    jaco2_jacobian_position_one(q, jacobian);
}

void CHAINRULE_NAME(jaco2_jacobian_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real jacobian[18 * 64];
    const int streaming = chainrule_streams(count, 18);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            jaco2_jacobian_position_one(q, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[1] + start * steps[1], steps[1], 3, 6, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 18, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 18, taken, 1);
            }
            jaco2_jacobian_position_tile(q, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[1] + start * steps[1], steps[1], 3, 6, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(jaco2_jacobian_pose)(const real *q, real *jacobian)
{
    jaco2_jacobian_pose_one(q, jacobian);
}

void CHAINRULE_NAME(jaco2_jacobian_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real jacobian[36 * 64];
    const int streaming = chainrule_streams(count, 36);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            jaco2_jacobian_pose_one(q, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[1] + start * steps[1], steps[1], 6, 6, steps[3], steps[4], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 36, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 36, taken, 1);
            }
            jaco2_jacobian_pose_tile(q, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[1] + start * steps[1], steps[1], 6, 6, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(jaco2_kinematics_position)(const real *q, real *position, real *jacobian)
{
    jaco2_kinematics_position_one(q, position, jacobian);
}

void CHAINRULE_NAME(jaco2_kinematics_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real position[3 * 64];
    real jacobian[18 * 64];
    const int streaming = chainrule_streams(count, 21);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[3], steps[3]);
            jaco2_kinematics_position_one(q, position, jacobian);
            chainrule_scatter(position, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4], 0);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 3, 6, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 3, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 18, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 18, taken, 1);
            }
            jaco2_kinematics_position_tile(q, position, jacobian);
            chainrule_scatter(position, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4], streaming);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 3, 6, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(jaco2_kinematics_pose)(const real *q, real *pose, real *jacobian)
{
    jaco2_kinematics_pose_one(q, pose, jacobian);
}

void CHAINRULE_NAME(jaco2_kinematics_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[6 * 64];
    real pose[16 * 64];
    real jacobian[36 * 64];
    const int streaming = chainrule_streams(count, 52);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[3], steps[3]);
            jaco2_kinematics_pose_one(q, pose, jacobian);
            chainrule_scatter(pose, 1, 1, args[1] + start * steps[1], steps[1], 4, 4, steps[4], steps[5], 0);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 6, 6, steps[6], steps[7], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 6, 6 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 6, taken, 0);
            if (!chainrule_past(streaming, 16, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 16, taken, 1);
            }
            if (!chainrule_past(streaming, 36, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 36, taken, 1);
            }
            jaco2_kinematics_pose_tile(q, pose, jacobian);
            chainrule_scatter(pose, 64, taken, args[1] + start * steps[1], steps[1], 4, 4, steps[4], steps[5], streaming);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 6, 6, steps[6], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}
