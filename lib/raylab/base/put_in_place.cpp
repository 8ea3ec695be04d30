#include "raylab/base/put_in_place.h"

#include "raylab/base/descriptor.h"
#include "raylab/base/error.h"
#include "raylab/base/interrupt.h"
#include "raylab/base/temporary.h"

#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <string_view>

namespace raylab {

namespace fs = std::filesystem;

namespace {

/// Delays SIGPIPE while it exists.
class PipeSignalHeld {
public:
    PipeSignalHeld() {
        sigset_t pipe;
        sigemptyset(&pipe);
        sigaddset(&pipe, SIGPIPE);
        pthread_sigmask(SIG_BLOCK, &pipe, &before_);
    }
    ~PipeSignalHeld() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
    PipeSignalHeld(const PipeSignalHeld&) = delete;
    PipeSignalHeld& operator=(const PipeSignalHeld&) = delete;

private:
    sigset_t before_;
};

/// Folders that were created for a file; they are removed again, if they are empty, unless they are kept.
class NewFolders {
public:
    NewFolders() = default;
    NewFolders(const NewFolders&) = delete;
    NewFolders& operator=(const NewFolders&) = delete;
    ~NewFolders() {
        std::error_code not_empty;
        for (auto folder = made_.rbegin(); folder != made_.rend(); ++folder) fs::remove(*folder, not_empty);
    }

    void make(const fs::path& folder) {
        if (folder.empty() || fs::is_directory(folder)) return;
        make(folder.parent_path());
        if (fs::create_directory(folder)) made_.push_back(folder);
    }
    void keep() { made_.clear(); }

private:
    std::vector<fs::path> made_;
};

[[noreturn]] void throw_unwritable(const OutputPlace& place, int problem) {
    const auto name = place.named == "-" ? "standard output" : place.named.string();
    throw Error({name}, "a place that can be written", std::strerror(problem));
}

Descriptor opened(const OutputPlace& place) {
    const int number = place.stream ? fcntl(*place.stream, F_DUPFD_CLOEXEC, 0)
                                    : open(place.target.c_str(), O_WRONLY | O_NOCTTY | O_CLOEXEC);
    if (number < 0) throw_unwritable(place, errno);
    return Descriptor(number);
}

void write_through(const CompleteOutput& output) {
    if (output.place.stream && std::fflush(nullptr) != 0 && errno != EPIPE) throw_unwritable(output.place, errno);
    const Descriptor file = opened(output.place);
    for (std::string_view rest = output.bytes; !rest.empty();) {
        const auto count = write(file.number(), rest.data(), rest.size());
        if (count < 0 && errno == EPIPE) return;
        if (count < 0 && errno != EINTR) throw_unwritable(output.place, errno);
        if (count > 0) rest.remove_prefix(static_cast<std::size_t>(count));
    }
}

/// Replaces rename() where a symlink leads to another file system than that of its folder.
void rename_copy(const CompleteOutput& output) {
    const Temporary copy(Temporary::Kind::file, output.place.folder, output.place.target.extension());
    fs::copy_file(output.file, copy.path(), fs::copy_options::overwrite_existing);
    fs::permissions(copy.path(), fs::status(output.file).permissions());
    fs::rename(copy.path(), output.place.target);
}

void rename(const CompleteOutput& output, NewFolders& folders) {
    const auto& place = output.place;
    try {
        folders.make(place.target.parent_path());
        if (place.mode) fs::permissions(output.file, *place.mode);
        std::error_code problem;
        fs::rename(output.file, place.target, problem);
        if (problem == std::errc::cross_device_link) return rename_copy(output);
        if (problem) throw fs::filesystem_error("rename", place.target, problem);
    } catch (const fs::filesystem_error& error) {
        throw Error({place.named.string()}, "a place that can be written", error.code().message());
    }
}

}  // namespace

void put_in_place(const std::vector<CompleteOutput>& outputs) {
    const PipeSignalHeld until_all_are_in_place;
    for (const auto& output : outputs)
        if (output.place.way == OutputPlace::Way::through) write_through(output);
    const Uninterrupted together;
    NewFolders folders;
    for (const auto& output : outputs)
        if (output.place.way == OutputPlace::Way::replace) rename(output, folders);
    folders.keep();
}

}  // namespace raylab
