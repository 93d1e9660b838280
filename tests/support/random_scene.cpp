#include "support/random_scene.hpp"

#include "support/random_parts.hpp"

#include <algorithm>
#include <array>
#include <glm/gtc/matrix_transform.hpp>
#include <string_view>

namespace sr::testing {
namespace {

using glm::dmat3;
using glm::dmat4;
using glm::dquat;
using glm::dvec3;

json list_of(const dvec3& v) { return {v.x, v.y, v.z}; }

/// Puts a scene together node by node.
class Assembly {
public:
    Assembly(const Recipe& recipe, std::uint64_t seed, const Extremes& extremes)
        : recipe_(recipe), extremes_(extremes), random_(seed) {}

    MadeGltf made() {
        append_pictures(made_, static_cast<int>(std::string_view(recipe_.name).size()), random_);
        for (const Surface surface : recipe_.surfaces) append_material(made_, surface, random_, extremes_);
        append_ground();
        for (int i = 0; i < static_cast<int>(recipe_.surfaces.size()); ++i) append_object(i);
        for (int i = 0; i < 2; ++i) append_object(random_.below(static_cast<int>(recipe_.surfaces.size())));
        for (const Emitter emitter : recipe_.emitters) append_emitter(emitter);
        append_camera();
        scale_all();
        made_.root["scenes"] = json::array({{{"nodes", roots_}}});
        return std::move(made_);
    }

private:
    int append_node(json node) {
        made_.root["nodes"].push_back(std::move(node));
        return static_cast<int>(made_.root["nodes"].size()) - 1;
    }

    static json placed(const dvec3& translation, const dquat& q, const dvec3& scale) {
        return {{"translation", list_of(translation)},
                {"rotation", {q.x, q.y, q.z, q.w}},
                {"scale", list_of(scale)}};
    }

    json& node(int index) { return made_.root["nodes"][static_cast<std::size_t>(index)]; }

    void append_ground() {
        const int mesh = append_mesh(made_, Form::ground, recipe_.surfaces[0], 0, random_, extremes_);
        const dquat flat = glm::angleAxis(-0.5 * glm::pi<double>(), dvec3(1, 0, 0)); // +Z becomes +Y
        json ground = placed({0, extremes_.is_coplanar ? 0.0 : -1.0, 0}, flat, dvec3(3.0));
        ground["mesh"] = mesh;
        roots_.push_back(append_node(ground));
    }

    dvec3 scale() {
        dvec3 s(random_.scale_within(0.25, 0.7));
        if (random_.has_chance(0.6)) s *= dvec3(random_.within(0.4, 1.5), 1.0, random_.within(0.4, 1.5));
        if (random_.has_chance(0.3)) s[random_.below(3)] *= -1.0;
        if (extremes_.has_flattened_nodes && random_.has_chance(0.4)) s[random_.below(3)] = 0.0;
        return s;
    }

    dvec3 place() {
        if (extremes_.is_coincident && random_.has_chance(0.6)) return dvec3(0.0);
        dvec3 p = random_.in_cube(0.9);
        if (extremes_.is_coplanar && random_.has_chance(0.6)) p.y = 0.0;
        return p;
    }

    dquat turn() {
        if (extremes_.is_coplanar && random_.has_chance(0.6))
            return glm::angleAxis(0.5 * glm::pi<double>() * random_.below(4), dvec3(1, 0, 0));
        return random_.turn();
    }

    /// The node's transform by itself, or through a parent of another scale, which may shear.
    void hang(json leaf, const dvec3& at, const dquat& q, const dvec3& s) {
        const int kind = random_.below(3);
        if (kind == 0) {
            leaf.update(placed(at, q, s));
            roots_.push_back(append_node(leaf));
            return;
        }
        const double unit = kind == 1 ? random_.scale_within(0.01, 100.0) : 1.0;
        if (kind == 1) { // centimetres, or the like
            leaf.update(placed(at / unit, q, s / unit));
            leaf = {{"scale", {unit, unit, unit}}, {"children", {append_node(leaf)}}};
        } else {
            leaf.update(placed(dvec3(0.0), random_.turn(), dvec3(1.0)));
            const int child = append_node(leaf);
            leaf = placed(at, q, s);
            leaf["children"] = {child};
        }
        roots_.push_back(append_node(leaf));
    }

    void append_object(int surface) {
        const Surface kind = recipe_.surfaces[static_cast<std::size_t>(surface)];
        auto form = static_cast<Form>(1 + random_.below(static_cast<int>(Form::form_count) - 1));
        if (kind == Surface::glowing_quad) form = Form::quad;
        if (kind == Surface::glowing && form == Form::quad) form = Form::box;
        const int mesh = append_mesh(made_, form, kind, surface, random_, extremes_);
        const int copies =
            kind == Surface::glowing_quad || kind == Surface::glowing ? 1 : 1 + random_.below(2);
        json leaf{{"mesh", mesh}};
        if (copies == 2 && random_.has_chance(0.3)) {
            leaf["extensions"]["EXT_mesh_gpu_instancing"]["attributes"] = instances();
            return hang(leaf, place(), turn(), scale());
        }
        for (int i = 0; i < copies; ++i) hang(leaf, place(), turn(), scale());
    }

    json instances() {
        std::vector<float> at, scales;
        for (int i = 0; i < 3; ++i)
            for (int axis = 0; axis < 3; ++axis) {
                at.push_back(static_cast<float>(random_.within(-1.0, 1.0)));
                scales.push_back(static_cast<float>(random_.within(0.3, 0.8)));
            }
        return {{"TRANSLATION", made_.floats(at, "VEC3")}, {"SCALE", made_.floats(scales, "VEC3")}};
    }

    void append_emitter(Emitter emitter) {
        dvec3 direction = random_.direction();
        direction.y = std::abs(direction.y) + 0.2;
        dvec3 at = random_.within(1.8, 2.8) * glm::normalize(direction);
        if (extremes_.is_coplanar && random_.has_chance(0.5)) at.y = 0.0;
        if (extremes_.is_coincident && random_.has_chance(0.5))
            at = dvec3(random_.below(3) - 1, -1, random_.below(3) - 1);
        const dquat aim = extremes_.is_coplanar ? turn() : looking(at, 0.3 * random_.in_cube(1.0));
        const int lamp = append_node(placed(at, aim, dvec3(random_.within(0.7, 1.4))));
        append_light(made_, emitter, lamp, random_, extremes_);
        roots_.push_back(lamp);
    }

    /// The turn of what stands at `from` and looks along its -Z to `to`.
    dquat looking(const dvec3& from, const dvec3& to) {
        const dvec3 back = glm::normalize(from - to);
        const dvec3 right =
            glm::normalize(glm::cross(std::abs(back.y) < 0.9 ? dvec3(0, 1, 0) : dvec3(1, 0, 0), back));
        return glm::quat_cast(dmat3(right, glm::cross(back, right), back))
               * glm::angleAxis(random_.within(0.0, 6.0), dvec3(0, 0, 1));
    }

    void append_camera() {
        dvec3 direction = random_.direction();
        direction.y = std::abs(direction.y) + 0.3;
        const dvec3 at = random_.within(4.0, 5.0) * glm::normalize(direction);
        json camera{{"type", "perspective"},
                    {"perspective", {{"yfov", random_.within(0.5, 0.8)}, {"znear", 0.1}}}};
        if (random_.has_chance(0.3))
            camera = {{"type", "orthographic"},
                      {"orthographic", {{"xmag", 1.8}, {"ymag", 1.8}, {"znear", 0.1}, {"zfar", 20.0}}}};
        made_.root["cameras"].push_back(camera);
        json eye = placed(at, looking(at, 0.3 * random_.in_cube(1.0)), dvec3(1.0));
        eye["camera"] = 0;
        roots_.push_back(append_node(eye));
    }

    /// Lengths of the file and of the camera by one factor, by a node over all others.
    void scale_all() {
        if (!(extremes_.max_length > 1.0)) return;
        const double s = random_.scale_within(1.0 / extremes_.max_length, extremes_.max_length);
        const int root = append_node({{"scale", {s, s, s}}, {"children", roots_}});
        roots_ = json::array({root});
        json& camera = made_.root["cameras"][0];
        for (json& lens : {std::ref(camera["perspective"]), std::ref(camera["orthographic"])})
            for (const char* length : {"znear", "zfar", "xmag", "ymag"})
                if (lens.contains(length)) lens[length] = s * lens[length].get<double>();
    }

    const Recipe& recipe_;
    const Extremes& extremes_;
    Random random_;
    MadeGltf made_;
    json roots_ = json::array();
};

std::vector<Recipe> named_recipes() {
    using E = Emitter;
    using S = Surface;
    constexpr S lambert = surface_of(scene::Model::lambert), mirror = surface_of(scene::Model::mirror),
                ggx = surface_of(scene::Model::ggx), oren_nayar = surface_of(scene::Model::oren_nayar);
    return {
        {"punctual", {E::point, E::spot, E::sun}, {S::plain, S::textured, lambert}},
        {"profile", {E::profile, E::sun}, {S::colored, S::mapped}},
        {"coats", {E::spot, E::point}, {S::coated, S::film}},
        {"directions", {E::point, E::sun}, {S::anisotropic, ggx}},
        {"cloth", {E::sun, E::spot}, {S::sheen, oren_nayar}},
        {"lobes", {E::point, E::spot}, {}}, // the models that no other recipe has
        {"leaves", {E::point, E::sun}, {lambert, S::masked, S::unlit}},
        {"panes", {E::spot, E::sun}, {S::plain, S::blended}},
        {"panels", {E::rectangle, E::area_rectangle}, {S::plain, S::mapped}},
        {"pictures", {E::textured_rectangle, E::ellipse}, {S::textured, lambert}},
        {"rounds", {E::disk, E::sphere, E::tube}, {lambert, S::plain}},
        {"lamps", {E::wide_point, E::wide_spot, E::wide_sun}, {S::plain, mirror}},
        {"polygons", {E::polygon}, {S::plain, S::glowing_quad}},
        {"glows", {}, {lambert, S::glowing, S::textured_glowing}},
    };
}

/// Returns the surfaces of those rows of scene::brdf_models that no recipe has. glTF's own BRDF is
/// Surface::plain; a measured one needs a file beside the scene.
std::vector<Surface> models_without(const std::vector<Recipe>& recipes) {
    std::vector<Surface> surfaces;
    for (std::size_t row = 0; row < scene::brdf_models.size(); ++row) {
        const auto model = static_cast<scene::Model>(row);
        const Surface surface = surface_of(model);
        const bool is_used = std::ranges::any_of(recipes, [&](const Recipe& recipe) {
            return std::ranges::find(recipe.surfaces, surface) != recipe.surfaces.end();
        });
        if (!is_used && model != scene::Model::metallic_roughness && model != scene::Model::merl)
            surfaces.push_back(surface);
    }
    return surfaces;
}

} // namespace

bool Recipe::is_without_extent() const {
    const auto is_point = [](Emitter e) {
        return e == Emitter::point || e == Emitter::spot || e == Emitter::sun || e == Emitter::profile;
    };
    const auto glows = [](Surface s) {
        return s == Surface::glowing || s == Surface::glowing_quad || s == Surface::textured_glowing;
    };
    return std::ranges::all_of(emitters, is_point) && std::ranges::none_of(surfaces, glows);
}

std::span<const Recipe> recipes() {
    static const std::vector<Recipe> all = [] {
        std::vector<Recipe> recipes = named_recipes();
        std::ranges::find(recipes, std::string_view("lobes"), &Recipe::name)->surfaces =
            models_without(recipes);
        return recipes;
    }();
    return all;
}

MadeGltf random_scene(const Recipe& recipe, std::uint64_t seed, const Extremes& extremes) {
    return Assembly(recipe, seed, extremes).made();
}

} // namespace sr::testing
