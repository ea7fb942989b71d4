/* chainrule_real.h: the floating-point type of the kernels.
 * double by default; float when CHAINRULE_FLOAT is defined. C99, no state, no allocation. */
#ifndef CHAINRULE_REAL_H
#define CHAINRULE_REAL_H

#include <float.h>
#include <math.h>
#include <stdint.h>

/* A kernel of one type is inlined wherever it is called, so that the loop around it vectorises. */
#if defined(__GNUC__)
#define CR_INLINE static inline __attribute__((always_inline))
#define CR_NOINLINE __attribute__((noinline))
#else
#define CR_INLINE static inline
#define CR_NOINLINE
#endif

#ifdef CHAINRULE_FLOAT

typedef float real;
typedef uint32_t chainrule_bits; /* as wide as real */
#define CHAINRULE_NAME(x) x##f
#define CR_C(x) x##f /* a decimal or hexadecimal literal of type real: CR_C(0.5) */
#define CR_EPSILON FLT_EPSILON
#define CR_MIN FLT_MIN
#define CR_MAX FLT_MAX
#define CR_SIN sinf
#define CR_COS cosf
#define CR_ATAN2 atan2f
#define CR_SQRT sqrtf
#define CR_FABS fabsf
#define CR_COPYSIGN copysignf
#if defined(FP_FAST_FMAF) || defined(__FMA__) || defined(__aarch64__) || defined(__ARM_FEATURE_FMA)
#define CR_HAS_FMA 1
#define CR_MULADD(a, b, c) fmaf((a), (b), (c))
#endif

#else /* double */

typedef double real;
typedef uint64_t chainrule_bits; /* as wide as real */
#define CHAINRULE_NAME(x) x
#define CR_C(x) x /* a decimal or hexadecimal literal of type real: CR_C(0.5) */
#define CR_EPSILON DBL_EPSILON
#define CR_MIN DBL_MIN
#define CR_MAX DBL_MAX
#define CR_SIN sin
#define CR_COS cos
#define CR_ATAN2 atan2
#define CR_SQRT sqrt
#define CR_FABS fabs
#define CR_COPYSIGN copysign
#if defined(FP_FAST_FMA) || defined(__FMA__) || defined(__aarch64__) \
    || (defined(__ARM_FEATURE_FMA) && defined(__ARM_FP) && (__ARM_FP & 8))
#define CR_HAS_FMA 1
#define CR_MULADD(a, b, c) fma((a), (b), (c))
#endif

#endif /* CHAINRULE_FLOAT */

/* a * b + c, fused where the hardware does it. Elsewhere fma() would be a slow call. */
#ifndef CR_HAS_FMA
#define CR_HAS_FMA 0
#define CR_MULADD(a, b, c) ((a) * (b) + (c))
#endif

/* The lesser and the greater of two numbers; nan where one of them is nan. */
CR_INLINE real chainrule_min(real a, real b)
{
    return a < b || a != a ? a : b;
}

CR_INLINE real chainrule_max(real a, real b)
{
    return a > b || a != a ? a : b;
}

#endif /* CHAINRULE_REAL_H */
