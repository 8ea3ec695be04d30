#include "raylab/experiment/generate/circle.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace raylab {

std::vector<Angle> circle(int levels) {
    std::vector<Angle> points{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    for (int level = 2; level < levels; ++level) {
        std::vector<Angle> finer;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto [c, s] = points[i];
            const auto [next_c, next_s] = points[(i + 1) % points.size()];
            const double x = c + next_c, y = s + next_s, length = std::sqrt(x * x + y * y);
            finer.push_back(points[i]);
            finer.push_back({x / length, y / length});
        }
        points = std::move(finer);
    }
    return points;
}

}  // namespace raylab
