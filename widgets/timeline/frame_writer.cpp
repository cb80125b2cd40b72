// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/timeline/frame_writer.h"

#include "core/animation/animation.h"
#include "core/exchange/png.h"
#include "core/render/render_image.h"
#include "core/text/whole_file.h"
#include "widgets/viewport/viewport.h"

namespace isoscope {

namespace {

/// Why the frame is not there; empty when it is written.
std::string drawFrame(const FrameOrder& order, int frame, std::stop_token stop) {
    ParseOptions options = withoutStop(order.options);
    options.stop = stop;
    options.clockOn = true;
    options.clock = order.frames.clock(frame);
    options.frameNumber = frame;
    options.initialFrame = order.frames.first;
    options.finalFrame = order.frames.last;
    options.imageWidth = order.width;
    options.imageHeight = order.height;
    const ParseResult parsed = readAtClock(order.text, options);
    if (stop.stop_requested()) return FrameWriter::stopped;
    if (!parsed.ok()) {
        for (const Diagnostic& diagnostic : parsed.diagnostics)
            if (diagnostic.severity == Severity::error)
                return isoscope::FrameWriter::tr("Frame %1: %2")
                    .arg(frame)
                    .arg(QString::fromStdString(diagnostic.message))
                    .toStdString();
    }
    RenderRequest request;
    request.scene = parsed.scene;
    request.camera = fittedCamera(order.view.value_or(parsed.scene->camera), order.width, order.height);
    request.width = order.width;
    request.height = order.height;
    request.antialias = order.antialias;
    request.rootFinder = order.rootFinder;
    const Image image = renderImage(request, 0, nullptr, stop);
    if (stop.stop_requested()) return FrameWriter::stopped;
    const std::string file = order.frames.file(frame).string();
    const std::string reason = writeWhole(file, encodePng(image, 0), {.durable = false});
    return reason.empty() ? reason : file + ": " + reason;
}

}  // namespace

FrameWriter::FrameWriter(QObject* parent) : QObject(parent) {}

FrameWriter::~FrameWriter() { stop(); }

void FrameWriter::start(const FrameOrder& order) {
    if (running_) return;
    running_ = true;
    stop_ = {};
    worker_.submit([this, order, stop = stop_.get_token()](std::stop_token) {
        std::string problem;
        for (int frame = order.frames.first; frame <= order.frames.last && problem.empty(); ++frame) {
            problem = drawFrame(order, frame, stop);
            const int done = frame - order.frames.first + 1;
            if (problem.empty())
                QMetaObject::invokeMethod(
                    this, [this, done] { emit progressed(done); }, Qt::QueuedConnection);
        }
        QMetaObject::invokeMethod(
            this,
            [this, error = QString::fromStdString(problem)] {
                running_ = false;
                emit finished(error);
            },
            Qt::QueuedConnection);
    });
}

void FrameWriter::stop() { stop_.request_stop(); }

}  // namespace isoscope
