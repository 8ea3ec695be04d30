#pragma once

#include "arguments.h"

#include <set>
#include <string>

#include <fmt/format.h>

// The truth: every sphere is tested. And what a function asked is gone through again, question by question: whether the
// ray comes to the box at all, whether a nearer hit was known, whether the other child comes first.

namespace raylab::grading::tree {

inline std::optional<double> truth(const Arguments& given) {
    std::optional<double> nearest;
    for (int leaf = given.leaves() - 1; leaf < given.nodes(); ++leaf)
        if (const auto t = hit_of(given, leaf); t && entry_of(given, leaf) && (!nearest || *t < *nearest)) nearest = t;
    return nearest;
}

/// A question that a right traversal does not ask.
struct Wasted {
    enum class Why {
        twice,       // it was asked before
        stranger,    // no such node, or the things of a node that is no leaf
        missed,      // the ray misses the box of the node that was opened
        beyond,      // that box is entered beyond the nearest hit known by then
        other_first  // the other child is entered earlier, and was not opened before
    } why;
    int asked;
};

inline std::vector<int> asked_of(std::span<const double> answer) {
    std::vector<int> all;
    for (std::size_t i = 0; i < most_asked && static_cast<double>(i) < answer[2]; ++i) {
        const double what = answer[3 + i];
        all.push_back(what >= 0 && what < 2 * leaf_mark ? static_cast<int>(what) : no_node);
    }
    return all;
}

inline int sibling_of(int node) { return node % 2 == 1 ? node + 1 : node - 1; }

/// Goes through the questions in their order. A leaf is opened when its things are asked for, another node when the box
/// of one of its children is. The root's box is asked for first.
inline std::optional<Wasted> first_wasted(const Arguments& given, const std::vector<int>& asked) {
    using enum Wasted::Why;
    std::set<int> before, opened;
    std::optional<double> nearest;
    for (const int what : asked) {
        if (!before.insert(what).second) return Wasted{twice, what};
        const bool things = what >= leaf_mark;
        const int node = things ? what - leaf_mark : what;
        if (!given.is_node(node) || (things && !given.is_leaf(node))) return Wasted{stranger, what};
        const int open = things ? node : (node - 1) / 2;
        if ((things || node > 0) && opened.insert(open).second) {
            for (int above = open;; above = (above - 1) / 2) {
                const auto entry = entry_of(given, above);
                if (!entry) return Wasted{missed, what};
                if (nearest && *entry > *nearest) return Wasted{beyond, what};
                if (above == 0) break;
            }
            if (open > 0) {
                const auto mine = entry_of(given, open), others = entry_of(given, sibling_of(open));
                if (others && *others < *mine && !opened.contains(sibling_of(open))) return Wasted{other_first, what};
            }
        }
        if (things)
            if (const auto t = hit_of(given, node); t && (!nearest || *t < *nearest)) nearest = t;
    }
    return std::nullopt;
}

/// The questions of a search that always goes on with the nearer child. A queue that gives out the box entered first
/// asks no more.
class DepthFirst {
public:
    explicit DepthFirst(const Arguments& given) : given_(given) {
        if (const auto entry = entry_of(given, 0)) open(0, *entry);
    }
    std::size_t questions() const { return questions_; }
    /// Whether two children are entered at once: then their order is open, and so is the number of questions.
    bool has_ties() const { return ties_; }
    /// The hit of the first leaf that has one.
    std::optional<double> first_hit() const { return first_hit_; }
    /// How many of the opened nodes have a child that is entered before the other one.
    std::size_t choices() const { return choices_; }

private:
    void open(int node, double entry) {
        if (nearest_ && entry > *nearest_) return;
        if (given_.is_leaf(node)) {
            ++questions_;
            if (const auto t = hit_of(given_, node); t && (!nearest_ || *t < *nearest_)) nearest_ = t;
            if (!first_hit_) first_hit_ = nearest_;
            return;
        }
        questions_ += 2;
        const auto left = entry_of(given_, 2 * node + 1), right = entry_of(given_, 2 * node + 2);
        if (left && right && *left == *right) ties_ = true;
        if (left && right && *left != *right) ++choices_;
        const bool right_first = left && right && *right < *left;
        if (right_first) open(2 * node + 2, *right);
        if (left) open(2 * node + 1, *left);
        if (right && !right_first) open(2 * node + 2, *right);
    }

    const Arguments& given_;
    std::optional<double> nearest_, first_hit_;
    std::size_t questions_ = 1;  // the root's box
    std::size_t choices_ = 0;
    bool ties_ = false;
};

inline std::string in_words(const Arguments& given, const Wasted& wasted) {
    const bool things = wasted.asked >= leaf_mark;
    const int node = things ? wasted.asked - leaf_mark : wasted.asked;
    const std::string what = fmt::format("{} {}", things ? "the things of leaf" : "the box of node", node);
    const int open = things ? node : (node - 1) / 2;
    switch (wasted.why) {
        case Wasted::Why::twice:
            return what + " was asked for before";
        case Wasted::Why::stranger:
            if (given.is_node(node)) return fmt::format("the things of node {}, which is no leaf", node);
            return fmt::format("the {} of a node that does not exist", things ? "things" : "box");
        case Wasted::Why::missed:
            return fmt::format("{} was asked for, though the ray misses the box of node {} or one above", what, open);
        case Wasted::Why::beyond:
            return fmt::format(
                "{} was asked for, though the box of node {} or one above is entered beyond the hit found by then",
                what, open);
        default:
            return fmt::format("{} was asked for before anything in node {}, which is entered earlier than node {}",
                               what, sibling_of(open), open);
    }
}

}  // namespace raylab::grading::tree
