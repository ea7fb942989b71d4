/* orthogonal_3r_kinematics.h: kinematics of orthogonal_3r.
 * Made from templates/kernel.h.j2; inputs acb2265402e52b72edd2dd46636047fbec5ba872b074bc2fa364e334504a1dbe.
 * 310 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_ORTHOGONAL_3R_KINEMATICS_H
#define CHAINRULE_ORTHOGONAL_3R_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char orthogonal_3r_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  position[3]
 *   33 operations */
void orthogonal_3r_position(const double *q, const double *parameters, double *position);
void orthogonal_3r_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_positionf(const float *q, const float *parameters, float *position);
void orthogonal_3r_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  pose[4][4]
 *   44 operations */
void orthogonal_3r_pose(const double *q, const double *parameters, double *pose);
void orthogonal_3r_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_posef(const float *q, const float *parameters, float *pose);
void orthogonal_3r_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position, in the base frame.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  jacobian[3][3]
 *   55 operations */
void orthogonal_3r_jacobian_position(const double *q, const double *parameters, double *jacobian);
void orthogonal_3r_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_jacobian_positionf(const float *q, const float *parameters, float *jacobian);
void orthogonal_3r_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose, in the base frame.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  jacobian[6][3]
 *   56 operations */
void orthogonal_3r_jacobian_pose(const double *q, const double *parameters, double *jacobian);
void orthogonal_3r_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_jacobian_posef(const float *q, const float *parameters, float *jacobian);
void orthogonal_3r_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and its Jacobian, in the base frame.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  position[3]
 *   out  jacobian[3][3]
 *   56 operations */
void orthogonal_3r_kinematics_position(const double *q, const double *parameters, double *position, double *jacobian);
void orthogonal_3r_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_kinematics_positionf(const float *q, const float *parameters, float *position, float *jacobian);
void orthogonal_3r_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and its Jacobian, in the base frame.
 *   in   q[3]
 *   in   parameters[4] = (d2, d3, d4, r2)
 *   out  pose[4][4]
 *   out  jacobian[6][3]
 *   66 operations */
void orthogonal_3r_kinematics_pose(const double *q, const double *parameters, double *pose, double *jacobian);
void orthogonal_3r_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void orthogonal_3r_kinematics_posef(const float *q, const float *parameters, float *pose, float *jacobian);
void orthogonal_3r_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_ORTHOGONAL_3R_KINEMATICS_H */
