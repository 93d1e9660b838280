#include "gltf/asset.hpp"

#include "core/error.hpp"
#include "gltf/extensions.hpp"
#include "gltf/read/animation.hpp"
#include "gltf/read/camera.hpp"
#include "gltf/read/environment.hpp"
#include "gltf/read/lights.hpp"
#include "gltf/read/mesh_instances.hpp"
#include "gltf/read/texture.hpp"
#include "gltf/warnings.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <numeric>
#include <set>

namespace sr::gltf {

class Asset::Impl {
public:
    Impl(const SourceFile& source, const AssetOptions& options)
        : is_strict_(options.is_strict),
          warnings_(source.path.string(), is_strict_),
          document_(read_document(source, warnings_)),
          scene_index_(options.scene),
          animations_(parse_animations(document_, warnings_)),
          tree_(document_),
          mesh_instances_(document_, tree_, tree_.flatten(options.scene),
                          find_variant(document_, options.variant)),
          measured_(document_),
          materials_(document_, measured_, warnings_),
          lights_(document_, materials_.textures()) {
        warn_of_unsupported(document_.extensions_used, warnings_);
        mesh_instances_.request_materials(materials_);
        scene_.materials = materials_.materials();
        scene_.measured = measured_.brdfs();
        place_lights(tree_.flatten(scene_index_), warnings_);
        scene_.profiles = lights_.profiles();
        scene_.units = unit_system_of(document_);
        warnings_.attempt("it has no environment", [&] {
            scene_.environment = parse_environment(document_, scene_index_, warnings_);
        });
        scene_.textures = materials_.textures().textures();
        Decoding decoding(document_, materials_.textures().image_sources());
        mesh_instances_.build(materials_, scene_, warnings_);
        mesh_count_ = scene_.meshes.size();
        scene_.images = decoding.images(warnings_, lost_images_);
        update(scene_, materials_);
        origin_ = scene::fitting_origin(scene_);
        if (origin_ != glm::dvec3(0.0)) update(scene_, materials_);
        list_contents();
        contents_.light_nodes = light_nodes_;
        contents_.material_numbers = materials_.numbers();
    }

    scene::Scene rest_pose() {
        require(!is_given_, "an asset gives its scene once");
        is_given_ = true;
        return std::move(scene_);
    }

    void evaluate(scene::Scene& scene, const AnimationTime& time) {
        require(scene.meshes.size() >= mesh_count_, "the scene comes from this asset");
        for (Animation& animation : animations_) animation.reset();
        for (const int animation : time.animations)
            animations_[static_cast<std::size_t>(animation)].apply(time.seconds);
        Warnings heard_before(document_.name);
        MaterialTable materials(document_, measured_, heard_before); // the same as at rest
        mesh_instances_.request_materials(materials);
        scene.materials = materials.materials();
        scene.meshes.resize(mesh_count_);
        update(scene, materials);
    }

    const Document& document() const { return document_; }
    const Contents& contents() const { return contents_; }
    const std::vector<int>& light_nodes() const { return light_nodes_; }
    std::vector<std::string> warnings() const { return warnings_.lines(); }

private:
    /// Everything that moves: instances, the shapes of meshes, lights, cameras.
    void update(scene::Scene& scene, const MaterialTable& materials) {
        std::vector<NodeTransform> nodes = tree_.flatten(scene_index_);
        for (NodeTransform& node : nodes) node.world_from_node[3] -= glm::dvec4(origin_, 0.0);
        scene.origin = origin_;
        const std::vector<bool> is_visible = mesh_instances_.evaluate(nodes, scene);
        materials.share_fluxes(scene); // a lamp that is switched off keeps its radiance
        drop_lost_textures(scene);
        std::erase_if(scene.instances, [&](const scene::Instance& instance) {
            return !is_visible[static_cast<std::size_t>(&instance - scene.instances.data())];
        });
        Warnings here(document_.name, is_strict_);
        scene.lights = place_lights(nodes, here);
        scene.cameras.clear();
        int number = 0;
        for (const NodeTransform& node : nodes) {
            const int camera = integer_in(*node.source, "camera", -1);
            if (camera < 0) continue;
            const int own_number = number++; // a camera that is left out keeps its number
            if (document_.is_lost(fmt::format("/cameras/{}", camera))) continue;
            here.attempt("that camera is left out", [&] {
                scene.cameras.push_back(parse_camera(document_, node));
                scene.cameras.back().number = own_number;
            });
        }
        warnings_.add_new(here);
    }

    /// Takes the textures away whose image could not be decoded. What is left of a material is its factors;
    /// of emission, nothing: most of such a map is black, and a surface that glows all over lights the scene.
    void drop_lost_textures(scene::Scene& scene) const {
        const auto is_lost = [&](int texture) {
            return texture >= 0
                   && lost_images_.contains(scene.textures[static_cast<std::size_t>(texture)].image);
        };
        if (lost_images_.empty()) return;
        for (scene::Material& material : scene.materials) {
            if (is_lost(material.emission_texture.texture)) material.emission = vec3(0.0f);
            for (const scene::TextureInput& input : scene::texture_inputs)
                if (is_lost((material.*input.member).texture)) material.*input.member = {};
        }
    }

    /// All lights ask for their textures, so that these have the same numbers at every time; those that are
    /// visible are given back.
    std::vector<scene::Light> place_lights(const std::vector<NodeTransform>& nodes, Warnings& warnings) {
        std::vector<scene::Light> visible;
        lights_.clear();
        light_nodes_.clear();
        for (const NodeTransform& node : nodes) {
            const std::size_t before = lights_.lights().size();
            lights_.append(node, warnings);
            if (!node.is_visible) continue;
            visible.insert(visible.end(), lights_.lights().begin() + static_cast<std::ptrdiff_t>(before),
                           lights_.lights().end());
            light_nodes_.resize(visible.size(), node.node);
        }
        return visible;
    }

    void list_contents() {
        for (const Animation& animation : animations_)
            contents_.animations.push_back(
                {animation.name, animation.duration, animation.channels.size(), animation.is_whole});
        contents_.variants = variant_names(document_);
        contents_.skins = document_.skins.size();
        for (int mesh = 0; mesh < static_cast<int>(document_.count("meshes")); ++mesh)
            for (const json& primitive : document_.entry("meshes", mesh).at("primitives"))
                if (primitive.contains("targets")) contents_.morph_targets += primitive.at("targets").size();
        for (int node = 0; node < static_cast<int>(document_.count("nodes")); ++node) {
            const json& source = document_.entry("nodes", node);
            contents_.nodes.push_back(
                {text_in(source, "name"), source.value("children", std::vector<int>{})});
        }
        contents_.extensions_used = document_.extensions_used;
        contents_.extensions_required = document_.extensions_required;
    }

    bool is_strict_ = false;
    Warnings warnings_;
    Document document_;
    std::optional<int> scene_index_;
    std::vector<Animation> animations_; // they point into the document
    NodeTree tree_;
    MeshInstances mesh_instances_;
    MeasuredTable measured_;
    MaterialTable materials_; // at rest; its textures are those of every time
    LightTable lights_;
    std::vector<int> light_nodes_; // of those that were placed last
    Contents contents_;
    scene::Scene scene_;        // until it is given away
    std::set<int> lost_images_; // those of the scene that could not be decoded
    std::size_t mesh_count_ = 0;
    glm::dvec3 origin_{0.0}; // fits the rest pose and stays, so that cameras may be kept
    bool is_given_ = false;
};

Asset::Asset(const std::filesystem::path& file, const AssetOptions& options)
    : Asset(read_source(file), options) {}
Asset::Asset(const SourceFile& source, const AssetOptions& options)
    : impl_(std::make_unique<Impl>(source, options)) {}
Asset::~Asset() = default;
Asset::Asset(Asset&&) noexcept = default;
Asset& Asset::operator=(Asset&&) noexcept = default;

const Contents& Asset::contents() const { return impl_->contents(); }
const SourceFile& Asset::source() const { return impl_->document().source; }
std::vector<std::string> Asset::warnings() const { return impl_->warnings(); }
scene::Scene Asset::rest_pose() { return impl_->rest_pose(); }
scene::Scene Asset::evaluate(scene::Scene scene, const AnimationTime& time) {
    impl_->evaluate(scene, time);
    return scene;
}
void Asset::evaluate_into(scene::Scene& scene, const AnimationTime& time) { impl_->evaluate(scene, time); }
const std::vector<int>& Asset::light_nodes() const { return impl_->light_nodes(); }

std::vector<int> Asset::animations_named(std::string_view text) const {
    const auto& all = contents().animations;
    if (all.empty()) impl_->document().fail("it has no animation", "leave out the time and the animation");
    if (text.empty()) return {0};
    if (text == "all") {
        std::vector<int> numbers(all.size());
        std::iota(numbers.begin(), numbers.end(), 0);
        return numbers;
    }
    const auto named = std::ranges::find(all, text, &Contents::AnimationInfo::name);
    if (named != all.end()) return {static_cast<int>(named - all.begin())};
    std::size_t index = 0;
    const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), index);
    if (failure == std::errc{} && end == text.data() + text.size() && index < all.size())
        return {static_cast<int>(index)};
    std::string names;
    for (std::size_t i = 0; i < all.size(); ++i) names += fmt::format("{} {}, ", i, in_quotes(all[i].name));
    impl_->document().fail(fmt::format("no animation {}", in_quotes(text)), "choose one of " + names + "all");
}

double Asset::duration(const std::vector<int>& animations) const {
    double end = 0.0;
    for (const int animation : animations)
        end = std::max(end, contents().animations[static_cast<std::size_t>(animation)].duration);
    return end;
}

void Asset::require_within(const AnimationTime& time) const {
    const double end = duration(time.animations);
    // Where channels are lost, nobody knows when they would have ended.
    for (const int animation : time.animations)
        if (!contents().animations[static_cast<std::size_t>(animation)].is_whole && time.seconds >= 0.0)
            return;
    if (time.seconds >= 0.0 && static_cast<float>(time.seconds) <= static_cast<float>(end)) return;
    impl_->document().fail(
        fmt::format("{} s is beyond its animation, which ends at {:.6g} s", time.seconds, end),
        fmt::format("choose a time from 0 to {:.6g}", end));
}

scene::Scene build_scene(Asset& asset, const LoadOptions& options) {
    scene::Scene scene = asset.rest_pose();
    if (!options.at) return scene;
    const AnimationTime time{asset.animations_named(options.animation), *options.at};
    asset.require_within(time);
    return asset.evaluate(std::move(scene), time);
}

Loaded load(const std::filesystem::path& file, const LoadOptions& options) {
    Asset asset(file, {options.scene, options.variant, options.is_strict});
    scene::Scene scene = build_scene(asset, options);
    return {std::move(scene), asset.warnings(), asset.contents()};
}

} // namespace sr::gltf
