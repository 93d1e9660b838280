#pragma once
// The parameters of the BRDFs that can be tested by themselves: options of `steradian brdf`, arguments in
// Python.
#include "brdf/brdf_under_test.hpp"

#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::brdf {

using ParameterMember =
    std::variant<float scene::Material::*, vec3 scene::Material::*, vec4 scene::Material::*>;

struct TestedParameter {
    std::string key; // "roughness_across"
    std::string help;
    ParameterMember member;
    float min = 0.0f;
    float max = 1.0f;
    bool has_default = true; // false: another parameter is in its place unless it is given
};

/// All of them; each holds for the BRDFs that its help names.
const std::vector<TestedParameter>& parameters();

/// Sets a parameter; a number takes the first channel.
void set(scene::Material& material, const ParameterMember& member, vec3 value);

/// Returns the BRDF of this name with its default parameters: a built-in one ("gltf" is metallic_roughness),
/// a .glsl file that declares f_r, or a .binary file of the MERL database. Absent for another name.
/// `backend`: what a process that tries a user's shader opens a context by. @throws Error for a broken file
std::optional<BrdfUnderTest> brdf_named(const std::string& name, gl::Backend backend);

/// The names of those that need no file; glTF's own is "gltf".
std::vector<std::string_view> builtin_names();

/// Makes it the conductor of a metal (scene::metal_names()). @return false if there is no such metal
bool set_metal(BrdfUnderTest& tested, std::string_view metal);

} // namespace sr::brdf
