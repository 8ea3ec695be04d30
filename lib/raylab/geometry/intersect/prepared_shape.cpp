#include "raylab/geometry/intersect/prepared_shape.h"

#include "raylab/geometry/filter/ellipsoid_filter.h"
#include "raylab/geometry/filter/revolution_filter.h"
#include "raylab/geometry/predicate/intersection.h"
#include "raylab/geometry/shape_parts.h"

namespace raylab {

namespace {

template <Scalar T>
FilterVerdict decide_in(const Ray& ray, const Shape& shape, const Affine& placement, const Motion* motion,
                        Sides sides) {
    Signs<T> signs;
    const auto found = intersect(ray, shape, placement, motion, sides, signs);
    if (signs.undecided()) return Undecided{};
    if (!found) return Miss{};
    const Enclosure t = value(found->t);
    return Candidate{.t = t.middle(), .t_error = t.radius(), .part = found->part};
}

// Whether an estimate's bound covers the roundings: not where a motion comes on top of a linear part.
bool can_be_estimated(const Affine& placement, const Motion* motion) {
    return !motion || only_translates(placement, *motion);
}

// The filter of shapes that have none of their own: estimates and, where these leave it open, enclosures.
FilterVerdict decide_in_doubles(const Ray& ray, const Shape& shape, const Affine& placement, const Motion* motion,
                                Sides sides) {
    if (can_be_estimated(placement, motion)) {
        const FilterVerdict estimated = if_accurate(decide_in<Estimate>(ray, shape, placement, motion, sides));
        if (!std::holds_alternative<Undecided>(estimated)) return estimated;
    }
    return if_accurate(decide_in<Enclosure>(ray, shape, placement, motion, sides));
}

}  // namespace

// Prepares each kind of shape that is at rest and not placed.
struct PreparedShape::Preparation {
    Kind operator()(const Sphere& sphere) const { return PreparedSphere(sphere); }
    Kind operator()(const Ellipsoid& ellipsoid) const { return &ellipsoid; }
    Kind operator()(const Cylinder& cylinder) const { return &cylinder; }
    Kind operator()(const Cone& cone) const { return &cone; }
    Kind operator()(const Paraboloid&) const { return Unprepared{}; }
    Kind operator()(const Hyperboloid&) const { return Unprepared{}; }
    Kind operator()(const Plane& plane) const { return std::make_shared<const PreparedFlat>(plane); }
    Kind operator()(const Disk& disk) const { return std::make_shared<const PreparedFlat>(disk); }
    Kind operator()(const Annulus& annulus) const { return std::make_shared<const PreparedFlat>(annulus); }
    Kind operator()(const Polygon& polygon) const { return std::make_shared<const PreparedFlat>(polygon); }
    Kind operator()(const Triangle&) const { return Unprepared{}; }
    Kind operator()(const std::shared_ptr<const Mesh>&) const { return Unprepared{}; }
};

PreparedShape::PreparedShape(const Shape& shape, const Affine& placement, const Motion* motion)
    : shape_(&shape),
      placement_(&placement),
      kind_(motion                    ? moving_kind(shape, placement, *motion)
            : placement.is_identity() ? std::visit(Preparation{}, shape)
                                      : placed_kind(shape, placement)) {}

// A shape at rest where a placement has moved it.
struct PreparedShape::Placed {
    CarryBack carry_back;
    Filtered shape;
};

// Asks the filter of a shape that is placed about the ray that is carried back.
struct PreparedShape::PlacedFilter {
    const Ray& ray;
    const CarryBack& carry_back;
    const Sides sides;

    FilterVerdict operator()(std::monostate) const { return Undecided{}; }
    FilterVerdict operator()(const Flat& flat) const {
        return seen_from(flat->point(), [&](const CarriedRay& carried) { return flat->filter(carried, sides); });
    }
    FilterVerdict operator()(const Sphere* sphere) const { return about_center(*sphere); }
    FilterVerdict operator()(const Ellipsoid* ellipsoid) const { return about_center(*ellipsoid); }
    FilterVerdict operator()(const auto* cylinder_or_cone) const {
        return seen_from(convert<double>(cylinder_or_cone->base), [&](const CarriedRay& carried) {
            return revolution_filter::decide(carried, *cylinder_or_cone, sides);
        });
    }

private:
    FilterVerdict seen_from(const Vec3d& point, const auto& filter) const {
        const auto carried = carry_back(ray, point);
        return carried ? filter(*carried) : FilterVerdict(Undecided{});
    }
    FilterVerdict about_center(const auto& closed) const {
        return seen_from(convert<double>(closed.center), [&](const CarriedRay& carried) {
            return sphere_filter::as_filter_verdict(ellipsoid_filter::decide(carried, closed, sides));
        });
    }
};

PreparedShape::Filtered PreparedShape::filtered(const Shape& shape) {
    if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere;
    if (const auto* ellipsoid = std::get_if<Ellipsoid>(&shape)) return ellipsoid;
    const Kind at_rest = std::visit(Preparation{}, shape);
    if (const auto* flat = std::get_if<Flat>(&at_rest)) return *flat;
    if (const auto* cylinder = std::get_if<const Cylinder*>(&at_rest)) return *cylinder;
    if (const auto* cone = std::get_if<const Cone*>(&at_rest)) return *cone;
    return {};
}

PreparedShape::Kind PreparedShape::placed_kind(const Shape& shape, const Affine& placement) {
    Filtered known = filtered(shape);
    if (std::holds_alternative<std::monostate>(known)) return Unprepared{};
    return std::make_shared<const Placed>(Placed{CarryBack(placement), std::move(known)});
}

PreparedShape::Moving PreparedShape::moving_kind(const Shape& shape, const Affine& placement, const Motion& motion) {
    return {&motion, only_translates(placement, motion) ? filtered(shape) : Filtered{}};
}

FilterVerdict PreparedShape::filter_at_rest(const Ray& ray, Sides sides) const {
    if (const auto* flat = std::get_if<Flat>(&kind_)) return (*flat)->filter(ray, sides);
    if (const auto* ellipsoid = std::get_if<const Ellipsoid*>(&kind_))
        return sphere_filter::as_filter_verdict(ellipsoid_filter::decide(ray, **ellipsoid, sides));
    if (const auto* cylinder = std::get_if<const Cylinder*>(&kind_))
        return revolution_filter::decide(ray, **cylinder, sides);
    if (const auto* cone = std::get_if<const Cone*>(&kind_)) return revolution_filter::decide(ray, **cone, sides);
    if (const auto* placed = std::get_if<std::shared_ptr<const Placed>>(&kind_))
        return std::visit(PlacedFilter{ray, (*placed)->carry_back, sides}, (*placed)->shape);
    return Undecided{};
}

// (One verdict, made where it is returned: see part.h on copies.)
FilterVerdict PreparedShape::in_doubles(const Ray& ray, Sides sides) const {
    FilterVerdict verdict = filter_at_rest(ray, sides);
    if (std::holds_alternative<Undecided>(verdict) && !std::holds_alternative<Flat>(kind_))
        verdict = decide_in_doubles(ray, *shape_, *placement_, nullptr, sides);
    return verdict;
}

// Asks the filter of a shape that translates.
struct PreparedShape::TranslatedFilter {
    const Ray& ray;
    const Affine& placement;
    const Motion& motion;
    const Sides sides;

    FilterVerdict operator()(std::monostate) const { return Undecided{}; }
    FilterVerdict operator()(const Flat& flat) const { return flat->filter(ray, placement, motion, sides); }
    FilterVerdict operator()(const Sphere* sphere) const {
        return sphere_filter::as_filter_verdict(sphere_filter::decide(ray, *sphere, placement, motion, sides));
    }
    FilterVerdict operator()(const Ellipsoid* ellipsoid) const {
        return sphere_filter::as_filter_verdict(ellipsoid_filter::decide(ray, *ellipsoid, placement, motion, sides));
    }
    FilterVerdict operator()(const auto* cylinder_or_cone) const {
        return revolution_filter::decide(ray, *cylinder_or_cone, placement, motion, sides);
    }
};

std::optional<Candidate> PreparedShape::intersect_moving(const Ray& ray, std::uint32_t part, const Moving& moving,
                                                         Sides sides, DecisionCounts& decisions) const {
    const Motion& motion = *moving.motion;
    if (const auto triangle = triangle_of(*shape_, part))
        return raylab::intersect(ray, *triangle, *placement_, motion, decisions, sides);
    FilterVerdict verdict = std::visit(TranslatedFilter{ray, *placement_, motion, sides}, moving.translated);
    if (std::holds_alternative<Undecided>(verdict))
        verdict = decide_in_doubles(ray, *shape_, *placement_, &motion, sides);
    if (!std::holds_alternative<Undecided>(verdict)) return candidate_of(verdict);
    return decide_beyond_doubles([&]<Scalar T>() { return decide_in<T>(ray, *shape_, *placement_, &motion, sides); },
                                 decisions);
}

std::optional<Candidate> PreparedShape::intersect(const Ray& ray, std::uint32_t part, Sides sides,
                                                  DecisionCounts& decisions) const {
    if (std::holds_alternative<PreparedSphere>(kind_))
        return raylab::intersect(ray, *std::get_if<Sphere>(shape_), decisions, sides);
    if (std::holds_alternative<Unprepared>(kind_)) {
        if (const auto triangle = triangle_of(*shape_, part))
            return raylab::intersect(ray, *triangle, *placement_, decisions, sides);
    } else if (const auto* moving = std::get_if<Moving>(&kind_)) {
        return intersect_moving(ray, part, *moving, sides, decisions);
    }
    const FilterVerdict verdict = in_doubles(ray, sides);
    if (!std::holds_alternative<Undecided>(verdict)) return candidate_of(verdict);
    return decide_beyond_doubles([&]<Scalar T>() { return decide_in<T>(ray, *shape_, *placement_, nullptr, sides); },
                                 decisions);
}

std::size_t PreparedShape::bytes() const {
    std::size_t bytes = sizeof *this;
    const auto* moving = std::get_if<Moving>(&kind_);
    const auto* placed = std::get_if<std::shared_ptr<const Placed>>(&kind_);
    if (placed) bytes += sizeof(Placed);
    const auto* flat = placed   ? std::get_if<Flat>(&(*placed)->shape)
                       : moving ? std::get_if<Flat>(&moving->translated)
                                : std::get_if<Flat>(&kind_);
    return bytes + (flat ? (*flat)->bytes() : 0);
}

std::optional<Candidate> intersect(const Ray& ray, const Shape& shape, const Affine& placement,
                                   DecisionCounts& decisions, Sides sides) {
    return PreparedShape(shape, placement).intersect(ray, 0, sides, decisions);
}

std::optional<Candidate> intersect(const Ray& ray, const Shape& shape, const Affine& placement, const Motion& motion,
                                   DecisionCounts& decisions, Sides sides) {
    return PreparedShape(shape, placement, &motion).intersect(ray, 0, sides, decisions);
}

}  // namespace raylab
