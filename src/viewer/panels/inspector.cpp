#include "viewer/panels/inspector.hpp"

#include "image/display.hpp"
#include "scene/transform.hpp"
#include "viewer/app/fonts.hpp"
#include "viewer/fields.hpp"
#include "viewer/ui.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <imgui.h>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

namespace sr::viewer {
namespace {

void fact(const char* name, const std::string& value) {
    ImGui::TextDisabled("%s", name);
    ImGui::SameLine(6.0f * ImGui::GetFontSize());
    ImGui::PushTextWrapPos();
    ImGui::TextUnformatted(in_plain_letters(value).c_str());
    ImGui::PopTextWrapPos();
}

const scene::TextureImage& image_of(const LoadedScene& loaded, int texture) {
    const scene::Scene& scene = loaded.stage.scene;
    const auto image = scene.textures[static_cast<std::size_t>(texture)].image;
    return scene.images[static_cast<std::size_t>(image)];
}

/// Lists the textures of a material. @return the one that is clicked
std::optional<int> draw_texture_rows(const LoadedScene& loaded, const scene::Material& material) {
    std::optional<int> chosen;
    for (const scene::TextureInput& input : scene::texture_inputs) {
        const scene::TextureSlot& slot = material.*input.member;
        if (!slot.is_present()) continue;
        const scene::TextureImage& image = image_of(loaded, slot.texture);
        const std::string row =
            fmt::format("{}: {} x {}##{}", input.name, image.width, image.height, input.name);
        if (ImGui::Selectable(row.c_str())) chosen = slot.texture;
        tooltip("a click shows the image");
    }
    return chosen;
}

/// Fields of the factors that a glTF material has. @return true if one changed
bool draw_factors(LightEditor& edits, MaterialFactors& factors, const scene::Material& material) {
    bool has_changed = false;
    const auto changed = [&](bool is_changed) {
        if (ImGui::IsItemActivated()) edits.begin_step();
        has_changed = has_changed || is_changed;
        return is_changed;
    };
    vec4 color = material.base_color;
    const vec3 shown(image::srgb_encoded(color.x), image::srgb_encoded(color.y),
                     image::srgb_encoded(color.z));
    ImGui::ColorButton("##swatch", {shown.x, shown.y, shown.z, 1.0f}, ImGuiColorEditFlags_NoTooltip);
    tooltip("the base colour as a screen shows it");
    ImGui::SameLine();
    const bool has_alpha = material.alpha_mode != scene::AlphaMode::opaque;
    if (changed(color_field("base colour", std::span(&color.x, has_alpha ? 4 : 3), false)))
        factors.base_color = glm::clamp(color, vec4(0.0f), vec4(1.0f));
    tooltip("linear reflectance 0 to 1 of red, green, blue (and alpha), times its texture");
    float metallic = material.metallic, roughness = material.roughness;
    const bool has_metallic =
        material.model == scene::Model::metallic_roughness && !material.is_specular_glossiness;
    if (has_metallic && changed(number_field("metallic", metallic, {0.0f, 1.0f})))
        factors.metallic = metallic;
    if (has_metallic) tooltip("0: a dielectric, 1: a metal; times the blue channel of its texture");
    if (changed(number_field("roughness", roughness, {0.0f, 1.0f}))) factors.roughness = roughness;
    tooltip(material.is_specular_glossiness
                ? "1 - glossiness, whose texture is the alpha of the specular one; GGX has the width alpha = "
                  "roughness^2"
                : "GGX has the width alpha = roughness^2; times the green channel of its texture");
    return has_changed;
}

/// Field of a factor. @return true if it changed
bool draw_factor(const gltf::EditableFactor& factor, vec3& value, LightEditor& edits) {
    const std::string label = fmt::format("{}##{}", factor.label, factor.key);
    const char* const format = factor.is_logarithmic ? "%.3g" : factor.max > 100.0f ? "%.0f" : "%.3f";
    if (std::isinf(value.x)) value.x = factor.max; // nothing is attenuated
    const bool is_changed =
        std::holds_alternative<float scene::Material::*>(factor.member)
            ? number_field(label, value.x, {factor.min, factor.max, format, true, factor.is_logarithmic})
            : color_field(label, std::span(&value.x, 3));
    if (ImGui::IsItemActivated()) edits.begin_step();
    tooltip(std::string(factor.meaning));
    return is_changed;
}

/// Fields of the factors that this material has or could have, in a branch for each property. @return true if
/// one changed
bool draw_other_factors(LightEditor& edits, MaterialFactors& factors, const scene::Material& material,
                        const scene::Material& file) {
    bool has_changed = false, is_open = false;
    std::string_view group;
    for (std::size_t i = 0; i < gltf::editable_factors.size(); ++i) {
        const gltf::EditableFactor& factor = gltf::editable_factors[i];
        if (!factor.is_of(material) && !factor.is_of(file)) continue;
        if (group != factor.group) {
            if (is_open) ImGui::TreePop();
            is_open = ImGui::TreeNode(std::string(factor.group).c_str());
            tooltip("factors of this property of the surface");
        }
        group = factor.group;
        if (!is_open) continue;
        vec3 value = value_of(factor, material);
        const bool is_changed = draw_factor(factor, value, edits);
        if (is_changed) factors.others[i] = glm::clamp(value, vec3(factor.min), vec3(factor.max));
        has_changed = has_changed || is_changed;
    }
    if (is_open) ImGui::TreePop();
    return has_changed;
}

/// Field of what a material emits: the same edit as among the lights. One that emits nothing yet becomes a
/// light.
Changes draw_emission(LightEditor& edits, const LoadedScene& loaded, std::size_t material) {
    const auto is_of_material = [&](const LightEntry& entry) {
        return entry.kind == LightEdit::Kind::material && edits.edits()[entry.edit].material == material;
    };
    const auto entry = std::ranges::find_if(edits.entries(), is_of_material);
    const bool is_light = entry != edits.entries().end();
    vec3 emission = is_light ? edits.edits()[entry->edit].emission : vec3(0.0f);
    constexpr float first_step = 200.0f; // of a drag that begins at 0
    const float brightest = std::max({emission.r, emission.g, emission.b, is_light ? 1e-3f : first_step});
    const std::string unit = with_superscripts(std::string(scene::radiance_unit(loaded.stage.scene.units)));
    const bool is_changed = number_field(fmt::format("emission##{}", material), emission,
                                         {0.0f, 1e9f, "%.4g"}, 0.005f * brightest);
    if (ImGui::IsItemActivated()) edits.begin_step();
    tooltip(fmt::format("what it emits, red, green and blue [{}], times its texture; also among the lights",
                        unit));
    if (!is_changed) return {};
    const bool was_dark = !edits.stated(material).is_emissive();
    if (is_light && emission == vec3(0.0f) && !was_dark)
        return {}; // a light is switched off among the lights
    edits.set_emission(material, emission);
    return is_light && emission != vec3(0.0f) ? Change::lights : Change::lights | Change::shadows;
}

} // namespace

std::string name_or_number(const std::string& name, const char* kind, std::size_t number) {
    return name.empty() ? fmt::format("{} {}", kind, number) : name;
}

std::optional<std::size_t> draw_object_facts(const LoadedScene& loaded, ObjectId object) {
    const scene::Scene& scene = loaded.stage.scene;
    const auto is_of = [&](const scene::Instance& i) { return object.is_of(i); };
    const auto instance = std::ranges::find_if(scene.instances, is_of);
    if (instance == scene.instances.end()) {
        ImGui::TextDisabled("not in the scene at this time");
        return std::nullopt;
    }
    const scene::Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance->mesh)];
    const auto count = std::ranges::count_if(scene.instances, is_of);
    fact("mesh", name_or_number(mesh.name, "mesh", static_cast<std::size_t>(object.mesh)));
    fact("triangles", count == 1 ? fmt::format("{}", mesh.indices.size() / 3)
                                 : fmt::format("{} in each of {} instances", mesh.indices.size() / 3, count));
    const scene::Bounds bounds = bounds_of(scene, object);
    const vec3 size = bounds.is_empty() ? vec3(0.0f) : bounds.max - bounds.min;
    fact("size", fmt::format("{:.3g} x {:.3g} x {:.3g} m", size.x, size.y, size.z));
    if (scene::mirrors(instance->world_from_object)) fact("transform", "mirrors");
    return static_cast<std::size_t>(mesh.material);
}

Changes draw_material(LightEditor& edits, const LoadedScene& loaded, std::size_t material,
                      std::optional<int>& texture) {
    const scene::Material& shown = loaded.stage.scene.materials[material];
    fact("material", name_or_number(shown.name, "material", material));
    fact("BRDF", scene::describe(shown) + (shown.is_unlit ? ", unlit" : ""));
    const char* const modes[]{"opaque", "mask", "blend"};
    fact("alpha", fmt::format("{}{}", modes[static_cast<std::size_t>(shown.alpha_mode)],
                              shown.is_double_sided ? ", double-sided" : ""));
    Changes changes;
    if (material < edits.material_count()) {
        MaterialFactors factors = edits.factors_of(material);
        bool has_changed = draw_factors(edits, factors, shown);
        has_changed |= draw_other_factors(edits, factors, shown, edits.stated(material));
        if (factors.any()) {
            if (ImGui::SmallButton("as in the file")) {
                edits.begin_step();
                factors = {};
                has_changed = true;
            }
            tooltip("take the file's values again");
        }
        if (has_changed) edits.set_factors(material, factors);
        // Alpha and glass change shadows, and the mixer's pictures have the old material.
        if (has_changed) changes = Change::lights | Change::shadows;
    }
    if (material < edits.material_count() && !shown.is_unlit)
        changes |= draw_emission(edits, loaded, material);
    if (const auto chosen = draw_texture_rows(loaded, shown)) texture = chosen;
    return changes;
}

void draw_texture(const LoadedScene& loaded, int texture, TexturePreview& preview, float max_height) {
    const scene::Scene& scene = loaded.stage.scene;
    const scene::Texture& shown = scene.textures[static_cast<std::size_t>(texture)];
    const scene::TextureImage& image = image_of(loaded, texture);
    const bool is_wide = std::holds_alternative<std::vector<std::uint16_t>>(image.texels);
    fact("image", name_or_number(image.name, "image", static_cast<std::size_t>(shown.image)));
    fact("texels", fmt::format("{} x {}, {} bits a channel, {}", image.width, image.height, is_wide ? 16 : 8,
                               shown.color_space == scene::ColorSpace::srgb ? "sRGB" : "linear"));
    std::string users;
    for (std::size_t m = 0; m < scene.materials.size(); ++m)
        for (const scene::TextureInput& input : scene::texture_inputs)
            if ((scene.materials[m].*input.member).texture == texture)
                users += fmt::format("{}{} of {}", users.empty() ? "" : ", ", input.name,
                                     name_or_number(scene.materials[m].name, "material", m));
    fact("used as", users.empty() ? "nothing that is shown" : users);
    preview.draw(image, {&scene, shown.image}, max_height);
}

void draw_file_facts(const LoadedScene& loaded) {
    const scene::Scene& scene = loaded.stage.scene;
    fact("file", loaded.file);
    fact("triangles", fmt::format("{}", scene::triangle_count(scene)));
    fact("instances", fmt::format("{} of {} meshes", loaded.base.instances, loaded.base.meshes));
    fact("images", fmt::format("{}", scene.images.size()));
    const auto list = [](const std::vector<std::string>& names) {
        std::string text;
        for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
        return text.empty() ? std::string("none") : text;
    };
    fact("extensions", list(loaded.contents.extensions_used));
    if (!loaded.contents.extensions_required.empty())
        fact("required", list(loaded.contents.extensions_required));
    if (!loaded.contents.variants.empty()) fact("variants", list(loaded.contents.variants));
    for (const auto& animation : loaded.contents.animations)
        fact("animation", fmt::format("{}, {:.3g} s, {} channels", animation.name, animation.duration,
                                      animation.channels));
    fact("warnings", loaded.remarks.empty() ? "none" : "");
    ImGui::PushTextWrapPos();
    for (const std::string& remark : loaded.remarks)
        ImGui::BulletText("%s", in_plain_letters(remark).c_str());
    ImGui::PopTextWrapPos();
}

} // namespace sr::viewer
