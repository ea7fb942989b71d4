/* iiwa14_kinematics.h: kinematics of iiwa14.
 * Made from templates/kernel.h.j2; inputs ef4e01d1cda97e55e2643a34b278d96d99713179d8788b08f5ad0b6dde005d6b.
 * 801 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_IIWA14_KINEMATICS_H
#define CHAINRULE_IIWA14_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char iiwa14_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[7]
 *   out  position[3]
 *   82 operations */
void iiwa14_position(const double *q, double *position);
void iiwa14_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_positionf(const float *q, float *position);
void iiwa14_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[7]
 *   out  pose[4][4]
 *   121 operations */
void iiwa14_pose(const double *q, double *pose);
void iiwa14_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_posef(const float *q, float *pose);
void iiwa14_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[7]
 *   out  jacobian[3][7]
 *   140 operations */
void iiwa14_jacobian_position(const double *q, double *jacobian);
void iiwa14_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_jacobian_positionf(const float *q, float *jacobian);
void iiwa14_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[7]
 *   out  jacobian[6][7]
 *   144 operations */
void iiwa14_jacobian_pose(const double *q, double *jacobian);
void iiwa14_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_jacobian_posef(const float *q, float *jacobian);
void iiwa14_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[7]
 *   out  position[3]
 *   out  jacobian[3][7]
 *   140 operations */
void iiwa14_kinematics_position(const double *q, double *position, double *jacobian);
void iiwa14_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_kinematics_positionf(const float *q, float *position, float *jacobian);
void iiwa14_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[7]
 *   out  pose[4][4]
 *   out  jacobian[6][7]
 *   174 operations */
void iiwa14_kinematics_pose(const double *q, double *pose, double *jacobian);
void iiwa14_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void iiwa14_kinematics_posef(const float *q, float *pose, float *jacobian);
void iiwa14_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_IIWA14_KINEMATICS_H */
