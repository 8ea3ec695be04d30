#include "raylab/base/large_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace raylab {

namespace {

void* address(std::uintptr_t at) { return reinterpret_cast<void*>(at); }

}  // namespace

// It aligns what malloc returns, and keeps that before it. (What posix_memalign has returned and is freed is too small
// for the next block of the same size and alignment up to glibc 2.37, so that the heap grows with every tree that is
// built: its bug 14581.)
void* allocate_on_large_pages(std::size_t bytes, std::size_t alignment) {
    // As many large pages as are at least half used. The rest lies on small ones, each of which has to be asked for by
    // a fault.
    const std::size_t large = (bytes + large_page / 2) / large_page * large_page, size = std::max(bytes, large);
    const std::size_t border = large > 0 ? large_page : std::max(alignment, alignof(std::max_align_t));
    if (size + border < size) throw std::bad_alloc();
    void* const all = std::malloc(size + border);
    if (!all) throw std::bad_alloc();
    const auto begin = (reinterpret_cast<std::uintptr_t>(all) / border + 1) * border;
    std::memcpy(address(begin - sizeof all), &all, sizeof all);
    if (large > 0) madvise(address(begin), large, MADV_HUGEPAGE);  // only a hint
    return address(begin);
}

void free_from_large_pages(void* memory) {
    if (!memory) return;
    void* all = nullptr;
    std::memcpy(&all, static_cast<std::byte*>(memory) - sizeof all, sizeof all);
    std::free(all);
}

}  // namespace raylab
