#include "raylab/base/large_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>

namespace raylab {

namespace {

// The size on x86-64 and most others; elsewhere there is no gain.
constexpr std::size_t large_page = std::size_t{1} << 21;

}  // namespace

void* allocate_on_large_pages(std::size_t bytes, std::size_t alignment) {
    const bool large = bytes >= large_page;
    void* memory = nullptr;
    if (posix_memalign(&memory, large ? large_page : std::max(alignment, sizeof(void*)), bytes) != 0)
        throw std::bad_alloc();
    if (large)
        // Only a hint; the last, incomplete page stays small.
        madvise(memory, bytes / large_page * large_page, MADV_HUGEPAGE);
    return memory;
}

void free_from_large_pages(void* memory) { std::free(memory); }

}  // namespace raylab
