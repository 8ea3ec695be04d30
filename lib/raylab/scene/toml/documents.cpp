#include "raylab/scene/toml/documents.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/toml/node.h"
#include "raylab/scene/toml/scene_format.h"
#include "raylab/scene/toml/skim.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::toml_file {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_include = 16;
constexpr std::size_t max_bytes = std::size_t{1} << 24;  // of all files together: some 300 000 shapes

// A file's one name, however a path to it is spelled.
fs::path identity(const fs::path& path) {
    std::error_code problem;
    const auto canonical = fs::weakly_canonical(path, problem);
    return problem ? path : canonical;
}

class Loader {
public:
    explicit Loader(const MemoryLimit& limit) : limit_(limit) {}

    void load(std::string_view text, const fs::path& path) {
        count(text, path);
        open_.push_back(identity(path));
        known_.push_back(identity(path));
        Document document{.path = path, .file = path.string(), .root = parse(text, path.string())};
        check(document.root, scene_format(), document.file, "the scene");
        const Node root(document.root, scene_format(), document.file);
        if (root.has("include"))
            for (const auto& name : std::get<Value::Array>(root.value("include").data))
                include(path.parent_path() / std::get<std::string>(name.data), {document.file, name.line});
        documents.push_back(std::move(document));
        open_.pop_back();
    }

    std::vector<Document> documents;

private:
    void include(const fs::path& path, const Place& place) {
        if (std::ranges::find(open_, identity(path)) != open_.end())
            throw Error(place, "files that do not include themselves", fmt::format("\"{}\" again", path.string()));
        if (std::ranges::find(known_, identity(path)) != known_.end()) return;
        if (open_.size() >= deepest_include)
            throw Error(place, fmt::format("includes nested at most {} deep", deepest_include), "more");
        std::error_code problem;
        if (!fs::is_regular_file(path, problem))
            throw Error(place, "a scene file to include", fmt::format("none at \"{}\"", path.string()));
        load(read_file(path, max_bytes), path);
    }

    void count(std::string_view text, const fs::path& path) {
        const Place place{path.string()};
        bytes_ += text.size();
        if (bytes_ > max_bytes) throw Error(place, fmt::format("at most {} bytes of TOML", max_bytes), "more");
        parsed_bytes_ += parsed_bytes(text, path.string());
        check_memory(
            {.bytes = parsed_bytes_, .what = "a scene", .why = fmt::format("{} bytes of TOML, parsed", bytes_)}, limit_,
            place);
    }

    std::vector<fs::path> open_;   // files that are being loaded, outermost first
    std::vector<fs::path> known_;  // files that are loaded or being loaded
    std::size_t bytes_ = 0;
    double parsed_bytes_ = 0;  // the predicted memory of the parsed files
    MemoryLimit limit_;
};

}  // namespace

std::vector<Document> load_documents(std::string_view text, const std::filesystem::path& path,
                                     const MemoryLimit& limit) {
    Loader loader(limit);
    loader.load(text, path);
    return std::move(loader.documents);
}

}  // namespace raylab::toml_file
