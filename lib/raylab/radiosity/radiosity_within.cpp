#include "raylab/radiosity/radiosity_within.h"

#include "raylab/base/error.h"
#include "raylab/radiosity/system/read_system.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace raylab {

namespace {

constexpr int most_attempts = 20;

/// One of the two ways, and where it stands. Its knob is what makes it finer: the number of patches, or one over the
/// tolerance of links.
class Way {
public:
    // By which powers of the error knob and seconds grow, as long as two attempts have not told it, and between which
    // they are believed: shadows' edges make errors fall with the patches' edges, smooth light with their areas. Two
    // attempts foretell badly, and the last attempt costs most; so a step multiplies the knob by `step` at most: what
    // comes before the last attempt takes a fraction of its time, and it overshoots little.
    struct Powers {
        double knob, least_knob, most_knob, seconds, step;
    };
    explicit Way(const Powers& powers) : powers_(powers) {}

    bool has_begun() const { return !done_.empty(); }
    void add(double knob, double error, double seconds) { done_.push_back({knob, error, seconds}); }

    double enough(double wanted) const {
        return done_.back().knob *
               std::pow(excess(wanted), power(&Point::knob, powers_.knob, powers_.least_knob, powers_.most_knob));
    }
    double next_knob(double wanted) const { return std::min(enough(wanted), powers_.step * done_.back().knob); }
    double seconds_to(double wanted) const {
        return done_.back().seconds * std::pow(excess(wanted), power(&Point::seconds, powers_.seconds,
                                                                     powers_.seconds / 2, powers_.seconds * 2));
    }

private:
    struct Point {
        double knob, error, seconds;
    };

    double excess(double wanted) const {
        constexpr double reserve = 1.1, farthest = 8;
        return std::clamp(reserve * done_.back().error / wanted, reserve, farthest);
    }
    double power(double Point::*value, double fallback, double least, double most) const {
        if (done_.size() < 2) return fallback;
        const Point &first = done_.front(), &last = done_.back();  // neighbours would tell less: errors scatter
        const double gained = std::log(first.error / last.error);
        return gained > 0.1 ? std::clamp(std::log(last.*value / (first.*value)) / gained, least, most) : most;
    }

    Powers powers_;
    std::vector<Point> done_ = {};
};

/// The attempts so far.
class Attempts {
public:
    Attempts(double error, int threads) : wanted_(error), threads_(threads) {}

    // Tries a way; true if its picture is right within what is wanted.
    template <class Solve>
    bool is_enough(Way& way, double knob, const char* mesh, const Solve& solve) {
        const auto begun = std::chrono::steady_clock::now();
        auto solved = solve();
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
        error_ = picture_error(solved.view(), threads_);
        way.add(knob, error_.relative, seconds);
        done_.push_back({mesh, solved.mesh->patches.size(), error_.relative, seconds});
        solved_.emplace(std::move(solved));
        return error_.relative <= wanted_;
    }

    std::size_t patches() const { return done_.back().patches; }
    bool has_more() const { return done_.size() < most_attempts; }

    RadiosityWithin result() && { return {std::move(*solved_), error_, std::move(done_)}; }

    Error not_reached(const Scene& scene) const {
        const auto nearest = std::ranges::min_element(done_, {}, &RadiosityWithin::Attempt::error);
        return {{scene.source},
                fmt::format("an error of at most {:g}, by patches and links that can be afforded", wanted_),
                fmt::format("{:.3g} with {} {} in the best of {} attempts", nearest->error, nearest->patches,
                            nearest->mesh, done_.size())};
    }

private:
    double wanted_;
    int threads_;
    PictureError error_ = {};
    std::vector<RadiosityWithin::Attempt> done_ = {};
    std::optional<std::variant<SceneRadiosity, SceneHierarchy>> solved_ = {};
};

}  // namespace

// Both ways are tried coarsely; then the one goes on that will be there sooner, as its last attempts let one expect.
RadiosityWithin radiosity_within(const Scene& scene, double error, const SceneRadiosityOptions& of_matrix,
                                 const SceneHierarchyOptions& of_links) {
    if (!(error > 0)) throw Error(fmt::format("expected an error over 0 for a picture, found {}", error));
    Attempts attempts(error, of_matrix.form_factors.threads);
    Way matrix({.knob = 2, .least_knob = 0.8, .most_knob = 3, .seconds = 4, .step = 2.5}),
        links({.knob = 1.8, .least_knob = 1, .most_knob = 3, .seconds = 2.5, .step = 2.5});
    SceneRadiosityOptions equal = of_matrix;
    equal.edge.reset();
    const auto solve_equal = [&](double patches) {
        equal.patches = static_cast<std::size_t>(patches);
        return attempts.is_enough(matrix, patches, "equal patches", [&] { return scene_radiosity(scene, equal); });
    };
    SceneHierarchyOptions linked = of_links;
    const auto solve_linked = [&](double by_tolerance) {
        linked.solving.error = 1 / by_tolerance;
        // An element is at least as small as equal patches would have to be, so that the links alone decide.
        linked.edge = edge_for_patches(scene, static_cast<std::size_t>(std::min(1e6, 4 * matrix.enough(error))));
        return attempts.is_enough(links, by_tolerance, "hierarchical", [&] { return scene_hierarchy(scene, linked); });
    };
    constexpr double few = 200, more = 800;  // patches: both together take a second
    bool is_enough = solve_equal(few) || solve_equal(std::min(more, matrix.next_knob(error)));
    while (!is_enough) {
        if (!attempts.has_more()) throw attempts.not_reached(scene);
        const auto in_the_end = static_cast<std::size_t>(matrix.enough(error));  // the way there must fit as a whole
        const bool fits = form_factors_need(in_the_end).bytes <= static_cast<double>(of_matrix.limit.bytes);
        constexpr double at_once = 1;  // seconds: then nothing else need be tried
        const double others = links.has_begun() ? links.seconds_to(error) : at_once;
        if (fits && matrix.seconds_to(error) < others)
            is_enough = solve_equal(matrix.next_knob(error));
        else
            is_enough = solve_linked(links.has_begun() ? links.next_knob(error) : 1 / std::min(0.3, 2 * error));
    }
    return std::move(attempts).result();
}

}  // namespace raylab
