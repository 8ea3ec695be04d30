#pragma once

#include "raylab/radiosity/mesh/patch_mesh.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace raylab {

/// A piece of a surface that sends and receives light as a whole. Of its four quarters each is an element, too; those
/// without any, the leaves, are the patches of the picture.
struct Element {
    Patch patch;
    std::uint32_t root;    // the patch of the coarse mesh from which it was cut
    std::uint32_t parent;  // of a root itself
    std::uint64_t number;  // tells its place below its root, in whatever order elements are made
    std::uint32_t first_child = no_child;

    static constexpr std::uint32_t no_child = 0;  // element 0 is a root, so nobody's child

    bool is_leaf() const { return first_child == no_child; }
};

/// Trees of elements, one below each patch of a mesh. A child's number is larger than its parent's, so a loop upwards
/// meets parents first, and one downwards children.
class ElementTree {
public:
    /// `smallest` is the least side of an element, metres: one whose quarters would have shorter longest sides is never
    /// quartered.
    ElementTree(const PatchMesh& mesh, double smallest);

    std::size_t size() const { return elements_.size(); }
    std::size_t roots() const { return roots_; }
    std::size_t leaves() const { return roots_ + (elements_.size() - roots_) / 4 * 3; }
    const Element& operator[](std::size_t element) const { return elements_[element]; }

    /// Whether an element has quarters, or may get them.
    bool can_be_quartered(std::size_t element) const;

    /// Makes an element's quarters if it has none, and returns the number of the first; the others follow.
    std::uint32_t quartered(std::uint32_t element);

private:
    std::vector<Element> elements_ = {};
    std::size_t roots_;
    double smallest_;
};

}  // namespace raylab
