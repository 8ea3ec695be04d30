#include "raylab/base/heap.h"

#include "raylab/base/large_pages.h"

#include <malloc.h>
#include <sys/mman.h>

#include <cstdint>
#include <cstdlib>

namespace raylab {

namespace {

constexpr std::size_t heap_size = std::size_t{1} << 26;  // of a thread's, in glibc

}  // namespace

void keep_freed_memory() {
    mallopt(M_MMAP_THRESHOLD, heap_size / 2);  // more is not taken
    mallopt(M_TRIM_THRESHOLD, 2 * heap_size);
    mallopt(M_TOP_PAD, heap_size);  // by how much more than was asked a heap grows
    put_heap_on_large_pages();
}

void put_heap_on_large_pages() {
    // Two blocks that are kept, and take no memory because they are not written. The first is more than is left of what
    // the heap began with: it grows, and goes on behind it. What is allocated after the second lies beyond the first
    // border of large pages. (Volatile, or the compiler sees that nothing is done with them, and leaves them out.)
    constexpr std::size_t growth = std::size_t{1} << 18;
    [[maybe_unused]] static thread_local void* volatile before_border = nullptr;
    [[maybe_unused]] static thread_local void* volatile across_border = nullptr;
    before_border = std::malloc(growth);
    if (!before_border) return;
    const auto end = reinterpret_cast<std::uintptr_t>(before_border) + growth;
    const auto border = (end + large_page - 1) / large_page * large_page;
    madvise(reinterpret_cast<void*>(border), heap_size - 2 * large_page, MADV_HUGEPAGE);  // only a hint
    across_border = std::malloc(large_page);
}

}  // namespace raylab
