#pragma once
// The properties of a glTF file that animations set, by their JSON pointers (glTF 2.0 Asset Object Model,
// KHR_animation_pointer).
#include "gltf/document.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace sr::gltf {

/// A property of the document's JSON: it can be set, and reset to the file's value.
class AnimatedProperty {
public:
    enum class Kind { numbers, rotation, flag };

    /// @param parent the object or array that has the property; it must outlive this, at its address
    /// @param key of an object
    /// @param index of an array
    AnimatedProperty(json& parent, std::string key, std::size_t index, std::size_t width, Kind kind);

    /// The number of values.
    std::size_t width() const { return width_; }
    Kind kind() const { return kind_; }

    /// @param numbers width() of them
    void set(std::span<const double> numbers);
    void reset();

private:
    json* parent_;
    std::string key_;
    std::size_t index_;
    std::size_t width_;
    Kind kind_;
    std::optional<json> rest_; // absent: the file does not have the property
};

/// Returns the property at a JSON pointer such as "/nodes/3/translation"; absent if it is not there or cannot
/// be animated. Weights of nodes and meshes that the file leaves out are created, as zeros.
std::optional<AnimatedProperty> property_at(Document& document, std::string_view pointer);

} // namespace sr::gltf
