#include "raylab/experiment/structure/structure_difference_search.h"

#include "raylab/base/progress.h"
#include "raylab/base/tiles.h"
#include "raylab/experiment/adversarial/adversarial_rays.h"
#include "raylab/experiment/adversarial/adversarial_scenes.h"
#include "raylab/sampling/random.h"
#include "raylab/scene/moving.h"
#include "raylab/scene/needs.h"

#include <cmath>
#include <mutex>

namespace raylab {

namespace {

using adversarial::Draw;
using adversarial::SceneRays;

constexpr std::uint64_t rays_a_scene = 500;  // at most; enough that building structures is not most of the work
// Largest number of primitives: each costs the oracle microseconds to milliseconds.
constexpr std::size_t max_for_oracle = 40;

// The most that one scene may cost the list, in primitive tests: otherwise a few scenes of many coincident or tiny
// primitives would take most of the time, and more scenes find more than more rays do. The limit is a count and not a
// time, so that every run ends at the same place.
constexpr std::uint64_t max_work = 40'000;
std::uint64_t work(const Traversal& traversal) { return traversal.primitive_tests + 100 * traversal.exact_decisions; }

const adversarial::SceneKind& kind_of(const DifferenceSearch& search, std::uint64_t scene) {
    return search.scenes[scene % search.scenes.size()];
}

/// The results of one scene and its rays.
struct Piece {
    DifferenceCount count;
    std::map<std::string, std::uint64_t> wrong;
    std::map<std::string, StructureDifference> first;  // not yet minimised
};

/// Asks all structures about the rays of one scene.
class Asking {
public:
    Asking(const DifferenceSearch& search, std::uint64_t number)
        : search_(search),
          number_(number),
          draw_(random_bits({.seed = search.seed, .pixel = number})),
          kind_(kind_of(search, number)),
          scene_(kind_.make(draw_)),
          rays_(scene_, anything_moves(scene_) ? any_time(draw_, ray_times(scene_)) : 0),
          list_(make_accelerator("list", scene_)) {
        for (const StructureMethod& method : search.structures) structures_.push_back(method.make(scene_));
        for (const auto& structure : structures_) callers_.emplace_back(*structure);
    }

    Piece ask(std::uint64_t largest) {
        const bool small = primitive_count(scene_) <= max_for_oracle;
        for (std::uint64_t i = 0; i < largest && work(asking_list_) < max_work; ++i) {
            const std::size_t kind =
                static_cast<std::size_t>(draw_.integer(0, static_cast<int>(SceneRays::kinds().size()) - 1));
            const auto [ray, expected] = next_ray(kind);
            asked_.push_back(ray);
            kinds_.push_back(kind);
            expected_.push_back(expected);
            piece_.count.hits += expected.has_value();
            for (std::size_t s = 0; s < callers_.size(); ++s)
                if (const auto found = callers_[s].ask(ray, expected))
                    note(search_.structures[s].name, i, asked_, *found);
            if (small && (number_ * rays_a_scene + i) % search_.oracle_every == 0) ask_oracle(i);
        }
        ask_together();
        piece_.count.scenes = 1;
        piece_.count.rays = asked_.size();
        return std::move(piece_);
    }

private:
    // A ray that follows a hit often ends about there, and often leaves the primitive that was hit.
    std::pair<Ray, std::optional<Hit>> next_ray(std::size_t kind) {
        Ray ray = !asked_.empty() && draw_.one_in(3) ? neighbour() : rays_.draw(draw_, kind);
        const auto hit = list_->closest(ray, asking_list_);
        const bool near = hit && draw_.one_in(3), again = hit && draw_.one_in(3);
        if (!near && !again) return {ray, hit};
        if (near) ray.range = adversarial::tight_range(draw_, cast<float>(hit->t));
        if (again) ray.leaving = hit->primitive;
        return {ray, list_->closest(ray, asking_list_)};
    }

    // A ray almost like the last one: some of the last bits of one number differ, or it is as far away as the next
    // pixel.
    Ray neighbour() {
        Ray ray = asked_.back();
        Vec3f& changed = draw_.one_in(2) ? ray.origin : ray.direction;
        const int axis = draw_.integer(0, 2);
        const float by = 1 + std::ldexp(draw_.uniform(-1, 1), draw_.integer(-23, -8));
        if (std::isfinite(changed[axis] * by)) changed[axis] *= by;
        return ray.direction == Vec3f(0) ? asked_.back() : ray;
    }

    void ask_together() {
        const std::vector<Ray> some(
            asked_.begin(), asked_.begin() + static_cast<std::ptrdiff_t>(std::min(search_.together, asked_.size())));
        for (std::size_t s = 0; s < structures_.size(); ++s)
            if (const auto found =
                    disagreement_together(*structures_[s], some, std::span(expected_).first(some.size())))
                note(search_.structures[s].name, found->ray, some, found->answers);
        piece_.count.together_rays = some.size();
    }

    void ask_oracle(std::size_t number) {
        ++piece_.count.oracle_rays;
        if (const auto found = judge_by_oracle({scene_, {asked_.back()}})) note("list", number, asked_, *found);
    }

    void note(const std::string& structure, std::size_t ray, const std::vector<Ray>& asked,
              const Disagreement& answers) {
        if (piece_.wrong[structure]++ > 0) return;
        piece_.first[structure] = {structure,       kind_.name, SceneRays::kinds()[kinds_[ray]], search_.seed, number_,
                                   {scene_, asked}, answers};
    }

    const DifferenceSearch& search_;
    std::uint64_t number_;
    Draw draw_;
    const adversarial::SceneKind& kind_;
    Scene scene_;
    SceneRays rays_;
    std::unique_ptr<Accelerator> list_;
    Traversal asking_list_;
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
    // It must depend on something that is not in the case, so it is kept as it was.
    if (!judge(difference.smallest)) return;
    difference.smallest = minimised(std::move(difference.smallest), judge);
    difference.answers = judge(difference.smallest).value();
}

/// Scenes are drawn in rounds: each round has as many as would suffice if none were ended early.
class Search {
public:
    explicit Search(const DifferenceSearch& search) : search_(search), progress_(search.label, search.rays) {}

    DifferenceReport run() {
        while (report_.total.rays < search_.rays) ask_a_round(search_.rays - report_.total.rays);
        for (auto& [structure, difference] : first_) {
            minimise(difference, judge_of(search_, structure));
            report_.differences.push_back(std::move(difference));
        }
        return std::move(report_);
    }

private:
    void ask_a_round(std::uint64_t rays) {
        const std::uint64_t before = report_.total.scenes, scenes = (rays + rays_a_scene - 1) / rays_a_scene;
        for_each_piece(scenes, 1, search_.threads, [&](std::size_t i, std::size_t) {
            Piece piece = Asking(search_, before + i).ask(std::min(rays_a_scene, rays - i * rays_a_scene));
            const std::lock_guard lock(collecting_);
            add(piece, before + i);
        });
    }

    void add(Piece& piece, std::uint64_t number) {
        report_.total += piece.count;
        report_.by_kind[kind_of(search_, number).name] += piece.count;
        for (const auto& [structure, count] : piece.wrong) report_.wrong[structure] += count;
        for (auto& [structure, found] : piece.first)
            if (const auto known = first_.find(structure); known == first_.end() || number < known->second.piece)
                first_.insert_or_assign(structure, std::move(found));
        progress_.step(piece.count.rays);
    }

    const DifferenceSearch& search_;
    DifferenceReport report_;
    std::map<std::string, StructureDifference> first_;
    std::mutex collecting_;
    Progress progress_;
};

}  // namespace

DifferenceReport find_differences(const DifferenceSearch& search) { return Search(search).run(); }

}  // namespace raylab
