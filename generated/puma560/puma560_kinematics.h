/* puma560_kinematics.h: kinematics of puma560.
 * Made from templates/kernel.h.j2; inputs dca842d5303801c628e150dba0d9bdac62d1af990563b94c54821f0df2a04558.
 * 511 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PUMA560_KINEMATICS_H
#define CHAINRULE_PUMA560_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char puma560_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   47 operations */
void puma560_position(const double *q, double *position);
void puma560_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void puma560_positionf(const float *q, float *position);
void puma560_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   107 operations */
void puma560_pose(const double *q, double *pose);
void puma560_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void puma560_posef(const float *q, float *pose);
void puma560_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[6]
 *   out  jacobian[3][6]
 *   65 operations */
void puma560_jacobian_position(const double *q, double *jacobian);
void puma560_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void puma560_jacobian_positionf(const float *q, float *jacobian);
void puma560_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[6]
 *   out  jacobian[6][6]
 *   98 operations */
void puma560_jacobian_pose(const double *q, double *jacobian);
void puma560_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void puma560_jacobian_posef(const float *q, float *jacobian);
void puma560_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   out  jacobian[3][6]
 *   65 operations */
void puma560_kinematics_position(const double *q, double *position, double *jacobian);
void puma560_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void puma560_kinematics_positionf(const float *q, float *position, float *jacobian);
void puma560_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   out  jacobian[6][6]
 *   129 operations */
void puma560_kinematics_pose(const double *q, double *pose, double *jacobian);
void puma560_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void puma560_kinematics_posef(const float *q, float *pose, float *jacobian);
void puma560_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PUMA560_KINEMATICS_H */
