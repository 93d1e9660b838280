#include "viewer/panels/texture_preview.hpp"

#include "viewer/ui.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <imgui.h>
#include <type_traits>
#include <variant>

namespace sr::viewer {

void TexturePreview::upload(const scene::TextureImage& image) {
    texture_.emplace(GL_TEXTURE_2D, "texture preview");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    std::visit(
        [&](const auto& texels) {
            const bool is_byte = std::is_same_v<decltype(texels), const std::vector<std::uint8_t>&>;
            glTexImage2D(GL_TEXTURE_2D, 0, is_byte ? GL_RGBA8 : GL_RGBA16, image.width, image.height, 0,
                         GL_RGBA, is_byte ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT, texels.data());
        },
        image.texels);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    const bool is_small = std::max(image.width, image.height) < 128; // its texels are to be seen
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, is_small ? GL_NEAREST : GL_LINEAR);
    choose(channel_);
}

/// Shows all channels but alpha, or one of them as grey.
void TexturePreview::choose(Channel channel) {
    channel_ = channel;
    if (!texture_) return;
    constexpr std::array<GLint, 5> sources{GL_RED, GL_RED, GL_GREEN, GL_BLUE, GL_ALPHA};
    const GLint source = sources[static_cast<std::size_t>(channel)];
    const std::array<GLint, 4> swizzle = channel == Channel::all
                                             ? std::array<GLint, 4>{GL_RED, GL_GREEN, GL_BLUE, GL_ONE}
                                             : std::array<GLint, 4>{source, source, source, GL_ONE};
    texture_->bind(0);
    glTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_SWIZZLE_RGBA, swizzle.data());
}

void TexturePreview::draw(const scene::TextureImage& image, std::pair<const void*, int> key,
                          float max_height) {
    if (!texture_ || key_ != key) {
        key_ = key;
        upload(image);
    }
    constexpr std::array<std::pair<const char*, const char*>, 5> buttons{
        {{"RGB", "all channels but alpha, as they are stored"},
         {"R", "the red channel as grey"},
         {"G", "the green channel as grey: of a metallic-roughness texture the roughness"},
         {"B", "the blue channel as grey: of a metallic-roughness texture the metalness"},
         {"A", "the alpha channel as grey"}}};
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        if (ImGui::RadioButton(buttons[i].first, channel_ == static_cast<Channel>(i)))
            choose(static_cast<Channel>(i));
        tooltip(buttons[i].second);
    }
    const float room = ImGui::GetContentRegionAvail().x;
    const float aspect = static_cast<float>(image.width) / static_cast<float>(std::max(1, image.height));
    const float width = std::max(16.0f, std::min(room, max_height * aspect));
    ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::uintptr_t>(texture_->id())),
                 {width, width / aspect});
}

} // namespace sr::viewer
