/* orthogonal_3r_cuspidality.c: cuspidality of orthogonal_3r.
 * Made from templates/kernel.c.j2; inputs 5115df605f1fdc3d6f77f19223b735215dc80e9e1f9a9d3ac278a83f3c8911a8.
 * 707 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "orthogonal_3r_cuspidality.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char orthogonal_3r_cuspidality_digest[] = "5115df605f1fdc3d6f77f19223b735215dc80e9e1f9a9d3ac278a83f3c8911a8";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "orthogonal_3r_cuspidality.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "orthogonal_3r_cuspidality.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(orthogonal_3r_quartic)(const real *parameters, const real *target, real *quartic)
{
    orthogonal_3r_quartic_one(parameters, target, quartic);
}

void CHAINRULE_NAME(orthogonal_3r_quartic_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real target[2 * 64];
    real quartic[5 * 64];
    const int streaming = chainrule_streams(count, 5);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            orthogonal_3r_quartic_one(parameters, target, quartic);
            chainrule_scatter(quartic, 1, 1, args[2] + start * steps[2], steps[2], 1, 5, 5 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 5, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 5, taken, 1);
            }
            orthogonal_3r_quartic_tile(parameters, target, quartic);
            chainrule_scatter(quartic, 64, taken, args[2] + start * steps[2], steps[2], 1, 5, 5 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_cusp_polynomial)(const real *parameters, real *polynomial)
{
    orthogonal_3r_cusp_polynomial_one(parameters, polynomial);
}

void CHAINRULE_NAME(orthogonal_3r_cusp_polynomial_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real polynomial[7 * 64];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            orthogonal_3r_cusp_polynomial_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 7, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 7, taken, 1);
            }
            orthogonal_3r_cusp_polynomial_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 64, taken, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_aspect_polynomial)(const real *parameters, real *polynomial)
{
    orthogonal_3r_aspect_polynomial_one(parameters, polynomial);
}

void CHAINRULE_NAME(orthogonal_3r_aspect_polynomial_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real polynomial[5 * 64];
    const int streaming = chainrule_streams(count, 5);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            orthogonal_3r_aspect_polynomial_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 5, 5 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 5, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 5, taken, 1);
            }
            orthogonal_3r_aspect_polynomial_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 64, taken, args[1] + start * steps[1], steps[1], 1, 5, 5 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_determinant_terms)(const real *parameters, const real *elbow, real *terms)
{
    orthogonal_3r_determinant_terms_one(parameters, elbow, terms);
}

void CHAINRULE_NAME(orthogonal_3r_determinant_terms_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real elbow[2 * 64];
    real terms[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            orthogonal_3r_determinant_terms_one(parameters, elbow, terms);
            chainrule_scatter(terms, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            orthogonal_3r_determinant_terms_tile(parameters, elbow, terms);
            chainrule_scatter(terms, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_determinant)(const real *parameters, const real *shoulder, const real *elbow, real *determinant)
{
    orthogonal_3r_determinant_one(parameters, shoulder, elbow, determinant);
}

void CHAINRULE_NAME(orthogonal_3r_determinant_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real shoulder[2 * 64];
    real elbow[2 * 64];
    real determinant[1 * 64];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            chainrule_gather(shoulder, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            orthogonal_3r_determinant_one(parameters, shoulder, elbow, determinant);
            chainrule_scatter(determinant, 1, 1, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(shoulder, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 1, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 1, taken, 1);
            }
            orthogonal_3r_determinant_tile(parameters, shoulder, elbow, determinant);
            chainrule_scatter(determinant, 64, taken, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_second_axis)(const real *parameters, real *polynomial)
{
    orthogonal_3r_second_axis_one(parameters, polynomial);
}

void CHAINRULE_NAME(orthogonal_3r_second_axis_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real polynomial[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            orthogonal_3r_second_axis_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 2, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 2, taken, 1);
            }
            orthogonal_3r_second_axis_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_triple_point)(const real *parameters, const real *elbow, real *cusp)
{
    orthogonal_3r_triple_point_one(parameters, elbow, cusp);
}

void CHAINRULE_NAME(orthogonal_3r_triple_point_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real elbow[2 * 64];
    real cusp[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            orthogonal_3r_triple_point_one(parameters, elbow, cusp);
            chainrule_scatter(cusp, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            orthogonal_3r_triple_point_tile(parameters, elbow, cusp);
            chainrule_scatter(cusp, 64, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_image)(const real *parameters, const real *shoulder, const real *elbow, real *target)
{
    orthogonal_3r_image_one(parameters, shoulder, elbow, target);
}

void CHAINRULE_NAME(orthogonal_3r_image_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real shoulder[2 * 64];
    real elbow[2 * 64];
    real target[2 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            chainrule_gather(shoulder, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            orthogonal_3r_image_one(parameters, shoulder, elbow, target);
            chainrule_scatter(target, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(shoulder, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            orthogonal_3r_image_tile(parameters, shoulder, elbow, target);
            chainrule_scatter(target, 64, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_conic_terms)(const real *parameters, real *conic)
{
    orthogonal_3r_conic_terms_one(parameters, conic);
}

void CHAINRULE_NAME(orthogonal_3r_conic_terms_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real conic[30 * 64];
    const int streaming = chainrule_streams(count, 30);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            orthogonal_3r_conic_terms_one(parameters, conic);
            chainrule_scatter(conic, 1, 1, args[1] + start * steps[1], steps[1], 6, 5, steps[3], steps[4], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 30, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 30, taken, 1);
            }
            orthogonal_3r_conic_terms_tile(parameters, conic);
            chainrule_scatter(conic, 64, taken, args[1] + start * steps[1], steps[1], 6, 5, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_shoulder)(const real *parameters, const real *target, const real *elbow, real *ratio)
{
    orthogonal_3r_shoulder_one(parameters, target, elbow, ratio);
}

void CHAINRULE_NAME(orthogonal_3r_shoulder_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real target[2 * 64];
    real elbow[2 * 64];
    real ratio[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            orthogonal_3r_shoulder_one(parameters, target, elbow, ratio);
            chainrule_scatter(ratio, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            orthogonal_3r_shoulder_tile(parameters, target, elbow, ratio);
            chainrule_scatter(ratio, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_unturned)(const real *parameters, const real *shoulder, const real *elbow, real *point)
{
    orthogonal_3r_unturned_one(parameters, shoulder, elbow, point);
}

void CHAINRULE_NAME(orthogonal_3r_unturned_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real shoulder[2 * 64];
    real elbow[2 * 64];
    real point[3 * 64];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            chainrule_gather(shoulder, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            orthogonal_3r_unturned_one(parameters, shoulder, elbow, point);
            chainrule_scatter(point, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(shoulder, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            orthogonal_3r_unturned_tile(parameters, shoulder, elbow, point);
            chainrule_scatter(point, 64, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_number_of_postures)(const real *parameters, const real *target, real *number, real *margin)
{
    orthogonal_3r_number_of_postures_one(parameters, target, number, margin);
}

void CHAINRULE_NAME(orthogonal_3r_number_of_postures_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real target[2 * 64];
    real number[1 * 64];
    real margin[1 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            orthogonal_3r_number_of_postures_one(parameters, target, number, margin);
            chainrule_scatter(number, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(margin, 1, 1, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 64, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 1, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 1, taken, 1);
            }
            orthogonal_3r_number_of_postures_tile(parameters, target, number, margin);
            chainrule_scatter(number, 64, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(margin, 64, taken, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_classify)(const real *parameters, real *domain, real *topology)
{
    orthogonal_3r_classify_one(parameters, domain, topology);
}

void CHAINRULE_NAME(orthogonal_3r_classify_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real domain[1 * 64];
    real topology[1 * 64];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            orthogonal_3r_classify_one(parameters, domain, topology);
            chainrule_scatter(domain, 1, 1, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(topology, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 1, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 1, taken, 1);
            }
            orthogonal_3r_classify_tile(parameters, domain, topology);
            chainrule_scatter(domain, 64, taken, args[1] + start * steps[1], steps[1], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(topology, 64, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_sides)(const real *parameters, real *sides)
{
    orthogonal_3r_sides_one(parameters, sides);
}

void CHAINRULE_NAME(orthogonal_3r_sides_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real sides[6 * 64];
    const int streaming = chainrule_streams(count, 6);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            orthogonal_3r_sides_one(parameters, sides);
            chainrule_scatter(sides, 1, 1, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 6, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 6, taken, 1);
            }
            orthogonal_3r_sides_tile(parameters, sides);
            chainrule_scatter(sides, 64, taken, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(orthogonal_3r_exact_sides)(const real *parameters, real *sides)
{
    orthogonal_3r_exact_sides_one(parameters, sides);
}

void CHAINRULE_NAME(orthogonal_3r_exact_sides_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[4 * 64];
    real sides[9 * 64];
    const int streaming = chainrule_streams(count, 9);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            orthogonal_3r_exact_sides_one(parameters, sides);
            chainrule_scatter(sides, 1, 1, args[1] + start * steps[1], steps[1], 1, 9, 9 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 64, taken, args[0] + start * steps[0], steps[0], 1, 4, 4 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 4, taken, 0);
            if (!chainrule_past(streaming, 9, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 9, taken, 1);
            }
            orthogonal_3r_exact_sides_tile(parameters, sides);
            chainrule_scatter(sides, 64, taken, args[1] + start * steps[1], steps[1], 1, 9, 9 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}
