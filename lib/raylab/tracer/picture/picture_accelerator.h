#pragma once

#include "raylab/accelerator/item_buffer/item_buffer.h"
#include "raylab/tracer/picture/eye_picture.h"
#include "raylab/tracer/whitted/whitted.h"

#include <memory>
#include <optional>
#include <string>

namespace raylab {

/// When a buffer is made before a picture is traced. The picture is the same bits with and without. Who names a
/// structure wants to see that structure at work: where_it_pays is for "auto" only.
enum class BufferUse { never, where_it_pays, always };

/// The structure that finds the hits of a picture's rays: one by name, and an item buffer before it where the eye rays
/// are many enough to buy it back, and light buffers, where asked for, for the rays to the lights. Where no ray goes on
/// from a surface, the structure behind them is not even built. It is the same for any number of threads that make it
/// (0: all cores).
class PictureAccelerator {
public:
    PictureAccelerator(const std::string& name, const Scene& scene, const CameraFrame& frame,
                       const WhittedOptions& options, const PixelSamples& samples,
                       BufferUse item_buffer = BufferUse::where_it_pays, BufferUse light_buffers = BufferUse::never,
                       const BuildOptions& build = {});

    const Accelerator& finds() const;
    const std::string& name() const { return name_; }             // of the structure: what "auto" has chosen
    std::size_t light_buffers() const { return light_buffers_; }  // how many lights have one

private:
    std::string name_;
    std::unique_ptr<Accelerator> structure_;
    std::size_t light_buffers_ = 0;
    std::optional<ItemBuffer> buffer_;
};

}  // namespace raylab
