#pragma once
// Values that cross between Python and this code.
#include "core/math.hpp"
#include "image/image.hpp"

#include <array>
#include <memory>
#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/shared_ptr.h>
#include <string>
#include <vector>

namespace sr::python {

namespace nb = nanobind;

using Triple = std::array<float, 3>;
using DoubleTriple = std::array<double, 3>;
/// Contiguous rows of floats that Python gives.
using Rows = nb::ndarray<const float, nb::ndim<2>, nb::c_contig, nb::device::cpu>;

inline vec3 vector_of(const Triple& v) { return {v[0], v[1], v[2]}; }
inline Triple triple_of(vec3 v) { return {v.x, v.y, v.z}; }

/// A new array of `rows` × `columns` that owns its values.
inline nb::object array_of(std::vector<float>&& values, std::size_t rows, std::size_t columns) {
    auto* kept = new std::vector<float>(std::move(values));
    const nb::capsule owner(kept, [](void* p) noexcept { delete static_cast<std::vector<float>*>(p); });
    return nb::cast(nb::ndarray<nb::numpy, float>(kept->data(), {rows, columns}, owner));
}

/// The channels first to first + count of an image as a read-only array of height × width × count, or of
/// height × width if `count` is 0. It looks into the image, which `owner` keeps alive.
nb::object view_of(const image::Image& image, std::size_t first, std::size_t count, nb::handle owner);

// The parts of the module.

void bind_images(nb::module_& m);
void bind_lights(nb::module_& m);
void bind_scene(nb::module_& m);
void bind_brdf(nb::module_& m);
void bind_assignment(nb::module_& m);

} // namespace sr::python
