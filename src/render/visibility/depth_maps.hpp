#pragma once
// Depth maps from points on the emitters, new ones for every frame (--visibility map).
#include "render/film.hpp"
#include "render/gpu/blocks.hpp"
#include "render/gpu/gpu_scene.hpp"
#include "render/gpu/shader_library.hpp"

namespace sr::render {

inline constexpr int default_map_points = 2;
inline constexpr int default_map_size = 1024;

struct MapOptions {
    int points = default_map_points; // on each emitter of finite size that a frame has
    int size =
        default_map_size; // texels on a map's side; halved until all maps fit into DepthMaps::max_bytes
};

class DepthMaps {
public:
    /// The scene's occluders were made for Visibility::map.
    DepthMaps(const GpuScene& scene, const MapOptions& options);

    /// Compiles what draw() will use. @throws ShaderError
    void compile(ShaderLibrary& shaders) const;

    /// Chooses this sample's points on the lights [first, end), draws the maps and leaves them where
    /// visibility/map.glsl reads them. Binds a framebuffer and a frame's block of its own.
    /// @throws Error if the driver refuses so many maps.
    void draw(std::uint32_t sample_index, std::uint32_t seed, int first_light, int end_light,
              ShaderLibrary& shaders);

    int size() const { return size_; }                               // texels on a map's side
    std::size_t map_count() const { return count_; }                 // of the last frame
    static constexpr std::size_t max_bytes = std::size_t{256} << 20; // that all maps of a frame may take

private:
    /// A point's views, and the layer of each face, negative where nothing is seen.
    struct Point {
        int light = 0;
        std::uint32_t seed = 0;
        scene::EmitterPoint on_emitter;
        shadow::MapView view;
        std::array<int, 6> layers{-1, -1, -1, -1, -1, -1};
    };

    bool has_extent(int light) const;
    void choose_middles();
    void choose_points(std::uint32_t sample_index, std::uint32_t seed, int first_light, int end_light);
    void look_from(Point& point, float roll);
    void make_room();
    void draw_maps(const std::vector<Point>& points, std::uint32_t sample_index, ShaderLibrary& shaders);
    void draw_face(const Point& point, int face, std::uint32_t sample_index, ShaderLibrary& shaders);
    void upload_points();

    const GpuScene& scene_;
    const shadow::ShadowMapScene& stage_;
    int points_per_light_;
    int size_;
    std::size_t count_ = 0;
    std::size_t room_ = 0;       // layers that the texture has
    std::vector<Point> middles_; // of the lights with an extent; drawn once, in the first layers
    std::size_t middle_count_ = 0;
    std::vector<Point> points_; // of this frame
    gl::Texture triangles_{GL_TEXTURE_2D_ARRAY, "depth maps"};
    gl::Texture depth_{GL_TEXTURE_2D, "depth maps"};
    gl::Framebuffer framebuffer_{"depth maps"};
    BufferTexture table_{"the points on emitters", GL_RGBA32F};
    FrameData frame_data_;
};

} // namespace sr::render
