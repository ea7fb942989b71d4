/* planar_rrr_kinematics.c: kinematics of planar_rrr.
 * Made from templates/kernel.c.j2; inputs 2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2.
 * 337 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "planar_rrr_kinematics.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char planar_rrr_kinematics_digest[] = "2015c547c4b653d0a768ae988d6c31027bb4c3d4b095f6dfe5de0b9130c064d2";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "planar_rrr_kinematics.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "planar_rrr_kinematics.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(planar_rrr_position)(const real *q, const real *parameters, real *position)
{
    planar_rrr_position_one(q, parameters, position);
}

void CHAINRULE_NAME(planar_rrr_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real position[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            planar_rrr_position_one(q, parameters, position);
            chainrule_scatter(position, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 2, taken, 1);
            }
            planar_rrr_position_tile(q, parameters, position);
            chainrule_scatter(position, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_pose)(const real *q, const real *parameters, real *pose)
{
    planar_rrr_pose_one(q, parameters, pose);
}

void CHAINRULE_NAME(planar_rrr_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real pose[9 * 64];
    const int streaming = chainrule_streams(count, 9);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            planar_rrr_pose_one(q, parameters, pose);
            chainrule_scatter(pose, 1, 1, args[2] + start * steps[2], steps[2], 3, 3, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 9, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 9, taken, 1);
            }
            planar_rrr_pose_tile(q, parameters, pose);
            chainrule_scatter(pose, 64, taken, args[2] + start * steps[2], steps[2], 3, 3, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_jacobian_position)(const real *q, const real *parameters, real *jacobian)
{
    planar_rrr_jacobian_position_one(q, parameters, jacobian);
}

void CHAINRULE_NAME(planar_rrr_jacobian_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real jacobian[6 * 64];
    const int streaming = chainrule_streams(count, 6);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            planar_rrr_jacobian_position_one(q, parameters, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 2, 3, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 6, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 6, taken, 1);
            }
            planar_rrr_jacobian_position_tile(q, parameters, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 2, 3, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_jacobian_x_alpha)(const real *q, const real *parameters, real *jacobian)
{
    planar_rrr_jacobian_x_alpha_one(q, parameters, jacobian);
}

void CHAINRULE_NAME(planar_rrr_jacobian_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real jacobian[6 * 64];
    const int streaming = chainrule_streams(count, 6);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            planar_rrr_jacobian_x_alpha_one(q, parameters, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 2, 3, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 6, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 6, taken, 1);
            }
            planar_rrr_jacobian_x_alpha_tile(q, parameters, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 2, 3, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_jacobian_pose)(const real *q, const real *parameters, real *jacobian)
{
    planar_rrr_jacobian_pose_one(q, parameters, jacobian);
}

void CHAINRULE_NAME(planar_rrr_jacobian_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real jacobian[9 * 64];
    const int streaming = chainrule_streams(count, 9);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            planar_rrr_jacobian_pose_one(q, parameters, jacobian);
            chainrule_scatter(jacobian, 1, 1, args[2] + start * steps[2], steps[2], 3, 3, steps[5], steps[6], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 9, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 9, taken, 1);
            }
            planar_rrr_jacobian_pose_tile(q, parameters, jacobian);
            chainrule_scatter(jacobian, 64, taken, args[2] + start * steps[2], steps[2], 3, 3, steps[5], steps[6], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_kinematics_position)(const real *q, const real *parameters, real *position, real *jacobian)
{
    planar_rrr_kinematics_position_one(q, parameters, position, jacobian);
}

void CHAINRULE_NAME(planar_rrr_kinematics_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real position[2 * 64];
    real jacobian[6 * 64];
    const int streaming = chainrule_streams(count, 8);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            planar_rrr_kinematics_position_one(q, parameters, position, jacobian);
            chainrule_scatter(position, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 2, 3, steps[7], steps[8], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            planar_rrr_kinematics_position_tile(q, parameters, position, jacobian);
            chainrule_scatter(position, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6], streaming);
            chainrule_scatter(jacobian, 64, taken, args[3] + start * steps[3], steps[3], 2, 3, steps[7], steps[8], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_kinematics_x_alpha)(const real *q, const real *parameters, real *pose, real *jacobian)
{
    planar_rrr_kinematics_x_alpha_one(q, parameters, pose, jacobian);
}

void CHAINRULE_NAME(planar_rrr_kinematics_x_alpha_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real pose[9 * 64];
    real jacobian[6 * 64];
    const int streaming = chainrule_streams(count, 15);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            planar_rrr_kinematics_x_alpha_one(q, parameters, pose, jacobian);
            chainrule_scatter(pose, 1, 1, args[2] + start * steps[2], steps[2], 3, 3, steps[6], steps[7], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 2, 3, steps[8], steps[9], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 9, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 9, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            planar_rrr_kinematics_x_alpha_tile(q, parameters, pose, jacobian);
            chainrule_scatter(pose, 64, taken, args[2] + start * steps[2], steps[2], 3, 3, steps[6], steps[7], streaming);
            chainrule_scatter(jacobian, 64, taken, args[3] + start * steps[3], steps[3], 2, 3, steps[8], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_kinematics_pose)(const real *q, const real *parameters, real *pose, real *jacobian)
{
    planar_rrr_kinematics_pose_one(q, parameters, pose, jacobian);
}

void CHAINRULE_NAME(planar_rrr_kinematics_pose_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real pose[9 * 64];
    real jacobian[9 * 64];
    const int streaming = chainrule_streams(count, 18);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            planar_rrr_kinematics_pose_one(q, parameters, pose, jacobian);
            chainrule_scatter(pose, 1, 1, args[2] + start * steps[2], steps[2], 3, 3, steps[6], steps[7], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 3, 3, steps[8], steps[9], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 9, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 9, taken, 1);
            }
            if (!chainrule_past(streaming, 9, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 9, taken, 1);
            }
            planar_rrr_kinematics_pose_tile(q, parameters, pose, jacobian);
            chainrule_scatter(pose, 64, taken, args[2] + start * steps[2], steps[2], 3, 3, steps[6], steps[7], streaming);
            chainrule_scatter(jacobian, 64, taken, args[3] + start * steps[3], steps[3], 3, 3, steps[8], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_survey_position)(const real *q, const real *parameters, real *position, real *jacobian, real *manipulability)
{
    planar_rrr_survey_position_one(q, parameters, position, jacobian, manipulability);
}

void CHAINRULE_NAME(planar_rrr_survey_position_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[3 * 64];
    real position[2 * 64];
    real jacobian[6 * 64];
    real manipulability[1 * 64];
    const int streaming = chainrule_streams(count, 9);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            planar_rrr_survey_position_one(q, parameters, position, jacobian, manipulability);
            chainrule_scatter(position, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[7], steps[7], 0);
            chainrule_scatter(jacobian, 1, 1, args[3] + start * steps[3], steps[3], 2, 3, steps[8], steps[9], 0);
            chainrule_scatter(manipulability, 1, 1, args[4] + start * steps[4], steps[4], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 2, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 1, taken, 1);
            }
            planar_rrr_survey_position_tile(q, parameters, position, jacobian, manipulability);
            chainrule_scatter(position, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[7], steps[7], streaming);
            chainrule_scatter(jacobian, 64, taken, args[3] + start * steps[3], steps[3], 2, 3, steps[8], steps[9], streaming);
            chainrule_scatter(manipulability, 64, taken, args[4] + start * steps[4], steps[4], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_rrr_postures)(const real *target, const real *parameters, real *q, real *radicand)
{
    planar_rrr_postures_one(target, parameters, q, radicand);
}

void CHAINRULE_NAME(planar_rrr_postures_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real target[3 * 64];
    real parameters[3 * 64];
    real q[6 * 64];
    real radicand[1 * 64];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(target, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            planar_rrr_postures_one(target, parameters, q, radicand);
            chainrule_scatter(q, 1, 1, args[2] + start * steps[2], steps[2], 2, 3, steps[6], steps[7], 0);
            chainrule_scatter(radicand, 1, 1, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(target, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 6, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 1, taken, 1);
            }
            planar_rrr_postures_tile(target, parameters, q, radicand);
            chainrule_scatter(q, 64, taken, args[2] + start * steps[2], steps[2], 2, 3, steps[6], steps[7], streaming);
            chainrule_scatter(radicand, 64, taken, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}
