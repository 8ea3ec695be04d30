// hint: weights
// The edge that lies opposite the second corner is taken for the third one's, and the other way round.
#include "raylab/accelerator/item_buffer/drawn_depth.h"

std::optional<double> raylab::drawn_depth(const std::array<DrawnCorner, 3>& corners, double x, double y) {
    const auto& [p, q, r] = corners;
    const auto side = [&](const DrawnCorner& from, const DrawnCorner& to) {
        return (to.x - from.x) * (y - from.y) - (to.y - from.y) * (x - from.x);
    };
    const double of_p = side(q, r), of_q = side(p, q), of_r = side(r, p);
    const double sum = of_p + of_q + of_r;
    if (sum == 0) return std::nullopt;
    for (const double weight : {of_p, of_q, of_r})
        if (weight / sum < 0) return std::nullopt;
    return sum / (of_p / p.depth + of_q / q.depth + of_r / r.depth);
}
