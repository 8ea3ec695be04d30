#pragma once

#include "raylab/base/tiles.h"

#include <algorithm>
#include <cstddef>

namespace raylab {

/// Calls work(i) for every row of an n x n matrix, from `threads` threads (0: all cores). Each row's result must depend
/// on nothing that another row's work changes.
template <class Work>
void for_each_row(std::size_t n, int threads, const Work& work) {
    constexpr std::size_t rows_a_piece = 64;
    for_each_piece(n, rows_a_piece, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) work(i);
    });
}

/// Calls work(i, j) for every pair i < j of an n x n matrix, block by block, so that the rows and the columns of a
/// block stay in the cache.
template <class Work>
void for_each_pair(std::size_t n, const Work& work) {
    constexpr std::size_t block = 32;
    for (std::size_t first = 0; first < n; first += block)
        for (std::size_t other = first; other < n; other += block)
            for (std::size_t i = first; i < std::min(n, first + block); ++i)
                for (std::size_t j = std::max(i + 1, other); j < std::min(n, other + block); ++j) work(i, j);
}

}  // namespace raylab
