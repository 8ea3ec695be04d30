#include "raylab/base/error.h"
#include "raylab/radiosity/cache/mesh_hash.h"
#include "raylab/radiosity/cache/radiosity_cache.h"

#include <utility>
#include <variant>

// The links of hierarchical radiosity and what they came to.

namespace raylab {

namespace {

// The numbers grow with every change of what is computed: files of before are then asked for no more.
const std::string links_head = "raylab links 2", hierarchy_head = "raylab hierarchy 2";

constexpr Link not_measured{0, 0, 0, 0, -1};

/// An entry of KnownLinks without gaps, as files have it.
struct StoredLink {
    KnownLinks::Pair pair;
    Link estimate;
    Link measured;  // of a factor below 0: it was not asked for
};

// The elements that have quarters, in the order in which they got them.
std::vector<std::uint32_t> quartered_elements(const ElementTree& elements) {
    std::vector<std::uint32_t> quartered;
    for (std::size_t i = elements.roots(); i < elements.size(); i += 4) quartered.push_back(elements[i].parent);
    return quartered;
}

template <class Alternatives>
void add_alternative(ContentHash& hash, const Alternatives& value) {
    hash.add_value(value.index());
    std::visit([&](const auto& one) { hash.add_value(one); }, value);
}

template <class Value>
void expect_one_each(const std::vector<Value>& values, std::size_t elements) {
    if (values.size() != elements) throw Error("expected a value for each element, found another number");
}

HierarchicalRadiosity read_hierarchy(CacheReader& reader, const PatchMesh& mesh, double smallest) {
    ElementTree elements(mesh, smallest);
    for (const std::uint32_t element : reader.get_list<std::uint32_t>()) {
        if (element >= elements.size()) throw Error("expected elements in the order of their making, found another");
        elements.quartered(element);
    }
    const std::size_t size = elements.size();
    Links links(size);
    for (auto& of_one : links) of_one = reader.get_list<Link>();
    ElementLight light{reader.get_list<Color>(), reader.get_list<Color>(), reader.get_list<Color>(),
                       reader.get_list<double>(), reader.get_list<double>()};
    HierarchicalRadiosity result{std::move(elements),
                                 std::move(links),
                                 std::move(light),
                                 reader.get_list<double>(),
                                 reader.get_list<double>(),
                                 reader.get_list<Color>(),
                                 reader.get_one<HierarchyWork>()};
    for (const auto* colors :
         {&result.light.emission, &result.light.reflectance, &result.light.radiosity, &result.background})
        expect_one_each(*colors, size);
    for (const auto* numbers : {&result.light.least, &result.light.most, &result.open, &result.filled})
        expect_one_each(*numbers, size);
    return result;
}

}  // namespace

std::optional<KnownLinks> RadiosityCache::links(const std::string& key) {
    KnownLinks links;
    const bool is_there = found(folder_ / ("links-" + key), links_head, [&](CacheReader& reader) {
        for (const auto& [pair, estimate, measured] : reader.get_list<StoredLink>())
            links.add(pair, {estimate, measured.factor < 0 ? std::nullopt : std::optional(measured)});
    });
    return is_there ? std::optional(std::move(links)) : std::nullopt;
}

void RadiosityCache::keep(const std::string& key, const KnownLinks& links) {
    std::vector<StoredLink> stored;
    for (const auto& [pair, known] : links.sorted())
        stored.push_back({pair, known.estimate, known.measured.value_or(not_measured)});
    write_cache_file(folder_ / ("links-" + key), links_head, [&](CacheWriter& writer) { writer.put_list(stored); });
}

std::optional<HierarchicalRadiosity> RadiosityCache::hierarchy(const std::string& key, const PatchMesh& mesh,
                                                               double smallest) {
    std::optional<HierarchicalRadiosity> result;
    const bool is_there = found(folder_ / ("hierarchy-" + key), hierarchy_head,
                                [&](CacheReader& reader) { result.emplace(read_hierarchy(reader, mesh, smallest)); });
    return is_there ? std::move(result) : std::nullopt;
}

void RadiosityCache::keep(const std::string& key, const HierarchicalRadiosity& hierarchy) {
    write_cache_file(folder_ / ("hierarchy-" + key), hierarchy_head, [&](CacheWriter& writer) {
        writer.put_list(quartered_elements(hierarchy.elements));
        for (const auto& of_one : hierarchy.links) writer.put_list(of_one);
        const ElementLight& light = hierarchy.light;
        for (const auto* colors : {&light.emission, &light.reflectance, &light.radiosity}) writer.put_list(*colors);
        for (const auto* numbers : {&light.least, &light.most, &hierarchy.open, &hierarchy.filled})
            writer.put_list(*numbers);
        writer.put_list(hierarchy.background);
        writer.put_one(hierarchy.work);
    });
}

std::string links_key(const PatchMesh& mesh, int rays) {
    ContentHash hash;
    hash.add(links_head + "\n");
    hash.add_value(rays);
    add_geometry(hash, mesh);
    return hash.digits();
}

std::string hierarchy_key(const std::string& links, const PatchMesh& mesh, const HierarchyOptions& options) {
    ContentHash hash;
    hash.add(hierarchy_head + "\n" + links + "\n");
    for (const double option : {options.error, options.smallest, options.residual}) hash.add_value(option);
    hash.add_value(options.light_points);
    for (const Patch& patch : mesh.patches) {
        hash.add_value(mesh.material(patch).emission);
        add_alternative(hash, mesh.material(patch).diffuse);
    }
    for (const Light& light : mesh.model.scene.lights) {
        add_alternative(hash, light.kind);
        hash.add_value(light.color);
        hash.add_value(light.attenuation);
    }
    const Background& background = mesh.model.scene.background;
    hash.add_value(background.color);
    hash.add_value(background.zenith.value_or(background.color));
    return hash.digits();
}

}  // namespace raylab
