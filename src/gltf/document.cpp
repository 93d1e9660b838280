#include "gltf/document.hpp"

#include "core/error.hpp"
#include "gltf/container.hpp"
#include "gltf/extensions.hpp"
#include "gltf/read/compression.hpp"
#include "gltf/schema.hpp"
#include "gltf/tinygltf.hpp"
#include "gltf/uri.hpp"
#include "gltf/warnings.hpp"

#include <fmt/format.h>
#include <functional>

namespace sr::gltf {
namespace {

namespace fs = std::filesystem;

// A file of another version may fail the checks for reasons that would mislead: the version is looked at
// first.
void check_version(const json& root, const std::string& name) {
    const json::json_pointer version("/asset/version");
    const json::json_pointer min_version("/asset/minVersion");
    const auto is_two = [&](const json::json_pointer& pointer, std::string_view prefix) {
        return root.at(pointer).is_string()
               && root.at(pointer).get_ref<const std::string&>().starts_with(prefix);
    };
    const auto stated = [&](const json::json_pointer& pointer) {
        const json& value = root.at(pointer);
        return in_quotes(value.is_string() ? value.get_ref<const std::string&>() : value.dump());
    };
    if (!root.contains(version))
        throw Error({name}, "this is not glTF 2.0, it has no asset.version", "give a glTF 2.0 file");
    if (!is_two(version, "2."))
        throw Error({name}, fmt::format("this is glTF {}, not 2.0", stated(version)),
                    "convert it to glTF 2.0");
    if (root.contains(min_version) && !is_two(min_version, "2.0"))
        throw Error({name}, fmt::format("it needs a reader of glTF {}", stated(min_version)),
                    "export it as glTF 2.0");
}

/// Each entry of an array costs far more memory than its two characters.
void check_counts(const json& root, const std::string& name) {
    for (const auto& [key, value] : root.items())
        if (value.is_array())
            check_limit(key == "materials" ? Limit::materials : Limit::elements, value.size(), name);
}

std::optional<Bytes> buffer_bytes(Document& document, const json& buffer, std::size_t index,
                                  std::optional<Bytes> bin) {
    const auto size = buffer.at("byteLength").get<std::size_t>();
    std::optional<Bytes> bytes;
    if (const auto uri = buffer.find("uri"); uri != buffer.end()) {
        const UriPlace place{document.name, fmt::format("/buffers/{}/uri", index)};
        const std::string& text = uri->get_ref<const std::string&>();
        document.storage.push_back(
            std::make_shared<const std::vector<std::uint8_t>>(read_uri(text, document.folder, place)));
        bytes = *document.storage.back();
        if (!is_data_uri(text))
            document.source.named[resolve_file(text, document.folder, place)].bytes = document.storage.back();
    } else if (index == 0) {
        bytes = bin;
    }
    if (!bytes) return std::nullopt;
    if (bytes->size() < size)
        document.fail(fmt::format("/buffers/{}/byteLength is {}, and only {} bytes are there", index, size,
                                  bytes->size()),
                      export_again);
    return bytes->first(size);
}

// A buffer that cannot be read costs what lies in it: perhaps a texture, perhaps a mesh.
void read_buffers(Document& document, const json& buffers, std::optional<Bytes> bin) {
    for (std::size_t i = 0; i < buffers.size(); ++i) {
        BufferSource source;
        try {
            source.bytes = buffer_bytes(document, buffers[i], i, bin);
        } catch (const Error& error) {
            source.fault = error;
        }
        document.buffers.push_back(std::move(source));
    }
}

/// Replaces cameras without a projection, and adds the angles of spots, which have defaults.
void complete(json& root, Document& document, Warnings& warnings) {
    if (root.contains("cameras"))
        for (std::size_t i = 0; i < root["cameras"].size(); ++i) {
            json& camera = root["cameras"][i];
            const std::string type = camera.at("type");
            if (camera.contains(type)) continue;
            const std::string pointer = fmt::format("/cameras/{}", i);
            warnings.add(fmt::format("{} has no {}", pointer, type), "that camera is left out");
            document.lost.insert(pointer);
            camera = {{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}};
        }
    const json::json_pointer lights("/extensions/KHR_lights_punctual/lights");
    if (root.contains(lights))
        for (json& light : root.at(lights))
            if (light.at("type") == "spot" && !light.contains("spot")) light["spot"] = json::object();
}

/// Records what the file refers to, before it is read.
void record_names(SourceFile& source, const json& root, std::string_view text) {
    source.json_hash = std::hash<std::string_view>{}(text);
    source.named.clear();
    for (const fs::path& file : named_files(root, source.path.parent_path()))
        source.named[file].stamp = stamp_of(file);
}

void list_images(Document& document, json& images) {
    for (json& image : images)
        document.images.push_back({image.value("name", ""), image.value("uri", ""),
                                   static_cast<int>(image.value("bufferView", -1))});
}

void list_skins(Document& document, json& skins) {
    for (json& skin : skins)
        document.skins.push_back({skin.value("name", ""), skin.at("joints").get<std::vector<int>>(),
                                  static_cast<int>(skin.value("inverseBindMatrices", -1))});
}

/// Returns the target of a channel as a JSON pointer, whether or not the file states it as one.
std::string pointer_of(const json& target) {
    const std::string path = target.at("path");
    if (path != "pointer")
        return target.contains("node") ? fmt::format("/nodes/{}/{}", target.at("node").get<int>(), path) : "";
    const json::json_pointer pointer("/extensions/KHR_animation_pointer/pointer");
    return target.contains(pointer) ? target.at(pointer).get<std::string>() : "";
}

void list_animations(Document& document, json& animations) {
    for (json& animation : animations) {
        AnimationSource source{animation.value("name", ""), {}, {}};
        for (json& sampler : animation.at("samplers"))
            source.samplers.push_back({sampler.value("input", -1), sampler.value("output", -1),
                                       sampler.value("interpolation", "LINEAR")});
        for (json& channel : animation.at("channels"))
            source.channels.push_back(
                {channel.at("sampler").get<std::size_t>(), pointer_of(channel.at("target"))});
        document.animations.push_back(std::move(source));
    }
}

} // namespace

void Document::fail(std::string_view what, std::string_view what_to_do) const {
    throw Error({name}, what, what_to_do);
}

Bytes Document::view(int buffer_view, std::string_view pointer) const {
    const tinygltf::BufferView& view = model->bufferViews[static_cast<std::size_t>(buffer_view)];
    const auto& [buffer, fault] = buffers[static_cast<std::size_t>(view.buffer)];
    if (fault) throw *fault;
    if (!buffer)
        fail(fmt::format("{} needs /buffers/{}, which has no uri and is no part of this file", pointer,
                         view.buffer),
             export_again);
    if (view.byteOffset > buffer->size() || view.byteLength > buffer->size() - view.byteOffset)
        fail(fmt::format("/bufferViews/{} ends at byte {} of /buffers/{}, which has {}", buffer_view,
                         view.byteOffset + view.byteLength, view.buffer, buffer->size()),
             export_again);
    return buffer->subspan(view.byteOffset, view.byteLength);
}

int Document::add_buffer(std::vector<std::uint8_t> bytes) {
    storage.push_back(std::make_shared<const std::vector<std::uint8_t>>(std::move(bytes)));
    buffers.push_back({*storage.back(), std::nullopt});
    return static_cast<int>(buffers.size()) - 1;
}

std::size_t Document::count(const char* list) const {
    const auto found = root.find(list);
    return found == root.end() ? 0 : found->size();
}

double number_in(const json& object, std::string_view key, double fallback) {
    const auto found = object.find(key);
    return found == object.end() ? fallback : found->get<double>();
}

int integer_in(const json& object, std::string_view key, int fallback) {
    const auto found = object.find(key);
    return found == object.end() ? fallback : found->get<int>();
}

bool flag_in(const json& object, std::string_view key, bool fallback) {
    const auto found = object.find(key);
    return found == object.end() ? fallback : found->get<bool>();
}

std::string text_in(const json& object, std::string_view key) {
    const auto found = object.find(key);
    return found == object.end() ? std::string() : found->get<std::string>();
}

std::vector<double> numbers_in(const json& object, std::string_view key) {
    const auto found = object.find(key);
    return found == object.end() ? std::vector<double>() : found->get<std::vector<double>>();
}

glm::dvec3 three_in(const json& object, std::string_view key, glm::dvec3 fallback) {
    const auto found = object.find(key);
    if (found == object.end()) return fallback;
    return {(*found)[0].get<double>(), (*found)[1].get<double>(), (*found)[2].get<double>()};
}

const json* extension(const json& object, std::string_view name) {
    const auto extensions = object.find("extensions");
    if (extensions == object.end()) return nullptr;
    const auto found = extensions->find(name);
    return found == extensions->end() ? nullptr : &*found;
}

const json* steradian_in(const json& object) {
    const auto extras = object.find("extras");
    if (extras == object.end()) return nullptr;
    const auto found = extras->find("steradian"); // the end where the extras are no object
    return found == extras->end() ? nullptr : &*found;
}

Document read_document(const SourceFile& source, Warnings& warnings) {
    Document document;
    document.name = source.path.string();
    document.folder = source.path.parent_path();
    document.values_read = std::make_unique<Tally>(Limit::values, document.name);
    document.source = source;

    const Container container = split_container(*source.bytes, document.name);
    json root = parse(container, document.name);
    record_names(document.source, root, container.json);
    check_version(root, document.name);
    check_required_extensions(root, document.name);
    check_counts(root, document.name);
    document.lost = check(root, gltf_schema(), document.name, warnings);

    complete(root, document, warnings);
    if (root.contains("buffers")) read_buffers(document, root["buffers"], container.bin);
    if (root.contains("images")) list_images(document, root["images"]);
    if (root.contains("skins")) list_skins(document, root["skins"]);
    if (root.contains("animations")) list_animations(document, root["animations"]);
    document.extensions_used = root.value("extensionsUsed", std::vector<std::string>{});
    document.extensions_required = root.value("extensionsRequired", std::vector<std::string>{});
    for (const char* list : {"buffers", "images", "skins", "animations"}) root.erase(list);
    document.model = parse_geometry(root, document.name);
    root.erase("accessors");
    document.root = std::move(root);
    unpack_meshopt(document);
    unpack_draco(document);
    return document;
}

} // namespace sr::gltf
