// The same methods from the same headers, compiled as most programs are: with fused multiply-add and contraction. It is
// not linked with the library, whose own copies of these templates are compiled without them. Rays are read from
// standard input; leaks and double hits are written to standard output, one line for each method.
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
    std::size_t leaks = 0, doubles = 0;
    for (std::size_t i = 0; i + 1 < shots.first.size(); ++i) {
        const RayOf<float> ray{shots.origins[i], shots.directions[i], {0, std::numeric_limits<float>::infinity()}};
        int hits = 0;
        for (auto j = shots.first[i]; j < shots.first[i + 1]; ++j)
            hits += intersect(ray, shots.triangles[shots.asked[j]]).has_value();
        leaks += hits == 0;
        doubles += hits > 1;
    }
    std::printf("%s,%zu,%zu\n", name, leaks, doubles);
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
