// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/picture_file.h"

#include <algorithm>
#include <cctype>
#include <memory>
#include <new>

#include "core/exchange/exr_stream.h"
#include "core/exchange/png.h"
#include "core/render/render_image.h"
#include "core/text/whole_file.h"

namespace isoscope {

namespace {

/// Takes the strips of a picture, in order. `add` returns false after a failure.
class PictureSink {
  public:
    virtual ~PictureSink() = default;
    virtual bool add(const Image& strip, int firstRow) = 0;
    /// Whether it can end with so many black rows soon.
    virtual bool takesRest(int rows) const = 0;
    /// These; 0 are none.
    virtual bool addRest(int rows, int firstRow) = 0;
    /// Why, where that is not the file's problem.
    virtual std::string problem() const { return {}; }
};

class PngSink : public PictureSink {
  public:
    PngSink(const RenderRequest& request, const PictureFileOptions& options, GrowingFile& file)
        : stream_(
              {request.width, request.height, options.bits, request.transparent},
              [&file](std::string_view bytes) { return file.append(bytes); }, options.threads) {}

    bool add(const Image& strip, int) override { return stream_.add(strip); }
    bool takesRest(int) const override { return true; }
    bool addRest(int rows, int) override { return rows == 0 || stream_.addBlack(rows); }

  private:
    PngStream stream_;
};

class LayeredSink : public PictureSink {
  public:
    LayeredSink(const RenderRequest& request, const PictureFileOptions& options, std::stop_token stop,
                GrowingFile& file)
        : request_(request),
          threads_(options.threads),
          stop_(std::move(stop)),
          stream_(request.width, request.height, request.rootFinder == RootFinder::certified, file) {}

    bool add(const Image& strip, int firstRow) override {
        return stream_.add(strip, surfaceLayers(request_, firstRow, strip.height, threads_, stop_));
    }
    bool takesRest(int rows) const override {
        return std::int64_t{rows} * request_.width <= PictureFileOptions::largestExrRest;
    }
    bool addRest(int rows, int firstRow) override {
        constexpr int stripRows = 64;
        for (; rows > 0; rows -= stripRows, firstRow += stripRows) {
            Image black(request_.width, std::min(rows, stripRows));
            if (request_.transparent) black.opacity.assign(black.pixels.size(), 0);
            if (!add(black, firstRow)) return false;
        }
        return true;
    }
    std::string problem() const override { return stream_.problem(); }

  private:
    const RenderRequest& request_;
    int threads_;
    std::stop_token stop_;
    ExrStream stream_;
};

PictureFileResult write(const std::filesystem::path& path, const RenderRequest& request,
                        const PictureFileOptions& options, const std::stop_token& stop,
                        const std::function<void(double)>& report) {
    PictureFileResult result;
    if (!StripRenderer::drawable(request)) {
        result.problem = "there is no picture of that size";
        return result;
    }
    GrowingFile file(path);
    result.problem = file.problem();
    if (!result.problem.empty()) return result;
    std::unique_ptr<PictureSink> sink;
    if (options.format == PictureFormat::png)
        sink = std::make_unique<PngSink>(request, options, file);
    else
        sink = std::make_unique<LayeredSink>(request, options, stop, file);
    StripRenderer renderer(request, options.threads);
    bool added = true;
    while (added && renderer.nextRow() < request.height) {
        const int row = renderer.nextRow();
        const Image strip = renderer.next(stop, report);
        const int rest = request.height - renderer.nextRow();
        result.stopped = stop.stop_requested();
        if (result.stopped && !(options.keepStopped && sink->takesRest(rest))) return result;
        if (strip.pixels.empty()) throw std::bad_alloc();
        added = sink->add(strip, row);
        if (!result.stopped) continue;
        result.kept = true;
        added = added && sink->addRest(rest, renderer.nextRow());
        break;
    }
    result.statistics = renderer.statistics();
    std::string inside = sink->problem();
    // OpenEXR writes where the rows lie in the file at its end.
    sink.reset();
    if (!added && inside.empty()) inside = "it could not be compressed";
    result.problem = added || !file.problem().empty() ? file.finish() : inside;
    return result;
}

}  // namespace

std::optional<PictureFormat> pictureFormat(const std::filesystem::path& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (ending == ".png") return PictureFormat::png;
    if (ending == ".exr") return PictureFormat::openExr;
    return {};
}

PictureFileResult writePictureFile(const std::filesystem::path& file, const RenderRequest& request,
                                   const PictureFileOptions& options, std::stop_token stop,
                                   const std::function<void(double share)>& report) {
    try {
        return write(file, request, options, stop, report);
    } catch (const std::bad_alloc&) {
        PictureFileResult refused;
        refused.problem = "there is not enough memory";
        return refused;
    }
}

}  // namespace isoscope
