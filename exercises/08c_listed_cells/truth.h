#pragma once

#include "arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>

// The truth without any cutting. What is farthest left of all that is seen through a face is a corner of the polygon,
// or a point where one of its edges crosses a side of the face's pyramid, or one where the polygon covers a corner of
// the face. All such points are tried, in long double.

namespace raylab::grading::listing {

/// A point in the face's coordinates.
struct Seen {
    long double u, v, w;
};

inline Seen seen_by(const Vec3d& p, int face) {
    const int axis = face / 2;
    const long double w = p[axis];
    return {p[(axis + 1) % 3], p[(axis + 2) % 3], face % 2 == 0 ? w : -w};
}

inline Seen between(const Seen& a, const Seen& b, long double share) {
    return {a.u + share * (b.u - a.u), a.v + share * (b.v - a.v), a.w + share * (b.w - a.w)};
}
inline Seen crossed(const Seen& a, const Seen& b) {
    return {a.v * b.w - a.w * b.v, a.w * b.u - a.u * b.w, a.u * b.v - a.v * b.u};
}
inline long double dotted(const Seen& a, const Seen& b) { return a.u * b.u + a.v * b.v + a.w * b.w; }

/// The part of the face, from -1 to 1 both ways, through which something is seen.
struct Window {
    long double left = std::numeric_limits<long double>::infinity(), right = -left, low = left, high = -left;

    bool is_empty() const { return left > right; }
};

/// Takes in what is seen through a face that is `wide` times as wide as it is.
class Looking {
public:
    Looking(const Arguments& given, long double wide) : wide_(wide) {
        for (const Vec3d& corner : given.corners) corners_.push_back(seen_by(corner, given.face));
        for (std::size_t i = 0; i < corners_.size(); ++i) along(corners_[i], corners_[(i + 1) % corners_.size()]);
        for (const long double u : {-wide, wide})
            for (const long double v : {-wide, wide}) through({u, v, 1});
    }

    const Window& window() const { return window_; }

    /// Where the ray in this direction meets the polygon.
    std::optional<Seen> met(const Seen& way) const {
        const Seen &a = corners_[0], &b = corners_[1], &c = corners_[2];
        const Seen n = crossed({b.u - a.u, b.v - a.v, b.w - a.w}, {c.u - a.u, c.v - a.v, c.w - a.w});
        const long double depth = dotted(n, a) / dotted(n, way);
        if (!(depth > 0 && std::isfinite(depth))) return std::nullopt;
        const Seen p{depth * way.u, depth * way.v, depth * way.w};
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Seen &from = corners_[i], &to = corners_[(i + 1) % corners_.size()];
            const Seen edge{to.u - from.u, to.v - from.v, to.w - from.w}, off{p.u - from.u, p.v - from.v, p.w - from.w};
            if (dotted(crossed(edge, off), n) < 0) return std::nullopt;
        }
        return p;
    }

private:
    // Whether it lies in the pyramid; the sides across one axis are not asked where it was put on one of them.
    bool is_inside(const Seen& p, int on = 0) const {
        const auto holds = [&](long double x, int axis) { return on == axis || std::abs(x) <= wide_ * p.w; };
        return p.w > 0 && holds(p.u, 1) && holds(p.v, 2);
    }

    void take(const Seen& p) {
        const long double u = p.u / p.w, v = p.v / p.w;
        window_ = {std::min(window_.left, u), std::max(window_.right, u), std::min(window_.low, v),
                   std::max(window_.high, v)};
    }

    void along(const Seen& a, const Seen& b) {
        if (is_inside(a)) take(a);
        for (const int axis : {1, 2})
            for (const long double side : {-wide_, wide_}) {
                const auto above = [&](const Seen& p) { return (axis == 1 ? p.u : p.v) - side * p.w; };
                const long double from = above(a), to = above(b);
                if ((from < 0) == (to < 0)) continue;
                const Seen p = between(a, b, from / (from - to));
                if (is_inside(p, axis)) take(p);
            }
    }

    void through(const Seen& way) {
        if (const auto p = met(way)) take(*p);
    }

    long double wide_;
    std::vector<Seen> corners_;
    Window window_;
};

inline Window window(const Arguments& given, long double wide = 1) { return Looking(given, wide).window(); }

/// Whether the polygon is seen at this place of the face.
inline bool is_seen_at(const Arguments& given, long double u, long double v) {
    return Looking(given, 1).met({u, v, 1}).has_value();
}

/// Where a place from -1 to 1 lies among the cells: from 0 to the resolution.
inline long double among_cells(long double place, int resolution) { return (place + 1) / 2 * resolution; }

/// The cells of a face that is cut into `resolution`, of which `cells` there are.
inline std::optional<CellRectangle> cells_of(const Window& window, int resolution, int cells) {
    if (window.is_empty()) return std::nullopt;
    const auto cell = [&](long double number) {
        return static_cast<int>(std::clamp(number, 0.0L, static_cast<long double>(cells - 1)));
    };
    const auto first = [&](long double place) { return cell(std::ceil(among_cells(place, resolution)) - 1); };
    const auto last = [&](long double place) { return cell(std::floor(among_cells(place, resolution))); };
    return CellRectangle{first(window.left), last(window.right), first(window.low), last(window.high)};
}

inline std::optional<CellRectangle> cells_of(const Window& window, int resolution) {
    return cells_of(window, resolution, resolution);
}

inline std::optional<CellRectangle> truth(const Arguments& given) { return cells_of(window(given), given.resolution); }

/// Whether any correct method must find these cells and no others: no end of the window is near a border within the
/// face, and a face that is a millionth wider or narrower shows the same cells.
inline bool keeps_margin(const Arguments& given) {
    const Window seen = window(given);
    const auto is_apart = [&](long double place) {
        const long double at = among_cells(place, given.resolution), border = std::round(at);
        return border <= 0 || border >= given.resolution || std::abs(at - border) > 1e-5L;
    };
    if (!seen.is_empty() && !(is_apart(seen.left) && is_apart(seen.right) && is_apart(seen.low) && is_apart(seen.high)))
        return false;
    const auto cells = cells_of(seen, given.resolution);
    const auto through = [&](long double wide) { return cells_of(window(given, wide), given.resolution); };
    return through(1 - 1e-6L) == cells && through(1 + 1e-6L) == cells;
}

}  // namespace raylab::grading::listing
