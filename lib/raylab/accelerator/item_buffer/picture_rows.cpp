#include "raylab/accelerator/item_buffer/picture_rows.h"

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
    everywhere_ = !std::isfinite(sum);
    if (everywhere_) return;
    const double last_row = view.size().height - 1;
    top_ = static_cast<int>(std::clamp(std::floor(rows.left - error_), 0.0, last_row + 1));
    bottom_ = static_cast<int>(std::clamp(std::floor(rows.right + error_), -1.0, last_row));
}

// A convex hull's columns in a strip of rows are those of its corners there and of where its edges enter and leave the
// strip; other pairs of corners lie inside, and to leave them out would take longer than to take them.
PictureRows::Columns PictureRows::between(double top, double bottom) const {
    Columns columns;
    for (std::size_t i = 0; i < count_; ++i) {
        const Point& p = points_[i];
        if (p.y >= top && p.y <= bottom) columns.unite(p.x);
        for (std::size_t j = 0; j < i; ++j) {
            const auto& [low, high] = p.y < points_[j].y ? std::pair(p, points_[j]) : std::pair(points_[j], p);
            for (const double y : {top, bottom})
                if (low.y < y && y < high.y) columns.unite(low.x + (y - low.y) / (high.y - low.y) * (high.x - low.x));
        }
    }
    return columns;
}

}  // namespace raylab
