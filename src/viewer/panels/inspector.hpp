#pragma once
// Inspector: what an object, a material and a texture of the scene are, and the factors of a material to
// edit.
#include "viewer/changes.hpp"
#include "viewer/document/light_edits.hpp"
#include "viewer/panels/texture_preview.hpp"

#include <optional>

namespace sr::viewer {

/// Draws the facts of an object. @return the material that it has
std::optional<std::size_t> draw_object_facts(const LoadedScene& loaded, ObjectId object);

/// Draws a material and the fields that edit its factors. `texture`: set to a texture that is clicked.
Changes draw_material(LightEditor& edits, const LoadedScene& loaded, std::size_t material,
                      std::optional<int>& texture);

/// Draws the facts of a texture and its image.
void draw_texture(const LoadedScene& loaded, int texture, TexturePreview& preview, float max_height);

/// Draws what the file has besides: extensions, animations, variants, counts, warnings.
void draw_file_facts(const LoadedScene& loaded);

/// Name of a material, texture or node, or a number for one without.
std::string name_or_number(const std::string& name, const char* kind, std::size_t number);

} // namespace sr::viewer
