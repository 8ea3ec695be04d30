#include "raylab/accelerator/painters/painters_picture.h"

#include "raylab/accelerator/item_buffer/picture_rows.h"
#include "raylab/accelerator/painters/cut_piece.h"
#include "raylab/base/error.h"
#include "raylab/number/next_float.h"

#include <algorithm>
#include <cmath>

namespace raylab {

namespace {

using Piece = PaintersTree::Piece;
using Turn = PaintersTree::Turn;

Box box_of(const Piece& piece) {
    Vec3d low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Vec3d& corner : piece.corners) {
        low = glm::min(low, corner);
        high = glm::max(high, corner);
    }
    Box box;
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = float_beyond(low[axis] - 2 * piece.off, -1);
        box.max[axis] = float_beyond(high[axis] + 2 * piece.off, 1);
    }
    return box;
}

class Painter {
public:
    Painter(const PaintersTree& tree, const CameraFrame& frame) : tree_(tree), view_(frame) {
        if (frame.projection == CameraFrame::Projection::orthographic)
            throw Error("the painter: expected a perspective camera, found an orthographic one");
        picture_ = {frame.image.width, frame.image.height};
        for (int y = 0; y < picture_.height; ++y)
            for (int x = 0; x < picture_.width; ++x) rays_.push_back(eye_ray(frame, x + 0.5, y + 0.5));
        picture_.seen.resize(rays_.size());
        shown_.resize(rays_.size());
    }

    const Vec3f& eye() const { return rays_.front().origin; }
    PaintedPicture picture() && { return std::move(picture_); }

    enum class Order { of_the_tree, of_distance };
    void paint(const Turn& turn, Order order = Order::of_the_tree) {
        const Piece& piece = *turn.piece;
        const Target& target = tree_.triangle(piece.triangle).target;
        const PictureRows rows(view_, picture_hull(view_, piece.cuts.empty() ? target : boxed_, box_of(piece)));
        if (rows.everywhere()) {
            for (std::size_t i = 0; i < rays_.size(); ++i) paint(turn, i, order);
            return;
        }
        rows.for_each([&](const PictureRow& row) {
            for (int x = row.first; x <= row.last; ++x)
                paint(turn, static_cast<std::size_t>(row.row * picture_.width + x), order);
        });
    }

private:
    struct Shown {
        Turn turn{nullptr, false};
        Candidate candidate{};
    };

    void paint(const Turn& turn, std::size_t pixel, Order order) {
        const Piece& piece = *turn.piece;
        const auto& [corners, target, primitive] = tree_.triangle(piece.triangle);
        const Ray& ray = rays_[pixel];
        ++picture_.tests;
        const auto found = intersect(ray, target, decisions_);
        if (!found || !holds(piece, ray, corners)) return;
        if (order == Order::of_the_tree && stays(shown_[pixel], turn, *found, ray)) return;
        ++picture_.painted;
        shown_[pixel] = {turn, *found};
        picture_.seen[pixel] = Hit{found->t, primitive, found->u, found->v};
    }

    // Whether the hit is on this piece's side of all cuts; a hit in a cutting plane is on both sides.
    bool holds(const Piece& piece, const Ray& ray, const Triangle& corners) {
        return std::ranges::all_of(piece.cuts, [&](const PaintersTree::Cut& cut) {
            return side(tree_.triangle(cut.plane).corners, ray, corners, decisions_) != -cut.side;
        });
    }

    // A later piece is painted over an earlier one, with two exceptions: where both are hit in the same point, the
    // lower number stays; and where the tree cannot tell their order, depths are compared.
    bool stays(const Shown& shown, const Turn& turn, const Candidate& found, const Ray& ray) {
        if (!shown.turn.piece || shown.turn.piece->triangle == turn.piece->triangle) return false;
        const auto &old = tree_.triangle(shown.turn.piece->triangle), &now = tree_.triangle(turn.piece->triangle);
        Sign against;
        if (shown.turn.unordered || turn.unordered) {
            ++picture_.compared;
            against = raylab::order(ray, now.target, found, old.target, shown.candidate, decisions_);
        } else {
            against = side(now.corners, ray, old.corners, decisions_) == Sign::zero ? Sign::zero : Sign::negative;
        }
        return against == Sign::positive || (against == Sign::zero && old.primitive < now.primitive);
    }

    const PaintersTree& tree_;
    PictureView view_;
    PaintedPicture picture_;
    std::vector<Ray> rays_;
    std::vector<Shown> shown_;
    DecisionCounts decisions_;
    const Shape any_ = Cylinder{};  // of a cut piece only the box is used
    const Affine here_;
    const Target boxed_{&any_, 0, &here_, Sides::both};
};

}  // namespace

PaintedPicture paint(const PaintersTree& tree, const CameraFrame& frame, std::size_t largest) {
    Painter painter(tree, frame);
    const auto order = tree.back_to_front(painter.eye());
    for (std::size_t i = 0; i < std::min(largest, order.size()); ++i) painter.paint(order[i]);
    return std::move(painter).picture();
}

PaintedPicture paint_by_distance(const PaintersTree& tree, const CameraFrame& frame) {
    Painter painter(tree, frame);
    const auto distance = [&](const Piece& piece) {
        return glm::length((piece.corners[0] + piece.corners[1] + piece.corners[2]) / 3.0 - frame.eye);
    };
    std::vector<Piece> whole;
    for (std::uint32_t i = 0; i < tree.triangles(); ++i) whole.push_back(whole_piece(tree.triangle(i).corners, i));
    std::ranges::stable_sort(whole, std::ranges::greater{}, distance);
    for (const Piece& piece : whole) painter.paint({&piece, false}, Painter::Order::of_distance);
    return std::move(painter).picture();
}

}  // namespace raylab
