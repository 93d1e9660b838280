#pragma once
// How a change alters a film, in numbers and as small pictures.
#include "core/math.hpp"
#include "image/image.hpp"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>

namespace sr::assignment {

vec3 rgb_at(const image::Image& film, int x, int y);

/// True if two values differ by more than 1 % of the larger one, and of `floor`.
bool differs(double a, double b, double floor);
bool differs(vec3 a, vec3 b, double floor);

/// The mean luminance of the finite pixels.
double mean_of(const image::Image& film);

/// Compares two films of one size: {"mean_before", "mean_after", "changed" (the share of pixels that differ),
/// "pixel" (where they differ most), "before", "after" (there)}.
nlohmann::ordered_json difference_of(const image::Image& before, const image::Image& after);

/// True if each pixel of `after` is from 1 to 2 times that of `before`.
bool is_between_once_and_twice(const image::Image& before, const image::Image& after);

/// A PNG as base64, in the automatic exposure of `exposed`. A frame surrounds the pixel `marked`.
std::string png_of(const image::Image& film, const image::Image& exposed,
                   std::optional<std::pair<int, int>> marked = {});

} // namespace sr::assignment
