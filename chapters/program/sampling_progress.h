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

    /// Where a picture is stored on its way, and what is said of that if it is interrupted.
    struct Storing {
        std::function<void()> store;  // none: it is stored when it is complete
        std::string go_on;            // "; --resume goes on with them"
    };

    /// Samples until the end that was asked for; stores now and then.
    TransportCounts run(const TransportPicture& picture, int threads, const Storing& storing);

    /// The same, with most samples where the picture is noisy.
    TransportCounts run_adaptively(const TransportPicture& picture, int threads, const Storing& storing);

    const SampledImage& image() const { return image_; }

    /// What a file says of the picture's samples.
    std::map<std::string, std::string> texts(const std::string& command) const;

    /// How far it got, and how good it is.
    std::string words() const;

private:
    class Watch;

    TransportCounts add_randomisation(const TransportPicture& picture, int threads);
    TransportCounts add_samples(const TransportPicture& picture, int threads);
    bool is_open_ended() const { return asked_.end.error || asked_.end.seconds; }
    SampleRange range() const { return asked_.part.range(asked_.sampler.count); }  // this part's samples
    int first() const { return range().first; }
    int last() const { return range().last; }

    AskedTransport asked_;
    std::string identity_;
    SampledImage image_;
    int done_ = 0;  // samples of this part, or randomisations
};

}  // namespace raylab
