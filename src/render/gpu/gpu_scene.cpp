#include "render/gpu/gpu_scene.hpp"

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "gl/context.hpp"
#include "render/gpu/gpu_texture.hpp"
#include "render/gpu/light_table.hpp"
#include "scene/transform.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <deque>
#include <future>
#include <set>
#include <thread>
#include <tuple>
#include <utility>

namespace sr::render {
namespace {

// A mesh of so many triangles is finely meshed: shading it pixel by pixel saves more than looking up
// triangles costs.
constexpr int fine_triangles = 256;

/// A block array in one uniform buffer; each entry starts where GL allows a range to start.
template<class BlockType>
GLsizeiptr upload_blocks(const gl::Buffer& buffer, const std::vector<BlockType>& blocks) {
    GLint alignment = 1;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    const std::size_t stride = (sizeof(BlockType) + step - 1) / step * step;
    std::vector<std::byte> bytes(std::max<std::size_t>(1, blocks.size()) * stride);
    for (std::size_t i = 0; i < blocks.size(); ++i)
        std::memcpy(&bytes[i * stride], &blocks[i], sizeof(BlockType));
    glBindBuffer(GL_UNIFORM_BUFFER, buffer.id());
    glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    return static_cast<GLsizeiptr>(stride);
}

/// `is_body`: a closed mesh of glass.
ObjectBlock packed_object(const scene::Instance& instance, const GpuMesh& mesh, std::size_t first_triangle,
                          std::size_t object, int material, bool is_body) {
    const mat4& m = instance.world_from_object;
    return {m,
            mat4(scene::normal_transform(m)),
            vec4(scene::mirrors(m) ? -1.0f : 1.0f, scene::length_scale(m), is_body ? 1.0f : 0.0f, 0.0f),
            static_cast<std::int32_t>(first_triangle),
            static_cast<std::int32_t>(object),
            material,
            mesh.first_float(1),
            mesh.first_float(2),
            mesh.first_float(3),
            mesh.first_float(4),
            mesh.first_float(5)};
}

/// An image as textures use it: the same picture may be colours to one and data to another.
struct ImageUse {
    int image = 0;
    scene::ColorSpace color_space = scene::ColorSpace::linear;
    TexelLayout layout;
    PackedAlpha alpha_from;

    bool operator==(const ImageUse&) const = default;
};

TexelSource source_of(const scene::Scene& scene, const ImageUse& use) {
    const auto image_of = [&](int i) -> const scene::TextureImage& {
        return scene.images[static_cast<std::size_t>(i)];
    };
    if (use.alpha_from.image < 0) return image_of(use.image);
    return {image_of(use.image), image_of(use.alpha_from.image), use.alpha_from.channel};
}

/// For each texture, whether a material compares its alpha with a cutoff.
std::vector<bool> alpha_is_compared(const scene::Scene& scene) {
    std::vector<bool> is_compared(scene.textures.size(), false);
    for (const scene::Material& material : scene.materials)
        if (material.alpha_mode == scene::AlphaMode::mask && material.base_color_texture.is_present())
            is_compared[static_cast<std::size_t>(material.base_color_texture.texture)] = true;
    return is_compared;
}

/// For each image, the channels that materials read of it, as TexelLayout has them.
std::vector<unsigned> channels_in_use(const scene::Scene& scene) {
    std::vector<unsigned> channels(scene.images.size(), 0);
    for (const scene::Material& material : scene.materials)
        for (const scene::TextureInput& input : scene::texture_inputs) {
            const int texture = (material.*input.member).texture;
            if (texture < 0) continue;
            const int image = scene.textures[static_cast<std::size_t>(texture)].image;
            for (unsigned c = 0; c < 4; ++c)
                if (input.channels.find("rgba"[c]) != std::string_view::npos)
                    channels[static_cast<std::size_t>(image)] |= 1u << c;
        }
    return channels;
}

/// The mean of the triangles' corners: it goes with the vertices wherever an affine transform takes them, so
/// that a transform worked into them leaves the order of blended instances alone. (The centre of their box
/// does not.)
vec3 center_of(const scene::Mesh& mesh, const mat4& world_from_object) {
    glm::dvec3 sum(0.0);
    for (const std::uint32_t index : mesh.indices) sum += glm::dvec3(mesh.positions[index]);
    const glm::dvec3 mean = sum / static_cast<double>(std::max<std::size_t>(1, mesh.indices.size()));
    return vec3(glm::dmat4(world_from_object) * glm::dvec4(mean, 1.0));
}

} // namespace

GpuScene::GpuScene(const scene::Scene& scene, std::span<const scene::Light> lights, Visibility visibility,
                   bool has_energy_compensation, TextureChannels channels)
    : visibility_(visibility), has_energy_compensation_(has_energy_compensation) {
    upload_textures(scene, channels);
    update(scene, lights);
}

void GpuScene::update(const scene::Scene& scene, std::span<const scene::Light> lights) {
    require(image_of_texture_.size() == scene.textures.size(), "a scene keeps its textures");
    relight(scene, lights, 0, true);
}

void GpuScene::relight(const scene::Scene& scene, std::span<const scene::Light> lights,
                       std::size_t first_mesh, bool casters_change) {
    meshes_.erase(meshes_.begin() + static_cast<std::ptrdiff_t>(std::min(first_mesh, meshes_.size())),
                  meshes_.end());
    meshes_.reserve(scene.meshes.size());
    for (std::size_t i = meshes_.size(); i < scene.meshes.size(); ++i) meshes_.emplace_back(scene.meshes[i]);
    upload_objects(scene);
    upload_materials(scene);
    try {
        upload_lights(scene, lights);
    } catch (...) { // textures may be counted that are not on the GPU
        emission_maps_ = {};
        environments_ = {};
        throw;
    }
    list_draws(scene, lights);
    if (casters_change || visibility_ == Visibility::map)
        cast_shadows(scene, lights); // maps know where lights are
}

void GpuScene::cast_shadows(const scene::Scene& scene, std::span<const scene::Light> lights) {
    visibility_backend_.reset();
    if (visibility_ != Visibility::none && !lights.empty())
        visibility_backend_ =
            std::make_unique<VisibilityBackend>(scene, lights, visibility_, !blended_.empty());
}

void GpuScene::upload_textures(const scene::Scene& scene, TextureChannels kept) {
    const bool driver_is_inexact =
        gl::is_software_renderer(reinterpret_cast<const char*>(glGetString(GL_RENDERER)));
    const std::vector<bool> is_compared = alpha_is_compared(scene);
    const std::vector<unsigned> channels = channels_in_use(scene);
    packing_ = pack_textures(scene, driver_is_inexact && kept == TextureChannels::in_use);
    std::vector<ImageUse> uses;
    std::vector<scene::Sampler> made;
    for (std::size_t i = 0; i < scene.textures.size(); ++i) {
        const scene::Texture& texture = scene.textures[i];
        const auto index = static_cast<std::size_t>(texture.image);
        const TexelNeeds needs{driver_is_inexact, is_compared[i],
                               kept == TextureChannels::all ? all_channels : channels[index]};
        ImageUse use{texture.image, texture.color_space,
                     texel_layout(scene.images[index], texture.color_space, needs), packing_.alpha_from[i]};
        if (use.alpha_from.image >= 0 && use.layout.format == TexelFormat::float16)
            use.layout.format = TexelFormat::float16_exact_alpha;
        const auto image = std::find(uses.begin(), uses.end(), use);
        image_of_texture_.push_back(packing_.is_needed[i] ? static_cast<int>(image - uses.begin()) : -1);
        if (image == uses.end() && packing_.is_needed[i]) uses.push_back(use);
        const auto sampler = std::find(made.begin(), made.end(), texture.sampler);
        sampler_of_texture_.push_back(static_cast<int>(sampler - made.begin()));
        if (sampler == made.end()) {
            made.push_back(texture.sampler);
            samplers_.push_back(sampler_object(texture.sampler));
        }
    }
    // Threads halve the images, a few ahead of the upload: all at once would take their memory at once.
    const std::size_t max_ahead = std::max(2u, std::thread::hardware_concurrency());
    std::deque<std::future<std::vector<MipLevel>>> ahead;
    for (std::size_t i = 0, begun = 0; i < uses.size(); ++i) {
        for (; begun < uses.size() && begun < i + max_ahead; ++begun)
            ahead.push_back(started([&scene, use = uses[begun]] {
                return lower_mip_levels(source_of(scene, use), use.color_space, use.layout);
            }));
        images_.push_back(
            upload(source_of(scene, uses[i]), uses[i].layout, [&] { return ahead.front().get(); }));
        ahead.pop_front();
    }
    for (const scene::MeasuredBrdf& measured : scene.measured) measured_.push_back(upload(measured));
}

void GpuScene::upload_objects(const scene::Scene& scene) {
    std::vector<ObjectBlock> blocks;
    std::size_t triangles = 0; // so far, as shadow::Casters counts them
    for (const scene::Instance& instance : scene.instances) {
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        const bool is_body = scene::is_body_of_glass(mesh, scene.materials[mesh.material]);
        blocks.push_back(packed_object(instance, meshes_[instance.mesh], triangles, blocks.size(),
                                       mesh.material, is_body));
        triangles += mesh.indices.size() / 3;
    }
    object_stride_ = upload_blocks(objects_, blocks);
}

void GpuScene::upload_materials(const scene::Scene& scene) {
    std::vector<MaterialBlock> blocks;
    textures_of_material_.clear();
    measured_of_material_.clear();
    for (const scene::Material& material : scene.materials) {
        blocks.push_back(pack_material(material, scene.measured));
        measured_of_material_.push_back(material.measured);
        std::array<int, slot_count> textures{};
        std::ranges::transform(
            scene::texture_inputs, textures.begin(), [&](const scene::TextureInput& input) {
                const int texture = (material.*input.member).texture;
                return texture >= 0 && image_of_texture_[static_cast<std::size_t>(texture)] < 0 ? -1
                                                                                                : texture;
            });
        textures_of_material_.push_back(textures);
    }
    material_stride_ = upload_blocks(materials_, blocks);
}

void GpuScene::upload_lights(const scene::Scene& scene, std::span<const scene::Light> lights) {
    const std::size_t before = emission_maps_.texel_count();
    const std::size_t environments_before = environments_.texel_count();
    light_table_.upload(pack_lights(scene, lights, emission_maps_, environments_),
                        "use fewer emissive triangles");
    if (environments_before == 0 || environments_.texel_count() != environments_before)
        environment_texels_.fill<vec4>(
            environments_.texel_count(), [&](std::span<vec4> texels) { environments_.write_texels(texels); },
            "use a smaller environment");
    visible_environments_.clear();
    for (std::size_t k = 0; k < lights.size(); ++k)
        if (const auto* light = std::get_if<scene::EnvironmentLight>(&lights[k]); light && light->is_visible)
            visible_environments_.push_back(static_cast<int>(k));
    if (before == 0 || emission_maps_.texel_count() != before)
        emission_texels_.fill<std::uint64_t>(
            emission_maps_.texel_count(),
            [&](std::span<std::uint64_t> texels) { emission_maps_.write_texels(scene, texels); },
            "use smaller emissive textures");
    light_count_ = static_cast<int>(lights.size());
    rays_per_light_ = light_features(lights).rays_per_light;
    rays_to_light_.clear();
    for (const scene::Light& light : lights)
        rays_to_light_.push_back(light_features({&light, 1}).rays_per_light);
}

void GpuScene::bind_lights() const {
    light_table_.bind(light_table_unit);
    emission_texels_.bind(emission_texels_unit);
    environment_texels_.bind(environment_texels_unit);
    ltc_texture_.bind(ltc_table_unit);
    glBindSampler(ltc_table_unit, 0);
    if (visibility_backend_) visibility_backend_->bind();
}

void GpuScene::list_draws(const scene::Scene& scene, std::span<const scene::Light> lights) {
    Features lit = light_features(lights);
    lit.has_energy_compensation = has_energy_compensation_;
    lit.has_transparent_casters = has_transparent_casters(scene);
    lit.has_tinted_casters = has_tinted_casters(scene);
    GLint texture_units = 0;
    glGetIntegerv(GL_MAX_TEXTURE_IMAGE_UNITS, &texture_units);
    opaque_.clear();
    blended_.clear();
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Mesh& mesh = scene.meshes[instance.mesh];
        if (mesh.is_empty() || instance.is_hidden) continue;
        Draw draw;
        draw.mesh = instance.mesh;
        draw.instance = static_cast<int>(i);
        draw.material = mesh.material;
        draw.features = shading_features(scene, mesh, lit);
        draw.features.has_packed_metallic_roughness = packing_.packs(mesh.material);
        require_texture_units(draw.features, scene.materials[mesh.material].name, texture_units);
        draw.mirrors = scene::mirrors(instance.world_from_object);
        draw.is_surface = mesh.is_surface();
        draw.is_double_sided = !draw.is_surface || scene.materials[mesh.material].is_double_sided;
        if (draw.features.is_blended || draw.features.has(scene::Layer::transmission)) {
            draw.center = center_of(mesh, instance.world_from_object);
            blended_.push_back(draw);
            draw.features.is_opaque_part = true;
            if (blended_.back().features.may_have_opaque_part()) opaque_.push_back(draw);
        } else {
            opaque_.push_back(draw);
        }
    }
    std::stable_sort(opaque_.begin(), opaque_.end(), [](const Draw& a, const Draw& b) {
        return std::tie(a.features, a.material) < std::tie(b.features, b.material);
    });
    number_draws(scene, texture_units);
}

/// Numbers the opaque draws that are finely meshed, while there are numbers.
void GpuScene::number_draws(const scene::Scene& scene, int texture_units) {
    int number = 0;
    for (Draw& draw : opaque_) {
        const GpuMesh& mesh = meshes_[draw.mesh];
        if (number == max_numbered_draws || mesh.triangle_count() < fine_triangles || !draw.is_surface
            || static_cast<std::size_t>(mesh.float_count()) > max_floats_
            || !has_room_for_mesh(draw.features, texture_units))
            continue;
        draw.number = ++number;
        draw.world_from_object = scene.instances[draw.instance].world_from_object;
        for (const vec3 position : scene.meshes[draw.mesh].positions)
            draw.bounds.extend(vec3(draw.world_from_object * vec4(position, 1.0f)));
    }
}

void GpuScene::bind_material(int material) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, material_block, materials_.id(), material * material_stride_,
                      sizeof(MaterialBlock));
    if (measured_of_material_[material] >= 0) {
        measured_[measured_of_material_[material]].bind(measured_unit);
        glBindSampler(measured_unit, 0);
    }
    for (unsigned slot = 0; slot < slot_count; ++slot) {
        const int texture = textures_of_material_[material][slot];
        if (texture < 0) continue;
        images_[image_of_texture_[texture]].bind(slot);
        glBindSampler(slot, samplers_[sampler_of_texture_[texture]].id());
    }
}

int GpuScene::most_rays(int lights) const {
    int most = 0, sum = 0;
    for (std::size_t k = 0; k < rays_to_light_.size(); ++k) {
        sum += rays_to_light_[k];
        if (k >= static_cast<std::size_t>(lights))
            sum -= rays_to_light_[k - static_cast<std::size_t>(lights)];
        most = std::max(most, sum);
    }
    return most;
}

std::size_t GpuScene::feature_set_count() const {
    std::set<Features> sets;
    for (const auto* draws : {&opaque_, &blended_})
        for (const Draw& draw : *draws) sets.insert(draw.features);
    return sets.size();
}

void GpuScene::bind(const Draw& draw) const {
    glBindBufferRange(GL_UNIFORM_BUFFER, object_block, objects_.id(), draw.instance * object_stride_,
                      sizeof(ObjectBlock));
    bind_material(draw.material);
    glFrontFace(draw.mirrors ? GL_CW : GL_CCW);
}

void GpuScene::draw(const Draw& draw) const {
    bind(draw);
    meshes_[draw.mesh].draw();
}

void GpuScene::draw(const Draw& draw, const TriangleSelection& triangles) const {
    bind(draw);
    meshes_[draw.mesh].draw(triangles);
}

void GpuScene::show_arrays(const Draw& draw) const {
    meshes_[draw.mesh].show_arrays(mesh_floats_, mesh_floats_unit, mesh_indices_, mesh_indices_unit);
}

void GpuScene::draw_triangle(const Draw& draw, int triangle) const {
    meshes_[draw.mesh].draw_triangle(triangle);
}

} // namespace sr::render
