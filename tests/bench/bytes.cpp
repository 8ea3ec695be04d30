#include "meshes.h"

#include "catch.h"
#include "raylab/accelerator/accelerator.h"

#include <malloc.h>

// Compares the memory that a structure reports with the heap's.

using namespace raylab;

namespace {

double heap_bytes() {
    const auto heap = mallinfo2();
    return static_cast<double>(heap.uordblks + heap.hblkhd);
}

}  // namespace

TEST_CASE("every structure tells the bytes that it holds") {
    const Scene scene = bench::scene_of_mesh("bumpy_4");
    for (const std::string& name : accelerator_names()) {
        make_accelerator(name, scene);  // malloc keeps small freed pieces, and counts them as allocated
        const double before = heap_bytes();
        const auto structure = make_accelerator(name, scene);
        const double held = heap_bytes() - before;
        const auto told = static_cast<double>(structure->bytes());
        INFO(name << " tells " << told << " bytes and holds " << held);
        CHECK(told >= 0.95 * held);  // malloc's own headers belong to no structure
        CHECK(told <= 1.05 * held);
    }
}
