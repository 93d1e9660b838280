#pragma once
// The properties of a glTF file that may move, by their JSON pointers: those of the glTF 2.0 Asset Object
// Model (KHR_animation_pointer) that this program reads.
#include "gltf/document.hpp"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::gltf {

/// The number of a property's values, and their meaning.
struct PropertyForm {
    enum class Kind { numbers, rotation, flag };

    std::size_t width = 1;
    Kind kind = Kind::numbers;
};

/// One property of a model: it can be set, and set back to what the file says.
class Property {
public:
    /// One number of an array that the model may have left out.
    struct Element {
        std::vector<double>* array = nullptr;
        std::size_t index = 0;
    };
    /// A member of an extension's object.
    struct Member {
        tinygltf::Value* object = nullptr;
        std::string key;
    };
    using Place = std::variant<double*, std::vector<double>*, Element, Member>;

    /// The model that `place` points into must outlive this and keep its shape.
    Property(PropertyForm form, Place place);

    const PropertyForm& form() const { return form_; }

    /// @param numbers form().width of them
    void set(std::span<const double> numbers);
    void reset();

private:
    using Rest = std::variant<double, std::vector<double>, std::optional<tinygltf::Value>>;

    PropertyForm form_;
    Place place_;
    Rest rest_;
};

/// The property at a JSON pointer such as "/nodes/3/translation"; absent where there is none that can move.
/// Weights of nodes and meshes that the file leaves out come to be, as zeros.
std::optional<Property> property_at(Document& document, std::string_view pointer);

/// Returns the largest number of morph targets of a mesh's primitives.
std::size_t target_count(const Document& document, int mesh);

} // namespace sr::gltf
