#include "gltf/read/accessor.hpp"

#include "gltf/tinygltf.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <limits>

namespace sr::gltf {
namespace {

const tinygltf::Accessor& at(const Document& document, int accessor) {
    return document.model->accessors[static_cast<std::size_t>(accessor)];
}

std::size_t size_of(int component_type) {
    return static_cast<std::size_t>(
        tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(component_type)));
}

// `count` elements of `element_size` bytes, `stride` apart, all of them inside the buffer view they come
// from.
struct Elements {
    const std::uint8_t* data = nullptr;
    std::size_t stride = 0;
    std::size_t count = 0;
};

Elements elements_in(const Document& document, int view, std::size_t offset, std::size_t count,
                     std::size_t element_size, std::size_t stride, const std::string& pointer) {
    const Bytes bytes = document.view(view, pointer);
    if (stride < element_size)
        document.fail(fmt::format("{} has elements of {} bytes, and /bufferViews/{}/byteStride is {}",
                                  pointer, element_size, view, stride),
                      export_again);
    // Counts, strides and offsets are below 2^32 (schema.cpp), so nothing wraps in 64 bits.
    const std::uint64_t end =
        count == 0 ? offset : std::uint64_t{offset} + std::uint64_t{stride} * (count - 1) + element_size;
    if (end > bytes.size())
        document.fail(fmt::format("{} ends at byte {} of /bufferViews/{}, which has {}", pointer, end, view,
                                  bytes.size()),
                      export_again);
    return {bytes.data() + offset, stride, count};
}

Elements elements_of(const Document& document, int accessor, std::size_t element_size) {
    const tinygltf::Accessor& a = at(document, accessor);
    const auto& view = document.model->bufferViews[static_cast<std::size_t>(a.bufferView)];
    return elements_in(document, a.bufferView, a.byteOffset, a.count, element_size,
                       view.byteStride == 0 ? element_size : view.byteStride,
                       fmt::format("/accessors/{}", accessor));
}

// Zeros cost a file nothing, so a broken count could ask for any amount of memory. No mesh has more vertices
// than its file has bytes.
void check_zeros(const Document& document, int accessor) {
    std::size_t bytes = 1 << 16;
    for (const auto& buffer : document.buffers) bytes += buffer.bytes ? buffer.bytes->size() : 0;
    if (at(document, accessor).count > bytes)
        document.fail(fmt::format("/accessors/{} has {} elements and no bufferView", accessor,
                                  at(document, accessor).count),
                      "give it a bufferView");
}

template<typename T>
T load(const std::uint8_t* from) {
    T value;
    std::memcpy(&value, from, sizeof(T)); // accessors may be misaligned in broken files
    return value;
}

// Section 3.11: f = c / max for unsigned, max(c / max, -1) for signed components.
template<typename T>
float as_float(T component, bool is_normalized) {
    const auto value = static_cast<float>(component);
    if (!is_normalized || std::is_floating_point_v<T>) return value;
    return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

template<typename T>
void decode(const Elements& from, int components, bool is_normalized, float* to) {
    const std::size_t size = sizeof(T) * static_cast<std::size_t>(components);
    if (std::is_same_v<T, float> && from.stride == size) {
        std::memcpy(to, from.data, size * from.count);
        return;
    }
    for (std::size_t i = 0; i < from.count; ++i)
        for (int c = 0; c < components; ++c)
            *to++ = as_float(load<T>(from.data + i * from.stride + static_cast<std::size_t>(c) * sizeof(T)),
                             is_normalized);
}

void decode(const Elements& from, const tinygltf::Accessor& accessor, int components, float* to) {
    if (from.count == 0) return;
    switch (accessor.componentType) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: return decode<std::int8_t>(from, components, accessor.normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return decode<std::uint8_t>(from, components, accessor.normalized, to);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
        return decode<std::int16_t>(from, components, accessor.normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return decode<std::uint16_t>(from, components, accessor.normalized, to);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return decode<std::uint32_t>(from, components, accessor.normalized, to);
    default: return decode<float>(from, components, accessor.normalized, to);
    }
}

std::vector<std::uint32_t> decode_indices(const Elements& from, int component_type) {
    std::vector<std::uint32_t> to(from.count);
    for (std::size_t i = 0; i < from.count; ++i) {
        const std::uint8_t* index = from.data + i * from.stride;
        if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE)
            to[i] = *index;
        else if (component_type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT)
            to[i] = load<std::uint16_t>(index);
        else
            to[i] = load<std::uint32_t>(index);
    }
    return to;
}

// The places that a sparse accessor replaces; all below `count`.
std::vector<std::uint32_t> sparse_places(const Document& document, int accessor) {
    const tinygltf::Accessor& a = at(document, accessor);
    const std::string pointer = fmt::format("/accessors/{}/sparse/indices", accessor);
    const std::size_t size = size_of(a.sparse.indices.componentType);
    const Elements from = elements_in(document, a.sparse.indices.bufferView,
                                      static_cast<std::size_t>(a.sparse.indices.byteOffset),
                                      static_cast<std::size_t>(a.sparse.count), size, size, pointer);
    std::vector<std::uint32_t> places = decode_indices(from, a.sparse.indices.componentType);
    for (const std::uint32_t place : places)
        if (place >= a.count)
            document.fail(
                fmt::format("{} contains {}, and the accessor has {} elements", pointer, place, a.count),
                export_again);
    return places;
}

Elements sparse_values(const Document& document, int accessor, std::size_t element_size) {
    const tinygltf::Accessor& a = at(document, accessor);
    return elements_in(document, a.sparse.values.bufferView,
                       static_cast<std::size_t>(a.sparse.values.byteOffset),
                       static_cast<std::size_t>(a.sparse.count), element_size, element_size,
                       fmt::format("/accessors/{}/sparse/values", accessor));
}

} // namespace

std::size_t count_of(const Document& document, int accessor) { return at(document, accessor).count; }

int components_of(const Document& document, int accessor) {
    return tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(at(document, accessor).type));
}

std::vector<float> numbers(const Document& document, int accessor) {
    const tinygltf::Accessor& a = at(document, accessor);
    const int components = components_of(document, accessor);
    const auto width = static_cast<std::size_t>(components);
    const std::size_t element_size = size_of(a.componentType) * width;
    Elements from;
    if (a.bufferView >= 0)
        from = elements_of(document, accessor, element_size);
    else
        check_zeros(document, accessor);
    document.values_read->add(a.count * width);

    std::vector<float> elements(a.count * width);
    if (from.count > 0) decode(from, a, components, elements.data());
    if (!a.sparse.isSparse) return elements;

    const std::vector<std::uint32_t> places = sparse_places(document, accessor);
    std::vector<float> values(places.size() * width);
    const Elements replacing = sparse_values(document, accessor, element_size);
    if (!values.empty()) decode(replacing, a, components, values.data());
    for (std::size_t i = 0; i < places.size(); ++i)
        std::copy_n(&values[i * width], width, &elements[places[i] * width]);
    return elements;
}

template<int N>
std::vector<glm::vec<N, float>> vectors(const Document& document, int accessor) {
    if (components_of(document, accessor) != N)
        document.fail(fmt::format("/accessors/{} has {} components, and {} are needed", accessor,
                                  components_of(document, accessor), N),
                      export_again);
    const std::vector<float> flat = numbers(document, accessor);
    std::vector<glm::vec<N, float>> elements(flat.size() / N);
    if (!flat.empty()) std::memcpy(&elements[0].x, flat.data(), flat.size() * sizeof(float));
    return elements;
}

template std::vector<glm::vec<2, float>> vectors<2>(const Document&, int);
template std::vector<glm::vec<3, float>> vectors<3>(const Document&, int);
template std::vector<glm::vec<4, float>> vectors<4>(const Document&, int);

std::vector<std::uint32_t> indices(const Document& document, int accessor) {
    const tinygltf::Accessor& a = at(document, accessor);
    const int type = a.componentType;
    const bool is_unsigned = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE
                             || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT
                             || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (a.type != TINYGLTF_TYPE_SCALAR || !is_unsigned)
        document.fail(
            fmt::format("/accessors/{} holds indices, and is not SCALAR of unsigned integers", accessor),
            export_again);
    if (a.bufferView < 0) check_zeros(document, accessor);
    document.values_read->add(a.count);
    std::vector<std::uint32_t> result =
        a.bufferView >= 0 ? decode_indices(elements_of(document, accessor, size_of(type)), type)
                          : std::vector<std::uint32_t>(a.count, 0);
    if (!a.sparse.isSparse) return result;

    const std::vector<std::uint32_t> places = sparse_places(document, accessor);
    const std::vector<std::uint32_t> values =
        decode_indices(sparse_values(document, accessor, size_of(type)), type);
    for (std::size_t i = 0; i < places.size(); ++i) result[places[i]] = values[i];
    return result;
}

std::uint32_t restart_index(const Document& document, int accessor) {
    const std::size_t size = size_of(at(document, accessor).componentType);
    return size == 1 ? 0xFFu : size == 2 ? 0xFFFFu : 0xFFFFFFFFu;
}

} // namespace sr::gltf
