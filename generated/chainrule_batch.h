/* chainrule_batch.h: how configurations reach a kernel's tile and how results leave it. C99, no allocation.
 *
 * A tile keeps `width` configurations, entry by entry: entry k of configuration i is tile[k * width + i]. */
#ifndef CHAINRULE_BATCH_H
#define CHAINRULE_BATCH_H

#include <stddef.h>

#include "chainrule_real.h"

/* How many configurations the next tile takes: a whole tile, what is left of the batch, or one where little is left. */
CR_INLINE int chainrule_take(ptrdiff_t left, int width)
{
    return left >= width ? width : left >= 8 ? (int)left : 1;
}

/* rows x cols entries of each of `count` configurations into the tile; strides in bytes. Unused lanes repeat the
 * first configuration, so that they cost nothing unusual. */
CR_INLINE void chainrule_gather(real *restrict tile, int width, int count, const char *from, ptrdiff_t outer, int rows,
                                int cols, ptrdiff_t row_step, ptrdiff_t col_step)
{
    for (int i = 0; i < count; ++i) {
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < cols; ++c) {
                tile[(r * cols + c) * width + i] = *(const real *)(const void *)(from + i * outer + r * row_step + c * col_step);
            }
        }
    }
    for (int k = 0; k < rows * cols; ++k) {
        for (int i = count; i < width; ++i) {
            tile[k * width + i] = tile[k * width];
        }
    }
}

/* The tile's entries out to `count` configurations. */
CR_INLINE void chainrule_scatter(const real *restrict tile, int width, int count, char *to, ptrdiff_t outer, int rows,
                                 int cols, ptrdiff_t row_step, ptrdiff_t col_step)
{
    if (col_step == (ptrdiff_t)sizeof(real) && row_step == cols * (ptrdiff_t)sizeof(real)) {
        for (int i = 0; i < count; ++i) {
            real *entry = (real *)(void *)(to + i * outer);
            int k = 0;
            for (; k + 4 <= rows * cols; k += 4) { /* four loads before four stores: faster, as they cannot overlap */
                const real a = tile[k * width + i], b = tile[(k + 1) * width + i];
                const real c = tile[(k + 2) * width + i], d = tile[(k + 3) * width + i];
                entry[k] = a;
                entry[k + 1] = b;
                entry[k + 2] = c;
                entry[k + 3] = d;
            }
            for (; k < rows * cols; ++k) {
                entry[k] = tile[k * width + i];
            }
        }
        return;
    }
    for (int i = 0; i < count; ++i) {
        for (int r = 0; r < rows; ++r) {
            for (int c = 0; c < cols; ++c) {
                *(real *)(void *)(to + i * outer + r * row_step + c * col_step) = tile[(r * cols + c) * width + i];
            }
        }
    }
}

#endif /* CHAINRULE_BATCH_H */
