#include "raylab/accelerator/item_buffer/picture_rows.h"

#include <ranges>
#include <span>

namespace raylab {

PictureRows::PictureRows(const PictureView& view, const PictureHull& hull) : image_(view.size()) {
    everywhere_ = !std::isfinite(hull.size);
    begins_ = view.perspective() ? hull.nearest : 0;
    if (everywhere_) return;
    Images images;
    for (std::size_t i = 0; i < hull.count; ++i) images[i] = view.image(hull.corners[i]);
    find_depth(view, hull, images);
    if (behind_) return;
    const double w = view.min_w(hull.distance) - (view.perspective() ? view.depth_error(hull.size, hull.off) : 0);
    everywhere_ = !(w > 0);
    if (everywhere_) return;
    cut(hull, images, w);
    error_ = view.error(hull.size, hull.off, w);
    if (count_ > 0) find_extent(view);
    if (!everywhere_ && count_ > 3 && !is_small()) keep_outline();
}

// A primitive that no ray reaches at t >= 0 is not seen; any other begins no nearer than the depth of its nearest
// corner.
void PictureRows::find_depth(const PictureView& view, const PictureHull& hull, const Images& images) {
    const double error = view.depth_error(hull.size, hull.off) + view.behind();
    double smallest = images[0].depth, greatest = smallest;
    for (std::size_t i = 1; i < hull.count; ++i) {
        smallest = std::min(smallest, images[i].depth);
        greatest = std::max(greatest, images[i].depth);
    }
    behind_ = greatest + hull.thickness < -error;
    begins_ = std::max(
        {view.perspective() ? hull.nearest : 0, (smallest - hull.thickness - error) * PictureView::below, 0.0});
}

void PictureRows::cut(const PictureHull& hull, const Images& images, double w) {
    for (std::size_t i = 0; i < hull.count; ++i) {
        const auto& a = images[i];
        if (!(a.w >= w)) continue;
        points_[count_++] = {a.x / a.w, a.y / a.w};
        for (std::size_t j = 0; j < hull.count; ++j) {
            const auto& b = images[j];
            if (b.w >= w) continue;
            const double share = (a.w - w) / (a.w - b.w);
            points_[count_++] = {(a.x + share * (b.x - a.x)) / w, (a.y + share * (b.y - a.y)) / w};
        }
    }
}

void PictureRows::find_extent(const PictureView& view) {
    Columns rows;
    double sum = error_;
    for (std::size_t i = 0; i < count_; ++i) {
        rows.unite(points_[i].y);
        widest_.unite(points_[i].x);
        sum += std::abs(points_[i].x) + std::abs(points_[i].y);
    }
    everywhere_ = !(sum < 0x1p500);  // so that squares are finite
    if (everywhere_) return;
    const double last_row = view.size().height - 1;
    top_ = static_cast<int>(std::clamp(std::floor(rows.left - error_), 0.0, last_row + 1));
    bottom_ = static_cast<int>(std::clamp(std::floor(rows.right + error_), -1.0, last_row));
}

bool PictureRows::is_small() const {
    return top_ >= bottom_ || std::floor(widest_.right + error_) - std::floor(widest_.left - error_) <= 1;
}

// Andrew's monotone chains (Another efficient algorithm for convex hulls in two dimensions, 1979): one side downwards,
// the other upwards. Whether three points turn is rounded, so a corner that is left out may lie 23 units of the largest
// coordinate outside, and another 23 where what it lies between is left out, too: 552 for 24 points, which
// PictureView::error has room for.
void PictureRows::keep_outline() {
    const auto turns = [](const Point& a, const Point& b, const Point& c) {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x) > 0;
    };
    const std::span all = std::span(points_).first(count_);
    std::ranges::sort(all, [](const Point& a, const Point& b) { return a.y != b.y ? a.y < b.y : a.x < b.x; });
    Points outline;
    std::size_t count = 0, begin = 0;
    const auto add = [&](const Point& next) {
        while (count >= begin + 2 && !turns(outline[count - 2], outline[count - 1], next)) --count;
        outline[count++] = next;
    };
    std::ranges::for_each(all, add);
    begin = --count;  // the last one begins the way back
    std::ranges::for_each(all | std::views::reverse, add);
    count_ = count - 1;  // the first one has come again
    std::ranges::copy_n(outline.begin(), count_, points_.begin());
}

// A convex hull's columns in a strip of rows are those of its corners there and of where its edges enter and leave the
// strip.
PictureRows::Columns PictureRows::between(double top, double bottom) const {
    Columns columns;
    Point before = points_[count_ - 1];
    for (std::size_t i = 0; i < count_; ++i) {
        const Point& p = points_[i];
        if (p.y >= top && p.y <= bottom) columns.unite(p.x);
        const auto& [low, high] = p.y < before.y ? std::pair(p, before) : std::pair(before, p);
        for (const double y : {top, bottom})
            if (low.y < y && y < high.y) columns.unite(low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x));
        before = p;
    }
    return columns;
}

}  // namespace raylab
