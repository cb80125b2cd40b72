// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <stop_token>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/language/directives/text_files.h"
#include "core/language/expressions/random_streams.h"
#include "core/language/parse_progress.h"
#include "core/language/reading_limits.h"
#include "core/language/tokens/symbol_table.h"
#include "core/scene/scene.h"
#include "core/text/diagnostic.h"

namespace isoscope {

/// What a parse is told from outside.
struct ParseOptions {
    std::filesystem::path file;  ///< name of the text; includes are searched beside it
    std::vector<std::filesystem::path>
        libraryPaths;  ///< searched for includes that are not the program's own
    /// Whether the text reads files of its own folder, of `libraryPaths` and of `readableFolders` only.
    bool restrictedReading = false;
    std::vector<std::filesystem::path> readableFolders;  ///< that the person allowed, besides those
    double clock = 0;
    bool clockOn = false;  ///< an animation frame was asked for
    int frameNumber = 0;
    int initialFrame = 1;
    int finalFrame = 1;
    int imageWidth = 800;
    int imageHeight = 600;
    int noiseGenerator = 2;                      ///< in force until global_settings says otherwise
    std::map<std::string, double> declarations;  ///< --declare NAME=VALUE, in force before the text
    /// Tokens read, and what counts as such (TokenStream::charge), before loops are cut off with a message.
    /// The longest scene known, a camera of 800x600 triangles each of which is traced and written to a file,
    /// takes 275 million of 0.1 microseconds; what a text may keep for them stays below some 2 GB.
    std::size_t stepBudget = 300'000'000;
    /// Of the clock, and bytes that the program may grow by meanwhile, before reading is cut off with a
    /// message. Both are far above what the steps of ordinary texts take; they hold whatever a step costs.
    double secondsBudget = 120;
    std::size_t memoryBudget = 850'000'000;
    std::size_t diagnosticLimit = 200;  ///< further ones are counted, not kept
    /// Asks for ParseResult::namesAtIsosurface of the isosurface with this SceneIsosurface::number; -1 for
    /// none.
    int namesOfIsosurface = -1;
    /// When requested, reading is cut off within a few milliseconds, with the error `stopped`.
    std::stop_token stop;
    std::shared_ptr<ParseProgress> progress;  ///< kept up to date while reading; may be null
};

/// The options for another parse: the stop and the progress of the first are its own.
inline ParseOptions withoutStop(ParseOptions options) {
    options.stop = {};
    options.progress.reset();
    return options;
}

struct ImageMap;
struct QueriedObjects;

/// What an unknown word was probably meant to be, and which of the program's own include files declares it
/// where the text includes none that does. Empty for no idea.
struct Suggestion {
    std::string word;
    std::string include;
};

/// Starts to watch what the options allow.
std::unique_ptr<const ReadingLimits> limitsOf(const ParseOptions& options);

/// What all parts of one parse share.
struct ParseContext {
    /// Under limits of its own, those of the options.
    explicit ParseContext(ParseOptions parseOptions);
    /// Under those that an earlier reading of the same text has begun to use up.
    ParseContext(ParseOptions parseOptions, std::unique_ptr<const ReadingLimits> begun);

    ParseOptions options;  ///< `stop` is that of `limits`
    std::unique_ptr<const ReadingLimits> limits;
    SourceLibrary sources;
    Diagnostics diagnostics;
    SymbolTable symbols;
    /// The sliders found so far; NumberValue::parameter and slots refer to it.
    std::vector<SceneParameter> parameters;
    std::vector<double> parameterTable;
    /// Those that loops declare anew, by index: where something begins to count is no slider in the end.
    std::set<int> counters;
    /// The parameter whose range begins at this byte of the user's text: a literal in a loop is one slider.
    std::unordered_map<std::uint32_t, int> parameterAt;
    /// The settings that isosurfaces leave out, and the byte where each could stand: several share one.
    std::set<std::pair<ParameterRole, std::uint32_t>> impliedAt;
    /// Whether built-ins may be called without functions.inc, for texts that could not include it.
    bool builtinsKnown = false;
    /// Operations in all functions of the text so far; FunctionParser refuses those beyond its limit.
    std::size_t functionNodes = 0;
    /// The object statement or call whose numbers are being read, and how many there were; see
    /// StatementScope.
    int statement = 0;
    int statementCount = 0;
    /// Statements around the one being read; see NestingGuard.
    int nesting = 0;
    /// Operations copied by calls of declared functions; FunctionCallParser refuses calls beyond its limit.
    std::size_t functionCopies = 0;
    RandomStreams random;
    TextFiles textFiles;
    /// Names whose `#declare` was not understood: that was reported, so their use is not.
    std::set<std::string, std::less<>> failedNames;
    /// Predeclared words that the text has declared anew or undefined: their constant is gone.
    std::set<std::string, std::less<>> replacedConstants;
    /// What trace(), inside() and the like have been asked about; see ObjectQueries.
    std::shared_ptr<QueriedObjects> queriedObjects;
    int languageVersion = 370;     ///< 100 times the #version in force
    bool versionStated = false;    ///< whether one has been read
    int noiseGenerator = 2;        ///< of global_settings, for functions declared later
    double assumedGamma = 1;       ///< of global_settings, for images and `srgb` read later
    bool hasAssumedGamma = false;  ///< whether the text has stated it
    /// Images read so far, by their files.
    std::map<std::string, std::shared_ptr<const ImageMap>> images;

    /// Isosurface statements read so far, and the names that options.namesOfIsosurface asks for.
    int isosurfaceCount = 0;
    std::map<std::string, Value> namesAtIsosurface;

    /// False once reading has been cut off: what is then missing is no mistake of the text.
    bool complete = true;

    /// Whether options.stop asks to end; what takes long should look at it every few milliseconds.
    bool stopAsked() const { return options.stop.stop_requested(); }
    /// What a reader that finds stopAsked() says at the place it has come to.
    Diagnostic stopMessage(const SourceRange& range) const;

    /// Adds a diagnostic. Repeated ones (same id, place and text) are dropped, and so are errors after
    /// reading has been cut off.
    void report(Diagnostic diagnostic);
    /// Whether report() would keep it: saves the search for a hint that would be dropped.
    bool keeps(const Diagnostic& diagnostic) const;
    void error(std::string id, const SourceRange& range, std::string message, std::string hint = {});
    void warning(std::string id, const SourceRange& range, std::string message, std::string hint = {});
    /// "`WHAT` is not simulated."
    void leftOut(const SourceRange& range, std::string what);
    void note(std::string id, const SourceRange& range, std::string message, std::string hint = {});

    /// Makes a slider for a number of the text and a slot in the parameter table; returns its index.
    int addParameter(SceneParameter parameter);
    /// A declared number was used where only a new parse can follow its change: takes its slot away. -1 is
    /// ignored.
    void markStructural(int parameter);
    /// The same for every parameter that `function` reads.
    void markStructural(const Function& function);

    /// An `#include` statement or macro call, and the text it leads to.
    struct Call {
        SourceRange site;
        SourceRange text;
        friend bool operator==(const Call&, const Call&) = default;
    };
    /// Those that are running, outermost first; kept by the TokenStream through the next two functions.
    std::vector<Call> calls;
    void enterCall(const SourceRange& site, const SourceRange& text) { calls.push_back({site, text}); }
    void leaveCall();

    /// Suggestions made so far, by word and kind of place, and how often one had to be looked for; see
    /// reportUnknownWord().
    std::unordered_map<std::string, Suggestion> suggestions;
    std::size_t suggestionsLookedFor = 0;

    std::size_t droppedDiagnostics = 0;  ///< reported behind the limit; the last diagnostic tells the number

  private:
    bool isDropped(const Diagnostic& diagnostic) const;
    std::vector<SourceRange> reachedFrom(const SourceRange& range) const;

    /// The calls that were running where a text was left last: a mistake in it may be noticed one token late.
    std::vector<Call> finishedCalls_;
};

}  // namespace isoscope
