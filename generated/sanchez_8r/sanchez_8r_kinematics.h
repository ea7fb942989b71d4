/* sanchez_8r_kinematics.h: kinematics of sanchez_8r.
 * Made from templates/kernel.h.j2; inputs ea1915cebf250136869b75260a5279fbcc7811012321df8ff8d574ba7e264fc3.
 * 1102 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_SANCHEZ_8R_KINEMATICS_H
#define CHAINRULE_SANCHEZ_8R_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char sanchez_8r_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[8]
 *   out  position[3]
 *   113 operations */
void sanchez_8r_position(const double *q, double *position);
void sanchez_8r_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_positionf(const float *q, float *position);
void sanchez_8r_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[8]
 *   out  pose[4][4]
 *   156 operations */
void sanchez_8r_pose(const double *q, double *pose);
void sanchez_8r_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_posef(const float *q, float *pose);
void sanchez_8r_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[8]
 *   out  jacobian[3][8]
 *   196 operations */
void sanchez_8r_jacobian_position(const double *q, double *jacobian);
void sanchez_8r_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_jacobian_positionf(const float *q, float *jacobian);
void sanchez_8r_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[8]
 *   out  jacobian[6][8]
 *   205 operations */
void sanchez_8r_jacobian_pose(const double *q, double *jacobian);
void sanchez_8r_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_jacobian_posef(const float *q, float *jacobian);
void sanchez_8r_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[8]
 *   out  position[3]
 *   out  jacobian[3][8]
 *   196 operations */
void sanchez_8r_kinematics_position(const double *q, double *position, double *jacobian);
void sanchez_8r_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_kinematics_positionf(const float *q, float *position, float *jacobian);
void sanchez_8r_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[8]
 *   out  pose[4][4]
 *   out  jacobian[6][8]
 *   236 operations */
void sanchez_8r_kinematics_pose(const double *q, double *pose, double *jacobian);
void sanchez_8r_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void sanchez_8r_kinematics_posef(const float *q, float *pose, float *jacobian);
void sanchez_8r_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_SANCHEZ_8R_KINEMATICS_H */
