/* planar_ppp_speed_ratio.c: speed ratio of planar_ppp.
 * Made from templates/kernel.c.j2; inputs ed99f203c53e369bbff1ddfeafc564f17a2be190cc8c2e4f9796913b98fb7552.
 * 583 operations. Do not edit: change the derivation and regenerate.
 *
 * Compile it for double as it is, and for float with -DCHAINRULE_FLOAT; the two can be linked together. */
#include "planar_ppp_speed_ratio.h"

#include "../chainrule_batch.h"
#include "../chainrule_sincos.h"

#ifndef CHAINRULE_FLOAT
const char planar_ppp_speed_ratio_digest[] = "ed99f203c53e369bbff1ddfeafc564f17a2be190cc8c2e4f9796913b98fb7552";
#endif

#define LANES 64
#define TERMS(name) name##_tile
#include "planar_ppp_speed_ratio.inc"
#undef TERMS
#undef LANES

#define LANES 1
#define TERMS(name) name##_one
#include "planar_ppp_speed_ratio.inc"
#undef TERMS
#undef LANES

void CHAINRULE_NAME(planar_ppp_speed_ratio_terms_1)(const real *q, const real *parameters, const real *tangent, const real *curvature, real *A, real *B, real *B0, real *B1, real *a, real *b, real *C, real *D, real *discriminant)
{
    planar_ppp_speed_ratio_terms_1_one(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_terms_1_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[6 * 64];
    real tangent[2 * 64];
    real curvature[2 * 64];
    real A[3 * 64];
    real B[6 * 64];
    real B0[6 * 64];
    real B1[6 * 64];
    real a[3 * 64];
    real b[3 * 64];
    real C[1 * 64];
    real D[1 * 64];
    real discriminant[1 * 64];
    const int streaming = chainrule_streams(count, 30);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[13], steps[13]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[14], steps[14]);
            chainrule_gather(tangent, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[15], steps[15]);
            chainrule_gather(curvature, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[16], steps[16]);
            planar_ppp_speed_ratio_terms_1_one(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
            chainrule_scatter(A, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[17], steps[17], 0);
            chainrule_scatter(B, 1, 1, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[18], steps[18], 0);
            chainrule_scatter(B0, 1, 1, args[6] + start * steps[6], steps[6], 1, 6, 6 * steps[19], steps[19], 0);
            chainrule_scatter(B1, 1, 1, args[7] + start * steps[7], steps[7], 1, 6, 6 * steps[20], steps[20], 0);
            chainrule_scatter(a, 1, 1, args[8] + start * steps[8], steps[8], 1, 3, 3 * steps[21], steps[21], 0);
            chainrule_scatter(b, 1, 1, args[9] + start * steps[9], steps[9], 1, 3, 3 * steps[22], steps[22], 0);
            chainrule_scatter(C, 1, 1, args[10] + start * steps[10], steps[10], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(D, 1, 1, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(discriminant, 1, 1, args[12] + start * steps[12], steps[12], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[13], steps[13]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[14], steps[14]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(tangent, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[15], steps[15]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(curvature, 64, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[16], steps[16]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 6, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[8])) {
                chainrule_fetch(args[8] + start * steps[8], steps[8], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[9])) {
                chainrule_fetch(args[9] + start * steps[9], steps[9], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[10])) {
                chainrule_fetch(args[10] + start * steps[10], steps[10], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[11])) {
                chainrule_fetch(args[11] + start * steps[11], steps[11], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[12])) {
                chainrule_fetch(args[12] + start * steps[12], steps[12], 1, taken, 1);
            }
            planar_ppp_speed_ratio_terms_1_tile(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
            chainrule_scatter(A, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[17], steps[17], streaming);
            chainrule_scatter(B, 64, taken, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[18], steps[18], streaming);
            chainrule_scatter(B0, 64, taken, args[6] + start * steps[6], steps[6], 1, 6, 6 * steps[19], steps[19], streaming);
            chainrule_scatter(B1, 64, taken, args[7] + start * steps[7], steps[7], 1, 6, 6 * steps[20], steps[20], streaming);
            chainrule_scatter(a, 64, taken, args[8] + start * steps[8], steps[8], 1, 3, 3 * steps[21], steps[21], streaming);
            chainrule_scatter(b, 64, taken, args[9] + start * steps[9], steps[9], 1, 3, 3 * steps[22], steps[22], streaming);
            chainrule_scatter(C, 64, taken, args[10] + start * steps[10], steps[10], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(D, 64, taken, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(discriminant, 64, taken, args[12] + start * steps[12], steps[12], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_terms_2)(const real *q, const real *parameters, const real *tangent, const real *curvature, real *A, real *B, real *B0, real *B1, real *a, real *b, real *C, real *D, real *discriminant)
{
    planar_ppp_speed_ratio_terms_2_one(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_terms_2_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[6 * 64];
    real tangent[2 * 64];
    real curvature[2 * 64];
    real A[3 * 64];
    real B[6 * 64];
    real B0[6 * 64];
    real B1[6 * 64];
    real a[3 * 64];
    real b[3 * 64];
    real C[1 * 64];
    real D[1 * 64];
    real discriminant[1 * 64];
    const int streaming = chainrule_streams(count, 30);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[13], steps[13]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[14], steps[14]);
            chainrule_gather(tangent, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[15], steps[15]);
            chainrule_gather(curvature, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[16], steps[16]);
            planar_ppp_speed_ratio_terms_2_one(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
            chainrule_scatter(A, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[17], steps[17], 0);
            chainrule_scatter(B, 1, 1, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[18], steps[18], 0);
            chainrule_scatter(B0, 1, 1, args[6] + start * steps[6], steps[6], 1, 6, 6 * steps[19], steps[19], 0);
            chainrule_scatter(B1, 1, 1, args[7] + start * steps[7], steps[7], 1, 6, 6 * steps[20], steps[20], 0);
            chainrule_scatter(a, 1, 1, args[8] + start * steps[8], steps[8], 1, 3, 3 * steps[21], steps[21], 0);
            chainrule_scatter(b, 1, 1, args[9] + start * steps[9], steps[9], 1, 3, 3 * steps[22], steps[22], 0);
            chainrule_scatter(C, 1, 1, args[10] + start * steps[10], steps[10], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(D, 1, 1, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(discriminant, 1, 1, args[12] + start * steps[12], steps[12], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[13], steps[13]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[14], steps[14]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(tangent, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[15], steps[15]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(curvature, 64, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[16], steps[16]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 6, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[8])) {
                chainrule_fetch(args[8] + start * steps[8], steps[8], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[9])) {
                chainrule_fetch(args[9] + start * steps[9], steps[9], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[10])) {
                chainrule_fetch(args[10] + start * steps[10], steps[10], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[11])) {
                chainrule_fetch(args[11] + start * steps[11], steps[11], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[12])) {
                chainrule_fetch(args[12] + start * steps[12], steps[12], 1, taken, 1);
            }
            planar_ppp_speed_ratio_terms_2_tile(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
            chainrule_scatter(A, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[17], steps[17], streaming);
            chainrule_scatter(B, 64, taken, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[18], steps[18], streaming);
            chainrule_scatter(B0, 64, taken, args[6] + start * steps[6], steps[6], 1, 6, 6 * steps[19], steps[19], streaming);
            chainrule_scatter(B1, 64, taken, args[7] + start * steps[7], steps[7], 1, 6, 6 * steps[20], steps[20], streaming);
            chainrule_scatter(a, 64, taken, args[8] + start * steps[8], steps[8], 1, 3, 3 * steps[21], steps[21], streaming);
            chainrule_scatter(b, 64, taken, args[9] + start * steps[9], steps[9], 1, 3, 3 * steps[22], steps[22], streaming);
            chainrule_scatter(C, 64, taken, args[10] + start * steps[10], steps[10], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(D, 64, taken, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(discriminant, 64, taken, args[12] + start * steps[12], steps[12], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_terms_3)(const real *q, const real *parameters, const real *tangent, const real *curvature, real *A, real *B, real *B0, real *B1, real *a, real *b, real *C, real *D, real *discriminant)
{
    planar_ppp_speed_ratio_terms_3_one(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_terms_3_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[6 * 64];
    real tangent[2 * 64];
    real curvature[2 * 64];
    real A[3 * 64];
    real B[6 * 64];
    real B0[6 * 64];
    real B1[6 * 64];
    real a[3 * 64];
    real b[3 * 64];
    real C[1 * 64];
    real D[1 * 64];
    real discriminant[1 * 64];
    const int streaming = chainrule_streams(count, 30);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[13], steps[13]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[14], steps[14]);
            chainrule_gather(tangent, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[15], steps[15]);
            chainrule_gather(curvature, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[16], steps[16]);
            planar_ppp_speed_ratio_terms_3_one(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
            chainrule_scatter(A, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[17], steps[17], 0);
            chainrule_scatter(B, 1, 1, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[18], steps[18], 0);
            chainrule_scatter(B0, 1, 1, args[6] + start * steps[6], steps[6], 1, 6, 6 * steps[19], steps[19], 0);
            chainrule_scatter(B1, 1, 1, args[7] + start * steps[7], steps[7], 1, 6, 6 * steps[20], steps[20], 0);
            chainrule_scatter(a, 1, 1, args[8] + start * steps[8], steps[8], 1, 3, 3 * steps[21], steps[21], 0);
            chainrule_scatter(b, 1, 1, args[9] + start * steps[9], steps[9], 1, 3, 3 * steps[22], steps[22], 0);
            chainrule_scatter(C, 1, 1, args[10] + start * steps[10], steps[10], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(D, 1, 1, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(discriminant, 1, 1, args[12] + start * steps[12], steps[12], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[13], steps[13]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[14], steps[14]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(tangent, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[15], steps[15]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(curvature, 64, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[16], steps[16]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 6, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 2, taken, 0);
            if (!chainrule_past(streaming, 3, steps[4])) {
                chainrule_fetch(args[4] + start * steps[4], steps[4], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 6, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[8])) {
                chainrule_fetch(args[8] + start * steps[8], steps[8], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[9])) {
                chainrule_fetch(args[9] + start * steps[9], steps[9], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[10])) {
                chainrule_fetch(args[10] + start * steps[10], steps[10], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[11])) {
                chainrule_fetch(args[11] + start * steps[11], steps[11], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[12])) {
                chainrule_fetch(args[12] + start * steps[12], steps[12], 1, taken, 1);
            }
            planar_ppp_speed_ratio_terms_3_tile(q, parameters, tangent, curvature, A, B, B0, B1, a, b, C, D, discriminant);
            chainrule_scatter(A, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[17], steps[17], streaming);
            chainrule_scatter(B, 64, taken, args[5] + start * steps[5], steps[5], 1, 6, 6 * steps[18], steps[18], streaming);
            chainrule_scatter(B0, 64, taken, args[6] + start * steps[6], steps[6], 1, 6, 6 * steps[19], steps[19], streaming);
            chainrule_scatter(B1, 64, taken, args[7] + start * steps[7], steps[7], 1, 6, 6 * steps[20], steps[20], streaming);
            chainrule_scatter(a, 64, taken, args[8] + start * steps[8], steps[8], 1, 3, 3 * steps[21], steps[21], streaming);
            chainrule_scatter(b, 64, taken, args[9] + start * steps[9], steps[9], 1, 3, 3 * steps[22], steps[22], streaming);
            chainrule_scatter(C, 64, taken, args[10] + start * steps[10], steps[10], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(D, 64, taken, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(discriminant, 64, taken, args[12] + start * steps[12], steps[12], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
        }
    }
    chainrule_settle(streaming);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_rates)(const real *q, const real *parameters, const real *tangent, const real *curvature, const real *leading, real *rates, real *ratios, real *tracked, real *tracked_rate, real *verdict, real *parabola, real *slack, real *least, real *null)
{
    planar_ppp_speed_ratio_rates_one(q, parameters, tangent, curvature, leading, rates, ratios, tracked, tracked_rate, verdict, parabola, slack, least, null);
}

void CHAINRULE_NAME(planar_ppp_speed_ratio_rates_batch)(ptrdiff_t count, char *const *args, const ptrdiff_t *steps)
{
    real q[3 * 64];
    real parameters[6 * 64];
    real tangent[2 * 64];
    real curvature[2 * 64];
    real leading[3 * 64];
    real rates[6 * 64];
    real ratios[4 * 64];
    real tracked[2 * 64];
    real tracked_rate[2 * 64];
    real verdict[5 * 64];
    real parabola[3 * 64];
    real slack[1 * 64];
    real least[3 * 64];
    real null[3 * 64];
    const int streaming = chainrule_streams(count, 29);
    int taken;
    for (ptrdiff_t start = 0; start < count; start += taken) {
        taken = chainrule_take(count - start, 64);
        if (taken == 1) {
            chainrule_gather(q, 1, 1, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[14], steps[14]);
            chainrule_gather(parameters, 1, 1, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[15], steps[15]);
            chainrule_gather(tangent, 1, 1, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[16], steps[16]);
            chainrule_gather(curvature, 1, 1, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[17], steps[17]);
            chainrule_gather(leading, 1, 1, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[18], steps[18]);
            planar_ppp_speed_ratio_rates_one(q, parameters, tangent, curvature, leading, rates, ratios, tracked, tracked_rate, verdict, parabola, slack, least, null);
            chainrule_scatter(rates, 1, 1, args[5] + start * steps[5], steps[5], 2, 3, steps[19], steps[20], 0);
            chainrule_scatter(ratios, 1, 1, args[6] + start * steps[6], steps[6], 2, 2, steps[21], steps[22], 0);
            chainrule_scatter(tracked, 1, 1, args[7] + start * steps[7], steps[7], 1, 2, 2 * steps[23], steps[23], 0);
            chainrule_scatter(tracked_rate, 1, 1, args[8] + start * steps[8], steps[8], 1, 2, 2 * steps[24], steps[24], 0);
            chainrule_scatter(verdict, 1, 1, args[9] + start * steps[9], steps[9], 1, 5, 5 * steps[25], steps[25], 0);
            chainrule_scatter(parabola, 1, 1, args[10] + start * steps[10], steps[10], 1, 3, 3 * steps[26], steps[26], 0);
            chainrule_scatter(slack, 1, 1, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), 0);
            chainrule_scatter(least, 1, 1, args[12] + start * steps[12], steps[12], 1, 3, 3 * steps[27], steps[27], 0);
            chainrule_scatter(null, 1, 1, args[13] + start * steps[13], steps[13], 1, 3, 3 * steps[28], steps[28], 0);
        } else {
            chainrule_gather(q, 64, taken, args[0] + start * steps[0], steps[0], 1, 3, 3 * steps[14], steps[14]);
            if (start == 0 || steps[1] != 0) /* the same for all: once */
                chainrule_gather(parameters, 64, taken, args[1] + start * steps[1], steps[1], 1, 6, 6 * steps[15], steps[15]);
            if (start == 0 || steps[2] != 0) /* the same for all: once */
                chainrule_gather(tangent, 64, taken, args[2] + start * steps[2], steps[2], 1, 2, 2 * steps[16], steps[16]);
            if (start == 0 || steps[3] != 0) /* the same for all: once */
                chainrule_gather(curvature, 64, taken, args[3] + start * steps[3], steps[3], 1, 2, 2 * steps[17], steps[17]);
            if (start == 0 || steps[4] != 0) /* the same for all: once */
                chainrule_gather(leading, 64, taken, args[4] + start * steps[4], steps[4], 1, 3, 3 * steps[18], steps[18]);
            chainrule_fetch(args[0] + (start + taken) * steps[0], steps[0], 3, taken, 0);
            chainrule_fetch(args[1] + (start + taken) * steps[1], steps[1], 6, taken, 0);
            chainrule_fetch(args[2] + (start + taken) * steps[2], steps[2], 2, taken, 0);
            chainrule_fetch(args[3] + (start + taken) * steps[3], steps[3], 2, taken, 0);
            chainrule_fetch(args[4] + (start + taken) * steps[4], steps[4], 3, taken, 0);
            if (!chainrule_past(streaming, 6, steps[5])) {
                chainrule_fetch(args[5] + start * steps[5], steps[5], 6, taken, 1);
            }
            if (!chainrule_past(streaming, 4, steps[6])) {
                chainrule_fetch(args[6] + start * steps[6], steps[6], 4, taken, 1);
            }
            if (!chainrule_past(streaming, 2, steps[7])) {
                chainrule_fetch(args[7] + start * steps[7], steps[7], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 2, steps[8])) {
                chainrule_fetch(args[8] + start * steps[8], steps[8], 2, taken, 1);
            }
            if (!chainrule_past(streaming, 5, steps[9])) {
                chainrule_fetch(args[9] + start * steps[9], steps[9], 5, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[10])) {
                chainrule_fetch(args[10] + start * steps[10], steps[10], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 1, steps[11])) {
                chainrule_fetch(args[11] + start * steps[11], steps[11], 1, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[12])) {
                chainrule_fetch(args[12] + start * steps[12], steps[12], 3, taken, 1);
            }
            if (!chainrule_past(streaming, 3, steps[13])) {
                chainrule_fetch(args[13] + start * steps[13], steps[13], 3, taken, 1);
            }
            planar_ppp_speed_ratio_rates_tile(q, parameters, tangent, curvature, leading, rates, ratios, tracked, tracked_rate, verdict, parabola, slack, least, null);
            chainrule_scatter(rates, 64, taken, args[5] + start * steps[5], steps[5], 2, 3, steps[19], steps[20], streaming);
            chainrule_scatter(ratios, 64, taken, args[6] + start * steps[6], steps[6], 2, 2, steps[21], steps[22], streaming);
            chainrule_scatter(tracked, 64, taken, args[7] + start * steps[7], steps[7], 1, 2, 2 * steps[23], steps[23], streaming);
            chainrule_scatter(tracked_rate, 64, taken, args[8] + start * steps[8], steps[8], 1, 2, 2 * steps[24], steps[24], streaming);
            chainrule_scatter(verdict, 64, taken, args[9] + start * steps[9], steps[9], 1, 5, 5 * steps[25], steps[25], streaming);
            chainrule_scatter(parabola, 64, taken, args[10] + start * steps[10], steps[10], 1, 3, 3 * steps[26], steps[26], streaming);
            chainrule_scatter(slack, 64, taken, args[11] + start * steps[11], steps[11], 1, 1, 1 * (ptrdiff_t)sizeof(real), (ptrdiff_t)sizeof(real), streaming);
            chainrule_scatter(least, 64, taken, args[12] + start * steps[12], steps[12], 1, 3, 3 * steps[27], steps[27], streaming);
            chainrule_scatter(null, 64, taken, args[13] + start * steps[13], steps[13], 1, 3, 3 * steps[28], steps[28], streaming);
        }
    }
    chainrule_settle(streaming);
}
