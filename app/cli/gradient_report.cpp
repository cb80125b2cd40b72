// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/gradient_report.h"

#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "core/study/gradient/gradient_verdict.h"
#include "core/text/csv_table.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

class CsvReport : public GradientReport {
  public:
    explicit CsvReport(bool withPlaces) : withPlaces_(withPlaces) {
        std::vector<std::string> header{"sampled", "lower",     "upper",   "x",      "y",
                                        "z",       "suggested", "verdict", "seconds"};
        if (withPlaces_) header.insert(header.end(), {"place", "max_gradient"});
        std::cout << csvLine(header);
    }

    void add(const StudiedGradient& studied) override {
        if (!studied.problem.empty()) {
            std::cout << csvLine({"nan", "nan", "nan", "nan", "nan", "nan", "nan", studied.verdict, "0"});
            return;
        }
        const GradientBracket& b = studied.bracket;
        std::vector<std::string> row{exactNumber(studied.sampled),
                                     exactNumber(b.lower),
                                     exactNumber(b.upper),
                                     exactNumber(b.place.x),
                                     exactNumber(b.place.y),
                                     exactNumber(b.place.z),
                                     exactNumber(suggestedGradient(b)),
                                     studied.verdict,
                                     fixedNumber(studied.seconds, 3)};
        if (withPlaces_)
            row.insert(row.end(), {studied.place, studied.setting ? exactNumber(*studied.setting) : "nan"});
        std::cout << csvLine(row);
    }
    void finish() override {}

  private:
    bool withPlaces_;
};

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json point(const glm::dvec3& p) { return Json::array({number(p.x), number(p.y), number(p.z)}); }

class JsonReport : public GradientReport {
  public:
    void add(const StudiedGradient& studied) override {
        Json json;
        json["verdict"] = studied.verdict;
        if (!studied.problem.empty()) {
            json["problem"] = studied.problem;
            all_.push_back(std::move(json));
            return;
        }
        const GradientBracket& b = studied.bracket;
        if (!studied.place.empty()) json["file_line"] = studied.place;
        if (studied.setting) json["max_gradient"] = number(*studied.setting);
        json["sampled"] = number(studied.sampled);
        json["lower"] = number(b.lower);
        json["upper"] = number(b.upper);
        json["place"] = point(b.place);
        json["suggested"] = number(suggestedGradient(b));
        json["state"] = name(b.state);
        json["seams"] = b.seams;
        json["singularity"] = nullptr;
        if (b.singularity)
            json["singularity"] = {{"kind", name(b.singularity->kind)},
                                   {"place", point(b.singularity->place)},
                                   {"advice", advice(b.singularity->kind)}};
        json["beside"] = nullptr;
        if (b.beside)
            json["beside"] = {{"lower", number(b.beside->lower)}, {"upper", number(b.beside->upper)},
                              {"place", point(b.beside->place)},  {"state", name(b.beside->state)},
                              {"reach", number(b.beside->reach)}, {"share", number(b.beside->share)}};
        json["boxes"] = b.boxes;
        json["seconds"] = studied.seconds;
        all_.push_back(std::move(json));
    }
    void finish() override {
        // Texts of the scene may hold any bytes.
        std::cout << all_.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
    }

  private:
    Json all_ = Json::array();
};

}  // namespace

std::unique_ptr<GradientReport> GradientReport::csv(bool withPlaces) {
    return std::make_unique<CsvReport>(withPlaces);
}
std::unique_ptr<GradientReport> GradientReport::json() { return std::make_unique<JsonReport>(); }

}  // namespace isoscope::cli
