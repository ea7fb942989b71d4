/* planar_rpp_kinematics.h: kinematics of planar_rpp.
 * Made from templates/kernel.h.j2; inputs cf9ad193fec3f7656c181f21abb2d3291ef9d1e171c8397ba813d1a904791b5a.
 * 244 operations. Do not edit: change the derivation and regenerate.
 *
 * SI units and radians; arrays row by row. Every function comes for double and, with the suffix f, for float.
 *
 * name(inputs..., outputs...)        one configuration; no state, no allocation, bounded time
 * name_batch(count, args, steps)     many: args are the arrays in the order of the scalar function's arguments; steps
 *                                    are byte strides, first from one configuration to the next for each argument,
 *                                    then for each argument's own axes in turn
 */
#ifndef CHAINRULE_PLANAR_RPP_KINEMATICS_H
#define CHAINRULE_PLANAR_RPP_KINEMATICS_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The digest above, to tell a library from another. */
extern const char planar_rpp_kinematics_digest[];

/* position of the tip, in the base frame.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  position[2]
 *   30 operations */
void planar_rpp_position(const double *q, const double *parameters, double *position);
void planar_rpp_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_positionf(const float *q, const float *parameters, float *position);
void planar_rpp_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose of the tip, in the base frame.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  pose[3][3]
 *   31 operations */
void planar_rpp_pose(const double *q, const double *parameters, double *pose);
void planar_rpp_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_posef(const float *q, const float *parameters, float *pose);
void planar_rpp_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the position task, in the base frame.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  jacobian[2][3]
 *   31 operations */
void planar_rpp_jacobian_position(const double *q, const double *parameters, double *jacobian);
void planar_rpp_jacobian_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_jacobian_positionf(const float *q, const float *parameters, float *jacobian);
void planar_rpp_jacobian_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the x_alpha task, in the base frame.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  jacobian[2][3]
 *   26 operations */
void planar_rpp_jacobian_x_alpha(const double *q, const double *parameters, double *jacobian);
void planar_rpp_jacobian_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_jacobian_x_alphaf(const float *q, const float *parameters, float *jacobian);
void planar_rpp_jacobian_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* Jacobian of the pose task, in the base frame.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  jacobian[3][3]
 *   31 operations */
void planar_rpp_jacobian_pose(const double *q, const double *parameters, double *jacobian);
void planar_rpp_jacobian_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_jacobian_posef(const float *q, const float *parameters, float *jacobian);
void planar_rpp_jacobian_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* position and the Jacobian of the position task.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  position[2]
 *   out  jacobian[2][3]
 *   31 operations */
void planar_rpp_kinematics_position(const double *q, const double *parameters, double *position, double *jacobian);
void planar_rpp_kinematics_position_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_kinematics_positionf(const float *q, const float *parameters, float *position, float *jacobian);
void planar_rpp_kinematics_position_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and the Jacobian of the x_alpha task.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  pose[3][3]
 *   out  jacobian[2][3]
 *   32 operations */
void planar_rpp_kinematics_x_alpha(const double *q, const double *parameters, double *pose, double *jacobian);
void planar_rpp_kinematics_x_alpha_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_kinematics_x_alphaf(const float *q, const float *parameters, float *pose, float *jacobian);
void planar_rpp_kinematics_x_alpha_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

/* pose and the Jacobian of the pose task.
 *   in   q[3]
 *   in   parameters[5] = (l1, l2, l3, heading2, heading3)
 *   out  pose[3][3]
 *   out  jacobian[3][3]
 *   32 operations */
void planar_rpp_kinematics_pose(const double *q, const double *parameters, double *pose, double *jacobian);
void planar_rpp_kinematics_pose_batch(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);
void planar_rpp_kinematics_posef(const float *q, const float *parameters, float *pose, float *jacobian);
void planar_rpp_kinematics_pose_batchf(ptrdiff_t count, char *const *args, const ptrdiff_t *steps);

#ifdef __cplusplus
}
#endif

#endif /* CHAINRULE_PLANAR_RPP_KINEMATICS_H */
