// The same methods from the same headers, compiled as most programs are: with fused multiply-add and contraction. It is
// not linked with the library, whose own copies of these templates are compiled without them. Rays are read from
// standard input; leaks, double hits and the number of the first ray that leaks (of rays: none does) are written to
// standard output, one line for each method.
#include "shot_file.h"

#include "raylab/experiment/ray_triangle/moeller_trumbore.h"
#include "raylab/experiment/ray_triangle/pluecker.h"
#include "raylab/experiment/ray_triangle/watertight.h"

#include <cstdio>
#include <iostream>
#include <iterator>

namespace {

using namespace raylab;

template <class Intersect>
void report(const char* name, const ShotFile& shots, Intersect intersect) {
    const std::size_t rays = shots.first.size() - 1;
    std::size_t leaks = 0, doubles = 0, first = rays;
    for (std::size_t i = 0; i < rays; ++i) {
        const RayOf<float> ray{shots.origins[i], shots.directions[i], {0, std::numeric_limits<float>::infinity()}};
        int hits = 0;
        for (auto j = shots.first[i]; j < shots.first[i + 1]; ++j)
            hits += intersect(ray, shots.triangles[shots.asked[j]]).has_value();
        if (hits == 0 && leaks++ == 0) first = i;
        doubles += hits > 1;
    }
    std::printf("%s,%zu,%zu,%zu\n", name, leaks, doubles, first);
}

}  // namespace

int main() {
    const std::string bytes(std::istreambuf_iterator<char>(std::cin), {});
    const ShotFile shots = from_bytes(bytes);
    report("Moeller-Trumbore, float", shots,
           [](const auto& ray, const auto& triangle) { return moeller_trumbore(ray, triangle); });
    report("Pluecker, float", shots, [](const auto& ray, const auto& triangle) { return pluecker(ray, triangle); });
    report("watertight, float", shots, [](const auto& ray, const auto& triangle) { return watertight(ray, triangle); });
}
