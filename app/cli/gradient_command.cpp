// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "app/cli/command_support.h"
#include "app/cli/commands.h"
#include "app/cli/container_text.h"
#include "app/cli/gradient_report.h"
#include "app/cli/output_files.h"
#include "app/cli/time_limit.h"
#include "core/evaluate/tape/loop_stop.h"
#include "core/exchange/gradient_repairs.h"
#include "core/render/render_image.h"
#include "core/study/gradient/gradient_study.h"
#include "core/study/gradient/gradient_verdict.h"
#include "core/study/gradient/proof_note.h"
#include "core/study/view/isosurfaces_of.h"
#include "core/text/number_format.h"

namespace isoscope::cli {

namespace {

struct GradientArguments {
    SceneArguments scene;
    std::vector<std::string> moreScenes;
    std::string object;
    std::string table;
    GradientStudySettings settings{.threads = 0};
    std::optional<double> proofLimit;  ///< seconds for all of it
    std::string changedScene;
    std::vector<std::string> only;
    bool repair = false;
    OutputFiles outputs;
    bool check = false;
    bool json = false;
};

/// Where no other is asked for: by what the caller has named, not by what that holds.
double proofSeconds(const GradientArguments& arguments) {
    if (arguments.proofLimit) return *arguments.proofLimit;
    if (!arguments.table.empty()) return WorkLimit::ofPictures;
    return WorkLimit::ofStudies * static_cast<double>(1 + arguments.moreScenes.size());
}

/// The time of a whole command, however many isosurfaces or rows there are.
class ProofTime {
  public:
    explicit ProofTime(const GradientArguments& arguments)
        : seconds_(proofSeconds(arguments)), limit_(seconds_) {}

    std::stop_token token() const { return limit_.token(); }
    bool over() const { return limit_.over(); }
    /// For the picture of one scene.
    double secondsForPicture(std::size_t scenes) {
        return std::min(seconds_ / (4 * static_cast<double>(scenes)), limit_.secondsLeft());
    }
    /// "PLACE: note: the time is over (--proof-limit 20); WHAT" on standard error.
    void tell(const std::string& place, std::string_view severity, const std::string& what) const {
        std::cerr << place << ": " << severity << ": the time is over (--proof-limit "
                  << shortestNumber(seconds_) << "); " << what << '\n';
    }

  private:
    double seconds_;
    TimeLimit limit_;
};

/// The verdict on what the time did not suffice for: nothing is proven of it.
constexpr const char* notStudied = "not-studied";

/// "this row and the 7 after it were not studied".
std::string notStudiedText(const std::string& one, std::size_t after) {
    if (after == 0) return "this " + one + " was not studied";
    return "this " + one + " and the " + std::to_string(after) + " after it were not studied";
}

StudiedGradient unstudied() {
    StudiedGradient result;
    result.bracket.state = GradientState::stopped;
    result.verdict = notStudied;
    return result;
}

/// `name` is what a message calls it when the time is over.
StudiedGradient study(const std::shared_ptr<const Tape>& tape, std::span<const double> parameters,
                      const Container& container, const GradientArguments& arguments, const ProofTime& time,
                      const std::string& name) {
    const auto begin = std::chrono::steady_clock::now();
    const LoopStop loops(time.token());
    StudiedGradient result;
    GradientStudy study(tape, parameters, container, arguments.settings);
    result.bracket = study.run(time.token());
    const auto& beside = result.bracket.beside;
    if (result.bracket.state == GradientState::stopped || (beside && beside->state == GradientState::stopped))
        time.tell(name, "note", "what is given is proven so far");
    result.sampled = study.sampled();
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    return result;
}

std::unique_ptr<GradientReport> reportFor(const GradientArguments& arguments) {
    return arguments.json ? GradientReport::json() : GradientReport::csv(arguments.check);
}

/// What is proven beside infinite gradients, one sentence; empty when nothing is.
std::string besideText(const GradientBracket& bracket) {
    if (!bracket.beside || !std::isfinite(bracket.beside->upper)) return {};
    const GradientBeside& beside = *bracket.beside;
    const std::string most = "no gradient exceeds " + shortestNumber(beside.suggested()) + ".";
    if (!(beside.share > 0)) return "Beside jumps " + most;
    return "Farther than " + shortestNumber(beside.reach) + " from such places " + most;
}

/// Of a function without a setting: how the study ended.
std::string verdictOf(const GradientBracket& bracket) {
    std::string verdict(name(bracket.state));
    if (bracket.singularity) verdict += "-" + std::string(name(bracket.singularity->kind));
    return verdict;
}

ExitStatus studyTable(const GradientArguments& arguments) {
    const std::optional<CsvTable> table = loadTable(arguments.table, {"function", "container"});
    if (!table) return inputHasErrors;
    ExitStatus status = done;
    const auto report = reportFor(arguments);
    const ProofTime time(arguments);
    for (std::size_t row = 0; row < table->rowCount(); ++row) {
        const std::string name = arguments.table + ": row " + std::to_string(row + 1);
        if (time.over()) {
            time.tell(name, "note", notStudiedText("row", table->rowCount() - row - 1));
            for (; row < table->rowCount(); ++row) report->add(unstudied());
            break;
        }
        ParseOptions options;
        options.restrictedReading = true;
        const ParsedFunction parsed =
            parseFunction(table->field(row, "function"), table->field(row, "prelude"), options);
        const std::optional<Container> container = readContainer(table->field(row, "container"));
        StudiedGradient studied;
        if (!parsed.ok() || !container) {
            studied.problem = parsed.diagnostics.empty() ? "neither box{<,,>,<,,>} nor sphere{<,,>,}"
                                                         : parsed.diagnostics.front().message;
            studied.verdict = "error";
            std::cerr << arguments.table << ": error: row " << row + 1 << ": " << studied.problem << '\n';
            status = inputHasErrors;
        } else {
            studied = study(Tape::compile(parsed.value.function), parsed.parameterTable, *container,
                            arguments, time, name);
            studied.verdict = verdictOf(studied.bracket);
        }
        report->add(studied);
    }
    report->finish();
    return status;
}

struct Subject {
    std::shared_ptr<const Isosurface> surface;
    double alongRays = 0;  ///< steepest slope that the rays of the picture met
    std::string place;     ///< file:line of its statement; empty for those of a declared object
};

/// `scene` is the file as the caller names it.
std::string placeOf(const SourceRange& range, const SourceLibrary& sources, const std::string& scene) {
    const SourceText& text = sources[range.file];
    return (range.file == 0 ? scene : text.name()) + ":" + std::to_string(text.position(range.begin).line);
}

/// The isosurfaces that the scene shows, with what a small picture sees of them; or those of one declared
/// object.
std::vector<Subject> subjects(const ParseResult& parsed, const std::string& scene, const std::string& object,
                              double pictureSeconds) {
    std::vector<Subject> all;
    if (!object.empty()) {
        for (const auto& surface : isosurfacesOf(declaredShape(parsed, object)))
            all.push_back({surface, 0, {}});
        return all;
    }
    RenderRequest request;
    request.scene = parsed.scene;
    request.camera = parsed.scene->camera;
    request.width = 160;
    request.height = 120;
    RenderStatistics statistics;
    const TimeLimit limit(pictureSeconds);
    renderImage(request, 0, &statistics, limit.token());
    for (std::size_t i = 0; i < parsed.scene->isosurfaces.size(); ++i) {
        const double steepest = i < statistics.gradients.size() ? statistics.gradients[i].steepest : 0;
        const SceneIsosurface& isosurface = parsed.scene->isosurfaces[i];
        all.push_back({isosurface.shape, steepest, placeOf(isosurface.range, *parsed.sources, scene)});
    }
    return all;
}

/// Where a setting loses the surface or wastes time, the proven value.
void addRepair(GradientRepairs& repairs, std::size_t number, GradientVerdict verdict,
               const GradientBracket& bracket) {
    if (verdict == GradientVerdict::holes || verdict == GradientVerdict::wasteful)
        repairs.add(number, suggestedGradient(bracket));
}

/// Writes them where they stand: into the scene and the include files in its folder or below, and tells of
/// each on standard error. False when one could not be written.
bool writeBack(const GradientRepairs& repairs, const ParseResult& parsed, const std::string& scene) {
    bool written = true;
    for (const std::uint32_t file : repairs.files()) {
        const std::string name = file == 0 ? scene : (*parsed.sources)[file].name();
        const std::string why = GradientRepairs::obstacle(parsed, file, scene);
        if (!why.empty()) {
            std::cerr << name << ": error: " << why << "; the file stays as it is\n";
            written = false;
        } else if (writeOutput(name, repairs.text(file))) {
            std::cerr << name << ": note: " << repairs.changes(file).size()
                      << " of its max_gradient changed\n";
        } else {
            written = false;
        }
    }
    return written;
}

/// As compilers say it: where which value is to stand.
void printTooSmall(const StudiedGradient& studied) {
    const GradientBracket& b = studied.bracket;
    const auto rounded = [](double value) {
        std::ostringstream text;
        text << std::setprecision(6) << value;
        return text.str();
    };
    std::cerr << studied.place << ": error: max_gradient " << rounded(*studied.setting)
              << " is too small: the largest gradient is ";
    if (std::isinf(b.lower))
        std::cerr << "infinite\n";
    else if (const std::string low = rounded(b.lower), high = rounded(b.upper); low == high)
        std::cerr << low << "; use " << rounded(suggestedGradient(b)) << '\n';
    else
        std::cerr << "between " << low << " and " << high << "; use " << rounded(suggestedGradient(b))
                  << '\n';
}

/// Whether --only leaves it in.
bool isChosen(const GradientArguments& arguments, const std::string& place) {
    return arguments.only.empty() || std::ranges::find(arguments.only, place) != arguments.only.end();
}

/// False, with a message on standard error, where the comment in front of the statement is not true any more.
bool noteHolds(const ParseResult& parsed, std::size_t number, const StudiedGradient& studied) {
    const SceneIsosurface& statement = parsed.scene->isosurfaces[number];
    if (statement.range.file != 0) return true;
    const auto note = noteBefore((*parsed.sources)[0].text(), statement.range);
    const double accuracy = statement.shape->rootSettings().accuracy;
    if (!note || checkNote(*note, studied.bracket, accuracy) != NoteState::broken) return true;
    std::cerr << studied.place << ": warning: " << brokenNoteText(*note, studied.bracket, accuracy) << '\n';
    return false;
}

/// What is told of a scene whose isosurfaces are studied.
struct SceneStudy {
    const GradientArguments& arguments;
    ProofTime& time;
    GradientReport& report;
    const ParseResult& parsed;
    GradientRepairs repairs{parsed};
    bool holes = false, broken = false;

    /// Isosurface `number`, in time.
    void look(std::size_t number, const Subject& subject) {
        StudiedGradient studied = study(subject.surface->tape(), *parsed.scene->parameterTable,
                                        subject.surface->settings().container, arguments, time,
                                        subject.place.empty() ? arguments.scene.file : subject.place);
        if (arguments.object.empty()) studied.sampled = subject.alongRays;
        const GradientVerdict verdict =
            judgeGradient(subject.surface->rootSettings().maxGradient, studied.bracket, subject.alongRays);
        holes = holes || verdict == GradientVerdict::holes;
        studied.verdict = name(verdict);
        add(subject, studied);
        if (arguments.object.empty() && isChosen(arguments, subject.place))
            addRepair(repairs, number, verdict, studied.bracket);
        if (arguments.object.empty() && !noteHolds(parsed, number, studied)) broken = true;
        if (arguments.check && verdict == GradientVerdict::holes && !studied.place.empty())
            printTooSmall(studied);
        if (studied.bracket.singularity)
            std::cerr << arguments.scene.file << ": note: " << advice(studied.bracket.singularity->kind)
                      << '\n';
        if (const std::string beside = besideText(studied.bracket); !beside.empty())
            std::cerr << arguments.scene.file << ": note: " << beside << '\n';
    }

    /// Those for which there was no time.
    void leaveOut(std::span<const Subject> subjects) {
        time.tell(subjects.front().place.empty() ? arguments.scene.file : subjects.front().place,
                  arguments.check ? "error" : "note", notStudiedText("isosurface", subjects.size() - 1));
        for (const Subject& subject : subjects) {
            StudiedGradient none = unstudied();
            none.sampled = subject.alongRays;
            add(subject, none);
        }
    }

  private:
    void add(const Subject& subject, StudiedGradient& studied) {
        studied.setting = subject.surface->rootSettings().maxGradient;
        studied.place = subject.place;
        report.add(studied);
    }
};

ExitStatus studyScene(const GradientArguments& arguments, ProofTime& time, GradientReport& report) {
    if (!arguments.outputs.mayWrite(arguments.changedScene, OutputKind::scene, arguments.scene.file))
        return inputHasErrors;
    const ParseResult parsed = loadScene(arguments.scene);
    printDiagnostics(parsed.diagnostics, *parsed.sources, true);
    const std::vector<Subject> found = subjects(parsed, arguments.scene.file, arguments.object,
                                                time.secondsForPicture(1 + arguments.moreScenes.size()));
    if (found.empty()) {
        std::cerr << arguments.scene.file << ": error: there is no isosurface"
                  << (arguments.object.empty() ? "" : " called `" + arguments.object + "`") << '\n';
        return inputHasErrors;
    }
    SceneStudy work{arguments, time, report, parsed};
    std::size_t number = 0;
    for (; number < found.size() && !time.over(); ++number) work.look(number, found[number]);
    const bool all = number == found.size();
    if (!all) work.leaveOut(std::span(found).subspan(number));
    if (!arguments.changedScene.empty() && !writeOutput(arguments.changedScene, work.repairs.text(0)))
        return inputHasErrors;
    if (arguments.repair && !writeBack(work.repairs, parsed, arguments.scene.file)) return inputHasErrors;
    if (!parsed.ok()) return inputHasErrors;
    // What was not looked at has not passed.
    return arguments.check && (work.holes || work.broken || !all) ? inputHasErrors : done;
}

/// One after the other; what one lacks does not keep the others from being studied.
ExitStatus studyScenes(const GradientArguments& arguments) {
    const auto report = reportFor(arguments);
    ProofTime time(arguments);
    ExitStatus status = studyScene(arguments, time, *report);
    for (const std::string& file : arguments.moreScenes) {
        GradientArguments one = arguments;
        one.scene.file = file;
        if (studyScene(one, time, *report) != done) status = inputHasErrors;
    }
    report->finish();
    return status;
}

}  // namespace

void addGradientCommand(CommandLine& line) {
    Command command = line.add("gradient", "Proven bounds of the largest gradient, for max_gradient");
    auto arguments = std::make_shared<GradientArguments>();
    arguments->scene.addTo(command);
    const Option scene = command.find("scene").required(false);
    const Option more = command.option("more", arguments->moreScenes, "Further scenes (with --check)");
    command.option("--object", arguments->object, "Declared object to look at instead of the scene")
        .needs(scene)
        .excludes(more);
    command.option("--table", arguments->table, "CSV with function,container[,prelude]").excludes(scene);
    command.option("--width", arguments->settings.relativeWidth, "Relative width of the bracket to stop at")
        .within(1e-9, 1e9)
        .showDefault();
    command.option("--boxes", arguments->settings.boxLimit, "Boxes to look at before giving up")
        .showDefault();
    command.option("--threads", arguments->settings.threads, "Number of threads; 0 means all cores")
        .within(0, 1024)
        .showDefault();
    command
        .option("--proof-limit", arguments->proofLimit,
                "Seconds to work in all (default: 20 for each scene, 600 for a table); what is proven "
                "then is told, and what was not studied")
        .positive();
    command.flag("--json", arguments->json, "One JSON array instead of CSV, with states and singularities");
    command.flag("--check", arguments->check,
                 "Exit with status 1 when a max_gradient is too low; further columns: place, max_gradient");
    command
        .option("--write", arguments->changedScene,
                "OUT.pov: the scene with the proven value where max_gradient is too low, or wastes time")
        .needs(scene)
        .excludes(more);
    const Option repair =
        command.flag("--repair", arguments->repair,
                     "Write such values back where they stand: into the scene and the include "
                     "files in its folder; all else stays as it is");
    Option(repair).needs(scene);
    command
        .option("--only", arguments->only,
                "FILE:LINE of a statement, as --check names it, that --repair or --write is for (repeatable)")
        .needs(scene);
    arguments->outputs.addTo(command);
    command.run([=] {
        if (arguments->table.empty() == arguments->scene.file.empty())
            throw UsageError("exactly one of SCENE and --table is required");
        if (!arguments->moreScenes.empty() && !arguments->check)
            throw UsageError("several scenes are studied with --check only");
        return arguments->table.empty() ? studyScenes(*arguments) : studyTable(*arguments);
    });
}

}  // namespace isoscope::cli
