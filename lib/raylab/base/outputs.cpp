#include "raylab/base/outputs.h"

#include "raylab/base/error.h"
#include "raylab/base/file.h"
#include "raylab/base/with_all_replaced.h"

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace raylab {

namespace fs = std::filesystem;

namespace {

using Way = OutputPlace::Way;
using Kind = Temporary::Kind;

/// A copy of the Error with one path replaced by another.
Error renamed(const Error& error, const fs::path& from, const fs::path& to) {
    return Error(with_all_replaced(error.what(), from.native(), to.native()));
}

Error unwritable(const OutputPlace& place, const fs::filesystem_error& error) {
    return Error({place.named.string()}, "a place that can be written", error.code().message());
}

void write_bytes(const fs::path& path, std::string_view bytes) {
    errno = 0;  // because streams do not keep the reason of a failure
    std::ofstream file(path, std::ios::binary);
    file.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    file.close();
    if (!file)
        throw Error({path.string()}, "to write " + std::to_string(bytes.size()) + " bytes",
                    errno != 0 ? std::strerror(errno) : "a failing disk");
}

template <class List>
auto& planned_in(List& list, const fs::path& name) {
    const auto found = std::ranges::find_if(list, [&](const auto& one) { return one.place.named == name; });
    assert(found != list.end());
    return *found;
}

/// Creates a temporary for the place and has it filled; if that fails, it is removed.
template <class Write>
void fill(std::optional<Temporary>& temporary, const OutputPlace& place, const Write& write) {
    const auto folder = place.way == Way::through ? fs::temp_directory_path() : place.folder;
    temporary.emplace(Kind::file, folder, place.target.extension());
    try {
        write(temporary->path());
    } catch (const Error& error) {
        const auto named = renamed(error, temporary->path(), place.named);
        temporary.reset();
        throw named;
    } catch (...) {
        temporary.reset();
        throw;
    }
}

}  // namespace

Outputs::Outputs(const Plan& plan) : inputs_(plan.inputs) {
    for (const auto& folder : plan.folders) {
        auto place = output_folder(folder);
        refuse_input(place);
        folders_.emplace_back(std::move(place));
    }
    for (const auto& file : plan.files) {
        auto place = output_place(file);
        refuse_collision(place);
        files_.emplace_back(std::move(place));
    }
}

void Outputs::keep(const std::vector<fs::path>& inputs) {
    inputs_.insert(inputs_.end(), inputs.begin(), inputs.end());
    for (const auto& file : files_) refuse_input(file.place);
}

void Outputs::refuse_input(const OutputPlace& place) const {
    if (place.way == Way::through) return;
    for (const auto& input : inputs_) {
        if (same_file(place.target, input))
            throw Error({place.named.string()}, "an output that is no input", "the same file as " + input.string());
        if (lies_in(place.target, input))
            throw Error({place.named.string()}, "an output outside of the inputs",
                        "one in the folder " + input.string());
    }
}

void Outputs::refuse_collision(const OutputPlace& place) const {
    refuse_input(place);
    if (place.way == Way::through) return;
    for (const auto& file : files_)
        if (const auto& other = file.place;
            other.way == Way::replace && (same_file(place.target, other.target) ||
                                          lies_in(place.target, other.target) || lies_in(other.target, place.target)))
            throw Error({place.named.string()}, "a place of its own", "that of " + other.named.string());
    for (const auto& [folder, temporary, bytes] : folders_)
        if (same_file(place.target, folder.target) || lies_in(folder.target, place.target))
            throw Error({place.named.string()}, "a place of its own", "that of the folder " + folder.named.string());
}

bool Outputs::replaces(const fs::path& file) const { return planned_in(files_, file).place.way == Way::replace; }

void Outputs::write(const fs::path& file, std::string_view bytes) {
    if (auto& output = planned_in(files_, file); output.place.way == Way::through)
        output.bytes = output.bytes.value_or("") + std::string(bytes);  // one pipe may be named twice
    else
        write_with(file, [&](const fs::path& temporary) { write_bytes(temporary, bytes); });
}

void Outputs::write_with(const fs::path& file, const std::function<void(const fs::path&)>& write) {
    auto& output = planned_in(files_, file);
    try {
        fill(output.temporary, output.place, write);
        if (output.place.way == Way::replace) return;
        const auto bytes = read_file(output.temporary->path());
        output.temporary.reset();
        this->write(file, bytes);
    } catch (const fs::filesystem_error& error) {
        throw unwritable(output.place, error);
    }
}

std::uintmax_t Outputs::size(const fs::path& file) {
    const auto& output = planned_in(files_, file);
    return output.temporary ? fs::file_size(output.temporary->path()) : output.bytes.value_or("").size();
}

StagedFolder Outputs::staged(const fs::path& folder) {
    auto& output = planned_in(folders_, folder);
    try {
        if (!output.temporary) output.temporary.emplace(Kind::folder, output.place.folder);
    } catch (const fs::filesystem_error& error) {
        throw unwritable(output.place, error);
    }
    return {output.temporary->path(), folder};
}

void Outputs::naming_folders(const std::function<void()>& work) const {
    try {
        work();
    } catch (const Error& error) {
        Error named = error;
        for (const auto& [place, temporary, bytes] : folders_)
            if (temporary) named = renamed(named, temporary->path(), place.named);
        throw named;
    }
}

std::vector<CompleteOutput> Outputs::complete_outputs() const {
    std::vector<CompleteOutput> complete;
    for (const auto& [place, temporary, bytes] : files_)
        if (temporary || bytes)
            complete.push_back({place, temporary ? temporary->path() : fs::path(), bytes.value_or("")});
    for (const auto& [folder, temporary, bytes] : folders_) {
        if (!temporary) continue;
        for (const auto& entry : fs::recursive_directory_iterator(temporary->path())) {
            if (entry.is_directory()) continue;
            auto place = output_place(folder.named / entry.path().lexically_relative(temporary->path()));
            refuse_collision(place);
            const bool through = place.way == Way::through;
            complete.push_back({std::move(place), entry.path(), through ? read_file(entry.path()) : ""});
        }
    }
    if (!said_.empty()) complete.push_back({.place = output_place("-"), .bytes = said_});
    return complete;
}

void Outputs::commit() {
    put_in_place(complete_outputs());
    for (auto& file : files_) file.temporary.reset(), file.bytes.reset();
    for (auto& folder : folders_) folder.temporary.reset();
    said_.clear();
}

}  // namespace raylab
