// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/viewport/scene_guides.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <optional>
#include <QPainter>

#include "core/scene/scene.h"
#include "widgets/section/section_plane.h"

namespace isoscope {

namespace {

const QColor frontColor(0xff, 0xff, 0xff, 215), backColor(0xff, 0xff, 0xff, 80), shade(0, 0, 0, 130);
constexpr double beyondContainers = 1.2;  ///< how far axes go, as a share of the containers
constexpr int stretches = 24;             ///< of a straight line, parts of which may lie behind the camera
constexpr int circleStretches = 72;

const std::array<QColor, 3> axisColors{QColor(0xff, 0x6b, 0x5e), QColor(0x6f, 0xd0, 0x5c),
                                       QColor(0x6a, 0xa8, 0xff)};

glm::dvec3 axis(int number) {
    glm::dvec3 direction(0);
    direction[number] = 1;
    return direction;
}

/// The parts of a line through many points that the view shows.
std::vector<QPolygonF> seen(const ViewProjection& view, const std::vector<glm::dvec3>& points) {
    std::vector<QPolygonF> parts(1);
    for (const glm::dvec3& point : points) {
        if (const auto pixel = view.pixelOf(point))
            parts.back() << *pixel;
        else if (!parts.back().isEmpty())
            parts.emplace_back();
    }
    return parts;
}

/// On a dark ground, so that lines are seen on light and dark pictures.
void paintLine(QPainter& painter, const std::vector<QPolygonF>& parts, const QColor& color, double width) {
    QColor ground = shade;
    ground.setAlpha(shade.alpha() * color.alpha() / 255);
    for (const QPen& pen : {QPen(ground, width + 2), QPen(color, width)}) {
        painter.setPen(pen);
        for (const QPolygonF& part : parts) painter.drawPolyline(part);
    }
}

std::vector<glm::dvec3> straight(const glm::dvec3& from, const glm::dvec3& to) {
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= stretches; ++i)
        points.push_back(from + (to - from) * (static_cast<double>(i) / stretches));
    return points;
}

/// The last point of the line that has room for a name in the picture.
std::optional<QPointF> endWithin(const QRect& area, const ViewProjection& view,
                                 const std::vector<glm::dvec3>& line) {
    constexpr double room = 12;
    const QRectF inside = QRectF(area).adjusted(room, room, -room, -room);
    for (auto point = line.rbegin(); point != line.rend(); ++point)
        if (const auto pixel = view.pixelOf(*point); pixel && inside.contains(*pixel)) return pixel;
    return {};
}

void paintName(QPainter& painter, const QPointF& at, const QString& name, const QColor& color) {
    const QRectF box(at - QPointF(9, 9), QSizeF(18, 18));
    painter.setPen(Qt::NoPen);
    painter.setBrush(QColor(0x2b, 0x2e, 0x33, 200));
    painter.drawEllipse(box);
    painter.setPen(color);
    painter.drawText(box, Qt::AlignCenter, name);
}

}  // namespace

void SceneGuides::setScene(const Scene* scene) {
    containers_.clear();
    reach_ = 0;
    if (scene)
        for (const SceneIsosurface& placed : scene->isosurfaces) {
            if (!placed.shape || containers_.size() == mostContainers) continue;
            const Container& container = placed.shape->settings().container;
            const Bounds bounds = containerBounds(container);
            bool finite = true;
            for (int corner = 0; corner < 8; ++corner) {
                const glm::dvec3 point = placed.transform.point({corner & 1 ? bounds.high.x : bounds.low.x,
                                                                 corner & 2 ? bounds.high.y : bounds.low.y,
                                                                 corner & 4 ? bounds.high.z : bounds.low.z});
                const double far = std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
                finite = finite && std::isfinite(far);
                if (finite) reach_ = std::max(reach_, far);
            }
            if (finite) containers_.push_back({container, placed.transform});
        }
    reach_ = reach_ > 0 ? beyondContainers * reach_ : 1;
    if (containersShown_ || axesShown_) emit changed();
}

void SceneGuides::setContainersShown(bool shown) {
    containersShown_ = shown;
    emit changed();
}

void SceneGuides::setAxesShown(bool shown) {
    axesShown_ = shown;
    emit changed();
}

void SceneGuides::paint(QPainter& painter, const ViewProjection& view, const QRect& area) const {
    if (!containersShown_ && !axesShown_) return;
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    if (containersShown_)
        for (const Placed& placed : containers_) paintContainer(painter, view, placed);
    if (axesShown_) {
        paintAxes(painter, view, area);
        paintGizmo(painter, view, area);
    }
    painter.restore();
}

/// The edges of a box, or three circles around a sphere. What its own container hides of them is fainter.
void SceneGuides::paintContainer(QPainter& painter, const ViewProjection& view, const Placed& placed) const {
    const auto facesEye = [&](const glm::dvec3& point, const glm::dvec3& normal) {
        const glm::dvec3 world = placed.toWorld.point(point);
        return glm::dot(view.sightTo(world), placed.toWorld.normal(normal)) < 0;
    };
    std::vector<std::vector<glm::dvec3>> front, back;
    if (const auto* box = std::get_if<ContainerBox>(&placed.container)) {
        const std::array<glm::dvec3, 2> ends{box->low, box->high};
        for (int along = 0; along < 3; ++along)
            for (int corner = 0; corner < 4; ++corner) {
                const int second = (along + 1) % 3, third = (along + 2) % 3;
                glm::dvec3 from = box->low, to = box->low;
                from[second] = to[second] = ends[static_cast<std::size_t>(corner & 1)][second];
                from[third] = to[third] = ends[static_cast<std::size_t>(corner >> 1)][third];
                to[along] = box->high[along];
                // An edge is seen where one of its two faces is.
                const bool shown = facesEye(from, (corner & 1 ? 1.0 : -1.0) * axis(second)) ||
                                   facesEye(from, (corner >> 1 ? 1.0 : -1.0) * axis(third));
                (shown ? front : back).push_back(straight(from, to));
            }
    } else {
        const auto& sphere = std::get<ContainerSphere>(placed.container);
        for (int across = 0; across < 3; ++across) {
            bool shown = false;
            for (int i = 0; i <= circleStretches; ++i) {
                const double turn = 2 * std::numbers::pi * i / circleStretches;
                const glm::dvec3 normal =
                    std::cos(turn) * axis((across + 1) % 3) + std::sin(turn) * axis((across + 2) % 3);
                const glm::dvec3 point = sphere.center + sphere.radius * normal;
                const bool now = facesEye(point, normal);
                auto& lines = now ? front : back;
                if (i == 0)
                    lines.emplace_back();
                else if (now != shown)
                    // Goes on where the line on the other side ends.
                    lines.push_back({(shown ? front : back).back().back()});
                lines.back().push_back(point);
                shown = now;
            }
        }
    }
    const auto draw = [&](std::vector<std::vector<glm::dvec3>>& lines, const QColor& color) {
        for (std::vector<glm::dvec3>& line : lines) {
            for (glm::dvec3& point : line) point = placed.toWorld.point(point);
            paintLine(painter, seen(view, line), color, 1.2);
        }
    };
    draw(back, backColor);
    draw(front, frontColor);
}

void SceneGuides::paintAxes(QPainter& painter, const ViewProjection& view, const QRect& area) const {
    for (int k = 0; k < 3; ++k) {
        const QColor color = axisColors[static_cast<std::size_t>(k)];
        QColor faint = color;
        faint.setAlpha(90);
        // The negative half is fainter: which way an axis points is seen without its name.
        paintLine(painter, seen(view, straight(-reach_ * axis(k), glm::dvec3(0))), faint, 1.2);
        paintLine(painter, seen(view, straight(glm::dvec3(0), reach_ * axis(k))), color, 1.6);
        if (const auto end = endWithin(area, view, straight(glm::dvec3(0), reach_ * axis(k))))
            paintName(painter, *end, QString(QLatin1Char("xyz"[k])), color);
    }
}

/// How the view is turned, in the lower right corner: the axes without perspective, the nearest drawn last.
void SceneGuides::paintGizmo(QPainter& painter, const ViewProjection& view, const QRect& area) const {
    constexpr double radius = 26, margin = 44;
    const QPointF middle(area.right() - margin, area.bottom() - margin);
    std::array<int, 3> order{0, 1, 2};
    const auto depth = [&](int k) { return view.turned(axis(k)).z; };
    std::sort(order.begin(), order.end(), [&](int a, int b) { return depth(a) > depth(b); });
    for (const int k : order) {
        const glm::dvec3 way = view.turned(axis(k));
        const QPointF tip = middle + radius * QPointF(way.x, -way.y);
        const QColor color = axisColors[static_cast<std::size_t>(k)];
        paintLine(painter, {QPolygonF{{middle, tip}}}, color, 2);
        paintName(painter, tip, QString(QLatin1Char("xyz"[k])), color);
    }
}

}  // namespace isoscope
