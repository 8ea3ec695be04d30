#include "raylab/scene/mesh/ply_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace raylab {

namespace {

// The limits bound the time for comparing each name with all before it. Files of Gaussian splats have 62 properties,
// the most in known files.
constexpr std::size_t max_elements = 256, max_properties = 1024;

struct TypeNames {
    std::string_view first, later;  // two vocabularies are in use
};

constexpr std::array<TypeNames, 8> type_names{{{"char", "int8"},  // in the order of PlyType
                                               {"uchar", "uint8"},
                                               {"short", "int16"},
                                               {"ushort", "uint16"},
                                               {"int", "int32"},
                                               {"uint", "uint32"},
                                               {"float", "float32"},
                                               {"double", "float64"}}};

PlyType read_type(const TextLines& lines, std::size_t word) {
    const auto name = lines.words()[word];
    const auto found =
        std::ranges::find_if(type_names, [&](const auto& names) { return name == names.first || name == names.later; });
    if (found == type_names.end()) lines.refuse("a type such as float, uchar or int32", word);
    return static_cast<PlyType>(found - type_names.begin());
}

void expect_words(const TextLines& lines, std::size_t wanted, const std::string& expected) {
    if (lines.words().size() != wanted) lines.refuse_line(expected);
}

PlyEncoding read_encoding(TextLines& lines) {
    expect_words(lines, 3, "'format ENCODING 1.0'");
    const auto encoding = lines.words()[1];
    if (lines.words()[2] != "1.0") lines.refuse("version 1.0", 2);
    if (encoding == "ascii") return PlyEncoding::text;
    if (encoding == "binary_little_endian") return PlyEncoding::little_endian;
    if (encoding == "binary_big_endian") return PlyEncoding::big_endian;
    lines.refuse("ascii, binary_little_endian or binary_big_endian", 1);
}

PlyElement read_element(const TextLines& lines, const std::vector<PlyElement>& others) {
    expect_words(lines, 3, "'element NAME COUNT'");
    const std::string name(lines.words()[1]);
    if (others.size() == max_elements) lines.refuse_line(fmt::format("at most {} elements", max_elements));
    if (std::ranges::find(others, name, &PlyElement::name) != others.end())
        lines.refuse("an element not named before", 1);
    return {name, lines.integer(2), {}};
}

// "property TYPE NAME" or "property list COUNT_TYPE ITEM_TYPE NAME".
PlyProperty read_property(const TextLines& lines, const PlyElement& element) {
    if (element.properties.size() == max_properties)
        lines.refuse_line(fmt::format("at most {} properties of an element", max_properties));
    const bool list = lines.words().size() > 1 && lines.words()[1] == "list";
    expect_words(lines, list ? 5 : 3, list ? "'property list COUNT_TYPE TYPE NAME'" : "'property TYPE NAME'");
    const auto name = lines.words().size() - 1;
    PlyProperty property{std::string(lines.words()[name]), read_type(lines, name - 1)};
    if (list) property.count = read_type(lines, 2);
    if (property.count >= PlyType::float32) lines.refuse("an integer type for the length of a list", 2);
    if (std::ranges::find(element.properties, property.name, &PlyProperty::name) != element.properties.end())
        lines.refuse("a property not named before", name);
    return property;
}

}  // namespace

std::size_t size_of(PlyType type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

std::size_t PlyElement::min_bytes_binary() const {
    std::size_t bytes = 0;
    for (const auto& property : properties) bytes += size_of(property.count.value_or(property.type));
    return bytes;
}

PlyHeader read_ply_header(TextLines& lines) {
    lines.expect_next("ply");
    if (lines.words().size() != 1 || lines.words()[0] != "ply") lines.refuse("ply");
    std::optional<PlyEncoding> encoding;
    std::vector<PlyElement> elements;
    for (;;) {
        lines.expect_next("a line of the header, or end_header");
        const auto keyword = lines.words()[0];
        if (keyword == "end_header") break;
        if (keyword == "comment" || keyword == "obj_info") continue;
        if (keyword == "format" && !encoding) {
            encoding = read_encoding(lines);
        } else if (keyword == "element") {
            elements.push_back(read_element(lines, elements));
        } else if (keyword == "property" && !elements.empty()) {
            elements.back().properties.push_back(read_property(lines, elements.back()));
        } else {
            lines.refuse("one format, elements each with its properties, comment, obj_info or end_header");
        }
    }
    if (!encoding) lines.refuse("a format before the header's end");
    for (const auto& element : elements)
        if (element.properties.empty())
            lines.refuse("a property of element " + in_quotes(element.name) + " before the header's end");
    return {*encoding, elements};
}

}  // namespace raylab
