// Edits that the driver has no room for: they are taken back, and the scene is lit as before.
#include "core/error.hpp"
#include "render/gpu/light_table.hpp"
#include "render/renderer.hpp"
#include "support/address.hpp"
#include "support/gl.hpp"
#include "viewer/view/scene_view.hpp"

#include <glad/gl.h>

using namespace sr;
using namespace sr::viewer;
using sr::testing::Test;

namespace {

const std::string spheres = STERADIAN_SCENES "/spheres.gltf";
constexpr int picture_side = 24; // of pictures [pixels]

/// Lowers the size of a buffer texture that the driver takes, while it lives.
class LowLimit {
public:
    explicit LowLimit(std::size_t texels) {
        most = static_cast<GLint>(texels);
        driver = glad_glGetIntegerv;
        glad_glGetIntegerv = answer;
    }
    ~LowLimit() { glad_glGetIntegerv = driver; }
    LowLimit(const LowLimit&) = delete;
    LowLimit& operator=(const LowLimit&) = delete;

private:
    static void GLAD_API_PTR answer(GLenum name, GLint* value) {
        driver(name, value);
        if (name == GL_MAX_TEXTURE_BUFFER_SIZE) *value = most;
    }
    static inline GLint most = 0;
    static inline PFNGLGETINTEGERVPROC driver = nullptr;
};

/// Texels of the table of emitters.
std::size_t table_size(const scene::RenderScene& stage) {
    render::EmissionMaps maps;
    render::EnvironmentTexels environments;
    return render::pack_lights(stage.scene, stage.lights, maps, environments).size();
}

std::vector<float> picture_of(const SceneView& view) {
    render::RenderOptions options = render_options({}, picture_side, picture_side);
    options.samples = 1;
    render::Renderer renderer(view.gpu(), view.stage().scene.cameras.front(), options);
    renderer.add_sample();
    return renderer.read_film().pixels;
}

SceneView shown_scene(const Options& options) {
    LoadedScene loaded = load_scene(spheres, options, 1.0f);
    const scene::Camera camera = loaded.stage.scene.cameras.front();
    return {std::move(loaded), options, camera, picture_side, picture_side};
}

const Test refused_emission("unit.viewer.refused_edits.a_large_mesh_as_a_light_is_taken_back", [] {
    sr::testing::context();
    for (const render::Visibility visibility : {render::Visibility::none, render::Visibility::ray}) {
        Options options;
        options.visibility = visibility;
        SceneView view = shown_scene(options);
        LightEditor& lights = view.lights();
        const std::size_t count = lights.entries().size(), last = lights.material_count() - 1;
        lights.brighten(0, 2.0f);
        view.relight(false);
        const std::vector<float> before = picture_of(view);
        {
            const LowLimit limit(table_size(view.stage()));
            lights.begin_step();
            lights.set_emission(last, vec3(100.0f));
            EXPECT_THROW(view.relight(true), Error);
        }
        EXPECT_EQ(lights.entries().size(), count);
        EXPECT_EQ(picture_of(view), before);
        EXPECT_FALSE(lights.redo()) << "what cannot be shown is no edit";
        EXPECT_TRUE(lights.undo()) << "the edit before is still there";
        EXPECT_FALSE(lights.undo());
        view.relight(false);
        EXPECT_NE(picture_of(view), before);
        lights.begin_step();
        lights.set_emission(last, vec3(100.0f)); // another driver takes it
        view.relight(true);
        EXPECT_EQ(lights.entries().size(), count + 1);
    }
});

const Test refused_showing("unit.viewer.refused_edits.an_object_that_cannot_be_shown_stays_hidden", [] {
    sr::testing::context();
    Options options;
    options.visibility = render::Visibility::none;
    SceneView view = shown_scene(options);
    const scene::Scene& scene = view.stage().scene;
    const scene::Instance& object = scene.instances[view.loaded().base.instances - 1];
    const std::set<ObjectId> hidden{{object.node, object.mesh}};
    const auto material =
        static_cast<std::size_t>(scene.meshes[static_cast<std::size_t>(object.mesh)].material);
    view.hide(hidden);
    view.relight(true);
    const LowLimit limit(table_size(view.stage()));
    view.lights().set_emission(material, vec3(100.0f));
    view.relight(true); // it is hidden, and emits nothing
    const std::vector<float> before = picture_of(view);
    view.hide({});
    EXPECT_THROW(view.relight(true), Error);
    EXPECT_EQ(view.loaded().hidden, hidden);
    EXPECT_EQ(picture_of(view), before);
    EXPECT_TRUE(view.lights().undo()) << "the edit itself could be shown";
});

} // namespace
