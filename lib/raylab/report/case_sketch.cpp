#include "raylab/report/case_sketch.h"

#include <cassert>

namespace raylab {

CaseSketch case_sketch(const std::string& caption, const PlaneSketch& marks, PlanePoint low, PlanePoint high) {
    return {caption, marks.drawing(low, high, 300, 220)};
}

std::vector<StabilityCase> with_sketches(std::vector<StabilityCase> cases, const CaseSketches& sketches) {
    std::size_t used = 0;
    for (auto& each : cases) {
        const auto found = sketches.find(each.name);
        if (found == sketches.end()) continue;
        each.sketch = found->second;
        ++used;
    }
    assert(used == sketches.size());
    return cases;
}

PlaneSketch floor_with_point() {
    PlaneSketch sketch;
    sketch.line({-2, 0}, {2, 0}, plane_ink::stroke(plane_ink::black, 3));
    sketch.dot({0, 0}, 5);
    return sketch;
}

}  // namespace raylab
