#include "raylab/report/page/cmark.h"

#include <cmark-gfm-core-extensions.h>
#include <cmark-gfm-extension_api.h>

#include <cstdlib>
#include <vector>

namespace raylab {

MarkdownDocument::MarkdownDocument(std::string_view markdown, int options) : options_(options) {
    cmark_gfm_core_extensions_ensure_registered();
    const std::unique_ptr<cmark_parser, void (*)(cmark_parser*)> parser(cmark_parser_new(options), cmark_parser_free);
    cmark_parser_attach_syntax_extension(parser.get(), cmark_find_syntax_extension("table"));
    cmark_parser_feed(parser.get(), markdown.data(), markdown.size());
    root_.reset(cmark_parser_finish(parser.get()));
}

std::string MarkdownDocument::html(cmark_node* node) const {
    const std::unique_ptr<char, void (*)(void*)> text(cmark_render_html(node, options_, nullptr), std::free);
    return text.get();
}

void MarkdownDocument::for_each(const std::function<void(cmark_node*)>& visit) const {
    std::vector<cmark_node*> nodes;  // collected first: a visit may replace its node
    const std::unique_ptr<cmark_iter, void (*)(cmark_iter*)> at(cmark_iter_new(root()), cmark_iter_free);
    for (auto event = cmark_iter_next(at.get()); event != CMARK_EVENT_DONE; event = cmark_iter_next(at.get()))
        if (event == CMARK_EVENT_ENTER) nodes.push_back(cmark_iter_get_node(at.get()));
    for (auto* node : nodes) visit(node);
}

void replace_by_children(cmark_node* node) {
    while (auto* child = cmark_node_first_child(node)) cmark_node_insert_before(node, child);
    cmark_node_free(node);
}

std::string plain_text(cmark_node* node) {
    const auto type = cmark_node_get_type(node);
    if (type == CMARK_NODE_TEXT || type == CMARK_NODE_CODE) return cmark_node_get_literal(node);
    if (type == CMARK_NODE_SOFTBREAK || type == CMARK_NODE_LINEBREAK) return " ";
    std::string text;
    for (auto* child = cmark_node_first_child(node); child; child = cmark_node_next(child)) text += plain_text(child);
    return text;
}

}  // namespace raylab
