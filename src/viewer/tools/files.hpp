#pragma once
// File tool: opens, reloads and saves scenes, writes screenshots, watches files for changes.
#include "image/file.hpp"
#include "viewer/document/watch.hpp"
#include "viewer/panels/file_dialog.hpp"
#include "viewer/tools/tool.hpp"

namespace sr::viewer {

class Files : public Tool {
public:
    explicit Files(Workspace& workspace);

    std::optional<Changes> handle(const Event& event) override;
    Changes update(double seconds) override;
    Changes draw(const Overlay& overlay) override;
    Activity activity() const override { return ws_.loading ? Activity::waiting : Activity::idle; }

private:
    Changes reload();
    Changes write_png();
    Changes write_exr();
    Changes write(const image::Image& picture, const std::string& file, image::SampleType type);
    void save(const std::string& file);

    FileDialog dialog_;
    Watch scene_watch_;
    Watch shader_watch_;
    std::string watched_; // the scene that scene_watch_ watches
};

} // namespace sr::viewer
