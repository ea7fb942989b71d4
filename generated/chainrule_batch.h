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

/* Four configurations times four entries at a time, where the compiler knows vectors; else one by one. */
#if !defined(CR_HAS_QUADS) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define CR_HAS_QUADS 1
#endif
#endif
#ifndef CR_HAS_QUADS
#define CR_HAS_QUADS 0
#endif

#if CR_HAS_QUADS
typedef real chainrule_quad __attribute__((vector_size(4 * sizeof(real)), aligned(sizeof(real)), may_alias));

/* Entry c of row r of the 4 x 4 numbers at `from` becomes entry r of row c at `to`; the rows are so many bytes apart. */
CR_INLINE void chainrule_transpose(const char *from, ptrdiff_t from_step, char *to, ptrdiff_t to_step)
{
    const chainrule_quad a = *(const chainrule_quad *)(const void *)from;
    const chainrule_quad b = *(const chainrule_quad *)(const void *)(from + from_step);
    const chainrule_quad c = *(const chainrule_quad *)(const void *)(from + 2 * from_step);
    const chainrule_quad d = *(const chainrule_quad *)(const void *)(from + 3 * from_step);
    const chainrule_quad ab = __builtin_shufflevector(a, b, 0, 4, 2, 6), ba = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const chainrule_quad cd = __builtin_shufflevector(c, d, 0, 4, 2, 6), dc = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    *(chainrule_quad *)(void *)to = __builtin_shufflevector(ab, cd, 0, 1, 4, 5);
    *(chainrule_quad *)(void *)(to + to_step) = __builtin_shufflevector(ba, dc, 0, 1, 4, 5);
    *(chainrule_quad *)(void *)(to + 2 * to_step) = __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
    *(chainrule_quad *)(void *)(to + 3 * to_step) = __builtin_shufflevector(ba, dc, 2, 3, 6, 7);
}
#endif

/* `size` >= 4 entries of each of `count` configurations, side by side in memory, into the tile or out of it; returns how
 * many configurations that was. The last four entries of a row may overlap the four before. */
CR_INLINE int chainrule_quads(real *tile, int width, int count, char *rows, ptrdiff_t outer, int size, int out)
{
#if CR_HAS_QUADS
    const ptrdiff_t entry = (ptrdiff_t)sizeof(real), lane = width * entry;
    const int whole = count & ~3;
    for (int i = 0; i < whole; i += 4) {
        for (int k = 0; k < size; k += 4) {
            const int at = k + 4 <= size ? k : size - 4;
            char *inside = (char *)(tile + at * width + i), *outside = rows + i * outer + at * entry;
            if (out) {
                chainrule_transpose(inside, lane, outside, outer);
            } else {
                chainrule_transpose(outside, outer, inside, lane);
            }
        }
    }
    return whole;
#else
    (void)tile, (void)width, (void)count, (void)rows, (void)outer, (void)size, (void)out;
    return 0;
#endif
}

/* Rows that lie close to each other, on their way into the cache while a tile is computed: to be read (0) or written (1).
 * An address may lie beyond the end: that asks for nothing. */
#if defined(__GNUC__)
#define chainrule_fetch(rows, outer, size, count, writing)                                           \
    do {                                                                                             \
        if ((outer) <= 2 * (size) * (ptrdiff_t)sizeof(real)) {                                       \
            for (ptrdiff_t byte = 0; byte < (outer) * (count); byte += 64) {                         \
                __builtin_prefetch((const void *)((uintptr_t)(rows) + (uintptr_t)byte), (writing)); \
            }                                                                                        \
        }                                                                                            \
    } while (0)
#else
#define chainrule_fetch(rows, outer, size, count, writing) ((void)0)
#endif

/* rows x cols entries of each of `count` configurations into the tile; strides in bytes. Unused lanes repeat the
 * first configuration, so that they cost nothing unusual. */
CR_INLINE void chainrule_gather(real *restrict tile, int width, int count, const char *from, ptrdiff_t outer, int rows,
                                int cols, ptrdiff_t row_step, ptrdiff_t col_step)
{
    int done = 0;
    if (rows * cols >= 4 && col_step == (ptrdiff_t)sizeof(real) && row_step == cols * (ptrdiff_t)sizeof(real)) {
        done = chainrule_quads(tile, width, count, (char *)(uintptr_t)from, outer, rows * cols, 0);
    }
    for (int i = done; i < count; ++i) {
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

/* Whether any of a tile's numbers is not 0: decides whether terms that matter only there are computed. */
CR_INLINE int chainrule_any(const real *restrict tile, int width)
{
    int found = 0;
    for (int i = 0; i < width; ++i) {
        found |= tile[i] != CR_C(0.0);
    }
    return found;
}

CR_INLINE void chainrule_clear(real *restrict tile, int width)
{
    for (int i = 0; i < width; ++i) {
        tile[i] = CR_C(0.0);
    }
}

/* One configuration's entries, from the tile's lane i. Four loads before four stores: faster, as they cannot overlap. */
CR_INLINE void chainrule_row(const real *restrict tile, int width, int i, real *restrict entry, int size)
{
    int k = 0;
    for (; k + 4 <= size; k += 4) {
        const real a = tile[k * width + i], b = tile[(k + 1) * width + i];
        const real c = tile[(k + 2) * width + i], d = tile[(k + 3) * width + i];
        entry[k] = a;
        entry[k + 1] = b;
        entry[k + 2] = c;
        entry[k + 3] = d;
    }
    for (; k < size; ++k) {
        entry[k] = tile[k * width + i];
    }
}

/* Results too many for any cache are written past the caches: nothing is read in only to be overwritten. */
#if defined(__SSE2__)
#include <emmintrin.h>
#include <string.h>
#define CR_STREAM_BYTES ((ptrdiff_t)32 << 20)
#define CR_STREAM_ROWS 16
#define CR_STREAM_LEAST 12
#define CR_STREAM_MOST 64

CR_INLINE int chainrule_streams(ptrdiff_t count, int size)
{
    return count * size * (ptrdiff_t)sizeof(real) >= CR_STREAM_BYTES;
}

/* Whether an array of these rows is written so: long rows, side by side. */
CR_INLINE int chainrule_past(int streaming, int size, ptrdiff_t outer)
{
    return streaming && size >= CR_STREAM_LEAST && size <= CR_STREAM_MOST && outer == size * (ptrdiff_t)sizeof(real);
}

CR_INLINE void chainrule_stream(char *to, const char *from, ptrdiff_t bytes)
{
    ptrdiff_t head = (ptrdiff_t)(-(uintptr_t)to & 63u); /* whole lines only; the ends as usual */
    head = head < bytes ? head : bytes;
    memcpy(to, from, (size_t)head);
    ptrdiff_t k = head;
    for (; k + 64 <= bytes; k += 64) {
        for (int part = 0; part < 64; part += 16) {
            _mm_stream_si128((__m128i *)(void *)(to + k + part), _mm_loadu_si128((const __m128i *)(const void *)(from + k + part)));
        }
    }
    memcpy(to + k, from + k, (size_t)(bytes - k));
}

/* After the last tile: what was streamed is visible before what follows. */
CR_INLINE void chainrule_settle(int streamed)
{
    if (streamed) {
        _mm_sfence();
    }
}
#else
CR_INLINE int chainrule_streams(ptrdiff_t count, int size)
{
    (void)count;
    (void)size;
    return 0;
}

CR_INLINE int chainrule_past(int streaming, int size, ptrdiff_t outer)
{
    (void)streaming;
    (void)size;
    (void)outer;
    return 0;
}

CR_INLINE void chainrule_settle(int streamed)
{
    (void)streamed;
}
#endif

/* The tile's entries out to `count` configurations. */
CR_INLINE void chainrule_scatter(real *restrict tile, int width, int count, char *to, ptrdiff_t outer, int rows,
                                 int cols, ptrdiff_t row_step, ptrdiff_t col_step, int streaming)
{
    const int size = rows * cols;
    if (col_step == (ptrdiff_t)sizeof(real) && row_step == cols * (ptrdiff_t)sizeof(real)) {
#if defined(__SSE2__)
        if (chainrule_past(streaming, size, outer)) {
            real staged[CR_STREAM_ROWS * CR_STREAM_MOST];
            for (int i = 0; i < count; i += CR_STREAM_ROWS) {
                const int rest = count - i < CR_STREAM_ROWS ? count - i : CR_STREAM_ROWS;
                for (int j = chainrule_quads(tile + i, width, rest, (char *)staged, outer, size, 1); j < rest; ++j) {
                    chainrule_row(tile, width, i + j, staged + j * size, size);
                }
                chainrule_stream(to + i * outer, (const char *)staged, rest * outer);
            }
            return;
        }
#endif
        (void)streaming;
        for (int i = size >= 4 ? chainrule_quads(tile, width, count, to, outer, size, 1) : 0; i < count; ++i) {
            chainrule_row(tile, width, i, (real *)(void *)(to + i * outer), size);
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
