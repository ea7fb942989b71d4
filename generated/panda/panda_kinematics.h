/* panda_kinematics.h: kinematics of panda.
 * Made from templates/kernel.h.j2; inputs 3d75968c9b8709666685fb83d25a26b653448fa96f52cdbdae90d2c2a8257563.
 * 1030 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PANDA_KINEMATICS_H
#define CHAINRULE_PANDA_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char panda_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[7]
 *   out  position[3]
 *   109 operations */
void panda_position(const double *q, double *position);
void panda_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_positionf(const float *q, float *position);
void panda_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[7]
 *   out  pose[4][4]
 *   143 operations */
void panda_pose(const double *q, double *pose);
void panda_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_posef(const float *q, float *pose);
void panda_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[7]
 *   out  jacobian[3][7]
 *   185 operations */
void panda_jacobian_position(const double *q, double *jacobian);
void panda_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_jacobian_positionf(const float *q, float *jacobian);
void panda_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[7]
 *   out  jacobian[6][7]
 *   193 operations */
void panda_jacobian_pose(const double *q, double *jacobian);
void panda_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_jacobian_posef(const float *q, float *jacobian);
void panda_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[7]
 *   out  position[3]
 *   out  jacobian[3][7]
 *   185 operations */
void panda_kinematics_position(const double *q, double *position, double *jacobian);
void panda_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_kinematics_positionf(const float *q, float *position, float *jacobian);
void panda_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[7]
 *   out  pose[4][4]
 *   out  jacobian[6][7]
 *   215 operations */
void panda_kinematics_pose(const double *q, double *pose, double *jacobian);
void panda_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void panda_kinematics_posef(const float *q, float *pose, float *jacobian);
void panda_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PANDA_KINEMATICS_H */
