#include "image/exr.hpp"

#include "core/error.hpp"
#include "core/text.hpp"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>
#include <ImfTestFile.h>
#include <ImfThreading.h>
#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <half.h>
#include <mutex>
#include <thread>
#include <utility>

namespace sr::image {
namespace {

constexpr std::array<const char*, 4> usual_names{"R", "G", "B", "A"};

/// A file in memory.
class Memory : public Imf::OStream {
public:
    explicit Memory(const std::string& name) : Imf::OStream(name.c_str()) {}

    void write(const char* bytes, int count) override {
        const std::size_t end = place_ + static_cast<std::size_t>(count);
        if (end > bytes_.size()) bytes_.resize(end);
        std::copy_n(bytes, count, bytes_.begin() + static_cast<std::ptrdiff_t>(place_));
        place_ = end;
    }
    std::uint64_t tellp() override { return place_; }
    void seekp(std::uint64_t place) override { place_ = place; }

    std::vector<std::uint8_t> take() { return std::move(bytes_); }

private:
    std::vector<std::uint8_t> bytes_;
    std::uint64_t place_ = 0;
};

std::string channel_name(const Image& image, int channel) {
    const auto index = static_cast<std::size_t>(channel);
    if (!image.channel_names.empty()) return image.channel_names[index];
    if (image.channels <= 2) return channel == 0 ? "Y" : "A";
    return channel < 4 ? usual_names[index] : fmt::format("channel{}", channel);
}

Imf::Header header_of(const Image& image, Imf::PixelType type) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    header.zipCompressionLevel() = 2; // measured, see README.md
    for (int channel = 0; channel < image.channels; ++channel)
        header.channels().insert(channel_name(image, channel), Imf::Channel(type));
    for (const auto& [name, value] : image.attributes) {
        const bool is_taken = header.find(name) != header.end(); // by what describes the format
        if (!is_taken) header.insert(name, Imf::StringAttribute(value));
    }
    return header;
}

/// Interleaved channels, of which a value has `size` bytes.
Imf::FrameBuffer interleaved(char* values, Imf::PixelType type, std::size_t size, int width,
                             const std::vector<std::string>& names) {
    Imf::FrameBuffer buffer;
    const std::size_t step = size * names.size();
    for (std::size_t channel = 0; channel < names.size(); ++channel)
        buffer.insert(names[channel], Imf::Slice(type, values + size * channel, step,
                                                 step * static_cast<std::size_t>(width)));
    return buffer;
}

/// Makes OpenEXR compress and decompress on all cores, or on fewer where the system gives no more threads.
void use_threads() {
    static std::once_flag once;
    std::call_once(once, [] {
        try {
            Imf::setGlobalThreadCount(static_cast<int>(std::thread::hardware_concurrency()));
        } catch (const std::exception&) { // the caller's is enough
            Imf::setGlobalThreadCount(0);
        }
    });
}

/// Writes the values, which are of the type that the header names. OpenEXR does not change them.
template<typename Value>
void write_pixels(Imf::OutputFile& file, const Image& image, const std::vector<Value>& values,
                  Imf::PixelType type) {
    std::vector<std::string> names;
    for (int channel = 0; channel < image.channels; ++channel) names.push_back(channel_name(image, channel));
    char* first = const_cast<char*>(reinterpret_cast<const char*>(values.data()));
    file.setFrameBuffer(interleaved(first, type, sizeof(Value), image.width, names));
    file.writePixels(image.height);
}

/// The channels in the order R, G, B, A; absent if there are others, some that lack pixels, or integers.
std::optional<std::vector<std::string>> plain_channels(const Imf::Header& header) {
    std::vector<std::string> names;
    for (const char* name : usual_names)
        if (header.channels().findChannel(name)) names.push_back(name);
    std::size_t count = 0;
    for (auto each = header.channels().begin(); each != header.channels().end(); ++each, ++count) {
        const Imf::Channel& channel = each.channel();
        if (channel.xSampling != 1 || channel.ySampling != 1 || channel.type == Imf::UINT)
            return std::nullopt;
    }
    if (count == 0 || count != names.size()) return std::nullopt;
    return names;
}

Image read_pixels(Imf::InputFile& input, const std::vector<std::string>& names, const std::string& file,
                  std::uint64_t max_values) {
    const Imf::Header& header = input.header();
    const auto& [from, to] = header.dataWindow();
    // Both are near enough to 0 not to overflow: OpenEXR refuses others.
    const std::int64_t width = std::int64_t{to.x} - from.x + 1, height = std::int64_t{to.y} - from.y + 1;
    const std::uint64_t pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    if (pixels > max_values / names.size())
        throw Error({file},
                    fmt::format("cannot take {} x {} pixels of {} channels", width, height, names.size()),
                    "use a flat image of an ordinary size, or allow more numbers with --limit pixels=N");
    Image image(static_cast<int>(width), static_cast<int>(height), static_cast<int>(names.size()));
    image.channel_names = names;
    for (auto each = header.begin(); each != header.end(); ++each)
        if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&each.attribute()))
            image.attributes.push_back({each.name(), text->value()});
    char* first = reinterpret_cast<char*>(image.pixels.data());
    // OpenEXR counts from the origin of the picture, not of the data.
    const auto skipped = (from.y * width + from.x) * static_cast<std::int64_t>(sizeof(float) * names.size());
    input.setFrameBuffer(interleaved(first - skipped, Imf::FLOAT, sizeof(float), image.width, names));
    input.readPixels(from.y, to.y);
    return image;
}

} // namespace

std::vector<std::uint8_t> encode_exr(const Image& image, SampleType type, const std::string& name) {
    try {
        use_threads();
        Memory memory(name);
        const Imf::PixelType stored = type == SampleType::half ? Imf::HALF : Imf::FLOAT;
        {
            Imf::OutputFile file(memory, header_of(image, stored)); // its end completes the file
            if (type == SampleType::half)
                write_pixels(file, image, std::vector<half>(image.pixels.begin(), image.pixels.end()),
                             stored);
            else
                write_pixels(file, image, image.pixels, stored);
        }
        return memory.take();
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error({name}, fmt::format("cannot be encoded ({})", one_line(problem.what())),
                    "write it in another format");
    }
}

std::optional<Image> read_plain_exr(const std::filesystem::path& file, std::uint64_t max_values) {
    const std::string name = file.string();
    try {
        bool is_tiled = false, is_deep = false, is_multipart = false;
        if (!Imf::isOpenExrFile(name.c_str(), is_tiled, is_deep, is_multipart)) return std::nullopt;
        if (is_tiled || is_deep || is_multipart) return std::nullopt;
        use_threads();
        Imf::InputFile input(name.c_str());
        const auto channels = plain_channels(input.header());
        if (!channels || input.header().dataWindow() != input.header().displayWindow()) return std::nullopt;
        return read_pixels(input, *channels, name, max_values);
    } catch (const Error&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& problem) {
        throw Error({name}, fmt::format("a broken image ({})", one_line(problem.what())), "make it again");
    }
}

} // namespace sr::image
