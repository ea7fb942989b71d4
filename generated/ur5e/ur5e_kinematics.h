/* ur5e_kinematics.h: kinematics of ur5e.
 * Made from templates/kernel.h.j2; inputs 95b3eaf6da9600783965b004b6713c6e10ce165a315e7cbe37703d414cb2318a.
 * 730 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_UR5E_KINEMATICS_H
#define CHAINRULE_UR5E_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char ur5e_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   83 operations */
void ur5e_position(const double *q, double *position);
void ur5e_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void ur5e_positionf(const float *q, float *position);
void ur5e_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   114 operations */
void ur5e_pose(const double *q, double *pose);
void ur5e_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void ur5e_posef(const float *q, float *pose);
void ur5e_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[6]
 *   out  jacobian[3][6]
 *   124 operations */
void ur5e_jacobian_position(const double *q, double *jacobian);
void ur5e_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void ur5e_jacobian_positionf(const float *q, float *jacobian);
void ur5e_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[6]
 *   out  jacobian[6][6]
 *   128 operations */
void ur5e_jacobian_pose(const double *q, double *jacobian);
void ur5e_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void ur5e_jacobian_posef(const float *q, float *jacobian);
void ur5e_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   out  jacobian[3][6]
 *   124 operations */
void ur5e_kinematics_position(const double *q, double *position, double *jacobian);
void ur5e_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void ur5e_kinematics_positionf(const float *q, float *position, float *jacobian);
void ur5e_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   out  jacobian[6][6]
 *   157 operations */
void ur5e_kinematics_pose(const double *q, double *pose, double *jacobian);
void ur5e_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void ur5e_kinematics_posef(const float *q, float *pose, float *jacobian);
void ur5e_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_UR5E_KINEMATICS_H */
