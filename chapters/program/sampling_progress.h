#pragma once

#include "transport_words.h"

#include "raylab/image/picture_files/sampled_files.h"
#include "raylab/transport/path/transport_picture.h"

#include <functional>
#include <map>
#include <string>

namespace raylab {

/// A sampled picture on its way: which samples it has, and which come next.
class SamplingProgress {
public:
    SamplingProgress(const AskedTransport& asked, std::string identity, ImageSize size);

    /// Goes on from a stored picture. It throws an Error, naming the file, where its samples belong to another picture.
    void go_on_from(const SampledFile& stored, const std::filesystem::path& file);

    /// Samples until the end that was asked for; calls `store` now and then, when the picture may be stored.
    TransportCounts run(const TransportPicture& picture, int threads, const std::function<void()>& store);

    /// Takes all samples at once, most of them where the picture is noisy.
    TransportCounts run_adaptively(const TransportPicture& picture, int threads);

    const SampledImage& image() const { return image_; }

    /// What a file says of the picture's samples.
    std::map<std::string, std::string> texts(const std::string& command) const;

    /// How far it got, and how good it is.
    std::string words() const;

private:
    bool is_open_ended() const { return asked_.end.error || asked_.end.seconds; }
    int first() const;  // of this part's samples
    int last() const;
    int next_stop() const;

    AskedTransport asked_;
    std::string identity_;
    SampledImage image_;
    int done_ = 0;  // samples of this part, or randomisations
};

}  // namespace raylab
