/* jaco2_kinematics.h: kinematics of jaco2.
 * Made from templates/kernel.h.j2; inputs 877d116cceea710cb04a9dcc8e044e2a80fc3ec6eac77bc800d6c1992b0822ea.
 * 949 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_JACO2_KINEMATICS_H
#define CHAINRULE_JACO2_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char jaco2_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   111 operations */
void jaco2_position(const double *q, double *position);
void jaco2_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_positionf(const float *q, float *position);
void jaco2_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   158 operations */
void jaco2_pose(const double *q, double *pose);
void jaco2_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_posef(const float *q, float *pose);
void jaco2_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[6]
 *   out  jacobian[3][6]
 *   154 operations */
void jaco2_jacobian_position(const double *q, double *jacobian);
void jaco2_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_jacobian_positionf(const float *q, float *jacobian);
void jaco2_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[6]
 *   out  jacobian[6][6]
 *   167 operations */
void jaco2_jacobian_pose(const double *q, double *jacobian);
void jaco2_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_jacobian_posef(const float *q, float *jacobian);
void jaco2_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   out  jacobian[3][6]
 *   154 operations */
void jaco2_kinematics_position(const double *q, double *position, double *jacobian);
void jaco2_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_kinematics_positionf(const float *q, float *position, float *jacobian);
void jaco2_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   out  jacobian[6][6]
 *   205 operations */
void jaco2_kinematics_pose(const double *q, double *pose, double *jacobian);
void jaco2_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void jaco2_kinematics_posef(const float *q, float *pose, float *jacobian);
void jaco2_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_JACO2_KINEMATICS_H */
