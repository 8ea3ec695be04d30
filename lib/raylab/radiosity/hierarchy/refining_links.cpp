#include "raylab/base/tiles.h"
#include "raylab/radiosity/hierarchy/linked_elements.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

// How links come about, and how they are replaced by links of quarters.

namespace raylab {

void LinkedElements::link_roots(double looser) {
    quarter_under_lights();
    pull_up(elements_, std::vector<Color>(elements_.size(), Color(0)), open_areas(elements_, open_shares_), light_);
    std::vector<LinkEnds> pairs;
    const auto roots = static_cast<std::uint32_t>(elements_.roots());
    for (std::uint32_t i = 0; i < roots; ++i)
        for (std::uint32_t j = 0; j < roots; ++j)
            if (i != j) pairs.push_back({i, j});
    link_pairs(std::move(pairs), looser);
}

// The links of pairs, with what refinement says of them; those that stay are measured.
std::vector<LinkedElements::Candidate> LinkedElements::estimated(const std::vector<LinkEnds>& pairs, double looser) {
    std::vector<Candidate> found(pairs.size());
    for_each_piece(pairs.size(), 64, options_.threads, [&](std::size_t begin, std::size_t end) {
        Traversal traversal;
        for (std::size_t i = begin; i < end; ++i) found[i] = candidate(pairs[i], looser, traversal);
    });
    work_.estimates += pairs.size();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const Candidate& one = found[i];
        if (!one.is_estimated_now) ++work_.known;
        if (one.link.exists() && !visibility_.nothing_hides())
            work_.rays += static_cast<std::uint64_t>(options_.rays) * (one.is_estimated_now + one.is_measured_now);
        if (options_.known && (one.is_estimated_now || one.is_measured_now))
            options_.known->add(numbers(pairs[i]), one.what_is_known);
    }
    return found;
}

KnownLinks::Pair LinkedElements::numbers(const LinkEnds& ends) const {
    return {elements_[ends.receiver].number, elements_[ends.source].number};
}

LinkedElements::Candidate LinkedElements::candidate(const LinkEnds& ends, double looser, Traversal& traversal) const {
    const KnownLinks::Known* known = options_.known ? options_.known->find(numbers(ends)) : nullptr;
    Candidate found{.what_is_known = known ? *known : KnownLinks::Known{}};
    auto& [estimate, measured] = found.what_is_known;
    if (!known) estimate = estimated_link(elements_, ends, visibility_, options_.rays, traversal);
    estimate.source = ends.source;
    found.refinement = refinement(elements_, light_, ends.receiver, estimate, looser * allowed_);
    found.link = estimate;
    found.is_estimated_now = !known;
    if (found.refinement != Refinement::none) return found;
    found.is_measured_now = !measured;
    if (!measured) measured = measured_link(elements_, ends, estimate, visibility_, options_.rays, traversal);
    found.link = *measured;
    found.link.source = ends.source;
    return found;
}

// The pairs that stand for one whose receiver or source is quartered.
std::array<LinkEnds, 4> LinkedElements::quarter_pairs(const LinkEnds& ends, Refinement refinement) {
    const bool of_receiver = refinement == Refinement::quarter_receiver;
    const std::uint32_t first = quarter(of_receiver ? ends.receiver : ends.source);
    std::array<LinkEnds, 4> pairs;
    for (std::uint32_t i = 0; i < 4; ++i)
        pairs[i] = of_receiver ? LinkEnds{first + i, ends.source} : LinkEnds{ends.receiver, first + i};
    return pairs;
}

// Links pairs, or their quarters, level by level.
void LinkedElements::link_pairs(std::vector<LinkEnds> pairs, double looser) {
    while (!pairs.empty()) {
        claim_memory(pairs.size());
        const auto found = estimated(pairs, looser);
        std::vector<LinkEnds> next;
        for (std::size_t i = 0; i < pairs.size(); ++i) {
            if (found[i].refinement != Refinement::none) {
                for (const LinkEnds& quarters : quarter_pairs(pairs[i], found[i].refinement)) next.push_back(quarters);
            } else if (found[i].link.exists()) {
                links_[pairs[i].receiver].push_back(found[i].link);
                ++work_.links;
            }
        }
        pairs = std::move(next);
    }
    quarter_under_lights();
}

// Links grow while they are refined, so what they need is said again whenever it is twice what was said before.
void LinkedElements::claim_memory(std::size_t pairs) {
    const MemoryNeed now = need(pairs);
    check_memory(now, options_.limit, {mesh_.model.scene.source});
    if (options_.before_memory && now.bytes >= 2 * stated_) {
        options_.before_memory(now);
        stated_ = now.bytes;
    }
    work_.bytes = std::max(work_.bytes, now.bytes);
}

MemoryNeed LinkedElements::need(std::size_t pairs) const {
    const double known = options_.known ? static_cast<double>(options_.known->size() + pairs) : 0;
    const double bytes = 1.5 * sizeof(Link) * static_cast<double>(work_.links) +  // vectors grow in steps
                         sizeof(Candidate) * static_cast<double>(pairs) + KnownLinks::bytes_each * known +
                         1.5 * (sizeof(Element) + 300.0) * static_cast<double>(elements_.size());
    const std::string kept = known > 0 ? fmt::format(", {} pairs kept for other light", known) : "";
    return {bytes, "hierarchical radiosity",
            fmt::format("{} links of {} elements so far{}; a larger --tolerance or --edge makes fewer",
                        work_.links + pairs, elements_.size(), kept)};
}

bool LinkedElements::refine(double looser) {
    std::vector<LinkEnds> pairs;
    for (std::uint32_t receiver = 0; receiver < links_.size(); ++receiver) {
        std::vector<Link> kept;
        for (const Link& link : std::vector<Link>(std::move(links_[receiver]))) {
            const Refinement what = refinement(elements_, light_, receiver, link, looser * allowed_);
            if (what == Refinement::none)
                kept.push_back(link);
            else
                for (const LinkEnds& quarters : quarter_pairs({receiver, link.source}, what)) pairs.push_back(quarters);
        }
        links_[receiver] = std::move(kept);
    }
    const bool found = !pairs.empty();
    work_.links -= pairs.size() / 4;
    link_pairs(std::move(pairs), looser);
    return found;
}

}  // namespace raylab
