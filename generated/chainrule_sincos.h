/* chainrule_sincos.h: sine and cosine of a tile of angles (rad), without a branch in the loop, so that it vectorises.
 *
 * Reduction by Cody and Waite to |r| <= pi/4, two minimax polynomials, quadrant by bit operations. Errors stay below
 * 0.85 ulp, also beside the multiples of pi/2, with FMA and without, however the compiler contracts. An element's
 * result does not depend on its place in the tile. Odd and even symmetry are exact, sin(-0) is -0; inf and nan give
 * nan. Angles beyond CR_SINCOS_LIMIT take the C library's functions.
 * Needs round-to-nearest, as C programs start with. Plain C99. */
#ifndef CHAINRULE_SINCOS_H
#define CHAINRULE_SINCOS_H

#include <string.h>

#include "chainrule_real.h"

/* Excess precision and reordered sums break the rounding trick: there the C library does it all. */
#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(_M_FP_FAST) \
    || FLT_EVAL_METHOD < 0 || FLT_EVAL_METHOD > 1
#define CR_SINCOS_LIBRARY 1
#else
#define CR_SINCOS_LIBRARY 0
#endif

#if CR_SINCOS_LIBRARY

CR_INLINE void chainrule_sincos1(real x, real *sine, real *cosine)
{
    *sine = CR_SIN(x);
    *cosine = CR_COS(x);
}

static inline void chainrule_sincos(const real *restrict x, real *restrict sine, real *restrict cosine, int count)
{
    for (int i = 0; i < count; i++) {
        sine[i] = CR_SIN(x[i]);
        cosine[i] = CR_COS(x[i]);
    }
}

#else

#ifdef CHAINRULE_FLOAT
/* round(2 x / pi) by adding 1.5 * 2^23: the sum's lowest bits are those of the integer. */
#define CR_TWO_OVER_PI 0x1.45f306p-1f
#define CR_MAGIC 0x1.8p+23f
/* The sum with the lowest n in range, -2^9; a difference from it has these bits out of range only. */
#define CR_MAGIC_LOWEST 0x1.7ffcp+23f
#define CR_SINCOS_BEYOND (~(chainrule_bits)0 << 10)
/* pi/2 truncated, and as a sum whose first three parts times |n| <= 2^9 are exact products. */
#define CR_HALF_PI 0x1.921fb4p+0f
#define CR_HALF_PI_0 0x1.921cp+0f
#define CR_HALF_PI_1 0x1.dap-15f
#define CR_HALF_PI_2 0x1.4444p-24f
#define CR_HALF_PI_3 -0x1.2e7b96p-40f
/* The polynomial path serves every |x| up to this, 802.677 rad, and at most a quadrant more. */
#define CR_SINCOS_LIMIT 0x1.9156a4p+9f
#define CR_SIGN_BIT ((chainrule_bits)1 << 31)
#define CR_SIGN_SHIFT 30
/* sin r = r + r z S(z), relative error below 4e-09; z = r^2, |r| <= pi/4 */
#define CR_SINE_0 -0x1.555546p-3f
#define CR_SINE_1 0x1.110778p-7f
#define CR_SINE_2 -0x1.9953fep-13f
#define CR_SINE_POLYNOMIAL(z, z2) \
    CR_MULADD(z2, CR_SINE_2, CR_MULADD(z, CR_SINE_1, CR_SINE_0))
/* cos r = 1 - z/2 + z^2 C(z), relative error below 1.2e-10 */
#define CR_COSINE_0 0x1.55554ap-5f
#define CR_COSINE_1 -0x1.6c0c28p-10f
#define CR_COSINE_2 0x1.99e80cp-16f
#define CR_COSINE_POLYNOMIAL(z, z2) \
    CR_MULADD(z2, CR_COSINE_2, CR_MULADD(z, CR_COSINE_1, CR_COSINE_0))
#else
/* round(2 x / pi) by adding 1.5 * 2^52: the sum's lowest bits are those of the integer. */
#define CR_TWO_OVER_PI 0x1.45f306dc9c883p-1
#define CR_MAGIC 0x1.8p+52
/* The sum with the lowest n in range, -2^20; a difference from it has these bits out of range only. */
#define CR_MAGIC_LOWEST 0x1.7fffffffp+52
#define CR_SINCOS_BEYOND (~(chainrule_bits)0 << 21)
/* pi/2 truncated, and as a sum whose first three parts times |n| <= 2^20 are exact products. */
#define CR_HALF_PI 0x1.921fb54442d18p+0
#define CR_HALF_PI_0 0x1.921fb544p+0
#define CR_HALF_PI_1 0x1.0b46p-34
#define CR_HALF_PI_2 0x1.1a626331p-54
#define CR_HALF_PI_3 0x1.1701b839a252p-88
/* The polynomial path serves every |x| up to this, 1.6471e+06 rad, and at most a quadrant more. */
#define CR_SINCOS_LIMIT 0x1.921f9c22477d4p+20
#define CR_SIGN_BIT ((chainrule_bits)1 << 63)
#define CR_SIGN_SHIFT 62
/* sin r = r + r z S(z), relative error below 3.8e-18; z = r^2, |r| <= pi/4 */
#define CR_SINE_0 -0x1.5555555555548p-3
#define CR_SINE_1 0x1.111111110f73p-7
#define CR_SINE_2 -0x1.a01a019be91cfp-13
#define CR_SINE_3 0x1.71de355524214p-19
#define CR_SINE_4 -0x1.ae5e4b7cfb06bp-26
#define CR_SINE_5 0x1.5d8b539fa23b1p-33
#define CR_SINE_POLYNOMIAL(z, z2) \
    CR_MULADD(z2, CR_MULADD(z2, CR_MULADD(z, CR_SINE_5, CR_SINE_4), CR_MULADD(z, CR_SINE_3, CR_SINE_2)), CR_MULADD(z, CR_SINE_1, CR_SINE_0))
/* cos r = 1 - z/2 + z^2 C(z), relative error below 5.7e-20 */
#define CR_COSINE_0 0x1.555555555554bp-5
#define CR_COSINE_1 -0x1.6c16c16c15015p-10
#define CR_COSINE_2 0x1.a01a019c8f23ep-16
#define CR_COSINE_3 -0x1.27e4f7f18f216p-22
#define CR_COSINE_4 0x1.1ee9dbccbc6f7p-29
#define CR_COSINE_5 -0x1.8fa682fa26c26p-37
#define CR_COSINE_POLYNOMIAL(z, z2) \
    CR_MULADD(z2, CR_MULADD(z2, CR_MULADD(z, CR_COSINE_5, CR_COSINE_4), CR_MULADD(z, CR_COSINE_3, CR_COSINE_2)), CR_MULADD(z, CR_COSINE_1, CR_COSINE_0))
#endif

CR_INLINE chainrule_bits chainrule_bits_of(real value)
{
    chainrule_bits bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

CR_INLINE real chainrule_real_of(chainrule_bits bits)
{
    real value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/* 2 x / pi rounded to an integer n, as n + CR_MAGIC. */
CR_INLINE real chainrule_sincos_shifted(real x)
{
    return CR_MULADD(x, CR_TWO_OVER_PI, CR_MAGIC);
}

/* Zero in the bits of CR_SINCOS_BEYOND unless n is out of range, infinite or nan. */
CR_INLINE chainrule_bits chainrule_sincos_range(real shifted)
{
    return chainrule_bits_of(shifted) - chainrule_bits_of(CR_MAGIC_LOWEST);
}

/* The polynomial path, right for n in range. */
CR_INLINE void chainrule_sincos_near(real x, real shifted, real *sine, real *cosine)
{
    /* x = n pi/2 + r - tail. The products with the first parts of pi/2 are exact, fused or not; so is head, and so is
     * the error of r. The tail's sign is such that -0 stays -0. */
    const real n = shifted - CR_MAGIC;
#if CR_HAS_FMA
    const real head = CR_MULADD(-n, CR_HALF_PI, x);
#else
    const real head = (x - n * CR_HALF_PI_0) - n * CR_HALF_PI_1;
#endif
    const real r = CR_MULADD(-n, CR_HALF_PI_2, head);
    const real tail = CR_MULADD(n, CR_HALF_PI_3, CR_MULADD(n, CR_HALF_PI_2, r - head));
    const real z = r * r;
    const real z2 = z * z;

    /* 1 - z/2 rounds; what it loses is added with the small terms. */
    const real w = CR_MULADD(-CR_C(0.5), z, CR_C(1.0));
    const real lost = CR_MULADD(-CR_C(0.5), z, CR_C(1.0) - w);
    const real c = w + CR_MULADD(r, tail, CR_MULADD(z2, (CR_COSINE_POLYNOMIAL(z, z2)), lost));
    const real s = r - CR_MULADD(-(r * z), (CR_SINE_POLYNOMIAL(z, z2)), w * tail);

    /* n modulo 4 is in the two lowest bits: odd turns (sine, cosine) into (cosine, -sine), 2 and 3 negate both. */
    const chainrule_bits quadrant = chainrule_bits_of(shifted);
    const chainrule_bits odd = (chainrule_bits)0 - (quadrant & 1);
    const chainrule_bits sign = (quadrant << CR_SIGN_SHIFT) & CR_SIGN_BIT;
    const chainrule_bits sine_bits = chainrule_bits_of(s);
    const chainrule_bits cosine_bits = chainrule_bits_of(c);
    const chainrule_bits swap = (sine_bits ^ cosine_bits) & odd;
    *sine = chainrule_real_of(sine_bits ^ swap ^ sign);
    *cosine = chainrule_real_of((cosine_bits ^ swap ^ sign) ^ (odd & CR_SIGN_BIT));
}

/* One angle, by the same operations as a tile. */
static inline void chainrule_sincos1(real x, real *sine, real *cosine)
{
    const real shifted = chainrule_sincos_shifted(x);
    if (chainrule_sincos_range(shifted) & CR_SINCOS_BEYOND) {
        *sine = CR_SIN(x);
        *cosine = CR_COS(x);
    } else {
        chainrule_sincos_near(x, shifted, sine, cosine);
    }
}

/* sine[i] = sin(x[i]), cosine[i] = cos(x[i]) for 0 <= i < count. The three arrays do not overlap. */
static inline void chainrule_sincos(const real *restrict x, real *restrict sine, real *restrict cosine, int count)
{
    chainrule_bits beyond = 0;
    for (int i = 0; i < count; i++) {
        const real shifted = chainrule_sincos_shifted(x[i]);
        beyond |= chainrule_sincos_range(shifted);
        chainrule_sincos_near(x[i], shifted, &sine[i], &cosine[i]);
    }
    if (beyond & CR_SINCOS_BEYOND) { /* rare: some angle of this tile */
        for (int i = 0; i < count; i++) {
            chainrule_sincos1(x[i], &sine[i], &cosine[i]);
        }
    }
}

#endif /* CR_SINCOS_LIBRARY */

#endif /* CHAINRULE_SINCOS_H */
