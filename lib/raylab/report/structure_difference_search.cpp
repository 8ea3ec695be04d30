#include "raylab/report/structure_difference_search.h"

#include "raylab/accelerator/adversarial_rays.h"
#include "raylab/accelerator/adversarial_scenes.h"
#include "raylab/base/progress.h"
#include "raylab/base/tiles.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/needs.h"

#include <cmath>
#include <mutex>

namespace raylab {

namespace {

using adversarial::Draw;
using adversarial::SceneRays;

constexpr std::uint64_t rays_a_scene = 250;       // so that building structures is not all the work
constexpr std::size_t most_for_oracle = 40;       // primitives: each takes it microseconds to milliseconds

/// What one scene and its rays brought to light.
struct Piece {
    std::uint64_t rays = 0, hits = 0, oracle_rays = 0;
    std::map<std::string, std::uint64_t> wrong;
    std::map<std::string, StructureDifference> first;  // not minimised
};

/// Asks all structures about the rays of one scene.
class Asking {
public:
    Asking(const DifferenceSearch& search, std::uint64_t number)
        : search_(search), number_(number), draw_(random_bits({.seed = search.seed, .pixel = number})),
          kind_(adversarial::scene_kinds()[number % adversarial::scene_kinds().size()]), scene_(kind_.make(draw_)),
          rays_(scene_), list_(make_accelerator("list", scene_)) {
        for (const StructureMethod& method : search.structures) structures_.push_back(method.make(scene_));
        for (const auto& structure : structures_) callers_.emplace_back(*structure);
    }

    Piece ask(std::uint64_t count) {
        const bool small = primitive_count(scene_) <= most_for_oracle;
        for (std::uint64_t i = 0; i < count; ++i) {
            const std::size_t kind = static_cast<std::size_t>(draw_.integer(0, static_cast<int>(SceneRays::kinds().size()) - 1));
            const auto [ray, expected] = next_ray(kind);
            asked_.push_back(ray);
            kinds_.push_back(kind);
            expected_.push_back(expected);
            ++piece_.rays;
            piece_.hits += expected.has_value();
            for (std::size_t s = 0; s < callers_.size(); ++s)
                if (const auto found = callers_[s].ask(ray, expected)) note(search_.structures[s].name, kind, *found);
            if (small && (number_ * rays_a_scene + i) % search_.oracle_every == 0) ask_oracle(kind);
        }
        ask_together();
        return std::move(piece_);
    }

private:
    // Where it hits, its range often ends about there, and it often leaves what it hit.
    std::pair<Ray, std::optional<Hit>> next_ray(std::size_t kind) {
        Ray ray = !asked_.empty() && draw_.one_in(3) ? neighbour() : rays_.draw(draw_, kind);
        Traversal traversal;
        const auto hit = list_->closest(ray, traversal);
        const bool near = hit && draw_.one_in(3), again = hit && draw_.one_in(3);
        if (!near && !again) return {ray, hit};
        if (near) ray.range = adversarial::tight_range(draw_, cast<float>(hit->t));
        if (again) ray.leaving = hit->primitive;
        return {ray, list_->closest(ray, traversal)};
    }

    // A ray almost like the last one: by some of the last bits of one number, or as far as a pixel.
    Ray neighbour() {
        Ray ray = asked_.back();
        Vec3f& changed = draw_.one_in(2) ? ray.origin : ray.direction;
        const int axis = draw_.integer(0, 2);
        const float by = 1 + std::ldexp(draw_.uniform(-1, 1), draw_.integer(-23, -8));
        if (std::isfinite(changed[axis] * by)) changed[axis] *= by;
        return ray.direction == Vec3f(0) ? asked_.back() : ray;
    }

    void ask_together() {
        for (std::size_t s = 0; s < structures_.size(); ++s)
            if (const auto found = disagreement_together(*structures_[s], asked_, expected_))
                note(search_.structures[s].name, kinds_[found->ray], found->answers);
    }

    void ask_oracle(std::size_t kind) {
        ++piece_.oracle_rays;
        if (const auto found = judge_by_oracle({scene_, {asked_.back()}})) note("list", kind, *found);
    }

    void note(const std::string& structure, std::size_t kind, const Disagreement& answers) {
        if (piece_.wrong[structure]++ > 0) return;
        piece_.first[structure] = {structure, kind_.name, SceneRays::kinds()[kind], search_.seed, number_, {scene_, asked_}, answers};
    }

    const DifferenceSearch& search_;
    std::uint64_t number_;
    Draw draw_;
    const adversarial::SceneKind& kind_;
    Scene scene_;
    SceneRays rays_;
    std::unique_ptr<Accelerator> list_;
    std::vector<std::unique_ptr<Accelerator>> structures_;
    std::vector<StructureCaller> callers_;
    std::vector<Ray> asked_;
    std::vector<std::size_t> kinds_;
    std::vector<std::optional<Hit>> expected_;
    Piece piece_;
};

CaseJudge judge_of(const DifferenceSearch& search, const std::string& structure) {
    for (const StructureMethod& method : search.structures)
        if (method.name == structure) return judge_by_list(method);
    return judge_by_oracle;
}

void minimise(StructureDifference& difference, const CaseJudge& judge) {
    if (!judge(difference.least)) return;  // it must depend on something that is not in the case: kept as it was
    difference.least = minimised(std::move(difference.least), judge);
    difference.answers = judge(difference.least).value();
}

}  // namespace

DifferenceReport find_differences(const DifferenceSearch& search) {
    const std::uint64_t pieces = (search.rays + rays_a_scene - 1) / rays_a_scene;
    DifferenceReport report{.scenes = pieces};
    std::map<std::string, StructureDifference> first;
    std::mutex collecting;
    Progress progress(search.label, pieces);
    for_each_piece(pieces, 1, search.threads, [&](std::size_t number, std::size_t) {
        Piece piece = Asking(search, number).ask(std::min(rays_a_scene, search.rays - number * rays_a_scene));
        const std::lock_guard lock(collecting);
        report.rays += piece.rays;
        report.hits += piece.hits;
        report.oracle_rays += piece.oracle_rays;
        for (const auto& [structure, count] : piece.wrong) report.wrong[structure] += count;
        for (auto& [structure, found] : piece.first)
            if (const auto known = first.find(structure); known == first.end() || number < known->second.piece)
                first.insert_or_assign(structure, std::move(found));
        progress.step();
    });
    for (auto& [structure, difference] : first) {
        minimise(difference, judge_of(search, structure));
        report.differences.push_back(std::move(difference));
    }
    return report;
}

}  // namespace raylab
