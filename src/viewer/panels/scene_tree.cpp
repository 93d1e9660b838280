#include "viewer/panels/scene_tree.hpp"

#include "image/display.hpp"
#include "viewer/palette.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <imgui.h>
#include <utility>

namespace sr::viewer {

/// State of a frame.
struct ScenePanel::Frame {
    LightEditor& edits;
    const LoadedScene& loaded;
    std::optional<ObjectId>& object;
    const Keymap& keys;
    Outcome outcome{};
    float list_height = 0.0f;
    bool is_revealing = false;
};

bool ScenePanel::show_next() {
    if (tab_ == Tab::file) return false;
    show(static_cast<Tab>(static_cast<int>(tab_) + 1));
    return true;
}

void ScenePanel::show(Tab tab) {
    tab_ = tab;
    is_tab_forced_ = true;
}

void ScenePanel::restart() {
    material_.reset();
    texture_.reset();
    preview_ = {};
    listed_ = nullptr;
}

/// Lists the objects of each node, and the nodes that have one or lead to one.
void ScenePanel::list_nodes(const LoadedScene& loaded) {
    const auto& nodes = loaded.contents.nodes;
    listed_ = &loaded;
    shown_.assign(nodes.size(), {});
    for (std::size_t i = 0; i < loaded.base.instances; ++i) {
        const scene::Instance& instance = loaded.stage.scene.instances[i];
        if (instance.node < 0) continue;
        std::vector<ObjectId>& here = shown_[static_cast<std::size_t>(instance.node)];
        const ObjectId id{instance.node, instance.mesh};
        if (std::ranges::find(here, id) == here.end()) here.push_back(id);
    }
    std::vector<int> parents(nodes.size(), -1);
    for (std::size_t n = 0; n < nodes.size(); ++n)
        for (const int child : nodes[n].children)
            parents[static_cast<std::size_t>(child)] = static_cast<int>(n);
    leads_to_object_.assign(nodes.size(), false);
    roots_.clear();
    for (std::size_t n = 0; n < nodes.size(); ++n) {
        if (parents[n] < 0) roots_.push_back(static_cast<int>(n));
        if (shown_[n].empty()) continue;
        for (int up = static_cast<int>(n); up >= 0 && !leads_to_object_[static_cast<std::size_t>(up)];
             up = parents[static_cast<std::size_t>(up)])
            leads_to_object_[static_cast<std::size_t>(up)] = true;
    }
}

void ScenePanel::draw_object(ObjectId id, const std::string& name, Frame& frame) {
    ImGui::PushID(id.node);
    ImGui::PushID(id.mesh);
    const std::set<ObjectId>& hidden = frame.loaded.hidden;
    bool is_shown = !hidden.contains(id);
    if (ImGui::Checkbox("##shown", &is_shown)) {
        frame.outcome.hidden = hidden;
        if (is_shown)
            frame.outcome.hidden->erase(id);
        else
            frame.outcome.hidden->insert(id);
    }
    tooltip("shown; without the tick it casts no shadow and emits nothing");
    ImGui::SameLine();
    if (ImGui::Selectable(name.c_str(), frame.object == id)) frame.object = id;
    if (frame.object == id && frame.is_revealing) ImGui::SetScrollHereY();
    ImGui::PopID();
    ImGui::PopID();
}

void ScenePanel::draw_node(int node, Frame& frame) {
    const auto number = static_cast<std::size_t>(node);
    if (!leads_to_object_[number]) return;
    const auto& info = frame.loaded.contents.nodes[number];
    const std::string name = name_or_number(info.name, "node", number);
    const bool is_leaf = std::ranges::none_of(
        info.children, [&](int child) { return leads_to_object_[static_cast<std::size_t>(child)]; });
    const std::vector<ObjectId>& here = shown_[number];
    if (is_leaf && here.size() == 1) return draw_object(here.front(), name, frame);
    ImGui::PushID(node);
    if (frame.is_revealing) ImGui::SetNextItemOpen(true);
    const int flags = ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_SpanAvailWidth;
    if (ImGui::TreeNodeEx(name.c_str(), flags)) {
        for (const ObjectId id : here) {
            const scene::Mesh& mesh = frame.loaded.stage.scene.meshes[static_cast<std::size_t>(id.mesh)];
            const auto material = static_cast<std::size_t>(mesh.material);
            const std::string& of = frame.loaded.stage.scene.materials[material].name;
            draw_object(id, fmt::format("{} ({})", name, name_or_number(of, "material", material)), frame);
        }
        for (const int child : info.children) draw_node(child, frame);
        ImGui::TreePop();
    }
    ImGui::PopID();
}

void ScenePanel::draw_objects(Frame& frame) {
    ImGui::BeginChild("objects", {0.0f, frame.list_height}, true);
    frame.is_revealing = std::exchange(is_revealing_, false);
    for (const int root : roots_) draw_node(root, frame);
    if (roots_.empty()) ImGui::TextDisabled("the file has no nodes");
    ImGui::EndChild();
    ImGui::PushItemWidth(0.55f * ImGui::GetContentRegionAvail().x);
    bool is_first = true;
    for (const auto& [label, command, tip] :
         {std::tuple("hide", Command::hide_object, "hide the selected object"),
          {"isolate", Command::isolate_object, "hide all others, or show all again"},
          {"frame", Command::frame_selection, "show it in the middle of the picture"},
          {"show all", Command::show_objects, "show all hidden objects"}}) {
        const float width = ImGui::CalcTextSize(label).x + 3.0f * ImGui::GetStyle().FramePadding.x;
        const float right = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
        const bool has_room = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width < right;
        if (!std::exchange(is_first, false) && has_room) ImGui::SameLine();
        if (ImGui::SmallButton(label)) frame.outcome.command = command;
        tooltip(frame.keys.hint(tip, command));
    }
    if (!frame.object) {
        ImGui::PushTextWrapPos();
        ImGui::TextDisabled(
            "%s", frame.keys.hint("select an object, or point at one", Command::inspect_pointed).c_str());
        ImGui::PopTextWrapPos();
    } else if (const auto material = draw_object_facts(frame.loaded, *frame.object)) {
        material_ = material;
        draw_factors_of(*material, frame);
    }
    ImGui::PopItemWidth();
}

/// Draws a material with its fields; a texture that is clicked is shown in its tab.
void ScenePanel::draw_factors_of(std::size_t material, Frame& frame) {
    std::optional<int> texture;
    frame.outcome.changes |= draw_material(frame.edits, frame.loaded, material, texture);
    if (!texture) return;
    texture_ = texture;
    show(Tab::textures);
}

void ScenePanel::draw_materials(Frame& frame) {
    const std::vector<scene::Material>& materials = frame.loaded.stage.scene.materials;
    ImGui::BeginChild("materials", {0.0f, frame.list_height}, true);
    for (std::size_t m = 0; m < frame.loaded.base.materials; ++m) {
        ImGui::PushID(static_cast<int>(m));
        const vec4 c = materials[m].base_color;
        const ImVec4 shown{image::srgb_encoded(c.x), image::srgb_encoded(c.y), image::srgb_encoded(c.z),
                           1.0f};
        const float side = ImGui::GetTextLineHeight();
        ImGui::ColorButton("##color", shown, ImGuiColorEditFlags_NoTooltip, {side, side});
        tooltip("its base colour, without its texture");
        ImGui::SameLine();
        const std::string name = name_or_number(materials[m].name, "material", m);
        if (ImGui::Selectable(name.c_str(), material_ == m)) material_ = m;
        ImGui::PopID();
    }
    ImGui::EndChild();
    if (!material_ || *material_ >= materials.size()) return ImGui::TextDisabled("select a material");
    ImGui::PushItemWidth(0.55f * ImGui::GetContentRegionAvail().x);
    draw_factors_of(*material_, frame);
    ImGui::PopItemWidth();
}

void ScenePanel::draw_textures(Frame& frame) {
    const scene::Scene& scene = frame.loaded.stage.scene;
    ImGui::BeginChild("textures", {0.0f, 0.6f * frame.list_height}, true);
    for (std::size_t t = 0; t < scene.textures.size(); ++t) {
        const auto number = static_cast<std::size_t>(scene.textures[t].image);
        const scene::TextureImage& image = scene.images[number];
        const std::string row = fmt::format("{}  {} x {}##{}", name_or_number(image.name, "image", number),
                                            image.width, image.height, t);
        if (ImGui::Selectable(row.c_str(), texture_ == static_cast<int>(t))) texture_ = static_cast<int>(t);
    }
    if (scene.textures.empty()) ImGui::TextDisabled("the file has no textures");
    ImGui::EndChild();
    if (!scene.textures.empty() && !texture_) texture_ = 0;
    if (texture_ && static_cast<std::size_t>(*texture_) < scene.textures.size())
        draw_texture(frame.loaded, *texture_, preview_,
                     std::max(64.0f, ImGui::GetContentRegionAvail().y - 6.0f * ImGui::GetFontSize()));
}

void ScenePanel::draw_file(Frame& frame) {
    const auto& cameras = frame.loaded.stage.scene.cameras;
    ImGui::BeginChild("file");
    draw_file_facts(frame.loaded);
    ImGui::TextDisabled("cameras");
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        const bool is_perspective = std::holds_alternative<scene::Perspective>(cameras[i].projection);
        const std::string row = fmt::format("{} ({})##{}", name_or_number(cameras[i].name, "camera", i),
                                            is_perspective ? "perspective" : "orthographic", i);
        if (ImGui::Selectable(row.c_str())) frame.outcome.camera = i;
        tooltip("go to this camera");
    }
    if (cameras.empty()) ImGui::TextDisabled("none");
    ImGui::EndChild();
}

ScenePanel::Outcome ScenePanel::draw(LightEditor& edits, const LoadedScene& loaded,
                                     std::optional<ObjectId>& object, const std::optional<Area>& area,
                                     const Ui& ui, const Keymap& keys) {
    if (listed_ != &loaded) list_nodes(loaded);
    if (area)
        place_next_window(*area);
    else
        ImGui::SetNextWindowSize({22.0f * ImGui::GetFontSize(), 0.8f * ImGui::GetMainViewport()->Size.y});
    Frame frame{edits, loaded, object, keys};
    if (ImGui::Begin(side::scene, nullptr,
                     ui.panel_flags(area.has_value()) & ~ImGuiWindowFlags_AlwaysAutoResize)) {
        frame.list_height = 0.42f * ImGui::GetContentRegionAvail().y;
        using Draw = void (ScenePanel::*)(Frame&);
        constexpr std::array<std::tuple<const char*, const char*, Draw>, 4> tabs{
            {{"Objects", "nodes with meshes, as the file nests them", &ScenePanel::draw_objects},
             {"Materials", "all materials of the file", &ScenePanel::draw_materials},
             {"Textures", "all textures, channel by channel", &ScenePanel::draw_textures},
             {"File", "cameras, extensions, warnings", &ScenePanel::draw_file}}};
        const Tab forced = tab_;
        const bool is_forced = std::exchange(is_tab_forced_, false);
        if (ImGui::BeginTabBar("lists")) {
            for (std::size_t i = 0; i < tabs.size(); ++i) {
                const auto& [name, tip, draw_tab] = tabs[i];
                const bool is_chosen = is_forced && static_cast<Tab>(i) == forced;
                const bool is_open =
                    ImGui::BeginTabItem(name, nullptr, is_chosen ? ImGuiTabItemFlags_SetSelected : 0);
                tooltip(frame.keys.hint(fmt::format("{}; the next list", tip), Command::scene_tree));
                if (!is_open) continue;
                if (!is_forced) tab_ = static_cast<Tab>(i);
                (this->*draw_tab)(frame);
                ImGui::EndTabItem();
            }
            ImGui::EndTabBar();
        }
        if (is_forced) frame.outcome.changes |= Change::redraw;
    }
    if (!area) keep_in_viewport();
    ImGui::End();
    return frame.outcome;
}

} // namespace sr::viewer
