// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/functions/function_insertion.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <optional>

#include "core/study/view/fitted_view.h"
#include "widgets/editor/text_outline.h"
#include "widgets/functions/function_snippet.h"
#include "widgets/numbers/number_text.h"
#include "widgets/viewport/camera_text.h"

namespace isoscope {

namespace {

const char* const includeLine = "#include \"functions.inc\"\n";
const char* const lights =
    "light_source { <4000, 6000, -5000> rgb 0.9 }\n"
    "light_source { <-6000, 2000, -3000> rgb <0.2, 0.24, 0.32> shadowless }\n";
const char* const camera =
    "camera {\n  location <2.4, 1.8, -3.2>\n  right x*image_width/image_height\n  look_at 0\n  angle 40\n}\n";

/// What is that much larger or smaller than the rest is scaled to its size.
constexpr double unlike = 4;
/// A camera of a text is fitted for pictures of 4 to 3, POV-Ray's own, and must do for 16 to 9, too.
constexpr double insertedShare = 0.74;
/// Between neighbours, in parts of the larger one.
constexpr double gapShare = 0.15;
constexpr double resolution = 0.001;  ///< of places, in parts of the size

double sizeOf(const Bounds& box) {
    const glm::dvec3 size = box.high - box.low;
    return std::max({size.x, size.y, size.z});
}

int largestAxis(const glm::dvec3& v) {
    const glm::dvec3 a = glm::abs(v);
    return a.x >= a.y && a.x >= a.z ? 0 : a.y >= a.z ? 1 : 2;
}

/// Lines that put what lies in `own` beside what lies in `there`, as `view` sees it: to the right, on the
/// same ground, at the same depth.
QString placementBeside(const Bounds& there, const Bounds& own, const Camera& view) {
    const double size = sizeOf(there), ownSize = sizeOf(own);
    if (isEmpty(there) || isEmpty(own) || !there.finite() || !own.finite() || !(size > 0) || !(ownSize > 0))
        return {};
    const double ratio = size / ownSize;
    const bool scaled = ratio > unlike || ratio < 1 / unlike;
    const double unit = std::pow(10, std::floor(std::log10(ratio)));
    const double factor = scaled ? std::round(ratio / unit) * unit : 1;
    const Bounds box{factor * own.low, factor * own.high};
    const int across = largestAxis(view.right);
    glm::dvec3 sky = view.sky;
    sky[across] = 0;
    const int up = largestAxis(sky);
    const double gap = gapShare * std::max(size, sizeOf(box));
    glm::dvec3 shift = 0.5 * (there.low + there.high - box.low - box.high);
    shift[across] = view.right[across] < 0 ? there.low[across] - box.high[across] - gap
                                           : there.high[across] - box.low[across] + gap;
    shift[up] = view.sky[up] < 0 ? there.high[up] - box.high[up] : there.low[up] - box.low[up];
    const auto text = [&](int k) { return numberText(shift[k], resolution * size); };
    return (scaled ? QString("  scale %1\n").arg(numberText(factor, 0.01 * factor)) : QString()) +
           QString("  translate <%1, %2, %3>\n").arg(text(0), text(1), text(2));
}

/// A text with changes, none of which overlap.
class Draft {
  public:
    explicit Draft(const std::string& text) : text_(&text) {}

    void replace(std::size_t begin, std::size_t end, const QString& replacement) {
        const SearchMatch added{static_cast<int>(begin), static_cast<int>(end), replacement};
        // What is only inserted goes before what is replaced from there on.
        const auto next = std::find_if(changes_.begin(), changes_.end(), [&](const SearchMatch& change) {
            return change.begin > added.begin || (change.begin == added.begin && begin == end);
        });
        changes_.insert(next, added);
    }
    const std::vector<SearchMatch>& changes() const { return changes_; }
    std::string result() const {
        std::string text = *text_;
        for (auto change = changes_.rbegin(); change != changes_.rend(); ++change)
            text.replace(static_cast<std::size_t>(change->begin),
                         static_cast<std::size_t>(change->end - change->begin),
                         change->replacement.toStdString());
        return text;
    }
    /// Behind the first change at `begin`, in the result.
    int endOf(std::size_t begin) const {
        qsizetype moved = 0;
        for (const SearchMatch& change : changes_) {
            moved += change.replacement.toUtf8().size();
            if (change.begin == static_cast<int>(begin)) return static_cast<int>(change.begin + moved);
            moved -= change.end - change.begin;
        }
        return static_cast<int>(text_->size());
    }

  private:
    const std::string* text_;
    std::vector<SearchMatch> changes_;
};

/// What a whole statement is brought in with.
struct Additions {
    QString statement;
    QString camera;                       ///< block that comes along, or takes the place of the text's own
    std::optional<SourceRange> replaced;  ///< that one
};

Draft draftOf(const std::string& text, const TextOutline& outline, const Additions& additions) {
    QString added;
    if (outline.place > 0 && text[outline.place - 1] != '\n') added += '\n';
    const bool together = outline.includePlace == outline.place;
    if (!outline.includesFunctions && together) added += includeLine;
    if (!additions.replaced) added += additions.camera;
    if (!outline.hasLight) added += lights;
    Draft draft(text);
    draft.replace(outline.place, outline.place, added + additions.statement);
    if (!outline.includesFunctions && !together)
        draft.replace(outline.includePlace, outline.includePlace, includeLine);
    if (additions.replaced)
        draft.replace(additions.replaced->begin, additions.replaced->end, additions.camera);
    return draft;
}

/// The camera block moved to where it shows all that `scene` does; empty when it cannot.
QString movedCamera(std::string_view block, const std::shared_ptr<const Scene>& scene,
                    const std::stop_token& stop) {
    SurfaceBounds surfaces(scene, {}, stop);
    const Camera facing = turnedToFace(scene->camera, surfaces.box());
    const auto fitted = fittedView(facing, facing, surfaces, insertedShare);
    return fitted ? QString::fromStdString(cameraText(block, scene->camera, *fitted)) : QString();
}

}  // namespace

FunctionInsertion insertStatement(const Builtin& builtin, const ParseResult& parsed, const std::string& text,
                                  std::size_t caret, std::stop_token stop) {
    const TextOutline outline = outlineOf(text, caret);
    const bool empty = parsed.scene->objects.empty();
    QString placement;
    if (!empty) {
        SurfaceBounds there(parsed.scene, {}, stop);
        SurfaceBounds own(parseScene(thumbnailScene(builtin)).scene, {}, stop);
        placement = placementBeside(there.box(), own.box(), parsed.scene->camera);
    }
    Additions additions{statementSnippet(builtin, placement), {}, {}};
    if (!outline.hasCamera) additions.camera = camera;
    Draft draft = draftOf(text, outline, additions);
    FunctionInsertion insertion;
    // The camera is the text's own matter, unless it is new or has shown nothing so far.
    const std::optional<SourceRange>& own = parsed.scene->cameraRange;
    const bool replaces = outline.hasCamera && empty && own && own->file == 0 && own->begin <= own->end &&
                          own->end <= text.size();
    if (replaces || !outline.hasCamera) {
        const ParseResult whole = parseScene(draft.result(), parsed.options);
        const std::string block = replaces ? text.substr(own->begin, own->end - own->begin) : camera;
        const QString moved = movedCamera(block, whole.scene, stop);
        insertion.cameraWritten = !moved.isEmpty();
        if (insertion.cameraWritten) {
            additions.camera = moved;
            if (!replaces && !moved.endsWith('\n')) additions.camera += '\n';
            if (replaces) additions.replaced = own;
            draft = draftOf(text, outline, additions);
        }
    }
    insertion.changes = draft.changes();
    insertion.caret = draft.endOf(outline.place);
    return insertion;
}

FunctionInsertion insertCall(const Builtin& builtin, const std::string& text, std::size_t begin,
                             std::size_t end) {
    const TextOutline outline = outlineOf(text, begin);
    Draft draft(text);
    if (!outline.includesFunctions && outline.includePlace <= begin)
        draft.replace(outline.includePlace, outline.includePlace, includeLine);
    draft.replace(begin, end, callSnippet(builtin));
    return {draft.changes(), draft.endOf(begin), false};
}

}  // namespace isoscope
