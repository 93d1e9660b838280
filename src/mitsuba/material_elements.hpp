#pragma once
// The content of a <bsdf> element: the plugin that evaluates a material, and its parameters.
#include "mitsuba/textures.hpp"

#include <string>

namespace sr::mitsuba {

/// The plugin for a material's BRDF: "steradian_phong"; "steradian_framed" for what Mitsuba has of its own.
std::string plugin_for(scene::Model model);

/// Writes the parameters of an open <bsdf> of the plugin, but for what a measured BRDF reads from its file.
/// @param has_tangents whether the mesh comes with the attributes that normal maps and directions need
/// @throws Error from Textures
void write_parameters(Xml& xml, Textures& textures, const scene::Material& material, const scene::Mesh& mesh,
                      bool has_tangents);

} // namespace sr::mitsuba
