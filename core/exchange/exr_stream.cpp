// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/exr_stream.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <exception>
#include <stdexcept>
#include <vector>

namespace isoscope {

namespace {

/// Lets OpenEXR write into a GrowingFile, back and forth.
class ExrSink : public Imf::OStream {
  public:
    explicit ExrSink(GrowingFile& file) : OStream("picture"), file_(file) {}

    void write(const char bytes[], int count) override {
        // OpenEXR knows no other way to be told; ExrStream lets none of it out.
        if (!file_.write(position_, {bytes, static_cast<std::size_t>(count)}))
            throw std::runtime_error("the file cannot be written");
        position_ += static_cast<std::uint64_t>(count);
    }
    std::uint64_t tellp() override { return position_; }
    void seekp(std::uint64_t position) override { position_ = position; }

  private:
    GrowingFile& file_;
    std::uint64_t position_ = 0;
};

/// "0 certified-hit, 1 certified-miss, ...".
std::string verdictList() {
    std::string list;
    for (int number = 0; number <= static_cast<int>(Verdict::notCertified); ++number) {
        if (number > 0) list += ", ";
        list += std::to_string(number) + ' ' + name(static_cast<Verdict>(number));
    }
    return list;
}

Imf::Header headerOf(int width, int height, bool verdicts) {
    Imf::Header header(width, height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const char* channel : {"R", "G", "B", "A", "N.X", "N.Y", "N.Z"})
        header.channels().insert(channel, Imf::Channel(Imf::HALF));
    header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
    if (verdicts) {
        header.channels().insert("verdict", Imf::Channel(Imf::UINT));
        header.insert("verdicts", Imf::StringAttribute(verdictList()));
    }
    return header;
}

}  // namespace

struct ExrStream::Implementation {
    Implementation(int pictureWidth, int height, bool withVerdicts, GrowingFile& file)
        : width(pictureWidth),
          verdicts(withVerdicts),
          sink(file),
          output(sink, headerOf(pictureWidth, height, withVerdicts), 0) {}

    void add(const Image& rows, const SurfaceLayers& layers);

    int width;
    bool verdicts;
    int row = 0;
    ExrSink sink;
    Imf::OutputFile output;
};

void ExrStream::Implementation::add(const Image& rows, const SurfaceLayers& layers) {
    std::vector<half> halves;
    std::vector<float> distances = layers.distance;
    std::vector<unsigned> codes;
    for (const Verdict verdict : layers.verdict) codes.push_back(static_cast<unsigned>(verdict));
    constexpr std::size_t channels = 7;
    halves.reserve(channels * rows.pixels.size());
    for (std::size_t i = 0; i < rows.pixels.size(); ++i) {
        for (const float channel : rows.pixels[i]) halves.emplace_back(channel);
        halves.emplace_back(rows.opacity.empty() ? 1.0f : rows.opacity[i]);
        for (const float channel : layers.normal[i]) halves.emplace_back(channel);
    }
    // OpenEXR counts rows from the top of the picture.
    const auto width64 = static_cast<std::size_t>(width), before = static_cast<std::size_t>(row) * width64;
    const auto slice = [&](Imf::PixelType type, auto* first, std::size_t stride) {
        return Imf::Slice(type, reinterpret_cast<char*>(first) - before * stride, stride, width64 * stride);
    };
    Imf::FrameBuffer buffer;
    const char* const names[channels] = {"R", "G", "B", "A", "N.X", "N.Y", "N.Z"};
    for (std::size_t c = 0; c < channels; ++c)
        buffer.insert(names[c], slice(Imf::HALF, halves.data() + c, channels * sizeof(half)));
    buffer.insert("Z", slice(Imf::FLOAT, distances.data(), sizeof(float)));
    if (verdicts) buffer.insert("verdict", slice(Imf::UINT, codes.data(), sizeof(unsigned)));
    output.setFrameBuffer(buffer);
    output.writePixels(rows.height);
    row += rows.height;
}

ExrStream::ExrStream(int width, int height, bool verdicts, GrowingFile& file) {
    try {
        implementation_ = std::make_unique<Implementation>(width, height, verdicts, file);
    } catch (const std::exception& error) {
        problem_ = error.what();
    }
}

ExrStream::~ExrStream() = default;

bool ExrStream::add(const Image& rows, const SurfaceLayers& layers) {
    if (!implementation_ || !problem_.empty()) return false;
    const std::size_t pixels = rows.pixels.size();
    if (rows.width != implementation_->width || layers.distance.size() != pixels ||
        layers.normal.size() != pixels || (implementation_->verdicts && layers.verdict.size() != pixels)) {
        problem_ = "the layers are not of the size of the picture";
        return false;
    }
    try {
        implementation_->add(rows, layers);
    } catch (const std::exception& error) {
        problem_ = error.what();
    }
    return problem_.empty();
}

}  // namespace isoscope
