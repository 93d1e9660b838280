#pragma once
// Scene panel: lists of objects by node, of materials, of textures and of what the file has, with an
// inspector of what is selected below.
#include "viewer/keymap.hpp"
#include "viewer/panels/inspector.hpp"
#include "viewer/ui.hpp"

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace sr::viewer {

class ScenePanel {
public:
    enum class Tab { objects, materials, textures, file };

    /// Actions of a person in a frame.
    struct Outcome {
        Changes changes;                          // of materials
        std::optional<std::set<ObjectId>> hidden; // other objects than before
        std::optional<std::size_t> camera;        // of the file, to go to
        std::optional<Command> command;           // of a button
    };

    /// Goes to the next tab. @return false after the last one
    bool show_next();
    void show(Tab tab);
    /// Opens the branches that lead to the selected object.
    void reveal() { is_revealing_ = true; }
    /// Another scene: nothing is selected.
    void restart();

    /// Draws the panel. `object`: the selected one, which a click changes.
    Outcome draw(LightEditor& edits, const LoadedScene& loaded, std::optional<ObjectId>& object,
                 const std::optional<Area>& area, const Ui& ui, const Keymap& keys);

private:
    struct Frame;

    void list_nodes(const LoadedScene& loaded);
    void draw_node(int node, Frame& frame);
    static void draw_object(ObjectId id, const std::string& name, Frame& frame);
    void draw_objects(Frame& frame);
    void draw_factors_of(std::size_t material, Frame& frame);
    void draw_materials(Frame& frame);
    void draw_textures(Frame& frame);
    void draw_file(Frame& frame);

    Tab tab_ = Tab::objects;
    bool is_tab_forced_ = false;
    bool is_revealing_ = false;
    std::optional<std::size_t> material_;
    std::optional<int> texture_;
    TexturePreview preview_;
    const LoadedScene* listed_ = nullptr;      // of the three below
    std::vector<std::vector<ObjectId>> shown_; // of each node
    std::vector<bool> leads_to_object_;        // of each node
    std::vector<int> roots_;
};

} // namespace sr::viewer
