#include "meshes.h"

#include "catch.h"
#include "raylab/accelerator/accelerator.h"

#include <malloc.h>

// What a structure says of its memory, against what the heap says.

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
        make_accelerator(name, scene);  // malloc keeps small pieces that are given back, and counts them as held
        const double before = heap_bytes();
        const auto structure = make_accelerator(name, scene);
        const double held = heap_bytes() - before;
        const auto told = static_cast<double>(structure->bytes());
        INFO(name << " tells " << told << " bytes and holds " << held);
        CHECK(told >= 0.95 * held);  // malloc's own headers are no one's
        CHECK(told <= 1.05 * held);
    }
}
