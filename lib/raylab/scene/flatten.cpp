#include "raylab/scene/check_shape.h"
#include "raylab/scene/group.h"
#include "raylab/scene/moving.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace raylab {

namespace {

constexpr std::size_t deepest_nesting = 64;
constexpr double bytes_an_object = sizeof(Object) + 64;  // including its path

// The numbers of shapes and instances to which a group flattens, and the depth to which its groups are nested.
struct Extent {
    std::size_t members = 0;
    std::size_t depth = 1;
};

// Measures every group before anything is built: 64 nested groups of ten instances each would exceed any memory, and
// even without a shape inside they would take forever.
class Census {
public:
    Census(const std::vector<Group>& groups, const MemoryLimit& limit)
        : groups_(groups), limit_(limit), known_(groups.size()) {}

    Extent measure(const Group& group) {
        Extent extent;
        for (const auto& member : group.members) {
            ++extent.members;
            if (const auto* instance = std::get_if<Instance>(&member)) add(extent, *instance);
        }
        return extent;
    }

private:
    void add(Extent& extent, const Instance& instance) {
        const auto inner = measure(instance);
        extent.members += inner.members;
        extent.depth = std::max(extent.depth, inner.depth + 1);
        if (extent.members > max_objects)
            throw Error(instance.place, fmt::format("at most {} shapes and instances in all", max_objects), "more");
        check_memory({.bytes = bytes_an_object * static_cast<double>(extent.members),
                      .what = "a scene",
                      .why = fmt::format("{} shapes and instances in all", extent.members)},
                     limit_, instance.place);
        if (extent.depth > deepest_nesting) refuse_depth(instance);
    }

    Extent measure(const Instance& instance) {
        refuse_cycle(instance);
        if (open_.size() >= deepest_nesting) refuse_depth(instance);
        auto& known = known_[instance.group];
        if (known) return *known;
        open_.push_back(instance.group);
        known = measure(groups_[instance.group]);
        open_.pop_back();
        return *known;
    }

    [[noreturn]] static void refuse_depth(const Instance& instance) {
        throw Error(instance.place, fmt::format("groups nested at most {} deep", deepest_nesting), "more");
    }

    void refuse_cycle(const Instance& instance) const {
        const auto begin = std::ranges::find(open_, instance.group);
        if (begin == open_.end()) return;
        std::string cycle;
        for (auto each = begin; each != open_.end(); ++each) cycle += groups_[*each].name + " -> ";
        throw Error(instance.place, "groups that do not contain themselves", cycle + groups_[instance.group].name);
    }

    const std::vector<Group>& groups_;
    MemoryLimit limit_;
    std::vector<std::optional<Extent>> known_;
    std::vector<std::size_t> open_;  // the groups that are being measured, outermost first
};

// The state of a group while it is being flattened.
struct Standing {
    AffineSteps steps;
    std::optional<Vec3d> motion = {};
    std::optional<AffineSteps> end = {};  // its place when the shutter closes, if a transform_end led there
    std::string path = {};
};

std::optional<Vec3d> moved(const std::optional<Vec3d>& own, const Standing& parent) {
    if (!own) return parent.motion;
    const auto& c = parent.steps.columns;
    return c[0] * own->x + c[1] * own->y + c[2] * own->z + parent.motion.value_or(Vec3d{0, 0, 0});
}

AffineSteps moved_by(const AffineSteps& steps, const std::optional<Vec3d>& velocity, double seconds) {
    return velocity ? steps.then(AffineSteps::translate(*velocity * seconds)) : steps;
}

// The end of a member of a group that stands so.
template <class Member>
std::optional<AffineSteps> end_of(const Member& member, const Standing& parent, const std::optional<Shutter>& shutter) {
    if (!shutter || (!member.end && !parent.end)) return std::nullopt;
    const AffineSteps own = moved_by(member.end.value_or(member.steps), member.motion, shutter->close);
    return own.then(parent.end ? *parent.end : moved_by(parent.steps, parent.motion, shutter->close));
}

Motion straight(const Vec3d& velocity) {
    return {.translation = {static_cast<float>(velocity.x), static_cast<float>(velocity.y),
                            static_cast<float>(velocity.z)}};
}

// The entries' way from the floats of time 0 to the end, in a second.
Motion motion_toward(const AffineSteps& end, const Affine& begin, double close) {
    const AffineSteps from = AffineSteps::of(begin);
    const auto rate = [&](const Vec3d& last, const Vec3d& first) { return (last - first) / close; };
    const Affine rates = AffineSteps{{rate(end.columns[0], from.columns[0]), rate(end.columns[1], from.columns[1]),
                                      rate(end.columns[2], from.columns[2])},
                                     rate(end.translation, from.translation)}
                             .rounded();
    return {rates.columns, rates.translation};
}

class Flattening {
public:
    Flattening(const std::vector<Group>& groups, const std::optional<Shutter>& shutter)
        : groups_(groups), shutter_(shutter) {}

    void add(const Group& group, const Standing& standing) {
        // Counts shapes by kind, so that a path can say "the third sphere of its group".
        std::map<std::string, int> seen;
        for (const auto& member : group.members) {
            if (const auto* shape = std::get_if<GroupShape>(&member))
                add(*shape, standing, fmt::format("{} {}", shape->kind, seen[shape->kind]++));
            if (const auto* instance = std::get_if<Instance>(&member)) {
                const auto& of = groups_[instance->group];
                add(of, {.steps = instance->steps.then(standing.steps),
                         .motion = moved(instance->motion, standing),
                         .end = end_of(*instance, standing, shutter_),
                         .path = fmt::format("{}{}[{}]/", standing.path, of.name, seen[of.name + "["]++)});
            }
        }
    }

    std::vector<Object> objects;

private:
    void add(const GroupShape& shape, const Standing& standing, const std::string& name) {
        Object object = shape.object;
        object.placement = shape.steps.then(standing.steps).rounded();
        check_placement(object.placement, shape.place);
        if (const auto end = end_of(shape, standing, shutter_))
            object.motion = motion_toward(*end, object.placement, shutter_->close);
        else if (const auto velocity = moved(shape.motion, standing))
            object.motion = straight(*velocity);
        if (object.motion) check_motion(object.placement, *object.motion, ray_times(shutter_), shape.place);
        object.path = standing.path + name;
        objects.push_back(std::move(object));
    }

    const std::vector<Group>& groups_;
    const std::optional<Shutter>& shutter_;
};

}  // namespace

std::vector<Object> flatten(const std::vector<Group>& groups, const Group& top, const std::optional<Shutter>& shutter,
                            const MemoryLimit& limit) {
    Census census(groups, limit);
    for (const auto& group : groups) census.measure(group);  // a cycle is refused even where nothing shows it
    census.measure(top);
    Flattening flattening(groups, shutter);
    flattening.add(top, Standing{});
    return std::move(flattening.objects);
}

}  // namespace raylab
