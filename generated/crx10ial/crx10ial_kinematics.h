/* crx10ial_kinematics.h: kinematics of crx10ial.
 * Made from templates/kernel.h.j2; inputs 5a1a4d8d015b476139cb7d9600556a7808a6b8fef2eeb067156f636f0edb0dbb.
 * 698 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_CRX10IAL_KINEMATICS_H
#define CHAINRULE_CRX10IAL_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char crx10ial_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   76 operations */
void crx10ial_position(const double *q, double *position);
void crx10ial_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void crx10ial_positionf(const float *q, float *position);
void crx10ial_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   109 operations */
void crx10ial_pose(const double *q, double *pose);
void crx10ial_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void crx10ial_posef(const float *q, float *pose);
void crx10ial_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[6]
 *   out  jacobian[3][6]
 *   117 operations */
void crx10ial_jacobian_position(const double *q, double *jacobian);
void crx10ial_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void crx10ial_jacobian_positionf(const float *q, float *jacobian);
void crx10ial_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[6]
 *   out  jacobian[6][6]
 *   124 operations */
void crx10ial_jacobian_pose(const double *q, double *jacobian);
void crx10ial_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void crx10ial_jacobian_posef(const float *q, float *jacobian);
void crx10ial_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  position[3]
 *   out  jacobian[3][6]
 *   117 operations */
void crx10ial_kinematics_position(const double *q, double *position, double *jacobian);
void crx10ial_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void crx10ial_kinematics_positionf(const float *q, float *position, float *jacobian);
void crx10ial_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[6]
 *   out  pose[4][4]
 *   out  jacobian[6][6]
 *   155 operations */
void crx10ial_kinematics_pose(const double *q, double *pose, double *jacobian);
void crx10ial_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void crx10ial_kinematics_posef(const float *q, float *pose, float *jacobian);
void crx10ial_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_CRX10IAL_KINEMATICS_H */
