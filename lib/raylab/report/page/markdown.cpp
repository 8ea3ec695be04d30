#include "raylab/report/page/markdown.h"

#include "raylab/report/page/cmark.h"
#include "raylab/report/page/formula.h"
#include "raylab/report/page/html.h"

#include <algorithm>

namespace raylab {

namespace {

constexpr int options = CMARK_OPT_UNSAFE;  // the lessons are our own: their <details> pass through

class Reader {
public:
    Reader(std::string_view markdown, const std::function<std::string(const std::string&)>& link)
        : document_(formulas_.take_from(markdown), options) {
        document_.for_each([&](cmark_node* node) {
            if (cmark_node_get_type(node) == CMARK_NODE_LINK)
                set_target(node, link(cmark_node_get_url(node)));
            else if (cmark_node_get_type(node) == CMARK_NODE_CODE_BLOCK)
                replace_fence(node);
        });
    }

    std::vector<MarkdownBlock> blocks() const {
        std::vector<MarkdownBlock> blocks;
        for (auto* node = cmark_node_first_child(document_.root()); node; node = cmark_node_next(node))
            blocks.push_back(block(node));
        return blocks;
    }

private:
    using Kind = MarkdownBlock::Kind;

    std::string html(cmark_node* node) const { return formulas_.put_into(document_.html(node)); }

    std::string inside(cmark_node* node) const {
        std::string all;
        for (auto* child = cmark_node_first_child(node); child; child = cmark_node_next(child)) all += html(child);
        return all;
    }

    std::string words(cmark_node* node) const { return formulas_.put_tex_into(plain_text(node)); }

    static void set_target(cmark_node* node, const std::string& target) {
        if (target.empty())
            replace_by_children(node);
        else
            cmark_node_set_url(node, target.c_str());
    }

    // A fence of math becomes an equation; the info word of any other is the class of its element.
    void replace_fence(cmark_node* node) const {
        const std::string info = cmark_node_get_fence_info(node);
        const std::string content = cmark_node_get_literal(node);
        const auto html = info == "math" ? equation_html(content)
                                         : "<pre" + (info.empty() ? "" : " class=\"" + escape_html(info) + "\"") +
                                               "><code>" + escape_html(content) + "</code></pre>\n";
        auto* replaced = cmark_node_new(CMARK_NODE_HTML_BLOCK);
        cmark_node_set_literal(replaced, html.c_str());
        cmark_node_replace(node, replaced);
        cmark_node_free(node);
    }

    MarkdownBlock block(cmark_node* node) const {
        MarkdownBlock made{.line = cmark_node_get_start_line(node)};
        const auto type = cmark_node_get_type(node);
        if (type == CMARK_NODE_HEADING) {
            made.kind = Kind::heading;
            made.level = cmark_node_get_heading_level(node);
            made.html = inside(node);
            made.text = words(node);
            return made;
        }
        made.html = html(node);
        if (type == CMARK_NODE_PARAGRAPH)
            read_paragraph(node, made);
        else if (type == CMARK_NODE_LIST)
            read_list(node, made);
        else if (type == CMARK_NODE_HTML_BLOCK)
            read_comment(cmark_node_get_literal(node), made);
        else if (std::string(cmark_node_get_type_string(node)) == "table")
            made.kind = Kind::table;
        return made;
    }

    void read_paragraph(cmark_node* node, MarkdownBlock& made) const {
        made.kind = Kind::paragraph;
        std::vector<cmark_node*> parts;  // without the line breaks between them
        for (auto* child = cmark_node_first_child(node); child; child = cmark_node_next(child))
            if (cmark_node_get_type(child) != CMARK_NODE_SOFTBREAK && plain_text(child) != " ") parts.push_back(child);
        const auto is_image = [](cmark_node* part) { return cmark_node_get_type(part) == CMARK_NODE_IMAGE; };
        if (!parts.empty() && std::ranges::all_of(parts, is_image)) {
            made.kind = Kind::images;
            for (auto* image : parts) made.images.push_back({cmark_node_get_url(image), inside(image), words(image)});
        } else if (parts.size() == 1 && cmark_node_get_type(parts[0]) == CMARK_NODE_LINK &&
                   *cmark_node_get_title(parts[0]) != '\0') {
            made.kind = Kind::link;
            made.html = inside(parts[0]);
            made.target = cmark_node_get_url(parts[0]);
            made.title = cmark_node_get_title(parts[0]);
        }
    }

    void read_list(cmark_node* node, MarkdownBlock& made) const {
        made.kind = Kind::list;
        for (auto* item = cmark_node_first_child(node); item; item = cmark_node_next(item)) {
            MarkdownItem read{.html = inside(item)};
            auto* paragraph = cmark_node_first_child(item);
            auto* first = paragraph ? cmark_node_first_child(paragraph) : nullptr;
            if (first && cmark_node_get_type(first) == CMARK_NODE_STRONG) read.term = inside(first);
            if (const auto text = first ? plain_text(first) : ""; InlineFormulas::begins_with_formula(text))
                read.term = formulas_.put_into(escape_html(text.substr(0, text.find(':'))));
            made.items.push_back(read);
        }
    }

    static void read_comment(std::string_view text, MarkdownBlock& made) {
        constexpr std::string_view begin = "<!--", end = "-->";
        const auto close = text.find(end);
        if (!text.starts_with(begin) || close == std::string_view::npos) return;
        text = text.substr(begin.size(), close - begin.size());
        const auto first = text.find_first_not_of(" \n"), last = text.find_last_not_of(" \n");
        made.kind = Kind::comment;
        made.text = first == std::string_view::npos ? "" : text.substr(first, last - first + 1);
    }

    InlineFormulas formulas_;
    MarkdownDocument document_;
};

}  // namespace

std::vector<MarkdownBlock> markdown_blocks(std::string_view markdown,
                                           const std::function<std::string(const std::string&)>& link) {
    return Reader(markdown, link).blocks();
}

}  // namespace raylab
