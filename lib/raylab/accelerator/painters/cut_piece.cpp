#include "raylab/accelerator/painters/cut_piece.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace raylab {

namespace {

using Piece = PaintersTree::Piece;

// A plane in doubles. Heights above it are distances times |normal|, and err by less than error(point).
class RoundedPlane {
public:
    explicit RoundedPlane(const Triangle& t)
        : a_(convert<double>(t.a)),
          b_(convert<double>(t.b) - a_),
          c_(convert<double>(t.c) - a_),
          normal_(cross(b_, c_)) {
        const auto minor = [&](int i, int j) { return std::abs(b_[i] * c_[j]) + std::abs(b_[j] * c_[i]); };
        sizes_ = {minor(1, 2), minor(2, 0), minor(0, 1)};
    }

    double height(const Vec3d& p) const { return dot(normal_, p - a_); }

    // Each of the three terms is the result of at most nine rounded operations.
    double error(const Vec3d& p) const { return 16 * unit_roundoff<double> * dot(sizes_, glm::abs(p - a_)); }

    // By how much the height of a point may change when the point moves by `off`.
    double rise(double off) const { return (sizes_.x + sizes_.y + sizes_.z) * off; }

private:
    Vec3d a_, b_, c_, normal_, sizes_;
};

struct Heights {
    std::vector<double> of;  // of each corner
    double slack = 0;        // how far each may be wrong
    Reach reach = {};
};

Heights heights(const Piece& piece, const RoundedPlane& plane) {
    Heights result;
    for (const Vec3d& corner : piece.corners) result.slack = std::max(result.slack, plane.error(corner));
    result.slack = 2 * result.slack + plane.rise(piece.off);
    for (const Vec3d& corner : piece.corners) {
        const double height = plane.height(corner);
        result.of.push_back(height);
        result.reach.behind |= height < -result.slack;
        result.reach.before |= height > result.slack;
    }
    return result;
}

// The part on one side. Its corners are wrong by no more than 12 u times the largest coordinate. It is cut `slack`
// beyond the plane, so that the exact cut of each edge belongs to the part that is kept.
Piece part(const Piece& piece, const Heights& heights, std::uint32_t plane, Sign side) {
    const double direction = side == Sign::positive ? 1 : -1;
    Piece result{piece.triangle, piece.cuts, {}, piece.off, piece.rounded};
    result.cuts.push_back({plane, side});
    double largest = 0;
    for (std::size_t i = 0; i < piece.corners.size(); ++i) {
        const std::size_t j = (i + 1) % piece.corners.size();
        const double here = direction * heights.of[i] + heights.slack, next = direction * heights.of[j] + heights.slack;
        const Vec3d &p = piece.corners[i], &q = piece.corners[j];
        if (here >= 0) result.corners.push_back(p);
        if ((here > 0 && next < 0) || (here < 0 && next > 0))
            result.corners.push_back(p + (q - p) * (here / (here - next)));
        largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
    }
    result.off += 32 * unit_roundoff<double> * largest;
    return result;
}

Piece but_for_rounding(Piece piece) {
    piece.rounded = true;
    return piece;
}

}  // namespace

Piece whole_piece(const Triangle& t, std::uint32_t number) {
    return {number, {}, {convert<double>(t.a), convert<double>(t.b), convert<double>(t.c)}};
}

Reach reach(const Piece& piece, const Triangle& plane) { return heights(piece, RoundedPlane(plane)).reach; }

Halves divided(const Piece& piece, const Triangle& triangle, const Triangle& plane, std::uint32_t number) {
    std::array<Sign, 3> signs;  // of the triangle's own corners, which are floats, so the signs are exact
    DecisionCounts decisions;
    std::ranges::transform(std::array{triangle.a, triangle.b, triangle.c}, signs.begin(),
                           [&](const Vec3f& corner) { return side(plane, corner, decisions); });
    const auto has = [&](Sign sign) { return std::ranges::count(signs, sign) > 0; };
    if (!has(Sign::negative) && !has(Sign::positive)) return {.inside = piece};
    if (!has(Sign::negative)) return {.before = piece};
    if (!has(Sign::positive)) return {.behind = piece};

    const Heights found = heights(piece, RoundedPlane(plane));
    if (found.reach.behind && found.reach.before)
        return {.behind = part(piece, found, number, Sign::negative),
                .before = part(piece, found, number, Sign::positive)};
    // The plane cuts the triangle, but not this piece of it, or only within what may be rounding error.
    const bool sure = std::ranges::all_of(found.of, [&](double height) { return std::abs(height) > found.slack; });
    const Piece whole = sure ? piece : but_for_rounding(piece);
    return found.reach.behind ? Halves{.behind = whole} : Halves{.before = whole};
}

}  // namespace raylab
