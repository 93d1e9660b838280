#include "render/visibility/depth_maps.hpp"

#include "core/error.hpp"
#include "render/sampling.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace sr::render {
namespace {

using shadow::MapKind;
using shadow::MapView;

constexpr std::size_t bytes_per_map_texel = 4;
constexpr int min_map_size = 64;

/// A sequence of its own for each point of each light.
std::uint32_t map_seed(std::uint32_t seed, int light, int point) {
    return seed * 2654435769u + static_cast<std::uint32_t>(light) * 64u + static_cast<std::uint32_t>(point);
}

int texture_kind(MapKind kind) { // as shaders/interface/maps.glsl numbers them
    return kind == MapKind::perspective ? 0 : kind == MapKind::cube ? 1 : 2;
}

/// Of a half cube the faces at its sides show something on the front's side only.
void scissor_to_front(const MapView& view, int face, int size) {
    const int middle = size / 2 - 4; // and two texels beyond
    const int axis = face / 2;
    if (!view.is_half || axis == 2) {
        glDisable(GL_SCISSOR_TEST);
        return;
    }
    glEnable(GL_SCISSOR_TEST);
    if (axis == 0)
        glScissor(0, middle, size, size - middle);
    else
        glScissor(middle, 0, size - middle, size);
}

} // namespace

DepthMaps::DepthMaps(const GpuScene& scene, const MapOptions& options)
    : scene_(scene),
      stage_(*scene.visibility_backend()->shadow_map_scene()),
      points_per_light_(options.points),
      size_(options.size) {}

void DepthMaps::compile(ShaderLibrary& shaders) const {
    for (const auto* draws : {&scene_.opaque_draws(), &scene_.blended_draws()})
        for (const Draw& draw : *draws)
            if (draw.is_surface) shaders.mesh_program("caster.frag", caster_features(draw.features));
}

bool DepthMaps::has_extent(int light) const {
    return scene::has_extent(stage_.lights[static_cast<std::size_t>(light)]);
}

void DepthMaps::choose_middles() {
    for (int k = 0; k < static_cast<int>(stage_.lights.size()); ++k) {
        if (!has_extent(k)) continue;
        Point point;
        point.light = k;
        point.seed = map_seed(0, k, 63);
        point.on_emitter = scene::middle_of(stage_.lights[static_cast<std::size_t>(k)]);
        look_from(point, 0.5f); // askew, like most others
        middles_.push_back(point);
    }
    middle_count_ = count_;
}

void DepthMaps::choose_points(std::uint32_t sample_index, std::uint32_t seed, int first_light,
                              int end_light) {
    points_.clear();
    count_ = middle_count_;
    for (int k = first_light; k < end_light; ++k) {
        for (int i = 0; i < (has_extent(k) ? points_per_light_ : 1); ++i) {
            Point point;
            point.light = k;
            point.seed = map_seed(seed, k, i);
            const vec2 place = sobol_2d(sample_index, point.seed);
            const vec2 rest = sobol_2d(sample_index, ~point.seed); // independent of the former
            point.on_emitter =
                scene::sample_point(stage_.lights[static_cast<std::size_t>(k)], vec3(place, rest.x));
            look_from(point, 2.0f * pi * rest.y);
            points_.push_back(point);
        }
    }
}

void DepthMaps::look_from(Point& point, float roll) {
    const auto k = static_cast<std::size_t>(point.light);
    const auto& casters = scene_.visibility_backend()->casters().casters;
    point.view =
        shadow::view_from(point.on_emitter, stage_.lights[k], stage_.receivers[k], stage_.all, roll, size_);
    for (int face = 0; face < 6; ++face) {
        if (!point.view.has_face(face)) continue;
        for (std::size_t i = 0; i < casters.size(); ++i) {
            if (!is_in_maps(casters[i], point.light) || !may_see(point.view, face, stage_.casters[i]))
                continue;
            point.layers[static_cast<std::size_t>(face)] = static_cast<int>(count_++);
            break;
        }
    }
}

void DepthMaps::make_room() {
    GLint most = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &most);
    const auto bytes = [&] {
        return count_ * static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_)
               * bytes_per_map_texel;
    };
    while (bytes() > max_bytes && size_ > min_map_size) size_ /= 2;
    triangles_.bind(0);
    if (count_ <= static_cast<std::size_t>(most)) {
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32I, size_, size_, static_cast<GLsizei>(count_), 0,
                     GL_RED_INTEGER, GL_INT, nullptr);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MAX_LEVEL, 0);
        depth_.bind(0);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size_, size_, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                     nullptr);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, triangles_.id(), 0, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.id(), 0);
    }
    if (count_ > static_cast<std::size_t>(most) || glGetError() == GL_OUT_OF_MEMORY
        || glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        throw Error(
            fmt::format("{} depth maps of {}×{} texels are more than the driver takes", count_, size_, size_),
            "render with --visibility ray, or with fewer --map-points");
    room_ = count_;
}

void DepthMaps::draw(std::uint32_t sample_index, std::uint32_t seed, int first_light, int end_light,
                     ShaderLibrary& shaders) {
    if (middles_.empty()) choose_middles();
    choose_points(sample_index, seed, first_light, end_light);
    const bool has_middles = count_ <= room_;
    if (!has_middles) make_room();
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.id());
    glViewport(0, 0, size_, size_);
    glDisable(GL_BLEND);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    if (!has_middles) draw_maps(middles_, sample_index, shaders);
    draw_maps(points_, sample_index, shaders);
    glDisable(GL_SCISSOR_TEST);
    upload_points();
    triangles_.bind(map_triangles_unit);
    glBindSampler(map_triangles_unit, 0);
    table_.bind(map_points_unit);
}

void DepthMaps::draw_maps(const std::vector<Point>& points, std::uint32_t sample_index,
                          ShaderLibrary& shaders) {
    for (const Point& point : points)
        for (int face = 0; face < 6; ++face)
            if (point.layers[static_cast<std::size_t>(face)] >= 0)
                draw_face(point, face, sample_index, shaders);
}

void DepthMaps::draw_face(const Point& point, int face, std::uint32_t sample_index, ShaderLibrary& shaders) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, triangles_.id(), 0,
                              point.layers[static_cast<std::size_t>(face)]);
    scissor_to_front(point.view, face, size_);
    constexpr GLint nothing[4]{-1, -1, -1, -1};
    constexpr GLfloat farthest = 1.0f;
    glClearBufferiv(GL_COLOR, 0, nothing);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    const vec4 eye(point.view.origin, point.view.kind == MapKind::orthographic ? 0.0f : 1.0f);
    frame_data_.upload({clip_from_world(point.view, face), eye, sample_index, point.seed, point.light,
                        point.light + 1, vec2(static_cast<float>(size_))});
    const auto& casters = scene_.visibility_backend()->casters().casters;
    const bool passes =
        scene_.visibility_backend()->casters().passes_back_faces[static_cast<std::size_t>(point.light)];
    glCullFace(face % 2 == 0 ? GL_FRONT : GL_BACK); // faces along an axis show the world mirrored
    for (const auto* draws : {&scene_.opaque_draws(), &scene_.blended_draws()}) {
        for (const Draw& draw : *draws) {
            const auto instance = static_cast<std::size_t>(draw.instance);
            if (!draw.is_surface) continue;
            if (!is_in_maps(casters[instance], point.light)
                || !may_see(point.view, face, stage_.casters[instance]))
                continue;
            (passes && !draw.is_double_sided ? glEnable : glDisable)(GL_CULL_FACE);
            shaders.mesh_program("caster.frag", caster_features(draw.features)).use();
            scene_.draw(draw);
        }
    }
    glDisable(GL_CULL_FACE);
}

void DepthMaps::upload_points() {
    std::vector<vec4> texels(stage_.lights.size(), vec4(0.0f));
    const auto append = [&](const Point& point) {
        const scene::EmitterPoint& on = point.on_emitter;
        const auto layer = [&](std::size_t face) { return static_cast<float>(point.layers[face]); };
        texels.emplace_back(on.place, texture_kind(point.view.kind));
        texels.emplace_back(on.normal, on.extent);
        texels.emplace_back(point.view.origin, point.view.scale);
        texels.emplace_back(point.view.axes[0], layer(4));
        texels.emplace_back(point.view.axes[1], layer(5));
        texels.emplace_back(on.uv, point.seed & 0xffffu, point.seed >> 16);
        texels.emplace_back(layer(0), layer(1), layer(2), layer(3));
    };
    auto point = points_.begin();
    for (int k = 0; k < static_cast<int>(stage_.lights.size()); ++k) {
        const auto first = static_cast<float>(texels.size());
        int count = 0;
        for (; point != points_.end() && point->light == k; ++point, ++count) append(*point);
        const auto middle = std::ranges::find(middles_, k, &Point::light);
        if (middle != middles_.end()) append(*middle);
        texels[static_cast<std::size_t>(k)] = vec4(first, count, middle != middles_.end(), 0.0f);
    }
    table_.upload(texels, "render with --visibility ray");
}

} // namespace sr::render
