#pragma once

#include <filesystem>
#include <string>

/// Numbered pictures as a film, by ffmpeg where it is installed.
namespace fiberchain::compare {

/// Whether there is a program ffmpeg on the PATH.
bool has_ffmpeg();

/// An MP4 (H.264) at `film` of the pictures that `pattern` names ("fall-%04d-fiber.png"), from this number
/// on.
/// @throws FigureError if ffmpeg fails, with what it says; nothing then stands at `film` that did not before
void make_film(const std::filesystem::path& pattern, std::int64_t first, int frame_rate,
               const std::filesystem::path& film);

}  // namespace fiberchain::compare
