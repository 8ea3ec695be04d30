#include "raylab/base/large_pages.h"

#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>

namespace raylab {

void* allocate_on_large_pages(std::size_t bytes, std::size_t alignment) {
    // As many as are at least half used. The rest lies on small pages, each of which has to be asked for by a fault.
    const std::size_t large = (bytes + large_page / 2) / large_page * large_page;
    void* memory = nullptr;
    if (posix_memalign(&memory, large > 0 ? large_page : std::max(alignment, sizeof(void*)), std::max(bytes, large)) !=
        0)
        throw std::bad_alloc();
    if (large > 0) madvise(memory, large, MADV_HUGEPAGE);  // only a hint
    return memory;
}

void free_from_large_pages(void* memory) { std::free(memory); }

}  // namespace raylab
