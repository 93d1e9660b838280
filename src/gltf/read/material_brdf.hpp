#pragma once
// BRDFs of extras.steradian, in the place of glTF's own.
#include "gltf/document.hpp"
#include "gltf/warnings.hpp"
#include "scene/material.hpp"
#include "scene/measured_brdf.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace sr::gltf {

/// The measured BRDFs that materials name, each read once for all moments of a file.
class MeasuredTable {
public:
    explicit MeasuredTable(const Document& document) : document_(document) {}

    /// The number (in brdfs()) of a MERL file beside the glTF; `title` says in errors who wants it.
    /// @throws Error if it cannot be read, or is cut short
    int number(const std::string& uri, const std::string& title);

    const std::vector<scene::MeasuredBrdf>& brdfs() const { return brdfs_; }

private:
    const Document& document_;
    std::vector<scene::MeasuredBrdf> brdfs_;
    std::map<std::string, int> number_of_; // by uri
};

/// Reads the BRDF that extras.steradian names, and its parameters, which scene::brdf_parameters lists.
/// `title` names the material in messages. @throws Error if a parameter is another BRDF's or makes no sense
void read_brdf(const Document& document, const json& stated, const std::string& title,
               MeasuredTable& measured, Warnings& warnings, scene::Material& to);

/// Returns the value; beyond [least, most] the nearest in it, with a warning.
float clamped(double value, double least, double most, std::string_view factor, const std::string& title,
              Warnings& warnings);

/// @throws Error unless all components are 0 to `most`; `remedy` says what is allowed
vec3 within(const Document& document, vec3 value, float most, std::string_view factor,
            const std::string& title, const std::string& remedy);

} // namespace sr::gltf
