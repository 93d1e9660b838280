#include "scene/prepare.hpp"

#include "core/error.hpp"
#include "scene/look_at.hpp"
#include "scene/own_light.hpp"
#include "scene/transform.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace sr::scene {
namespace {

// Emitters.

using Triangle = std::array<vec3, 3>;

/// The corner of a triangle at which its edges are perpendicular; absent if there is none.
std::optional<int> right_angle(const Triangle& t) {
    for (int i = 0; i < 3; ++i) {
        const vec3 a = t[(i + 1) % 3] - t[i];
        const vec3 b = t[(i + 2) % 3] - t[i];
        const float lengths = glm::length(a) * glm::length(b);
        if (lengths > 0.0f && std::abs(glm::dot(a, b)) <= 1e-3f * lengths) return i;
    }
    return std::nullopt;
}

bool is_near(vec3 a, vec3 b, float tolerance) { return glm::distance(a, b) <= tolerance; }

/// The rectangle that two triangles make: both have a right angle, they share the hypotenuse, and they face
/// the same way. Counter-clockwise triangles give a rectangle whose front is theirs.
std::optional<RectangleLight> rectangle(const Triangle& a, const Triangle& b) {
    const auto i = right_angle(a);
    const auto j = right_angle(b);
    if (!i || !j) return std::nullopt;
    const vec3 corner = a[*i];
    const vec3 u = a[(*i + 1) % 3] - corner;
    const vec3 v = a[(*i + 2) % 3] - corner;
    const float tolerance = 1e-3f * std::min(glm::length(u), glm::length(v));
    // Going round the same way, b's right angle lies opposite and its next corner is a's last.
    if (!is_near(b[*j], corner + u + v, tolerance) || !is_near(b[(*j + 1) % 3], corner + v, tolerance)
        || !is_near(b[(*j + 2) % 3], corner + u, tolerance))
        return std::nullopt;
    RectangleLight light;
    light.center = corner + 0.5f * (u + v);
    light.half_u = 0.5f * u;
    light.half_v = 0.5f * v;
    return light;
}

/// All triangles in world space with an area; `map` says where a texture is read, null if there is none.
std::vector<MeshLight::Triangle> triangles_of(const Mesh& mesh, const mat4& world_from_object,
                                              const TextureSlot* map) {
    const bool is_mirrored = mirrors(world_from_object);
    std::vector<MeshLight::Triangle> triangles;
    for (std::size_t t = 0; t + 2 < mesh.indices.size(); t += 3) {
        MeshLight::Triangle triangle{};
        for (std::size_t i = 0; i < 3; ++i) {
            const std::uint32_t vertex =
                mesh.indices[t + (is_mirrored ? 2 - i : i)]; // keeps the front in front
            triangle.corners[i] = vec3(world_from_object * vec4(mesh.positions[vertex], 1.0f));
            if (!map) continue;
            const std::vector<vec2>& uv = mesh.texcoords[map->texcoord];
            if (!uv.empty()) triangle.uv[i] = vec2(map->uv_transform * vec3(uv[vertex], 1.0f));
        }
        const auto& c = triangle.corners;
        const float doubled_area = glm::length(glm::cross(c[1] - c[0], c[2] - c[0]));
        if (doubled_area > 0.0f && std::isfinite(doubled_area)) triangles.push_back(triangle);
    }
    return triangles;
}

/// All rectangles of a mesh in world space; absent if a triangle is left over.
std::optional<std::vector<RectangleLight>> rectangles_of(const Mesh& mesh, const mat4& world_from_object) {
    // Lamps have few triangles; a sculpture that glows is not made of rectangles, and pairing it would take
    // long.
    constexpr std::size_t max_triangles = 256;
    const std::size_t count = mesh.indices.size() / 3;
    if (count == 0 || count % 2 != 0 || count > max_triangles) return std::nullopt;
    std::vector<Triangle> triangles;
    for (const MeshLight::Triangle& triangle : triangles_of(mesh, world_from_object, nullptr))
        triangles.push_back(triangle.corners);
    std::vector<RectangleLight> found;
    while (!triangles.empty()) {
        const Triangle first = triangles.back();
        triangles.pop_back();
        bool paired = false;
        for (std::size_t t = 0; t < triangles.size() && !paired; ++t) {
            if (const auto light = rectangle(first, triangles[t])) {
                found.push_back(*light);
                triangles.erase(triangles.begin() + static_cast<std::ptrdiff_t>(t));
                paired = true;
            }
        }
        if (!paired) return std::nullopt;
    }
    return found;
}

MeshLight mesh_light(const Mesh& mesh, const mat4& world_from_object, const Material& material) {
    MeshLight light;
    const bool is_textured = material.emission_texture.is_present();
    light.triangles =
        triangles_of(mesh, world_from_object, is_textured ? &material.emission_texture : nullptr);
    light.L = material.emission;
    light.is_two_sided = material.is_double_sided;
    light.texture = material.emission_texture.texture;
    return light;
}

void append_emitters_of(const Instance& instance, const Scene& scene, std::vector<Light>& lights) {
    const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
    const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
    if (instance.is_hidden || !mesh.is_surface() || !material.is_emissive() || material.is_unlit) return;
    const std::string& name = instance.name.empty() ? mesh.name : instance.name;
    auto rectangles = material.emission_texture.is_present()
                          ? std::nullopt
                          : rectangles_of(mesh, instance.world_from_object);
    if (!rectangles) {
        MeshLight light = mesh_light(mesh, instance.world_from_object, material);
        light.name = name;
        if (!light.triangles.empty()) lights.emplace_back(std::move(light));
        return;
    }
    for (RectangleLight& light : *rectangles) {
        light.name = name;
        light.L = material.emission;
        light.is_two_sided = material.is_double_sided;
        lights.emplace_back(std::move(light));
    }
}

// The rigs.

struct Softbox {
    const char* name;
    vec3 direction; // from the subject: to the right of the camera, up, towards the camera
    float distance; // in radii of the subject
    float edge;     // in radii of the subject
    float E;        // at the subject's centre, facing the softbox [lx]
};

constexpr std::array<Softbox, 3> softboxes{{
    {"key", {-0.8f, 0.9f, 0.9f}, 4.0f, 4.0f, 1000.0f},
    {"fill", {1.0f, 0.1f, 0.5f}, 4.0f, 6.0f, 500.0f},
    {"rim", {0.4f, 0.9f, -0.8f}, 4.0f, 4.0f, 800.0f},
}};

/// A panel on the sphere of directions, the camera at azimuth 0 and its right at 90° [degrees].
struct Panel {
    float azimuth, elevation; // of its middle
    float width, height;
    float edge; // over which it fades
    float L;    // relative to the others
};

constexpr std::array<Panel, 5> panels{{
    {-48.0f, 38.0f, 66.0f, 46.0f, 10.0f, 3.4f}, // key
    {62.0f, 12.0f, 44.0f, 74.0f, 14.0f, 1.3f},  // fill
    {-146.0f, 28.0f, 22.0f, 84.0f, 8.0f, 3.0f}, // strips
    {142.0f, 28.0f, 26.0f, 84.0f, 8.0f, 3.4f},
    {0.0f, 90.0f, 720.0f, 56.0f, 16.0f, 1.5f}, // ceiling
}};

/// From 0 to 1 as x goes from -0.5 to 0.5, with no kink.
float soft_step(float x) {
    const float t = std::clamp(x + 0.5f, 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

float studio_radiance(vec3 w) {
    const float azimuth = glm::degrees(std::atan2(w.x, w.z)), elevation = glm::degrees(std::asin(w.y));
    float L = glm::mix(0.22f, 0.62f, soft_step(0.5f * w.y)); // floor to ceiling
    for (const Panel& panel : panels) {
        const float around = std::abs(std::remainder(azimuth - panel.azimuth, 360.0f));
        const float along = std::abs(elevation - panel.elevation);
        L += panel.L * soft_step((0.5f * panel.width - around) / panel.edge)
             * soft_step((0.5f * panel.height - along) / panel.edge);
    }
    return L;
}

/// [cd/m²]
EnvironmentMap studio_map() {
    constexpr int width = 256, height = 128;
    const vec3 n = glm::normalize(vec3(0.0f, 0.35f, 1.0f)); // of the white that is 1
    std::vector<vec3> texels;
    double E = 0.0;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            const vec3 w = EnvironmentMap::direction_of(
                {(static_cast<float>(i) + 0.5f) / width, (static_cast<float>(j) + 0.5f) / height});
            texels.emplace_back(studio_radiance(w));
            const double solid_angle = 2.0 * pi * pi / (width * height) * std::sqrt(1.0 - w.y * w.y);
            E += solid_angle * std::max(glm::dot(n, w), 0.0f) * texels.back().x;
        }
    }
    for (vec3& L : texels) L *= static_cast<float>(pi / E);
    return {width, height, std::move(texels)};
}

// The camera.

/// Returns the support of the scene in a direction: max p·direction over all vertices.
float reach(const Scene& scene, vec3 direction) {
    float farthest = -std::numeric_limits<float>::infinity();
    for (const Instance& instance : scene.instances) {
        const mat4& m = instance.world_from_object;
        const vec3 in_object = glm::transpose(mat3(m)) * direction;
        const float shift = glm::dot(vec3(m[3]), direction);
        for (const vec3 position : scene.meshes[instance.mesh].positions)
            farthest = std::max(farthest, glm::dot(position, in_object) + shift);
    }
    return farthest;
}

/// Where the eye is along one axis of the picture, and how far back it must be, for the planes that bound the
/// picture at ±tangent to touch the scene on both sides.
struct Fit {
    float along;
    float back;
};

Fit fitted(const Scene& scene, vec3 axis, vec3 back, float tangent) {
    const float plus = reach(scene, axis + tangent * back);
    const float minus = reach(scene, -axis + tangent * back);
    return {0.5f * (plus - minus), 0.5f * (plus + minus) / tangent};
}

// The scene as a whole.

/// Returns the number that identifies the camera at this place of Scene::cameras: its own, or else the place.
int number_of(const Scene& scene, std::size_t place) {
    const int number = scene.cameras[place].number;
    return number >= 0 ? number : static_cast<int>(place);
}

std::string cameras_of(const Scene& scene) {
    std::string names;
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        names += fmt::format("{} '{}', ", number_of(scene, i), scene.cameras[i].name);
    return names + "auto, or a view: eye=X,Y,Z;target=X,Y,Z";
}

/// A scene of nothing but the corners of a box.
Scene corners_of(const Bounds& box) {
    Scene scene;
    Mesh& mesh = scene.meshes.emplace_back();
    for (int corner = 0; corner < 8; ++corner)
        mesh.positions.emplace_back((corner & 1) != 0 ? box.max.x : box.min.x,
                                    (corner & 2) != 0 ? box.max.y : box.min.y,
                                    (corner & 4) != 0 ? box.max.z : box.min.z);
    scene.instances.emplace_back();
    return scene;
}

/// True if almost nothing of what the camera sees would be lit.
bool is_dark(const RenderScene& stage, const Scene& scene, float aspect_ratio) {
    if (stage.lights.empty()) return true;
    const auto share = lit_share(scene, stage.lights, stage.camera, aspect_ratio);
    return share && *share < min_lit_share(scene);
}

/// True if the scene has a surface that is seen only if it is lit.
bool needs_light(const Scene& scene) {
    return std::ranges::any_of(scene.instances, [&](const Instance& instance) {
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        return !is_unlit(mesh, scene.materials[static_cast<std::size_t>(mesh.material)]);
    });
}

void add_rig(RenderScene& stage, const Scene& scene, const std::string& name, const PrepareOptions& options) {
    const bool judges = options.rig == Rig::automatic || options.rig == Rig::none;
    const bool dark = judges && needs_light(scene) && is_dark(stage, scene, options.aspect_ratio);
    stage.rig = options.rig != Rig::automatic ? options.rig : dark ? Rig::studio : Rig::none;
    if (stage.rig == Rig::studio) stage.lights.emplace_back(studio(stage.camera));
    if (stage.rig == Rig::softboxes)
        for (RectangleLight& light : softbox_rig(options.extent.value_or(bounds_of(scene)), stage.camera))
            stage.lights.emplace_back(std::move(light));
    if (!dark) return;
    const std::string why = stage.lights.size() == (stage.rig == Rig::studio ? 1u : 0u)
                                ? "no lamp in this file"
                                : "the file's own light leaves it almost dark";
    stage.remarks.push_back(
        stage.rig == Rig::studio
            ? fmt::format("{}: {}: a studio lights it (--rig none leaves it so)", name, why)
            : fmt::format("{}: {}: almost nothing is lit (--rig studio lights it)", name, why));
}

/// Says what pictures of glass leave out.
void remark_on_glass(const Scene& scene, const std::string& name, std::vector<std::string>& remarks) {
    const auto count = std::ranges::count_if(scene.materials, &Material::is_transmissive);
    if (count > 0)
        remarks.push_back(fmt::format("{}: light goes straight through the glass of {} material{}: it is not "
                                      "refracted, and rough glass does not blur it",
                                      name, count, count == 1 ? "" : "s"));
}

/// Says what pictures of points and lines leave out.
void remark_on_lines(const Scene& scene, const std::string& name, std::vector<std::string>& remarks) {
    const auto count =
        std::ranges::count_if(scene.meshes, [](const Mesh& mesh) { return !mesh.is_surface(); });
    if (count > 0)
        remarks.push_back(fmt::format("{}: {} mesh{} points or lines: they are drawn 3 pixels wide at every "
                                      "distance, and cast no shadows",
                                      name, count, count == 1 ? " is" : "es are"));
}

} // namespace

std::vector<Light> emitters_of(const Scene& scene) {
    std::vector<Light> lights = scene.lights;
    for (const Instance& instance : scene.instances) append_emitters_of(instance, scene, lights);
    return lights;
}

std::vector<Light> assign_emitters(Scene& scene) {
    std::vector<Light> lights = scene.lights;
    for (Instance& instance : scene.instances) {
        instance.emits_as.first = static_cast<int>(lights.size());
        append_emitters_of(instance, scene, lights);
        instance.emits_as.end = static_cast<int>(lights.size());
    }
    return lights;
}

int add_light_surfaces(Scene& scene) {
    const std::size_t before = scene.instances.size();
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        std::optional<LightSurface> surface = surface_of(scene.lights[i]);
        if (!surface) continue;
        const std::string name = name_of(scene.lights[i]);
        Material material;
        material.name = name;
        material.base_color = vec4(0.0f, 0.0f, 0.0f, 1.0f);
        material.metallic = 0.0f;
        material.specular = 0.0f;
        material.emission = surface->L;
        material.emission_texture.texture = surface->texture;
        material.is_double_sided = surface->is_two_sided;
        surface->mesh.name = name;
        surface->mesh.material = static_cast<int>(scene.materials.size());
        scene.materials.push_back(material);
        scene.meshes.push_back(std::move(surface->mesh));
        scene.instances.push_back({static_cast<int>(scene.meshes.size()) - 1, mat4(1.0f), name});
        scene.instances.back().emits_as = {static_cast<int>(i), static_cast<int>(i) + 1};
    }
    return static_cast<int>(scene.instances.size() - before);
}

EnvironmentLight studio(const Camera& camera) {
    static const auto map = std::make_shared<const EnvironmentMap>(studio_map());
    EnvironmentLight light;
    light.name = "studio";
    light.map = map;
    const vec3 back = glm::cross(vec3(camera.world_from_camera[0]), vec3(0.0f, 1.0f, 0.0f));
    light.rotation = std::atan2(back.x, back.z); // the map's +Z is where the camera stands
    light.is_visible = false;
    light.passes_back_faces = true;
    return light;
}

std::vector<RectangleLight> softbox_rig(const Bounds& subject, const Camera& camera) {
    const float radius = std::max(subject.radius(), 1e-6f); // a subject without extent still gets lights
    const mat3 world_from_camera(camera.world_from_camera);
    const vec3 up = world_from_camera[1];
    std::vector<RectangleLight> lights;
    for (const Softbox& softbox : softboxes) {
        const vec3 outward = glm::normalize(world_from_camera * softbox.direction);
        const vec3 u = glm::normalize(glm::cross(up, -outward));
        const vec3 v = glm::cross(-outward, u);
        const float half_edge = 0.5f * softbox.edge * radius;
        RectangleLight light;
        light.name = softbox.name;
        light.center = subject.center() + softbox.distance * radius * outward;
        light.half_u = half_edge * u;
        light.half_v = half_edge * v;
        // E = L A / d² on the axis, for an emitter that is small against its distance; "about" is all that is
        // promised.
        light.L = vec3(softbox.E * softbox.distance * softbox.distance / (softbox.edge * softbox.edge));
        light.is_visible = false;
        light.passes_back_faces = true;
        lights.push_back(light);
    }
    return lights;
}

Camera framing_camera(const Scene& scene, float aspect_ratio) {
    constexpr float yfov = 0.6f;    // [rad], about a 40 mm lens on a full frame
    constexpr float margin = 1.08f; // air around the subject
    const Bounds bounds = bounds_of(scene);
    const float radius = bounds.is_empty() ? 1.0f : std::max(bounds.radius(), 1e-6f);

    const vec3 back = glm::normalize(vec3(0.5f, 0.35f, 1.0f)); // from the subject to the camera
    const vec3 right = glm::normalize(glm::cross(vec3(0.0f, 1.0f, 0.0f), back));
    const vec3 up = glm::cross(back, right);

    const float tan_y = std::tan(0.5f * yfov) / margin;
    vec3 eye = 5.0f * back;
    float nearest = 4.0f, farthest = 6.0f;
    if (!bounds.is_empty()) {
        const Fit x = fitted(scene, right, back, tan_y * aspect_ratio);
        const Fit y = fitted(scene, up, back, tan_y);
        const float front = reach(scene, back);
        const float distance = std::max({x.back, y.back, front + 1e-3f * radius});
        eye = x.along * right + y.along * up + distance * back;
        nearest = distance - front;
        farthest = distance + reach(scene, -back);
    }
    Camera camera;
    camera.name = "auto";
    camera.world_from_camera = mat4(vec4(right, 0.0f), vec4(up, 0.0f), vec4(back, 0.0f), vec4(eye, 1.0f));
    camera.projection = Perspective{yfov, std::nullopt, 0.9f * nearest,
                                    farthest + 0.1f * (farthest - nearest) + 1e-3f * radius};
    return camera;
}

Camera chosen_camera(const Scene& scene, const std::string& name, const PrepareOptions& options) {
    const std::string& wanted = options.camera;
    if (wanted == "auto" || (wanted.empty() && scene.cameras.empty()))
        return options.extent && !options.extent->is_empty()
                   ? framing_camera(corners_of(*options.extent), options.aspect_ratio)
                   : framing_camera(scene, options.aspect_ratio);
    if (wanted.empty()) return scene.cameras.front();
    if (is_look_at(wanted))
        return camera_at(parse_look_at(wanted, scene.origin), bounds_of(scene), options.aspect_ratio);
    for (const Camera& camera : scene.cameras)
        if (camera.name == wanted) return camera;
    int number = 0;
    const auto [end, failure] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), number);
    for (std::size_t i = 0; i < scene.cameras.size(); ++i)
        if (failure == std::errc{} && end == wanted.data() + wanted.size() && number == number_of(scene, i))
            return scene.cameras[i];
    throw Error({name}, fmt::format("no camera '{}'", wanted), "choose one of " + cameras_of(scene));
}

RenderScene prepare_scene(Scene scene, const std::string& name, const PrepareOptions& options) {
    RenderScene stage;
    stage.camera = chosen_camera(scene, name, options);

    stage.lights = assign_emitters(scene);
    if (const auto& environment = options.environment ? options.environment : scene.environment) {
        EnvironmentLight light = *environment;
        light.is_visible = light.is_visible && !options.hide_emitters;
        stage.lights.emplace_back(std::move(light));
    }
    remark_on_glass(scene, name, stage.remarks);
    remark_on_lines(scene, name, stage.remarks);
    add_rig(stage, scene, name, options);
    if (options.hide_emitters)
        for (Material& material : scene.materials) material.emission = vec3(0.0f);
    else
        add_light_surfaces(scene);
    stage.scene = std::move(scene);
    return stage;
}

} // namespace sr::scene
