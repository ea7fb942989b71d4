/* orthogonal_3r_kinematics.c: kinematics of orthogonal_3r.
 * Made from templates/kernel.c.j2; inputs acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe.
 * 310 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "orthogonal_3r_kinematics.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char orthogonal_3r_kinematics_digest[] = "acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "orthogonal_3r_kinematics.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "orthogonal_3r_kinematics.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(orthogonal_3r_position)(const real *q, const real *parameters, real *position)
{
    orthogonal_3r_position_one(q, parameters, position);
}

void CHAINRULE_NAME(orthogonal_3r_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real position[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            orthogonal_3r_position_one(q, parameters, position);
            chainrule_scatter(position, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            orthogonal_3r_position_tile(q, parameters, position);
            chainrule_scatter(position, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_pose)(const real *q, const real *parameters, real *pose)
{
    orthogonal_3r_pose_one(q, parameters, pose);
}

void CHAINRULE_NAME(orthogonal_3r_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real pose[16 * 64];
    const int streaming = chainrule_streams(count, 16);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            orthogonal_3r_pose_one(q, parameters, pose);
            chainrule_scatter(pose, 1, 1, args[2] + start * steps[2], steps[2], 4, 4, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 16, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 16, taken, 1);
            }
            orthogonal_3r_pose_tile(q, parameters, pose);
            chainrule_scatter(pose, 64, taken, args[2] + start * steps[2], steps[2], 4, 4, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_jacobian_position)(const real *q, const real *parameters, real *jacobian)
{
    orthogonal_3r_jacobian_position_one(q, parameters, jacobian);
}

void CHAINRULE_NAME(orthogonal_3r_jacobian_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real jacobian[9 * 64];
    const int streaming = chainrule_streams(count, 9);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            orthogonal_3r_jacobian_position_one(q, parameters, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 3, 3, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 9, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 9, taken, 1);
            }
            orthogonal_3r_jacobian_position_tile(q, parameters, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 3, 3, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_jacobian_pose)(const real *q, const real *parameters, real *jacobian)
{
    orthogonal_3r_jacobian_pose_one(q, parameters, jacobian);
}

void CHAINRULE_NAME(orthogonal_3r_jacobian_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real jacobian[18 * 64];
    const int streaming = chainrule_streams(count, 18);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            orthogonal_3r_jacobian_pose_one(q, parameters, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 6, 3, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 18, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 18, taken, 1);
            }
            orthogonal_3r_jacobian_pose_tile(q, parameters, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 6, 3, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_kinematics_position)(const real *q, const real *parameters, real *position, real *jacobian)
{
    orthogonal_3r_kinematics_position_one(q, parameters, position, jacobian);
}

void CHAINRULE_NAME(orthogonal_3r_kinematics_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real position[3 * 64];
    real jacobian[9 * 64];
    const int streaming = chainrule_streams(count, 12);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[5], steps[5]);
            orthogonal_3r_kinematics_position_one(q, parameters, position, jacobian);
            chainrule_scatter(position, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 3, 3, steps[7], steps[8], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 9, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 9, taken, 1);
            }
            orthogonal_3r_kinematics_position_tile(q, parameters, position, jacobian);
            chainrule_scatter(position, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[6], steps[6], streaming);
            chainrule_scatter(jacobian, 64, taken, args[3] + start * steps[3], steps[3], 3, 3, steps[7], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_kinematics_pose)(const real *q, const real *parameters, real *pose, real *jacobian)
{
    orthogonal_3r_kinematics_pose_one(q, parameters, pose, jacobian);
}

void CHAINRULE_NAME(orthogonal_3r_kinematics_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[4 * 64];
    real pose[16 * 64];
    real jacobian[18 * 64];
    const int streaming = chainrule_streams(count, 34);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[5], steps[5]);
            orthogonal_3r_kinematics_pose_one(q, parameters, pose, jacobian);
            chainrule_scatter(pose, 1, 1, args[2] + start * steps[2], steps[2], 4, 4, steps[6], steps[7], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 6, 3, steps[8], steps[9], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 4, 4 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 4, taken, 0);
            if (!chainrule_past(streaming, 16, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 16, taken, 1);
            }
            if (!chainrule_past(streaming, 18, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 18, taken, 1);
            }
            orthogonal_3r_kinematics_pose_tile(q, parameters, pose, jacobian);
            chainrule_scatter(pose, 64, taken, args[2] + start * steps[2], steps[2], 4, 4, steps[6], steps[7], streaming);
            chainrule_scatter(jacobian, 64, taken, args[3] + start * steps[3], steps[3], 6, 3, steps[8], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}
