#pragma once

#include <cmark-gfm.h>

#include <functional>
#include <memory>
#include <string>
#include <string_view>

// cmark-gfm's C functions behind one owner.

namespace raylab {

class MarkdownDocument {
public:
    /// `options` are cmark's CMARK_OPT_ flags. Tables are read as GitHub reads them.
    MarkdownDocument(std::string_view markdown, int options);

    cmark_node* root() const { return root_.get(); }

    /// A node of the document as HTML.
    std::string html(cmark_node* node) const;

    /// Visits each node of the document in its order; `visit` may replace the node.
    void for_each(const std::function<void(cmark_node*)>& visit) const;

private:
    struct Free {
        void operator()(cmark_node* node) const { cmark_node_free(node); }
    };
    std::unique_ptr<cmark_node, Free> root_;
    int options_;
};

/// The text of a node without marks and markup; a line break is a blank.
std::string plain_text(cmark_node* node);

/// Takes a node out of its document and leaves what was inside, as when a link becomes text.
void replace_by_children(cmark_node* node);

}  // namespace raylab
