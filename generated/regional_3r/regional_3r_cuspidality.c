/* regional_3r_cuspidality.c: cuspidality of regional_3r.
 * Made from templates/kernel.c.j2; inputs 75e033e629be7085bf11ded7e3a5804c34f745dda6e84345d76a89b262b8c17c.
 * 5743 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "regional_3r_cuspidality.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char regional_3r_cuspidality_digest[] = "75e033e629be7085bf11ded7e3a5804c34f745dda6e84345d76a89b262b8c17c";
#endif

#define LANES 32
#define TERMS(name) name##_tile
#include "regional_3r_cuspidality.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "regional_3r_cuspidality.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(regional_3r_quartic)(const real *parameters, const real *target, real *quartic)
{
    regional_3r_quartic_one(parameters, target, quartic);
}

void CHAINRULE_NAME(regional_3r_quartic_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real target[2 * 32];
    real quartic[5 * 32];
    const int streaming = chainrule_streams(count, 5);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            regional_3r_quartic_one(parameters, target, quartic);
            chainrule_scatter(quartic, 1, 1, args[2] + start * steps[2], steps[2], 1, 5, 5 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 5, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 5, taken, 1);
            }
            regional_3r_quartic_tile(parameters, target, quartic);
            chainrule_scatter(quartic, 32, taken, args[2] + start * steps[2], steps[2], 1, 5, 5 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_cusp_polynomial)(const real *parameters, real *polynomial)
{
    regional_3r_cusp_polynomial_one(parameters, polynomial);
}

void CHAINRULE_NAME(regional_3r_cusp_polynomial_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real polynomial[13 * 32];
    const int streaming = chainrule_streams(count, 13);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            regional_3r_cusp_polynomial_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 13, 13 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            if (!chainrule_past(streaming, 13, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 13, taken, 1);
            }
            regional_3r_cusp_polynomial_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 32, taken, args[1] + start * steps[1], steps[1], 1, 13, 13 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_cusp_polynomial_right_angle)(const real *parameters, real *polynomial)
{
    regional_3r_cusp_polynomial_right_angle_one(parameters, polynomial);
}

void CHAINRULE_NAME(regional_3r_cusp_polynomial_right_angle_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real polynomial[7 * 32];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            regional_3r_cusp_polynomial_right_angle_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            if (!chainrule_past(streaming, 7, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 7, taken, 1);
            }
            regional_3r_cusp_polynomial_right_angle_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 32, taken, args[1] + start * steps[1], steps[1], 1, 7, 7 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_aspect_polynomial)(const real *parameters, real *polynomial)
{
    regional_3r_aspect_polynomial_one(parameters, polynomial);
}

void CHAINRULE_NAME(regional_3r_aspect_polynomial_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real polynomial[9 * 32];
    const int streaming = chainrule_streams(count, 9);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            regional_3r_aspect_polynomial_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 9, 9 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            if (!chainrule_past(streaming, 9, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 9, taken, 1);
            }
            regional_3r_aspect_polynomial_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 32, taken, args[1] + start * steps[1], steps[1], 1, 9, 9 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_determinant_terms)(const real *parameters, const real *elbow, real *terms)
{
    regional_3r_determinant_terms_one(parameters, elbow, terms);
}

void CHAINRULE_NAME(regional_3r_determinant_terms_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real elbow[2 * 32];
    real terms[3 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            regional_3r_determinant_terms_one(parameters, elbow, terms);
            chainrule_scatter(terms, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            regional_3r_determinant_terms_tile(parameters, elbow, terms);
            chainrule_scatter(terms, 32, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_determinant)(const real *parameters, const real *shoulder, const real *elbow, real *determinant)
{
    regional_3r_determinant_one(parameters, shoulder, elbow, determinant);
}

void CHAINRULE_NAME(regional_3r_determinant_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real shoulder[2 * 32];
    real elbow[2 * 32];
    real determinant[1 * 32];
    const int streaming = chainrule_streams(count, 1);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            chainrule_gather(shoulder, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            regional_3r_determinant_one(parameters, shoulder, elbow, determinant);
            chainrule_scatter(determinant, 1, 1, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(shoulder, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 1, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 1, taken, 1);
            }
            regional_3r_determinant_tile(parameters, shoulder, elbow, determinant);
            chainrule_scatter(determinant, 32, taken, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_second_axis)(const real *parameters, real *polynomial)
{
    regional_3r_second_axis_one(parameters, polynomial);
}

void CHAINRULE_NAME(regional_3r_second_axis_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real polynomial[2 * 32];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            regional_3r_second_axis_one(parameters, polynomial);
            chainrule_scatter(polynomial, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[3], steps[3], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            if (!chainrule_past(streaming, 2, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 2, taken, 1);
            }
            regional_3r_second_axis_tile(parameters, polynomial);
            chainrule_scatter(polynomial, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[3], steps[3], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_quartic_invariants)(const real *coefficients, real *invariants, real *discriminating)
{
    regional_3r_quartic_invariants_one(coefficients, invariants, discriminating);
}

void CHAINRULE_NAME(regional_3r_quartic_invariants_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real coefficients[5 * 32];
    real invariants[2 * 32];
    real discriminating[3 * 32];
    const int streaming = chainrule_streams(count, 5);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(coefficients, 1, 1, args[0] + start * steps[0], steps[0], 1, 5, 5 * steps[3], steps[3]);
            regional_3r_quartic_invariants_one(coefficients, invariants, discriminating);
            chainrule_scatter(invariants, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4], 0);
            chainrule_scatter(discriminating, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(coefficients, 32, taken, args[0] + start * steps[0], steps[0], 1, 5, 5 * steps[3], steps[3]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 5, taken, 0);
            if (!chainrule_past(streaming, 2, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            regional_3r_quartic_invariants_tile(coefficients, invariants, discriminating);
            chainrule_scatter(invariants, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4], streaming);
            chainrule_scatter(discriminating, 32, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_triple_point)(const real *parameters, const real *elbow, real *cusp)
{
    regional_3r_triple_point_one(parameters, elbow, cusp);
}

void CHAINRULE_NAME(regional_3r_triple_point_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real elbow[2 * 32];
    real cusp[3 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            regional_3r_triple_point_one(parameters, elbow, cusp);
            chainrule_scatter(cusp, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            regional_3r_triple_point_tile(parameters, elbow, cusp);
            chainrule_scatter(cusp, 32, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_triple_point_right_angle)(const real *parameters, const real *elbow, real *cusp)
{
    regional_3r_triple_point_right_angle_one(parameters, elbow, cusp);
}

void CHAINRULE_NAME(regional_3r_triple_point_right_angle_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real elbow[2 * 32];
    real cusp[3 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            regional_3r_triple_point_right_angle_one(parameters, elbow, cusp);
            chainrule_scatter(cusp, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[3], steps[3]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[4], steps[4]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            regional_3r_triple_point_right_angle_tile(parameters, elbow, cusp);
            chainrule_scatter(cusp, 32, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[5], steps[5], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_image)(const real *parameters, const real *shoulder, const real *elbow, real *target)
{
    regional_3r_image_one(parameters, shoulder, elbow, target);
}

void CHAINRULE_NAME(regional_3r_image_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real shoulder[2 * 32];
    real elbow[2 * 32];
    real target[2 * 32];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            chainrule_gather(shoulder, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            regional_3r_image_one(parameters, shoulder, elbow, target);
            chainrule_scatter(target, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(shoulder, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            regional_3r_image_tile(parameters, shoulder, elbow, target);
            chainrule_scatter(target, 32, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_conic_terms)(const real *parameters, real *conic)
{
    regional_3r_conic_terms_one(parameters, conic);
}

void CHAINRULE_NAME(regional_3r_conic_terms_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real conic[30 * 32];
    const int streaming = chainrule_streams(count, 30);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            regional_3r_conic_terms_one(parameters, conic);
            chainrule_scatter(conic, 1, 1, args[1] + start * steps[1], steps[1], 6, 5, steps[3], steps[4], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[2], steps[2]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            if (!chainrule_past(streaming, 30, steps[1])) {
                chainrule_fetch(args[1] + start * steps[1], steps[1], 30, taken, 1);
            }
            regional_3r_conic_terms_tile(parameters, conic);
            chainrule_scatter(conic, 32, taken, args[1] + start * steps[1], steps[1], 6, 5, steps[3], steps[4], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_shoulder)(const real *parameters, const real *target, const real *elbow, real *ratio)
{
    regional_3r_shoulder_one(parameters, target, elbow, ratio);
}

void CHAINRULE_NAME(regional_3r_shoulder_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real target[2 * 32];
    real elbow[2 * 32];
    real ratio[3 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            regional_3r_shoulder_one(parameters, target, elbow, ratio);
            chainrule_scatter(ratio, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            regional_3r_shoulder_tile(parameters, target, elbow, ratio);
            chainrule_scatter(ratio, 32, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_unturned)(const real *parameters, const real *shoulder, const real *elbow, real *point)
{
    regional_3r_unturned_one(parameters, shoulder, elbow, point);
}

void CHAINRULE_NAME(regional_3r_unturned_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real shoulder[2 * 32];
    real elbow[2 * 32];
    real point[3 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            chainrule_gather(shoulder, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            regional_3r_unturned_one(parameters, shoulder, elbow, point);
            chainrule_scatter(point, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(shoulder, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            regional_3r_unturned_tile(parameters, shoulder, elbow, point);
            chainrule_scatter(point, 32, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_number_of_postures)(const real *parameters, const real *target, real *number, real *margin)
{
    regional_3r_number_of_postures_one(parameters, target, number, margin);
}

void CHAINRULE_NAME(regional_3r_number_of_postures_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real target[2 * 32];
    real number[1 * 32];
    real margin[1 * 32];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            regional_3r_number_of_postures_one(parameters, target, number, margin);
            chainrule_scatter(number, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(margin, 1, 1, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 1, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 1, taken, 1);
            }
            regional_3r_number_of_postures_tile(parameters, target, number, margin);
            chainrule_scatter(number, 32, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(margin, 32, taken, args[3] + start * steps[3], steps[3], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_postures)(const real *parameters, const real *point, real *angles, real *room, real *closure, real *slope, real *number, real *margin)
{
    regional_3r_postures_one(parameters, point, angles, room, closure, slope, number, margin);
}

void CHAINRULE_NAME(regional_3r_postures_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real point[3 * 32];
    real angles[12 * 32];
    real room[2 * 32];
    real closure[4 * 32];
    real slope[4 * 32];
    real number[1 * 32];
    real margin[1 * 32];
    const int streaming = chainrule_streams(count, 24);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[8], steps[8]);
            chainrule_gather(point, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[9], steps[9]);
            regional_3r_postures_one(parameters, point, angles, room, closure, slope, number, margin);
            chainrule_scatter(angles, 1, 1, args[2] + start * steps[2], steps[2], 4, 3, steps[10], steps[11], 0);
            chainrule_scatter(room, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[12], steps[12], 0);
            chainrule_scatter(closure, 1, 1, args[4] + start * steps[4], steps[4], 1, 4, 4 * steps[13], steps[13], 0);
            chainrule_scatter(slope, 1, 1, args[5] + start * steps[5], steps[5], 1, 4, 4 * steps[14], steps[14], 0);
            chainrule_scatter(number, 1, 1, args[6] + start * steps[6], steps[6], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(margin, 1, 1, args[7] + start * steps[7], steps[7], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[8], steps[8]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(point, 32, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[9], steps[9]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 12, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 12, taken, 1);
            }
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 4, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 4, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 1, taken, 1);
            }
            regional_3r_postures_tile(parameters, point, angles, room, closure, slope, number, margin);
            chainrule_scatter(angles, 32, taken, args[2] + start * steps[2], steps[2], 4, 3, steps[10], steps[11], streaming);
            chainrule_scatter(room, 32, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[12], steps[12], streaming);
            chainrule_scatter(closure, 32, taken, args[4] + start * steps[4], steps[4], 1, 4, 4 * steps[13], steps[13], streaming);
            chainrule_scatter(slope, 32, taken, args[5] + start * steps[5], steps[5], 1, 4, 4 * steps[14], steps[14], streaming);
            chainrule_scatter(number, 32, taken, args[6] + start * steps[6], steps[6], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(margin, 32, taken, args[7] + start * steps[7], steps[7], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_postures_intersecting)(const real *parameters, const real *point, real *angles, real *closure, real *width)
{
    regional_3r_postures_intersecting_one(parameters, point, angles, closure, width);
}

void CHAINRULE_NAME(regional_3r_postures_intersecting_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real point[3 * 32];
    real angles[12 * 32];
    real closure[4 * 32];
    real width[4 * 32];
    const int streaming = chainrule_streams(count, 20);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            chainrule_gather(point, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            regional_3r_postures_intersecting_one(parameters, point, angles, closure, width);
            chainrule_scatter(angles, 1, 1, args[2] + start * steps[2], steps[2], 4, 3, steps[7], steps[8], 0);
            chainrule_scatter(closure, 1, 1, args[3] + start * steps[3], steps[3], 1, 4, 4 * steps[9], steps[9], 0);
            chainrule_scatter(width, 1, 1, args[4] + start * steps[4], steps[4], 1, 4, 4 * steps[10], steps[10], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(point, 32, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 12, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 12, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 4, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 4, taken, 1);
            }
            regional_3r_postures_intersecting_tile(parameters, point, angles, closure, width);
            chainrule_scatter(angles, 32, taken, args[2] + start * steps[2], steps[2], 4, 3, steps[7], steps[8], streaming);
            chainrule_scatter(closure, 32, taken, args[3] + start * steps[3], steps[3], 1, 4, 4 * steps[9], steps[9], streaming);
            chainrule_scatter(width, 32, taken, args[4] + start * steps[4], steps[4], 1, 4, 4 * steps[10], steps[10], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_postures_parallel)(const real *parameters, const real *point, real *angles, real *closure, real *width)
{
    regional_3r_postures_parallel_one(parameters, point, angles, closure, width);
}

void CHAINRULE_NAME(regional_3r_postures_parallel_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real point[3 * 32];
    real angles[12 * 32];
    real closure[4 * 32];
    real width[4 * 32];
    const int streaming = chainrule_streams(count, 20);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            chainrule_gather(point, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            regional_3r_postures_parallel_one(parameters, point, angles, closure, width);
            chainrule_scatter(angles, 1, 1, args[2] + start * steps[2], steps[2], 4, 3, steps[7], steps[8], 0);
            chainrule_scatter(closure, 1, 1, args[3] + start * steps[3], steps[3], 1, 4, 4 * steps[9], steps[9], 0);
            chainrule_scatter(width, 1, 1, args[4] + start * steps[4], steps[4], 1, 4, 4 * steps[10], steps[10], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(point, 32, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            if (!chainrule_past(streaming, 12, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 12, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 4, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 4, taken, 1);
            }
            regional_3r_postures_parallel_tile(parameters, point, angles, closure, width);
            chainrule_scatter(angles, 32, taken, args[2] + start * steps[2], steps[2], 4, 3, steps[7], steps[8], streaming);
            chainrule_scatter(closure, 32, taken, args[3] + start * steps[3], steps[3], 1, 4, 4 * steps[9], steps[9], streaming);
            chainrule_scatter(width, 32, taken, args[4] + start * steps[4], steps[4], 1, 4, 4 * steps[10], steps[10], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_sweep_conditions)(const real *parameters, const real *target, real *U, real *V, real *W)
{
    regional_3r_sweep_conditions_one(parameters, target, U, V, W);
}

void CHAINRULE_NAME(regional_3r_sweep_conditions_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real target[2 * 32];
    real U[3 * 32];
    real V[3 * 32];
    real W[5 * 32];
    const int streaming = chainrule_streams(count, 11);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            chainrule_gather(target, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[6], steps[6]);
            regional_3r_sweep_conditions_one(parameters, target, U, V, W);
            chainrule_scatter(U, 1, 1, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7], 0);
            chainrule_scatter(V, 1, 1, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], 0);
            chainrule_scatter(W, 1, 1, args[4] + start * steps[4], steps[4], 1, 5, 5 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(target, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[2])) {
                chainrule_fetch(args[2] + start * steps[2], steps[2], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 5, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 5, taken, 1);
            }
            regional_3r_sweep_conditions_tile(parameters, target, U, V, W);
            chainrule_scatter(U, 32, taken, args[2] + start * steps[2], steps[2], 1, 3, 3 * steps[7], steps[7], streaming);
            chainrule_scatter(V, 32, taken, args[3] + start * steps[3], steps[3], 1, 3, 3 * steps[8], steps[8], streaming);
            chainrule_scatter(W, 32, taken, args[4] + start * steps[4], steps[4], 1, 5, 5 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_sweep_elbow)(const real *parameters, const real *elbow, const real *target, real *mismatch, real *point)
{
    regional_3r_sweep_elbow_one(parameters, elbow, target, mismatch, point);
}

void CHAINRULE_NAME(regional_3r_sweep_elbow_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real elbow[2 * 32];
    real target[2 * 32];
    real mismatch[2 * 32];
    real point[2 * 32];
    const int streaming = chainrule_streams(count, 4);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[6], steps[6]);
            chainrule_gather(target, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[7], steps[7]);
            regional_3r_sweep_elbow_one(parameters, elbow, target, mismatch, point);
            chainrule_scatter(mismatch, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[8], steps[8], 0);
            chainrule_scatter(point, 1, 1, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(target, 32, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 2, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 2, taken, 1);
            }
            regional_3r_sweep_elbow_tile(parameters, elbow, target, mismatch, point);
            chainrule_scatter(mismatch, 32, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[8], steps[8], streaming);
            chainrule_scatter(point, 32, taken, args[4] + start * steps[4], steps[4], 1, 2, 2 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_sweep_base)(const real *parameters, const real *elbow, const real *turned, real *xy)
{
    regional_3r_sweep_base_one(parameters, elbow, turned, xy);
}

void CHAINRULE_NAME(regional_3r_sweep_base_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real parameters[9 * 32];
    real elbow[2 * 32];
    real turned[2 * 32];
    real xy[2 * 32];
    const int streaming = chainrule_streams(count, 2);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(parameters, 1, 1, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            chainrule_gather(elbow, 1, 1, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            chainrule_gather(turned, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            regional_3r_sweep_base_one(parameters, elbow, turned, xy);
            chainrule_scatter(xy, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[7], steps[7], 0);
        } else {
            chainrule_gather(parameters, 32, taken, args[0] + start * steps[0], steps[0], 1, 9, 9 * steps[4], steps[4]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(elbow, 32, taken, args[1] + start * steps[1], steps[1], 1, 2, 2 * steps[5], steps[5]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(turned, 32, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[6], steps[6]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 2, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            regional_3r_sweep_base_tile(parameters, elbow, turned, xy);
            chainrule_scatter(xy, 32, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[7], steps[7], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_spherical_orientations)(const real *second, const real *third, const real *wanted, real *angles, real *share)
{
    regional_3r_spherical_orientations_one(second, third, wanted, angles, share);
}

void CHAINRULE_NAME(regional_3r_spherical_orientations_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real second[9 * 32];
    real third[9 * 32];
    real wanted[9 * 32];
    real angles[6 * 32];
    real share[1 * 32];
    const int streaming = chainrule_streams(count, 7);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(second, 1, 1, args[0] + start * steps[0], steps[0], 3, 3, steps[5], steps[6]);
            chainrule_gather(third, 1, 1, args[1] + start * steps[1], steps[1], 3, 3, steps[7], steps[8]);
            chainrule_gather(wanted, 1, 1, args[2] + start * steps[2], steps[2], 3, 3, steps[9], steps[10]);
            regional_3r_spherical_orientations_one(second, third, wanted, angles, share);
            chainrule_scatter(angles, 1, 1, args[3] + start * steps[3], steps[3], 2, 3, steps[11], steps[12], 0);
            chainrule_scatter(share, 1, 1, args[4] + start * steps[4], steps[4], 1, 1, 1 * steps[13], steps[13], 0);
        } else {
            chainrule_gather(second, 32, taken, args[0] + start * steps[0], steps[0], 3, 3, steps[5], steps[6]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(third, 32, taken, args[1] + start * steps[1], steps[1], 3, 3, steps[7], steps[8]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(wanted, 32, taken, args[2] + start * steps[2], steps[2], 3, 3, steps[9], steps[10]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 9, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 9, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 9, taken, 0);
            if (!chainrule_past(streaming, 6, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 1, taken, 1);
            }
            regional_3r_spherical_orientations_tile(second, third, wanted, angles, share);
            chainrule_scatter(angles, 32, taken, args[3] + start * steps[3], steps[3], 2, 3, steps[11], steps[12], streaming);
            chainrule_scatter(share, 32, taken, args[4] + start * steps[4], steps[4], 1, 1, 1 * steps[13], steps[13], streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(regional_3r_spherical_elbow)(const real *before, const real *behind, const real *square, real *angles, real *share)
{
    regional_3r_spherical_elbow_one(before, behind, square, angles, share);
}

void CHAINRULE_NAME(regional_3r_spherical_elbow_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real before[3 * 32];
    real behind[3 * 32];
    real square[1 * 32];
    real angles[2 * 32];
    real share[1 * 32];
    const int streaming = chainrule_streams(count, 3);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 32);
        if (taken == 1) {
            chainrule_gather(before, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            chainrule_gather(behind, 1, 1, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            chainrule_gather(square, 1, 1, args[2] + start * steps[2], steps[2], 1, 1, 1 * steps[7], steps[7]);
            regional_3r_spherical_elbow_one(before, behind, square, angles, share);
            chainrule_scatter(angles, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[8], steps[8], 0);
            chainrule_scatter(share, 1, 1, args[4] + start * steps[4], steps[4], 1, 1, 1 * steps[9], steps[9], 0);
        } else {
            chainrule_gather(before, 32, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[5], steps[5]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(behind, 32, taken, args[1] + start * steps[1], steps[1], 1, 3, 3 * steps[6], steps[6]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(square, 32, taken, args[2] + start * steps[2], steps[2], 1, 1, 1 * steps[7], steps[7]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 3, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 1, taken, 0);
            if (!chainrule_past(streaming, 2, steps[3])) {
                chainrule_fetch(args[3] + start * steps[3], steps[3], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 1, taken, 1);
            }
            regional_3r_spherical_elbow_tile(before, behind, square, angles, share);
            chainrule_scatter(angles, 32, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[8], steps[8], streaming);
            chainrule_scatter(share, 32, taken, args[4] + start * steps[4], steps[4], 1, 1, 1 * steps[9], steps[9], streaming);
        }
    }
    chainrule_settle(streaming);
}
