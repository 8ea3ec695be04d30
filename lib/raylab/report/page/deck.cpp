#include "raylab/report/page/deck.h"

#include "raylab/base/base64.h"
#include "raylab/base/file.h"
#include "raylab/report/page/page_parts.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace raylab {

namespace fs = std::filesystem;

namespace {

// Where an attribute of a start tag stands, with the space before it, and its value.
struct Attribute {
    std::size_t begin, size;
    std::string value;
};

std::optional<Attribute> attribute(std::string_view tag, std::string_view name) {
    const auto assigned = " " + std::string(name) + "=\"";
    const auto begin = tag.find(assigned);
    if (begin == std::string_view::npos) return std::nullopt;
    const auto value = begin + assigned.size(), end = tag.find('"', value);
    return Attribute{begin, end + 1 - begin, std::string(tag.substr(value, end - value))};
}

bool stands_alone(const std::string& link) { return link.starts_with("#") || link.starts_with("https://"); }

// A picture's floats, a walk through its scene: words that are nothing without the link.
bool says_only_where(std::string_view tag) {
    const auto kind = attribute(tag, "class");
    return kind && (kind->value == "floats" || kind->value == "walk");
}

// Rewrites a page that whole_page() made, tag by tag: in its attributes and texts each < and > is escaped.
class DeckWriter {
public:
    explicit DeckWriter(const fs::path& page) : html_(read_file(page)), folder_(page.parent_path()) {}

    std::string write() {
        while (at_ < html_.size()) {
            copy_to(html_.find('<', at_));
            if (at_ == html_.size()) break;
            const auto rest = std::string_view(html_).substr(at_);
            if (rest.starts_with("<script"))
                copy_to(html_.find("</script", at_));  // its text may hold any <
            else if (rest.starts_with("<style"))
                copy_to(html_.find("</style", at_));
            else if (rest.starts_with("<nav class=\"book\""))
                skip_to_end_of("</nav>");
            else
                add(std::string(take_tag()));
        }
        return std::move(deck_);
    }

private:
    void copy_to(std::size_t end) {
        end = std::min(end, html_.size());
        deck_.append(html_, at_, end - at_);
        at_ = end;
    }
    void skip_to_end_of(std::string_view end) { at_ = html_.find(end, at_) + end.size(); }

    std::string_view take_tag() {
        const auto begin = at_;
        skip_to_end_of(">");
        return std::string_view(html_).substr(begin, at_ - begin);
    }

    void add(std::string tag) {
        if (tag.starts_with("<body")) {
            tag.insert(std::string_view("<body").size(), " data-deck");
        } else if (tag.starts_with("<img ")) {
            if (const auto source = attribute(tag, "src"))
                tag.replace(source->begin, source->size, " src=\"" + data_address(source->value) + "\"");
        } else if (tag.starts_with("<figure")) {
            // The ray trees of a picture's pixels are a file of their own.
            if (const auto trees = attribute(tag, "data-trees")) tag.erase(trees->begin, trees->size);
        } else if (tag.starts_with("<a ")) {
            const auto link = attribute(tag, "href");
            in_plain_words_ = link && !stands_alone(link->value);
            if (in_plain_words_ && says_only_where(tag)) skip_to_end_of("</a>");
            if (in_plain_words_) return;
        } else if (tag == "</a>" && in_plain_words_) {
            return;
        }
        deck_ += tag;
    }

    std::string data_address(const std::string& file) const {
        return std::string("data:image/") + (is_drawing(file) ? "svg+xml" : "png") + ";base64," +
               base64(read_file(folder_ / file));
    }

    std::string html_;
    fs::path folder_;
    std::size_t at_ = 0;
    bool in_plain_words_ = false;  // within a link that leads nowhere from a deck
    std::string deck_;
};

}  // namespace

std::string deck_from_page(const fs::path& page) { return DeckWriter(page).write(); }

}  // namespace raylab
