#include "raylab/scene/toml/documents.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/scene/toml/node.h"
#include "raylab/scene/toml/scene_format.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab::toml_file {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t deepest_include = 16;
constexpr std::size_t most_bytes = std::size_t{1}
                                   << 24;  // of all files together; parsed TOML takes a hundred times that

// One name for one file, however it is spelled.
fs::path identity(const fs::path& path) {
    std::error_code problem;
    const auto canonical = fs::weakly_canonical(path, problem);
    return problem ? path : canonical;
}

class Loader {
public:
    void load(std::string_view text, const fs::path& path) {
        count_bytes(text.size(), {path.string()});
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
        load(read_file(path, most_bytes), path);
    }

    void count_bytes(std::size_t size, const Place& place) {
        bytes_ += size;
        if (bytes_ > most_bytes) throw Error(place, fmt::format("at most {} bytes of TOML", most_bytes), "more");
    }

    std::vector<fs::path> open_;   // files being loaded, outermost first
    std::vector<fs::path> known_;  // files loaded or being loaded
    std::size_t bytes_ = 0;
};

}  // namespace

std::vector<Document> load_documents(std::string_view text, const std::filesystem::path& path) {
    Loader loader;
    loader.load(text, path);
    return std::move(loader.documents);
}

}  // namespace raylab::toml_file
