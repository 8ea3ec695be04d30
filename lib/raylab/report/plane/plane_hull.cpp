#include "raylab/report/plane/plane_hull.h"

#include <algorithm>

namespace raylab {

namespace {

double turn(PlanePoint a, PlanePoint b, PlanePoint c) { return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x); }

}  // namespace

std::vector<PlanePoint> convex_hull(std::vector<PlanePoint> points) {
    std::ranges::sort(points, [](PlanePoint a, PlanePoint b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    const auto same = [](PlanePoint a, PlanePoint b) { return a.x == b.x && a.y == b.y; };
    points.erase(std::unique(points.begin(), points.end(), same), points.end());
    if (points.size() < 3) return points;
    std::vector<PlanePoint> chain;
    const auto walk = [&](auto begin, auto end) {
        const std::size_t first = chain.size();
        for (auto p = begin; p != end; ++p) {
            while (chain.size() >= first + 2 && turn(chain[chain.size() - 2], chain.back(), *p) <= 0) chain.pop_back();
            chain.push_back(*p);
        }
        chain.pop_back();  // it is the first point of the other chain
    };
    walk(points.begin(), points.end());
    walk(points.rbegin(), points.rend());
    return chain;
}

}  // namespace raylab
