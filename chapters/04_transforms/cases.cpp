#include "cases.h"

#include "judge.h"

#include "raylab/base/number_text.h"
#include "raylab/experiment/transform/placed_sphere.h"

#include <fmt/format.h>

namespace raylab::transforms {

namespace {

constexpr std::size_t case_rays = 2'000;  //; the oracle answers each
constexpr std::size_t case_normals = 2'000;

// A row for a weak method that must be wrong, or for a strong one that must not be.
CaseRow wrong_at_least(const std::string& title, double ppm, double smallest) {
    return {title, "fails: wrong in more than " + share_text(smallest / 1e6), "wrong in " + share_text(ppm / 1e6),
            ppm > smallest};
}

CaseRow never_wrong(const std::string& title, double ppm) {
    return {title, "holds: never wrong", ppm == 0 ? "never wrong" : "wrong in " + share_text(ppm / 1e6), ppm == 0};
}

// Measures one method on one of the sphere workloads.
class Spheres {
public:
    Spheres(const ChapterRun& run, const std::string& name)
        : workload_(named(sphere_workloads(case_rays, run.seed), name)), truth_(truth(workload_, run.threads)) {}

    double wrong_ppm(const std::string& title) const {
        return judge_hits(truth_, answers_of(find_method(placed_sphere_methods(), title), workload_)).error;
    }
    CaseRow weak(const std::string& title, double smallest) const {
        return wrong_at_least(title, wrong_ppm(title), smallest);
    }
    CaseRow strong(const std::string& title) const { return never_wrong(title, wrong_ppm(title)); }

    // The share of hits whose t has an error of more than a thousandth.
    double wrong_t_ppm(const PlacedSphereMethod& method) const {
        const auto answers = answers_of(method, workload_);
        double wrong = 0, hits = 0;
        for (std::size_t i = 0; i < truth_.size(); ++i) {
            if (!truth_[i]) continue;
            ++hits;
            wrong += !answers[i] || std::abs(*answers[i] - *truth_[i]) > 1e-3 * *truth_[i];
        }
        return 1e6 * wrong / hits;
    }

private:
    SphereWorkload workload_;
    std::vector<std::optional<double>> truth_;
};

// A method, and the ppm of decisions that it must at least get wrong.
struct Weak {
    std::string title;
    double smallest;
};

// A case of weak methods, and of the one that is always right, on one of the sphere workloads.
StabilityCase on_instances(const ChapterRun& run, const std::string& name, const std::string& about,
                           const std::string& workload, const std::vector<Weak>& weak) {
    return {name, about, [=] {
                const Spheres spheres(run, workload);
                std::vector<CaseRow> rows;
                for (const auto& [title, smallest] : weak) rows.push_back(spheres.weak(title, smallest));
                rows.push_back(spheres.strong("filtered exact, float to exact"));
                return rows;
            }};
}

StabilityCase far_instance(const ChapterRun& run) {
    return on_instances(run, "FAR-INSTANCE",
                        "Sheared spheres a hundred kilometres from the origin, rays about "
                        "their rims.",
                        "far", {{"inverse matrix, float", 1e5}, {"move, then inverse, float", 10}});
}

StabilityCase flat_instance(const ChapterRun& run) {
    return on_instances(run, "FLAT-INSTANCE",
                        "Spheres pressed to a ten-thousandth of their height, rays about "
                        "their rims.",
                        "flattened", {{"world quadric, float", 1e5}, {"adjugate, float", 1e5}});
}

StabilityCase tiny_instance(const ChapterRun& run) {
    return on_instances(run, "TINY-INSTANCE",
                        "Spheres of size 1e-14: their determinant, 1e-42, is hardly a float "
                        "any more.",
                        "tiny", {{"inverse matrix, float", 1e5}, {"adjugate, float", 1e5}});
}

StabilityCase unit_again(const ChapterRun& run) {
    return {"UNIT-AGAIN",
            "Stretched spheres: t must count directions of the world, not lengths in object "
            "space.",
            [run] {
                const Spheres spheres(run, "stretched");
                const auto mistake = unit_again_method();
                const auto kept = find_method(placed_sphere_methods(), "move, then inverse, double");
                const double right = spheres.wrong_t_ppm(kept);
                return std::vector<CaseRow>{wrong_at_least(mistake.title(), spheres.wrong_t_ppm(mistake), 9e5),
                                            {kept.title(), "holds: t off in less than 0.1 %",
                                             "t off in " + share_text(right / 1e6), right < 1e3}};
            }};
}

// A row with the worst angle and the share of normals that point inward.
CaseRow angle_row(const std::string& title, const NormalWorkload& workload, double smallest, double largest) {
    const auto answers = answers_of(find_method(normal_methods(), title), workload);
    const double worst = judge_normals(truth(workload), answers).error;
    const bool weak = smallest > 0;
    return {title,
            weak ? fmt::format("fails: leans by more than {} rad", smallest)
                 : fmt::format("holds: within {:g} rad", largest),
            fmt::format("leans by {:.2g} rad", worst), weak ? worst > smallest : worst <= largest};
}

StabilityCase normal_shear(const ChapterRun& run) {
    return {"NORMAL-SHEAR", "Normals of sheared surfaces: the map itself tilts them off the surface.", [run] {
                const auto workload = named(normal_workloads(case_normals, run.seed), "sheared");
                return std::vector{angle_row("like a point, double", workload, 1, 0),
                                   angle_row("inverse transpose, float", workload, 0, 1e-4),
                                   angle_row("inverse transpose, double", workload, 0, 1e-12)};
            }};
}

StabilityCase mirror(const ChapterRun& run) {
    return {"MIRROR", "Normals of mirrored surfaces: the cross products of the columns change sides.", [run] {
                const auto workload = named(normal_workloads(case_normals, run.seed), "mirrored");
                const auto inward = [&](const std::string& title) {
                    const auto answers = answers_of(find_method(normal_methods(), title), workload);
                    return judge_normals(truth(workload), answers).counts.at("inward ppm");
                };
                const double forgotten = inward("cofactors, sign forgotten, double");
                const double kept = inward("cofactors, double");
                return std::vector<CaseRow>{{"cofactors, sign forgotten, double", "fails: all point inward",
                                             share_text(forgotten / 1e6) + " point inward", forgotten == 1e6},
                                            {"cofactors, double", "holds: none points inward",
                                             share_text(kept / 1e6) + " point inward", kept == 0}};
            }};
}

// Two matrices: one is exactly singular, though its float determinant is not zero; the other is invertible, though its
// float determinant is zero.
StabilityCase singular() {
    return {"SINGULAR", "Is a map invertible? The sign of a rounded determinant does not know.", [] {
                const auto rounded = [](const Affine& map) { return PlacementOf<float>(map).determinant; };
                const Vec3f a{1000003, 999983, 1000037}, b{999961, 1000039, 1000081};
                const Affine flat{{a, b, a + b}};  // integers: the sum is exact, but the products are not
                const Affine small{{Vec3f{1e-16f, 0, 0}, Vec3f{0, 1e-16f, 0}, Vec3f{0, 0, 1e-16f}}};
                const auto row = [](const std::string& title, bool says_singular, bool is, bool weak) {
                    const std::string said = says_singular ? "says singular" : "says invertible";
                    const std::string truly = is ? "singular" : "invertible";
                    return CaseRow{title, weak ? "fails: the map is " + truly : "holds: says " + truly, said,
                                   (says_singular != is) == weak};
                };
                return std::vector{
                    row("float determinant, a map of 1e-16", rounded(small) == 0, false, true),
                    row("exact determinant, a map of 1e-16", is_singular(small), false, false),
                    row("float determinant, third column = first + second", rounded(flat) == 0, true, true),
                    row("exact determinant, third column = first + second", is_singular(flat), true, false)};
            }};
}

}  // namespace

std::vector<StabilityCase> cases(const ChapterRun& run) {
    return {normal_shear(run),  mirror(run),        unit_again(run), far_instance(run),
            flat_instance(run), tiny_instance(run), singular()};
}

}  // namespace raylab::transforms
