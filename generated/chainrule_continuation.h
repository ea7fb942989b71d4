/* chainrule_continuation.h: follows the curve e(q) = 0 of n - 1 equations for n joints, without jumping to another one.
 * C99, double, no allocation: the caller gives the room for the points.
 *
 * x stands for the joint values in rad, prismatic ones divided by a length scale; rows that are lengths are divided by a
 * length. The steps, and why they are right:
 *
 * 1. Guard. At a point x0 of the curve with unit tangent t and b >= |J^+|, let K bound the second derivative of e in the
 *    ball of radius r about x0. For b K r <= c < 1 the map T(x) = x - J^+ e(x) + (s - t.(x - x0)) t contracts the ball,
 *    and |T(x) - x0|^2 <= s^2 + (c r / 2)^2. So for every |s| <= r sqrt(1 - c^2 / 4) the ball holds exactly one point of
 *    the curve with t.(x - x0) = s: within that slab of the ball the solutions are one arc, through x0. A step to a
 *    solution in it cannot have changed curves.
 * 2. Step. Predict by the polynomial through up to 4 points and tangents; correct by Newton's method,
 *    x -= J^+ e; halve the step where that does not contract. A point in the slab of the last ball is on its arc; so is one
 *    beyond whose own ball holds the end of that arc in its slab: then both arcs are one.
 * 3. Closure. Where the start, revolute joints shifted by whole turns, lies ahead within the slab, or behind the new point
 *    within the slab of its ball, the arc leads to it.
 * 4. Length. As often as the tangent has turned a little (or 5 radii were passed), the length since then is the integral of 1 / (t.d) over the
 *    distance along the chord's direction d, by Lobatto's rule with 7 points, each corrected on the curve. Its last
 *    Legendre coefficients, and how fast they fall, estimate the error and set the next turn.
 * 5. Extrema of each joint and of H between points: the roots of the tangent's component and of dH/ds. */
#ifndef CHAINRULE_CONTINUATION_H
#define CHAINRULE_CONTINUATION_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <string.h>

/* Why a curve ended. */
enum {
    CHAINRULE_CLOSED,   /* it returned to its start */
    CHAINRULE_LENGTH,   /* the greatest length was reached */
    CHAINRULE_SINGULAR, /* 1 / (|J| |J^+|) fell below the stated share */
    CHAINRULE_STEPS,    /* the greatest number of steps was reached */
    CHAINRULE_STUCK,    /* no step satisfied the guard */
    CHAINRULE_START,    /* the start does not lead to the curve */
    CHAINRULE_ROOM      /* there was no room for a further point */
};

/* Where to end. */
typedef struct {
    double longest;  /* length */
    double singular; /* share below which J counts as singular */
    ptrdiff_t steps; /* certified steps */
    int direction;   /* 1 along the null vector, -1 against it */
} chainrule_curve_settings;

/* What there is besides the points. */
typedef struct {
    double length, closure, contraction, lowest, highest; /* the last two: H */
    ptrdiff_t points, knots, steps, evaluations;
    int reason;
} chainrule_curve_result;

/* Arrays for `count` curves; a step is the distance from one curve's entries to the next one's, 0 where they share them. */
typedef struct {
    const double *starts;                            /* joints each */
    const double *targets;     ptrdiff_t target_step;
    const double *parameters;  ptrdiff_t parameter_step; /* null where the arm has none */
    const double *units;       ptrdiff_t unit_step;  /* per joint: 1, or the length scale of a prismatic one */
    const double *links;       ptrdiff_t link_step;  /* per joint: constant distance to the next one, or to the tip */
    const double *sizes;       ptrdiff_t size_step;  /* the length that rows are divided by */
} chainrule_curve_inputs;

/* Where points and extrema go, curve after curve. */
typedef struct {
    double *points;    /* 3 joints + 3 numbers each: x, dx/ds, d2x/ds2, s, H, dH/ds */
    double *knots;     /* 3 numbers each: joint from 0 (H: the number of joints), s, value */
    ptrdiff_t most_points, most_knots;
} chainrule_curve_room;

#ifdef CHAINRULE_FOLLOWS /* the code, for the units that follow a curve */

#define CR_N CHAINRULE_JOINTS       /* joints, */
#define CR_M (CR_N - 1)             /* rows, */
#define CR_LANES ((CR_N + 3) / 4 * 4) /* and either, filled up for vector instructions */
#define CR_WIDTH (3 * CR_N + 3)
#define CR_PARTS 8 /* of an interval between points in which a slope is looked at for a change of sign */
#define CR_NODES 48  /* certified points kept between two ends of the length rule */
#define CR_ROOM (CR_NODES + 16)
#define CR_ORDER 7
#define CR_TURNS 6.283185307179586

typedef struct chainrule_curve {
    int positions, whole, spatial;
    const char *kinds;
    void (*held)(const struct chainrule_curve *, const double *q, double *error, double *jacobian, double *null_vector);
    void (*bending)(const struct chainrule_curve *, const double *q, double *null_vector, double *bending);
    const double *target, *parameters, *unit, *links;
    double size;
    chainrule_curve_settings settings;
    chainrule_curve_result result;
    double *points; /* x, dx/ds, d2x/ds2, s, H, dH/ds: CR_WIDTH numbers each */
    double *knots;  /* extrema: joint from 0 (CR_N for H), s, value */
    ptrdiff_t room, knot_room;
    double turn;
} chainrule_curve;

typedef struct {
    double x[CR_LANES], t[CR_LANES], radius, s;
} cr_node;

/* What a correction leaves: the tangent, the bound of |J^+|, and the scaled Jacobian. */
typedef struct {
    double x[CR_LANES], t[CR_LANES], jacobian[CR_M * CR_N], bound;
} cr_found;

static const double cr_lobatto_nodes[CR_ORDER] = {0.0, 0.08488805186071653, 0.2655756032646429, 0.5, 0.7344243967353571, 0.9151119481392834, 1.0};
static const double cr_lobatto_last[4][CR_ORDER] = { /* values to the last four Legendre coefficients */
    {-0.16666666666666666, -0.17952466570427653, 0.6733777254041259, 0.0, -0.6733777254041259, 0.17952466570427653, 0.16666666666666666},
    {0.21428571428571427, -0.16347064236057107, -0.46224364335371465, 0.8228571428571428, -0.46224364335371465, -0.16347064236057107, 0.21428571428571427},
    {-0.2619047619047619, 0.5242660651521481, -0.36974277380392945, 0.0, 0.36974277380392945, -0.5242660651521481, 0.2619047619047619},
    {0.14285714285714285, -0.34444119176359883, 0.4301554774778845, -0.45714285714285713, 0.4301554774778845, -0.34444119176359883, 0.14285714285714285},
};
static const double cr_lobatto_running[CR_ORDER][CR_ORDER] = { /* values to integrals up to each node */
    {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0},
    {0.03284626432829265, 0.05932289402755141, -0.010768594451189268, 0.005597591780569777, -0.0034889299708074626, 0.0022170965889145395, -0.0008382704426151044},
    {0.018002223201815166, 0.15770113064168903, 0.10235481204686192, -0.018478259273459044, 0.009577580100741405, -0.005681864566224377, 0.002099981113218786},
    {0.027529761904761904, 0.12778825555983747, 0.23748565272164546, 0.1219047619047619, -0.02161296211671413, 0.010624768120945505, -0.003720238095238095},
    {0.021709542696305022, 0.14409488824700736, 0.20629511050418992, 0.26228778308298284, 0.1135178785580694, -0.01928810696090607, 0.0058073006077086434},
    {0.024647794252138915, 0.13619592709186842, 0.21936162057573877, 0.23821193202895402, 0.22664128505612058, 0.07909012965323158, -0.009036740518768838},
    {0.023809523809523808, 0.13841302368078298, 0.2158726906049313, 0.2438095238095238, 0.2158726906049313, 0.13841302368078298, 0.023809523809523808},
};

static double cr_least(double a, double b)
{
    return a < b ? a : b;
}

static double cr_most(double a, double b)
{
    return a > b ? a : b;
}

/* CR_N numbers */
static void cr_copy(double *to, const double *from)
{
    memcpy(to, from, sizeof(double) * CR_N);
}

static double cr_dot(const double *a, const double *b)
{
    double sum = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        sum += a[i] * b[i];
    }
    return sum;
}

static double cr_distance(const double *a, const double *b)
{
    double sum = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        sum += (a[i] - b[i]) * (a[i] - b[i]);
    }
    return sqrt(sum);
}

/* -J^+ e and a bound of |J^+|, its Frobenius norm unless `sharp`; 0 where a row is zero. The rows are made orthogonal one
 * after the other, J = L Q with L of unit diagonal, all later rows at a time: a lane is a row. With the rows of Q of length
 * 1 / sqrt(D), |J^+|^2 is the largest eigenvalue of G = L^-T D L^-1, which is at most the root of |G^2| (Frobenius). */
static int cr_minimum_norm(const double *jacobian, const double *e, int sharp, double *step, double *bound)
{
    double q[CR_N][CR_LANES], inverse[CR_M][CR_LANES]; /* columns: of Q, and of 1 / L */
    double y[CR_LANES], over[CR_LANES], share[CR_LANES];
    for (int k = 0; k < CR_N; ++k) {
        for (int i = 0; i < CR_M; ++i) {
            q[k][i] = jacobian[i * CR_N + k];
        }
        for (int i = CR_M; i < CR_LANES; ++i) {
            q[k][i] = 0.0;
        }
    }
    for (int k = 0; k < CR_M; ++k) {
        for (int i = 0; i < CR_LANES; ++i) {
            inverse[k][i] = i == k ? 1.0 : 0.0;
        }
    }
    for (int i = 0; i < CR_LANES; ++i) {
        y[i] = i < CR_M ? e[i] : 0.0;
        over[i] = 0.0;
    }
    for (int i = 0; i < CR_M; ++i) {
        double product[CR_LANES], other[CR_LANES]; /* two sums: one would wait for itself */
        for (int j = 0; j < CR_LANES; ++j) {
            product[j] = other[j] = 0.0;
        }
        for (int k = 0; k + 1 < CR_N; k += 2) {
            const double one = q[k][i], two = q[k + 1][i];
            for (int j = 0; j < CR_LANES; ++j) {
                product[j] += one * q[k][j];
                other[j] += two * q[k + 1][j];
            }
        }
        for (int j = 0; j < CR_LANES; ++j) {
            product[j] += other[j] + (CR_N % 2 ? q[CR_N - 1][i] * q[CR_N - 1][j] : 0.0);
        }
        if (!(product[i] > 1e-290)) {
            return 0;
        }
        over[i] = 1.0 / product[i];
        for (int j = 0; j < CR_LANES; ++j) {
            share[j] = j > i ? product[j] * over[i] : 0.0;
        }
        for (int k = 0; k < CR_N; ++k) {
            const double part = q[k][i];
            for (int j = 0; j < CR_LANES; ++j) {
                q[k][j] -= share[j] * part;
            }
        }
        for (int k = 0; k < CR_M; ++k) {
            const double part = inverse[k][i];
            for (int j = 0; j < CR_LANES; ++j) {
                inverse[k][j] -= share[j] * part;
            }
        }
        const double part = y[i];
        for (int j = 0; j < CR_LANES; ++j) {
            y[j] -= share[j] * part;
        }
    }
    for (int j = 0; j < CR_M; ++j) {
        y[j] *= over[j];
    }
    for (int k = 0; k < CR_N; ++k) {
        double part = 0.0;
        for (int j = 0; j < CR_M; ++j) {
            part += q[k][j] * y[j];
        }
        step[k] = -part;
    }
    double squares = 0.0;
    if (!sharp) {
        double total[CR_LANES] = { 0.0 };
        for (int k = 0; k < CR_M; ++k) {
            for (int j = 0; j < CR_LANES; ++j) {
                total[j] += inverse[k][j] * inverse[k][j] * over[j];
            }
        }
        for (int j = 0; j < CR_M; ++j) {
            squares += total[j];
        }
        *bound = sqrt(squares);
        return 1;
    }
    double gram[CR_M][CR_LANES];
    for (int k = 0; k < CR_M; ++k) {
        for (int l = CR_M; l < CR_LANES; ++l) {
            gram[k][l] = 0.0;
        }
        for (int l = k; l < CR_M; ++l) {
            double sum = 0.0;
            for (int j = l; j < CR_M; ++j) { /* L is lower triangular */
                sum += inverse[k][j] * inverse[l][j] * over[j];
            }
            gram[k][l] = gram[l][k] = sum;
        }
    }
    for (int k = 0; k < CR_M; ++k) {
        double row[CR_LANES];
        for (int j = 0; j < CR_LANES; ++j) {
            row[j] = 0.0;
        }
        for (int l = 0; l < CR_M; ++l) {
            for (int j = 0; j < CR_LANES; ++j) {
                row[j] += gram[k][l] * gram[l][j];
            }
        }
        for (int j = 0; j < CR_M; ++j) {
            squares += row[j] * row[j];
        }
    }
    *bound = sqrt(sqrt(sqrt(squares)));
    return 1;
}

/* Scaled error and Jacobian, and the unit tangent in the direction followed. */
static int cr_held(chainrule_curve *c, const double *x, double *e, double *jacobian, double *t)
{
    double q[CR_N];
    for (int i = 0; i < CR_N; ++i) {
        q[i] = x[i] * c->unit[i];
    }
    c->held(c, q, e, jacobian, t);
    c->result.evaluations += 1;
    for (int r = 0; r < CR_M; ++r) {
        const double scale = r < c->positions ? 1.0 / c->size : 1.0;
        e[r] *= scale;
        for (int i = 0; i < CR_N; ++i) {
            jacobian[r * CR_N + i] *= scale * c->unit[i];
        }
    }
    double squares = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        t[i] /= c->unit[i];
        squares += t[i] * t[i];
    }
    if (!(squares > 0.0 && squares <= DBL_MAX)) {
        return 0;
    }
    const double scale = c->settings.direction / sqrt(squares);
    for (int i = 0; i < CR_N; ++i) {
        t[i] *= scale;
    }
    return 1;
}

/* An output point at x: tangent, curvature vector, H and its slope; s is set by the caller. */
static void cr_row(chainrule_curve *c, const double *x, double *row)
{
    double q[CR_N], null_vector[CR_N], bending[CR_N], h2 = 0.0, turning = 0.0, squares = 0.0, along = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        q[i] = x[i] * c->unit[i];
    }
    c->bending(c, q, null_vector, bending);
    c->result.evaluations += 1;
    for (int i = 0; i < CR_N; ++i) {
        h2 += null_vector[i] * null_vector[i];
        turning += null_vector[i] * bending[i];
        null_vector[i] /= c->unit[i];
        bending[i] /= c->unit[i];
        squares += null_vector[i] * null_vector[i];
        along += null_vector[i] * bending[i];
    }
    const double h = sqrt(h2), over = 1.0 / squares, scale = c->settings.direction * sqrt(over);
    for (int i = 0; i < CR_N; ++i) {
        row[i] = x[i];
        row[CR_N + i] = scale * null_vector[i];
        row[2 * CR_N + i] = (bending[i] - null_vector[i] * (along * over)) * over;
    }
    row[3 * CR_N] = 0.0;
    row[3 * CR_N + 1] = h;
    row[3 * CR_N + 2] = scale * turning / h;
}

/* Newton's method onto the curve; in the plane normal.x = offset where a normal is given. The last correction is at most
 * 1e-09 (so that the tangent and the Jacobian, taken before it, are right to that), or leaves an error of rounding: `loose`. */
static int cr_correct(chainrule_curve *c, const double *guess, const double *normal, double offset, int loose, cr_found *f)
{
    double e[CR_LANES], step[CR_N], before = DBL_MAX;
    cr_copy(f->x, guess);
    for (int turn = 0; turn < 12; ++turn) {
        if (!cr_held(c, f->x, e, f->jacobian, f->t) || !cr_minimum_norm(f->jacobian, e, !loose, step, &f->bound)) {
            return 0;
        }
        if (normal) {
            const double along = cr_dot(normal, f->t);
            if (!(fabs(along) >= 0.05)) {
                return 0;
            }
            const double rest = (offset - cr_dot(normal, f->x) - cr_dot(normal, step)) / along;
            for (int i = 0; i < CR_N; ++i) {
                step[i] += rest * f->t[i];
            }
        }
        const double size = sqrt(cr_dot(step, step));
        if (!(size <= cr_most(0.5 * before, 1e-11))) {
            return 0;
        }
        for (int i = 0; i < CR_N; ++i) {
            f->x[i] += step[i];
        }
        /* the error left is of the order of |J^+| |D2e| size^2 */
        if (size <= 1e-09 || (loose && f->bound * size * size <= 1e-16)) {
            return 1;
        }
        before = size;
    }
    return 0;
}

/* K: the largest eigenvalue of bounds of the second derivatives in the ball. For i <= j, d2p/dq_i dq_j = w_i x v_j (0 where
 * i is prismatic) is at most the distance of the tip from joint j (1 where j is prismatic): what the links beyond j reach,
 * or |v_j| at the centre plus radius times the bound of its own derivative. Rows of a spatial orientation have the skew
 * part of [w_i][w_j] E: 1/2 for i != j and 0 for i = j where E = I, and sqrt(n) radius more in the ball. */
static double cr_second_derivative(const chainrule_curve *c, const double *x, const double *jacobian, double radius)
{
    double reach[CR_LANES], unit[CR_LANES], turning[CR_LANES], bound[CR_N][CR_LANES], y[CR_LANES], image[CR_LANES];
    double ratio = 0.0, rest = 0.0;
    for (int j = 0; j < CR_LANES; ++j) {
        reach[j] = 0.0;
        unit[j] = j < CR_N ? c->unit[j] : 0.0;
        turning[j] = j < CR_N && c->kinds[j] == 'R' ? 1.0 : 0.0;
    }
    for (int j = CR_N - 1; j >= 0; --j) {
        rest += c->links[j] + (c->kinds[j] == 'R' ? 0.0 : c->unit[j] * (fabs(x[j]) + radius));
        reach[j] = c->kinds[j] == 'R' ? rest : 1.0;
    }
    if (c->whole) {
        double slope[CR_N] = { 0.0 }; /* squares */
        for (int i = 0; i < CR_N; ++i) {
            for (int j = i; j < CR_N; ++j) {
                const double change = c->kinds[i] == 'R' ? reach[j] * reach[j] : 0.0;
                slope[j] += change * c->unit[i] * c->unit[i];
                slope[i] += j > i ? change * c->unit[j] * c->unit[j] : 0.0;
            }
        }
        for (int j = 0; j < CR_N; ++j) {
            double speed = 0.0;
            for (int r = 0; r < c->positions; ++r) {
                speed += jacobian[r * CR_N + j] * jacobian[r * CR_N + j];
            }
            if (c->kinds[j] == 'R') {
                reach[j] = cr_least(reach[j], sqrt(speed) * c->size / c->unit[j] + radius * sqrt(slope[j]));
            }
        }
    }
    const double turns = sqrt((double)CR_N) * radius, over = 1.0 / c->size, spatial = c->spatial ? 1.0 : 0.0;
    for (int i = 0; i < CR_N; ++i) { /* row i from its diagonal on, the rest by symmetry */
        for (int j = 0; j < CR_LANES; ++j) {
            const double value = turning[i] * reach[j] * unit[i] * unit[j] * over;
            const double turned = spatial * turning[i] * turning[j] * (turns + (j != i ? 0.5 : 0.0));
            bound[i][j] = sqrt(value * value + turned * turned);
        }
        for (int j = 0; j < i; ++j) {
            bound[i][j] = bound[j][i];
        }
    }
    for (int i = 0; i < CR_LANES; ++i) {
        y[i] = i < CR_N ? 1.0 : 0.0;
    }
    for (int turn = 0; turn < 3; ++turn) { /* at most max (A y)_i / y_i for any y > 0 (Collatz and Wielandt) */
        for (int i = 0; i < CR_LANES; ++i) {
            image[i] = 0.0;
        }
        for (int j = 0; j < CR_N; ++j) {
            for (int i = 0; i < CR_LANES; ++i) {
                image[i] += bound[j][i] * y[j];
            }
        }
        ratio = 0.0;
        for (int i = 0; i < CR_N; ++i) {
            const double each = image[i] / y[i];
            ratio = each > ratio ? each : ratio;
        }
        const double shrunk = 1.0 / (ratio > 1e-300 ? ratio : 1e-300);
        for (int i = 0; i < CR_N; ++i) {
            const double each = image[i] * shrunk;
            y[i] = each > 1e-6 ? each : 1e-6;
        }
    }
    return ratio;
}

/* The radius of the ball in which the curve is one arc. */
static double cr_radius(const chainrule_curve *c, const cr_found *f, double last)
{
    double trial = cr_least(1.5 * last, 1.0), allowed = 0.0;
    for (int turn = 0; turn < 3; ++turn) {
        const double curving = cr_second_derivative(c, f->x, f->jacobian, trial);
        allowed = curving > 0.0 ? 0.9 / (f->bound * curving) : DBL_MAX;
        if (allowed >= 0.5 * trial || turn == 2) {
            break;
        }
        trial = cr_least(2.0 * allowed, 0.5 * trial);
    }
    return cr_least(trial, allowed);
}

static int cr_singular(const chainrule_curve *c, const cr_found *f)
{
    double squares = 0.0;
    for (int k = 0; k < CR_M * CR_N; ++k) {
        squares += f->jacobian[k] * f->jacobian[k];
    }
    return !(sqrt(squares) * f->bound * c->settings.singular < 1.0);
}

/* Whether the arcs of two nodes' balls meet: the arc of the first has one point at the distance `ahead` along its tangent,
 * in a disc of the radius c / 2r (ahead^2 + (c r / 2)^2), which has to lie in the slab of the second ball, behind its
 * centre. `*reached`: how far from a centre that is, of a ball's radius. */
static int cr_joined(const cr_node *a, const cr_node *b, double ahead, double *reached)
{
    const double half = 0.5 * 0.9 * a->radius;
    const double disc = 0.5 * 0.9 / a->radius * (ahead * ahead + half * half);
    double gap[CR_N], squares = 0.0, along = 0.0, across = 0.0, cosine = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        gap[i] = a->x[i] + ahead * a->t[i] - b->x[i];
        squares += gap[i] * gap[i];
        along += gap[i] * b->t[i];
        across += gap[i] * a->t[i];
        cosine += a->t[i] * b->t[i];
    }
    const double sideways = sqrt(cr_most(squares - across * across, 0.0));
    const double far = sqrt(squares + 2.0 * sideways * disc + disc * disc);
    const double tilt = disc * sqrt(cr_most(1.0 - cosine * cosine, 0.0));
    *reached = cr_most(sqrt(ahead * ahead + disc * disc) / a->radius, far / b->radius);
    return ahead <= 0.89 * a->radius && far <= b->radius && along + tilt < 0.0
           && along - tilt >= -0.89 * b->radius;
}

/* The Hermite polynomial through nodes at `places` (one for each) and their tangents times `scales`, at another place. */
static void cr_hermite_through(const cr_node *nodes, const double *places, const double *scales, int count, double at,
                               double *guess)
{
    double knots[2 * 4], table[2 * 4][CR_N];
    const int knotted = 2 * count;
    for (int k = 0; k < knotted; ++k) {
        knots[k] = places[k / 2];
        cr_copy(table[k], nodes[k / 2].x);
    }
    for (int order = 1; order < knotted; ++order) { /* divided differences in place, the last entries first */
        for (int k = knotted - 1; k >= order; --k) {
            if (order == 1 && k % 2 == 1) {
                for (int i = 0; i < CR_N; ++i) {
                    table[k][i] = nodes[k / 2].t[i] * scales[k / 2];
                }
            } else {
                const double over = 1.0 / (knots[k] - knots[k - order]);
                for (int i = 0; i < CR_N; ++i) {
                    table[k][i] = (table[k][i] - table[k - 1][i]) * over;
                }
            }
        }
    }
    for (int i = 0; i < CR_N; ++i) {
        guess[i] = 0.0;
    }
    for (int k = knotted - 1; k >= 0; --k) {
        for (int i = 0; i < CR_N; ++i) {
            guess[i] = table[k][i] + (at - knots[k]) * guess[i];
        }
    }
}

/* `step` beyond the last of some nodes. */
static void cr_predict(const cr_node *history, int count, double step, double *guess)
{
    double places[4], scales[4];
    for (int k = 0; k < count; ++k) {
        places[k] = history[k].s - history[count - 1].s;
        scales[k] = 1.0;
    }
    cr_hermite_through(history, places, scales, count, step, guess);
}

/* The cubic with these values and derivatives at 0 and 1. */
static double cr_hermite(double x0, double d0, double x1, double d1, double u)
{
    const double v = 1.0 - u;
    return (1.0 + 2.0 * u) * v * v * x0 + u * v * v * d0 + (1.0 + 2.0 * v) * u * u * x1 - u * u * v * d1;
}

/* The cubic through two nodes and their tangents, at the share u of the way along d. */
static void cr_between(const cr_node *a, const cr_node *b, const double *d, double u, double *guess)
{
    const double width = cr_dot(d, b->x) - cr_dot(d, a->x);
    const double first = width / cr_dot(d, a->t), last = width / cr_dot(d, b->t);
    for (int i = 0; i < CR_N; ++i) {
        guess[i] = cr_hermite(a->x[i], first * a->t[i], b->x[i], last * b->t[i], u);
    }
}

/* A map of the values at Lobatto's points. */
static double cr_sum(const double *map, const double *values)
{
    double sum = 0.0;
    for (int k = 0; k < CR_ORDER; ++k) {
        sum += map[k] * values[k];
    }
    return sum;
}

/* Lobatto's rule over nodes 0 .. end: 1 done, 0 not accurate enough, -1 no room. */
static int cr_rule(chainrule_curve *c, const cr_node *nodes, int end, int always)
{
    const cr_node *first = nodes, *last = nodes + end;
    const double chord = cr_distance(last->x, first->x);
    double d[CR_LANES], values[CR_ORDER], along[CR_ROOM], scales[CR_ROOM], guess[CR_LANES];
    cr_found f;
    if (chord == 0.0) {
        return 1;
    }
    if (c->result.points + CR_ORDER > c->room) {
        return -1;
    }
    for (int i = 0; i < CR_N; ++i) {
        d[i] = (last->x[i] - first->x[i]) / chord;
    }
    const double offset = cr_dot(d, first->x);
    for (int j = 0; j <= end; ++j) {
        const double cosine = cr_dot(d, nodes[j].t);
        along[j] = cr_dot(d, nodes[j].x) - offset;
        scales[j] = 1.0 / cosine;
        if (!always && (cosine < 0.3 || (j > 0 && along[j] <= along[j - 1]))) {
            return 0;
        }
    }
    double *rows = c->points + (c->result.points - 1) * CR_WIDTH; /* the point before, which is nodes[0] */
    for (int k = 1, j = 0; k < CR_ORDER - 1; ++k) {
        const double place = cr_lobatto_nodes[k] * chord;
        while (j < end - 1 && along[j + 1] < place) {
            ++j;
        }
        if (always) {
            cr_between(nodes + j, nodes + j + 1, d, (place - along[j]) / (along[j + 1] - along[j]), guess);
        } else {
            const int used = end + 1 < 4 ? end + 1 : 4; /* nodes around the place */
            int from = j + 1 - used / 2 > 0 ? j + 1 - used / 2 : 0;
            from = from + used > end + 1 ? end + 1 - used : from;
            cr_hermite_through(nodes + from, along + from, scales + from, used, place, guess);
        }
        if (!cr_correct(c, guess, d, offset + place, 1, &f)
            || (cr_distance(f.x, nodes[j].x) > nodes[j].radius && cr_distance(f.x, nodes[j + 1].x) > nodes[j + 1].radius)) {
            if (!always) {
                return 0;
            }
            cr_copy(f.x, guess);
        }
        cr_row(c, f.x, rows + k * CR_WIDTH);
    }
    cr_row(c, last->x, rows + (CR_ORDER - 1) * CR_WIDTH);
    for (int k = 0; k < CR_ORDER; ++k) {
        values[k] = 1.0 / cr_dot(d, rows + k * CR_WIDTH + CR_N);
    }
    double sizes[4]; /* of smooth integrands they fall as r^-k, and the rule's error as r^-(2 CR_ORDER - 2) */
    for (int k = 0; k < 4; ++k) {
        sizes[k] = fabs(cr_sum(cr_lobatto_last[k], values));
    }
    const double end_size = cr_most(sizes[2], sizes[3]), fall = end_size / cr_most(cr_most(sizes[0], sizes[1]), 1e-300);
    const double error = end_size * (fall < 1.0 ? fall * fall * fall : 1.0);
    if (error > 1e-11 && !always && chord > 1e-9) {
        c->turn = cr_most(0.7 * c->turn, 0.02);
        return 0;
    }
    const double factor = cr_least(0.9 * pow(1e-11 / cr_most(error, 1e-300), 1.0 / (2 * CR_ORDER)), 1.5);
    c->turn = cr_least(cr_most(c->turn * factor, 0.02), 0.7);
    const double before = rows[3 * CR_N];
    for (int k = 1; k < CR_ORDER; ++k) {
        rows[k * CR_WIDTH + 3 * CR_N] = before + chord * cr_sum(cr_lobatto_running[k], values);
    }
    c->result.points += CR_ORDER - 1;
    return 1;
}

/* A further certified node between two neighbours. */
static int cr_halved(chainrule_curve *c, const cr_node *a, const cr_node *b, cr_node *middle)
{
    const double chord = cr_distance(b->x, a->x);
    double d[CR_LANES], guess[CR_LANES];
    cr_found f;
    if (chord < 1e-9) {
        return 0;
    }
    for (int i = 0; i < CR_N; ++i) {
        d[i] = (b->x[i] - a->x[i]) / chord;
    }
    if (cr_dot(a->t, d) < 0.3 || cr_dot(b->t, d) < 0.3) {
        return 0;
    }
    cr_between(a, b, d, 0.5, guess);
    if (!cr_correct(c, guess, d, cr_dot(d, a->x) + 0.5 * chord, 0, &f)) {
        return 0;
    }
    cr_copy(middle->x, f.x);
    cr_copy(middle->t, f.t);
    middle->radius = cr_most(a->radius - cr_distance(f.x, a->x), b->radius - cr_distance(f.x, b->x));
    middle->s = 0.5 * (a->s + b->s);
    return 1;
}

/* Points and length over the nodes; the last of them becomes the first. 0 where there is no room. */
static int cr_measure(chainrule_curve *c, cr_node *nodes, int *count)
{
    int begin = 0;
    while (begin < *count - 1) {
        int end = *count - 1, done = cr_rule(c, nodes + begin, end - begin, 0);
        while (done == 0) {
            if (end > begin + 1) {
                end = (begin + end) / 2;
                done = cr_rule(c, nodes + begin, end - begin, 0);
                continue;
            }
            cr_node middle;
            if (*count < CR_ROOM && cr_halved(c, nodes + begin, nodes + end, &middle)) {
                memmove(nodes + end + 1, nodes + end, sizeof(cr_node) * (size_t)(*count - end));
                nodes[end] = middle;
                *count += 1;
                done = cr_rule(c, nodes + begin, end - begin, 0);
            } else { /* cannot be refined: take it as it is */
                done = cr_rule(c, nodes + begin, end - begin, 1);
            }
        }
        if (done < 0) {
            return 0;
        }
        begin = end;
    }
    nodes[0] = nodes[*count - 1];
    *count = 1;
    return 1;
}

/* The slope of joint i (of H for i = CR_N) between two points, at the share u of the length: of its cubic. */
static double cr_slope(const double *a, const double *b, int i, double u)
{
    const double width = b[3 * CR_N] - a[3 * CR_N];
    if (i < CR_N) {
        return cr_hermite(a[CR_N + i], width * a[2 * CR_N + i], b[CR_N + i], width * b[2 * CR_N + i], u);
    }
    const double rise = (b[3 * CR_N + 1] - a[3 * CR_N + 1]) / width, v = 1.0 - u;
    return (1.0 - 3.0 * u) * v * a[3 * CR_N + 2] + (1.0 - 3.0 * v) * u * b[3 * CR_N + 2] + 6.0 * u * v * rise;
}

/* All of these slopes at CR_PARTS + 1 shares: slopes[share][joint]. */
static void cr_slopes(const double *a, const double *b, double slopes[CR_PARTS + 1][CR_N + 1])
{
    const double width = b[3 * CR_N] - a[3 * CR_N];
    for (int part = 0; part <= CR_PARTS; ++part) {
        const double u = part * (1.0 / CR_PARTS), v = 1.0 - u;
        const double p = (1.0 + 2.0 * u) * v * v, q = u * v * v * width, r = (1.0 + 2.0 * v) * u * u, w = -u * u * v * width;
        for (int i = 0; i < CR_N; ++i) {
            slopes[part][i] = p * a[CR_N + i] + q * a[2 * CR_N + i] + r * b[CR_N + i] + w * b[2 * CR_N + i];
        }
        slopes[part][CR_N] = cr_slope(a, b, CR_N, u);
    }
}

/* The quintic through two points, their tangents and curvature vectors, at the share u of the length. */
static void cr_quintic(const double *a, const double *b, double u, double *guess)
{
    const double width = b[3 * CR_N] - a[3 * CR_N];
    for (int i = 0; i < CR_N; ++i) {
        const double rise = b[i] - a[i], d0 = width * a[CR_N + i], d1 = width * b[CR_N + i];
        const double c0 = width * width * a[2 * CR_N + i], c1 = width * width * b[2 * CR_N + i];
        const double third = 10.0 * rise - 6.0 * d0 - 4.0 * d1 - 1.5 * c0 + 0.5 * c1;
        const double fourth = -15.0 * rise + 8.0 * d0 + 7.0 * d1 + 1.5 * c0 - c1;
        const double fifth = 6.0 * rise - 3.0 * d0 - 3.0 * d1 - 0.5 * c0 + 0.5 * c1;
        guess[i] = a[i] + u * (d0 + u * (0.5 * c0 + u * (third + u * (fourth + u * fifth))));
    }
}

/* An extremum of joint i (of H for i = CR_N) on the curve itself, where its slope changes sign between the shares low and
 * high: by false position (Illinois), for joints by Newton's method on the slope as long as it stays between them. The
 * last step is not made but taken from the parabola. */
static int cr_extremum(chainrule_curve *c, const double *a, const double *b, int i, double low, double high, double g_low,
                       double g_high, double *s, double *value)
{
    const double width = b[3 * CR_N] - a[3 * CR_N];
    const double scale = i < CR_N ? 1.0 : fabs(a[3 * CR_N + 2]) + fabs(b[3 * CR_N + 2]);
    double u = g_high != g_low ? low - g_low * (high - low) / (g_high - g_low) : 0.5 * (low + high), row[CR_WIDTH];
    int side = 0;
    if (i < CR_N) { /* the root of the cubic */
        double left = low, right = high, f = g_low, g = g_high;
        for (int k = 0; k < 8; ++k) {
            const double at = cr_slope(a, b, i, u);
            if ((at > 0.0) == (g > 0.0)) {
                right = u;
                g = at;
                f *= 0.5;
            } else {
                left = u;
                f = at;
                g *= 0.5;
            }
            u = f != g ? left - f * (right - left) / (g - f) : 0.5 * (left + right);
        }
    }
    for (int turn = 0; turn < 12; ++turn) {
        double guess[CR_N];
        cr_found f;
        cr_quintic(a, b, u, guess);
        if (!cr_correct(c, guess, NULL, 0.0, 1, &f)) {
            return 0;
        }
        cr_row(c, f.x, row);
        const double g = i < CR_N ? row[CR_N + i] : row[3 * CR_N + 2];
        *s = a[3 * CR_N] + u * width;
        *value = i < CR_N ? row[i] : row[3 * CR_N + 1];
        if (i < CR_N && fabs(g) <= 1e-5) {
            const double bend = row[2 * CR_N + i];
            if (fabs(g) <= 1e-4 * width * fabs(bend)) {
                *s -= g / bend;
                *value -= 0.5 * g * g / bend;
                return 1;
            }
        }
        if (fabs(g) <= (i < CR_N ? 1e-9 : 1e-6 * scale) || high - low < 1e-7) {
            return 1;
        }
        if ((g > 0.0) == (g_low > 0.0)) {
            low = u;
            g_low = g;
            g_high *= side == 1 ? 0.5 : 1.0;
            side = 1;
        } else {
            high = u;
            g_high = g;
            g_low *= side == -1 ? 0.5 : 1.0;
            side = -1;
        }
        const double newton = i < CR_N ? u - g / (row[2 * CR_N + i] * width) : low;
        u = newton > low && newton < high ? newton
            : g_high != g_low ? low - g_low * (high - low) / (g_high - g_low) : 0.5 * (low + high);
    }
    return 1;
}

/* Least and greatest joint values and H, between the points too, and every extremum as a knot; 0 where there is no room. */
static int cr_extrema(chainrule_curve *c, double *box)
{
    double low[CR_N + 1], high[CR_N + 1], slopes[CR_PARTS + 1][CR_N + 1];
    for (int i = 0; i <= CR_N; ++i) {
        low[i] = INFINITY;
        high[i] = -INFINITY;
    }
    for (ptrdiff_t k = 0; k < c->result.points; ++k) {
        const double *a = c->points + k * CR_WIDTH, *b = a + CR_WIDTH;
        for (int i = 0; i <= CR_N; ++i) {
            const double value = a[i < CR_N ? i : 3 * CR_N + 1];
            low[i] = cr_least(low[i], value);
            high[i] = cr_most(high[i], value);
        }
        if (k == c->result.points - 1 || !(b[3 * CR_N] > a[3 * CR_N])) {
            continue;
        }
        cr_slopes(a, b, slopes);
        for (int i = 0; i <= CR_N; ++i) {
            double steepest = 0.0; /* what does not move has slopes of rounding, of either sign */
            for (int part = 0; part <= CR_PARTS; ++part) {
                steepest = cr_most(steepest, fabs(slopes[part][i]));
            }
            if (steepest <= 1e-12 * (i < CR_N ? 1.0 : a[3 * CR_N + 1])) {
                continue;
            }
            for (int part = 0; part < CR_PARTS; ++part) {
                const double before = slopes[part][i], after = slopes[part + 1][i], share = 1.0 / CR_PARTS;
                if ((before > 0.0) == (after > 0.0)) {
                    continue;
                }
                if (c->result.knots == c->knot_room) {
                    return 0;
                }
                double *knot = c->knots + 3 * c->result.knots;
                if (cr_extremum(c, a, b, i, share * part, share * (part + 1), before, after, knot + 1, knot + 2)) {
                    knot[0] = i;
                    low[i] = cr_least(low[i], knot[2]);
                    high[i] = cr_most(high[i], knot[2]);
                    knot[2] *= i < CR_N ? c->unit[i] : 1.0;
                    c->result.knots += 1;
                }
            }
        }
    }
    for (int i = 0; i < CR_N; ++i) {
        box[2 * i] = low[i] * c->unit[i];
        box[2 * i + 1] = high[i] * c->unit[i];
    }
    c->result.lowest = low[CR_N];
    c->result.highest = high[CR_N];
    return 1;
}

/* The start, shifted by whole turns to where it is nearest to a node; how far ahead of that along its tangent, and how far
 * away. */
static void cr_image(const chainrule_curve *c, const cr_node *origin, const cr_node *near, double *image, double *along,
                     double *distance)
{
    *along = *distance = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        const double apart = near->x[i] - origin->x[i];
        image[i] = origin->x[i] + (c->kinds[i] == 'R' ? CR_TURNS * floor(apart / CR_TURNS + 0.5) : 0.0);
        *along += near->t[i] * (image[i] - near->x[i]);
        *distance += (image[i] - near->x[i]) * (image[i] - near->x[i]);
    }
    *distance = sqrt(*distance);
}

/* The last node, which is the start, shifted by whole turns: `image`; the arc that leads to it ends in the plane through it. */
static void cr_close(chainrule_curve *c, const cr_node *origin, const cr_node *here, const double *image,
                     const cr_node *history, int remembered, cr_node *last)
{
    const double along = cr_dot(here->t, image) - cr_dot(here->t, here->x);
    double guess[CR_N];
    cr_found f;
    cr_predict(history, remembered, along, guess);
    if (cr_correct(c, guess, origin->t, cr_dot(origin->t, image), 0, &f)) {
        cr_copy(guess, f.x);
    }
    c->result.closure = 0.0;
    for (int i = 0; i < CR_N; ++i) {
        c->result.closure = cr_most(c->result.closure, fabs(guess[i] - image[i]));
    }
    *last = *origin;
    last->s = here->s + along;
    cr_copy(last->x, image);
}

/* Follow one curve from `start`; box (joints, 2). What there is to say is in curve->result. */
static void chainrule_follow(chainrule_curve *c, const double *start, double *box)
{
    cr_node nodes[CR_ROOM], history[4], origin;
    cr_found f;
    double guess[CR_LANES], ahead[CR_LANES], e[CR_LANES];
    int count = 1, remembered = 1, reason = -1;
    memset(&c->result, 0, sizeof c->result);
    memset(&origin, 0, sizeof origin);
    c->result.closure = NAN;
    c->turn = 0.4;
    for (int i = 0; i < CR_N; ++i) {
        guess[i] = start[i] / c->unit[i];
    }
    if (c->room < 1) {
        c->result.reason = CHAINRULE_ROOM;
        return;
    }
    if (!cr_correct(c, guess, NULL, 0.0, 0, &f)) {
        /* where J has lost rank on the target itself there is no tangent to begin with */
        double squares = 0.0;
        cr_held(c, guess, e, f.jacobian, f.t);
        for (int r = 0; r < CR_M; ++r) {
            squares += e[r] * e[r];
        }
        c->result.reason = squares < 1e-18 ? CHAINRULE_SINGULAR : CHAINRULE_START;
        cr_extrema(c, box);
        return;
    }
    if (cr_singular(c, &f)) {
        c->result.reason = CHAINRULE_SINGULAR;
        cr_extrema(c, box);
        return;
    }
    cr_copy(origin.x, f.x);
    cr_copy(origin.t, f.t);
    origin.radius = cr_radius(c, &f, 0.5);
    nodes[0] = history[0] = origin;
    cr_row(c, origin.x, c->points);
    c->result.points = 1;
    double step = 0.85 * origin.radius, smallest = origin.radius;
    double last_radius = origin.radius;
    while (reason < 0) {
        const cr_node *here = nodes + count - 1;
        const double *row = c->points + (c->result.points - 1) * CR_WIDTH;
        double along, distance;
        cr_image(c, &origin, here, ahead, &along, &distance);
        int closing = along > 0.0 && along <= 0.89 * here->radius && distance <= here->radius, found = 0;
        cr_node *next = nodes + count;
        if (closing) {
            cr_close(c, &origin, here, ahead, history, remembered, next);
            count += 1;
            reason = CHAINRULE_CLOSED;
            break;
        }
        if (row[3 * CR_N] + cr_distance(here->x, row) >= c->settings.longest) {
            reason = CHAINRULE_LENGTH;
            break;
        }
        if (c->result.steps >= c->settings.steps) {
            reason = CHAINRULE_STEPS;
            break;
        }
        /* one ball's length, or two where the next one is about as large */
        const double larger = here->radius < last_radius ? here->radius * here->radius / last_radius : here->radius;
        step = cr_least(cr_least(step, 0.82 * (here->radius + larger)), 0.5);
        if (remembered > 1) {
            const cr_node *one = history + remembered - 2, *two = one + 1;
            const double bend = cr_distance(one->t, two->t) / (two->s - one->s);
            step = bend > 0.0 ? cr_least(step, 0.5 / bend) : step;
        }
        double reached = 0.0;
        for (; step > 1e-3 * here->radius; step = cr_least(0.5 * step, 0.85 * here->radius)) {
            cr_predict(history, remembered, step, guess);
            if (!cr_correct(c, guess, NULL, 0.0, 0, &f)) {
                continue;
            }
            distance = cr_distance(f.x, here->x);
            along = cr_dot(here->t, f.x) - cr_dot(here->t, here->x);
            if (!(along > 0.0)) {
                continue;
            }
            cr_copy(next->x, f.x);
            cr_copy(next->t, f.t);
            next->radius = cr_radius(c, &f, here->radius);
            if (along <= 0.89 * here->radius && distance <= here->radius) {
                reached = distance / here->radius;
                found = 1;
                break;
            }
            if (cr_joined(here, next, along * here->radius / (here->radius + next->radius), &reached)) {
                double behind, apart;
                cr_image(c, &origin, next, ahead, &behind, &apart);
                closing = behind <= 0.0 && behind >= -0.89 * next->radius && apart <= next->radius
                          && cr_dot(here->t, ahead) - cr_dot(here->t, here->x) > 0.0;
                found = 1;
                break;
            }
        }
        if (!found) {
            reason = CHAINRULE_STUCK;
            break;
        }
        c->result.steps += 1;
        c->result.contraction = cr_most(c->result.contraction, 0.9 * reached);
        if (closing) { /* the start lies on the way */
            cr_close(c, &origin, here, ahead, history, remembered, next);
            count += 1;
            reason = CHAINRULE_CLOSED;
            break;
        }
        const double turned = cr_distance(f.t, here->t);
        smallest = cr_least(count == 1 ? here->radius : smallest, next->radius);
        next->s = here->s + distance * (1.0 + turned * turned / 24.0);
        last_radius = here->radius;
        count += 1;
        if (remembered == 4) {
            memmove(history, history + 1, sizeof(cr_node) * (4 - 1));
            remembered -= 1;
        }
        history[remembered] = *next;
        remembered += 1;
        step *= 2.0;
        if (cr_singular(c, &f)) {
            reason = CHAINRULE_SINGULAR;
        } else if (count >= CR_NODES || cr_distance(f.t, nodes[0].t) >= c->turn
                   || cr_distance(f.x, nodes[0].x) >= 5 * smallest) {
            if (!cr_measure(c, nodes, &count)) {
                reason = CHAINRULE_ROOM;
            }
        }
    }
    if (reason != CHAINRULE_ROOM && !cr_measure(c, nodes, &count)) {
        reason = CHAINRULE_ROOM;
    }
    c->result.reason = reason;
    c->result.length = c->points[(c->result.points - 1) * CR_WIDTH + 3 * CR_N];
    if (reason != CHAINRULE_ROOM && !cr_extrema(c, box)) {
        c->result.reason = CHAINRULE_ROOM;
    }
}

/* The curve's own numbers, of many. */
static void cr_of(chainrule_curve *c, const chainrule_curve_inputs *inputs, ptrdiff_t k)
{
    c->target = inputs->targets + k * inputs->target_step;
    c->parameters = inputs->parameters ? inputs->parameters + k * inputs->parameter_step : NULL;
    c->unit = inputs->units + k * inputs->unit_step;
    c->links = inputs->links + k * inputs->link_step;
    c->size = inputs->sizes[k * inputs->size_step];
}

/* Follow many curves, one after the other; returns how many were done before there was no room for another. */
static ptrdiff_t chainrule_follow_all(chainrule_curve *c, ptrdiff_t count, const chainrule_curve_inputs *inputs,
                                      const chainrule_curve_settings *settings, chainrule_curve_room *room, double *boxes,
                                      chainrule_curve_result *results)
{
    ptrdiff_t points = 0, knots = 0;
    c->settings = *settings;
    for (ptrdiff_t k = 0; k < count; ++k) {
        cr_of(c, inputs, k);
        c->points = room->points + points * CR_WIDTH;
        c->room = room->most_points - points;
        c->knots = room->knots + knots * 3;
        c->knot_room = room->most_knots - knots;
        chainrule_follow(c, inputs->starts + k * CR_N, boxes + k * 2 * CR_N);
        results[k] = c->result;
        if (c->result.reason == CHAINRULE_ROOM) {
            return k;
        }
        points += c->result.points;
        knots += c->result.knots;
    }
    return count;
}

/* Move configurations q[count][CR_N] near their curves onto them: `times` corrections, each the shortest one, none where
 * the Jacobian has lost rank; tangents[count][CR_N] has the null vector's direction, of x, before the last correction. */
static void chainrule_correct_all(chainrule_curve *c, ptrdiff_t count, const chainrule_curve_inputs *inputs, int times,
                                  double *q, double *tangents)
{
    memset(&c->settings, 0, sizeof c->settings);
    c->settings.direction = 1;
    for (ptrdiff_t k = 0; k < count; ++k) {
        double x[CR_N], e[CR_LANES], jacobian[CR_M * CR_N], step[CR_N], bound;
        double *tangent = tangents + k * CR_N;
        cr_of(c, inputs, k);
        for (int i = 0; i < CR_N; ++i) {
            x[i] = q[k * CR_N + i] / c->unit[i];
        }
        for (int turn = 0; turn < times; ++turn) {
            if (!cr_held(c, x, e, jacobian, tangent) || !cr_minimum_norm(jacobian, e, 0, step, &bound)) {
                break;
            }
            for (int i = 0; i < CR_N; ++i) {
                x[i] += step[i];
            }
        }
        for (int i = 0; i < CR_N; ++i) {
            q[k * CR_N + i] = x[i] * c->unit[i];
        }
    }
}

#endif /* CHAINRULE_FOLLOWS */

#endif /* CHAINRULE_CONTINUATION_H */
