// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <QStringList>

#include "core/shapes/shape.h"
#include "tests/support/csv_table.h"

namespace isoscope::test {

/// How a shape compares with golden/rays.csv or golden/inside.csv (golden/README-rays.md says how to).
struct Agreement {
    std::size_t compared = 0;
    QStringList disagreements;

    void add(const Agreement& other) {
        compared += other.compared;
        disagreements += other.disagreements;
    }
};

using Parameters = std::shared_ptr<const std::vector<double>>;

/// Rays and points of the golden files, by shape.
class GoldenRays {
  public:
    GoldenRays()
        : shapes_(dataFile("golden/shapes.csv")),
          rays_(dataFile("golden/rays.csv")),
          points_(dataFile("golden/inside.csv")) {
        for (std::size_t row = 0; row < shapes_.rowCount(); ++row)
            shapeRow_[shapes_.field(row, "shape")] = row;
        for (std::size_t row = 0; row < rays_.rowCount(); ++row)
            rayRows_[rays_.field(row, "shape")].push_back(row);
        for (std::size_t row = 0; row < points_.rowCount(); ++row)
            pointRows_[points_.field(row, "shape")].push_back(row);
    }

    std::vector<std::string> names() const {
        std::vector<std::string> result;
        for (std::size_t row = 0; row < shapes_.rowCount(); ++row)
            if (!rayRows(shapes_.field(row, "shape")).empty()) result.push_back(shapes_.field(row, "shape"));
        return result;
    }

    const std::string& family(const std::string& shape) const {
        return shapes_.field(shapeRow_.at(shape), "family");
    }

    /// Hits of the rows that are not fragile, and normals where both are forward differences: the certified
    /// root finder's are exact. `own` is added to the tolerance of the file.
    Agreement rays(const std::string& name, const Shape& shape, double own, const Parameters& parameters = {},
                   RootFinder finder = RootFinder::lipschitz) const {
        Agreement result;
        const double tolerance = shapes_.number(shapeRow_.at(name), "tolerance") + own;
        std::vector<std::size_t> rows;
        std::vector<Ray> rays;
        for (const std::size_t row : rayRows(name)) {
            if (rays_.field(row, "fragile") == "1") continue;
            rows.push_back(row);
            rays.push_back({vector(row, "o"), vector(row, "d")});
        }
        TraceContext context(parameters, finder);
        context.missMemory = false;
        // POV-Ray's shapes overlook what is nearer than this, and the `inside` rays of flat patches begin on
        // them. The limit hides none of its answers: the nearest hit of all rows that are not fragile is
        // 1.7e-4 away (triangle_sliver), 170 times the limit.
        context.nearLimit = 1e-6;
        std::vector<NearestHit> nearest(rays.size());
        shape.nearest(rays, context, nearest);
        result.compared = rows.size();
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const QString problem = compare(rows[k], nearest[k], tolerance, finder == RootFinder::lipschitz);
            if (!problem.isEmpty())
                result.disagreements +=
                    QString::fromStdString(name) + QString(" ray %1: ").arg(rows[k] + 2) + problem;
        }
        return result;
    }

    Agreement points(const std::string& name, const Shape& shape, const Parameters& parameters = {}) const {
        Agreement result;
        const auto found = pointRows_.find(name);
        if (found == pointRows_.end()) return result;
        TraceContext context(parameters, RootFinder::lipschitz);
        for (const std::size_t row : found->second) {
            if (points_.field(row, "fragile") == "1") continue;
            ++result.compared;
            const glm::dvec3 point(points_.number(row, "x"), points_.number(row, "y"),
                                   points_.number(row, "z"));
            if (shape.contains(point, context) != (points_.field(row, "inside") == "1"))
                result.disagreements +=
                    QString::fromStdString(name) + QString(" point %1: inside differs").arg(row + 2);
        }
        return result;
    }

  private:
    const std::vector<std::size_t>& rayRows(const std::string& shape) const {
        static const std::vector<std::size_t> none;
        const auto found = rayRows_.find(shape);
        return found == rayRows_.end() ? none : found->second;
    }

    glm::dvec3 vector(std::size_t row, const std::string& prefix) const {
        return {rays_.number(row, prefix + "x"), rays_.number(row, prefix + "y"),
                rays_.number(row, prefix + "z")};
    }

    QString compare(std::size_t row, const NearestHit& nearest, double tolerance, bool normals) const {
        const bool wanted = rays_.field(row, "hit") == "1";
        const QString kind = " (" + QString::fromStdString(rays_.field(row, "class")) + ")";
        if (wanted != nearest.found) return (wanted ? "hit expected" : "miss expected") + kind;
        if (!wanted) return {};
        const glm::dvec3 normal = vector(row, "n");
        const double off = std::abs(glm::dot(nearest.hit.point - vector(row, "p"), normal));
        if (!(off <= tolerance)) return QString("hit is off by %1 along the normal").arg(off) + kind;
        if (!normals || rays_.field(row, "nfragile") == "1") return {};
        const double turned = glm::distance(nearest.hit.normal, normal);
        if (!(turned <= 1e-4)) return QString("normal is off by %1").arg(turned) + kind;
        return {};
    }

    CsvTable shapes_;
    CsvTable rays_;
    CsvTable points_;
    std::map<std::string, std::size_t> shapeRow_;
    std::map<std::string, std::vector<std::size_t>> rayRows_;
    std::map<std::string, std::vector<std::size_t>> pointRows_;
};

}  // namespace isoscope::test
