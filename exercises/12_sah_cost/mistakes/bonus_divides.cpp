// hint: bonus_saves
// Divides by 1 + bonus.
#include "raylab/accelerator/split_tree/sah_cost.h"

#include <limits>

double raylab::sah_cost(const SahCut& cut) {
    const Vec3d& s = cut.size;
    if (s.x * s.y + s.y * s.z + s.z * s.x == 0) return std::numeric_limits<double>::infinity();
    const int a = cut.axis, b = (a + 1) % 3, c = (a + 2) % 3;
    const double end = s[b] * s[c], around = s[b] + s[c], all = end + around * s[a];
    double tests = (end + around * cut.place) / all * cut.below + (end + around * (s[a] - cut.place)) / all * cut.above;
    if (cut.below == 0 || cut.above == 0) tests /= 1 + cut.empty_bonus;
    return cut.visit_cost + cut.test_cost * tests;
}
