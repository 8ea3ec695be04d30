#pragma once

#include "raylab/accelerator/item_buffer.h"
#include "raylab/tracer/eye_picture.h"
#include "raylab/tracer/whitted.h"

#include <memory>
#include <optional>
#include <string>

namespace raylab {

/// When an item buffer is drawn before a picture is traced. The picture is the same bits with and without. Who names a
/// structure wants to see that structure at work: where_it_pays is for "auto" only.
enum class ItemBufferUse { never, where_it_pays, always };

/// What finds the hits of a picture's rays: a structure by name, and an item buffer before it where the eye rays are many
/// enough to buy it back. Where no ray goes on from a surface, the structure behind it is not even built.
class PictureAccelerator {
public:
    PictureAccelerator(const std::string& name, const Scene& scene, const CameraFrame& frame, const WhittedOptions& options,
                       const PixelSamples& samples, ItemBufferUse use = ItemBufferUse::where_it_pays);

    const Accelerator& finds() const;
    bool has_item_buffer() const { return buffer_.has_value(); }

private:
    std::unique_ptr<Accelerator> structure_;
    std::optional<ItemBuffer> buffer_;
};

}  // namespace raylab
