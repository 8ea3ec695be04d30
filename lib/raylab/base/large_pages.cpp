#include "raylab/base/large_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>

namespace raylab {

namespace {

constexpr std::size_t large_page = std::size_t{1} << 21;  // of x86-64 and of most others; elsewhere nothing is gained

}  // namespace

void* allocate_on_large_pages(std::size_t bytes, std::size_t alignment) {
    const bool large = bytes >= large_page;
    void* memory = nullptr;
    if (posix_memalign(&memory, large ? large_page : std::max(alignment, sizeof(void*)), bytes) != 0)
        throw std::bad_alloc();
    if (large)
        madvise(memory, bytes / large_page * large_page, MADV_HUGEPAGE);  // a wish; the last, broken page stays small
    return memory;
}

void free_from_large_pages(void* memory) { std::free(memory); }

}  // namespace raylab
