// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/exchange/povray_process.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>
#if defined(__linux__)
#include <sys/prctl.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string_view>
#include <system_error>

#include "core/exchange/png.h"
#include "core/language/directives/library_paths.h"

extern char** environ;

namespace isoscope {

namespace {

namespace fs = std::filesystem;

constexpr int waitMilliseconds = 50;
/// What is kept of what POV-Ray says.
constexpr std::size_t keptOutput = 1 << 14;
/// The status of a program that could not be started, as shells have it.
constexpr int notStarted = 127;

class TemporaryFolder {
  public:
    TemporaryFolder() {
        std::error_code failed;
        std::string name = (fs::temp_directory_path(failed) / "isoscope-povray-XXXXXX").string();
        if (!failed && ::mkdtemp(name.data())) path_ = name;
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        if (!path_.empty()) fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;

    /// Empty when it could not be made.
    const fs::path& path() const { return path_; }

  private:
    fs::path path_;
};

bool writeText(const fs::path& file, const std::string& text) {
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
    std::ofstream output(file, std::ios::binary);
    output << text;
    return static_cast<bool>(output.flush());
}

/// POV-Ray looks for it under HOME, which is the temporary folder: what it may read and write.
std::string restrictions(const PovrayOrder& order, const fs::path& own) {
    std::string text = "[File I/O Security]\nrestricted\n[Shellout Security]\nforbidden\n[Permitted Paths]\n";
    const auto permit = [&text](const char* what, const fs::path& path) {
        text += std::string(what) + " = \"" + path.string() + "\"\n";
    };
    permit("read+write*", own);
    if (!order.folder.empty()) permit("read*", order.folder);
    for (const fs::path& folder : installedLibraryPaths()) permit("read*", folder);
    return text;
}

/// A child process whose standard error, and output, are read. It ends with this thread at the latest,
/// whatever ends that.
class Child {
  public:
    Child(const fs::path& program, const std::vector<std::string>& arguments, const fs::path& home) {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0) return;
        std::vector<std::string> words{program.string()};
        words.insert(words.end(), arguments.begin(), arguments.end());
        std::vector<std::string> settings{"HOME=" + home.string()};
        for (char** entry = environ; *entry; ++entry)
            if (!std::string_view(*entry).starts_with("HOME=")) settings.emplace_back(*entry);
        // Made before: behind fork() a program with threads must not ask for memory.
        const std::vector<char*> wordPointers = pointers(words), settingPointers = pointers(settings);
        const pid_t parent = ::getpid();
        process_ = ::fork();
        if (process_ == 0) become(parent, ends[1], home.c_str(), wordPointers.data(), settingPointers.data());
        ::close(ends[1]);
        output_ = ends[0];
    }
    ~Child() {
        if (output_ >= 0) ::close(output_);
        if (process_ > 0) end();
    }
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;

    bool started() const { return process_ > 0; }
    /// Appends what has come within a moment; false at the end of it.
    bool read(std::string& text) const {
        pollfd wanted{output_, POLLIN, 0};
        if (::poll(&wanted, 1, waitMilliseconds) <= 0) return true;
        std::array<char, 4096> bytes;
        const ssize_t count = ::read(output_, bytes.data(), bytes.size());
        if (count > 0) text.append(bytes.data(), static_cast<std::size_t>(count));
        return count > 0 || (count < 0 && errno == EINTR);
    }
    /// The processor's time that it has taken; none where it cannot be known.
    std::optional<std::chrono::nanoseconds> timeTaken() const {
        clockid_t clock{};
        timespec time{};
        if (::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0) return {};
        return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
    }
    /// Waits for its end and gives the status: 0 is a success, negative that a signal ended it.
    int finish() {
        int status = 0;
        while (::waitpid(process_, &status, 0) < 0 && errno == EINTR) {
        }
        process_ = -1;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }

  private:
    static std::vector<char*> pointers(std::vector<std::string>& words) {
        std::vector<char*> list;
        for (std::string& word : words) list.push_back(word.data());
        list.push_back(nullptr);
        return list;
    }
    [[noreturn]] static void become(pid_t parent, int output, const char* home, char* const* words,
                                    char* const* settings) {
        // A group of its own: what a script has started is ended with it. So Ctrl+C of a terminal does not
        // reach it, nor is it told when this program is killed: it would draw on in vain.
        ::setpgid(0, 0);
#if defined(__linux__)
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
        const bool orphaned = ::getppid() != parent;
        const int nothing = ::open("/dev/null", O_RDONLY);
        if (!orphaned && nothing >= 0 && ::dup2(nothing, 0) >= 0 && ::dup2(output, 1) >= 0 &&
            ::dup2(output, 2) >= 0 && ::chdir(home) == 0)
            ::execve(words[0], words, settings);
        ::_exit(notStarted);
    }
    void end() {
        ::kill(-process_, SIGKILL);
        ::kill(process_, SIGKILL);  // it may not have its group yet
        finish();
    }

    pid_t process_ = -1;
    int output_ = -1;
};

/// Tells when a process does nothing any more: it says nothing, and takes no more of the processor than what
/// looks at a clock now and then. POV-Ray waits for ever for a thread that memory was refused to.
class Standstill {
  public:
    Standstill(const Child& child, std::chrono::milliseconds patience) : child_(child), patience_(patience) {}

    /// To be asked again and again; `said` tells that there was a sign of life.
    bool lasts(bool said) {
        const auto now = std::chrono::steady_clock::now();
        if (!said && now - since_ < patience_) return false;
        const auto taken = child_.timeTaken();
        // Where its time cannot be known it may be busy.
        const bool idle = !said && taken && (*taken - takenThen_) * leastShare < now - since_;
        since_ = now;
        takenThen_ = taken.value_or(takenThen_);
        return idle;
    }

  private:
    /// At work it has a fiftieth of one processor at the least.
    static constexpr int leastShare = 50;

    const Child& child_;
    std::chrono::milliseconds patience_;
    std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
    std::chrono::nanoseconds takenThen_{0};
};

/// The last "(25%)" that POV-Ray has said, from 0 to 1; negative when there is none.
double shareTold(std::string_view output) {
    const std::size_t end = output.rfind("%)");
    if (end == std::string_view::npos) return -1;
    const std::size_t begin = output.rfind('(', end);
    if (begin == std::string_view::npos || end - begin > 8) return -1;
    return std::clamp(std::atoi(std::string(output.substr(begin + 1, end - begin - 1)).c_str()) / 100.0, 0.0,
                      1.0);
}

/// The line that tells what is wrong, else the last one; the scene is called by its bare name.
std::string complaint(const std::string& output, const fs::path& own) {
    std::string last, error;
    for (std::size_t begin = 0; begin < output.size();) {
        const std::size_t end = std::min(output.find_first_of("\r\n", begin), output.size());
        const std::string line = output.substr(begin, end - begin);
        if (line.find_first_not_of(" \t") != std::string::npos) last = line;
        const bool wrong = line.find("Error:") != std::string::npos;
        if (error.empty() && wrong && line.find("Possible") == std::string::npos) error = line;
        begin = end + 1;
    }
    std::string text = error.empty() ? last : error;
    const std::string folder = own.string() + '/';
    for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder))
        text.erase(at, folder.size());
    return text;
}

std::vector<std::string> argumentsOf(const PovrayOrder& order, const fs::path& own) {
    std::vector<std::string> arguments{"+I" + (own / "scene.pov").string(),
                                       "+O" + (own / "picture.png").string(),
                                       "+W" + std::to_string(order.width),
                                       "+H" + std::to_string(order.height),
                                       "+FN8",
                                       "-D",
                                       "-P",
                                       "-A",
                                       "+V"};
    if (!order.folder.empty()) arguments.push_back("+L" + order.folder.string());
    for (const fs::path& folder : installedLibraryPaths()) arguments.push_back("+L" + folder.string());
    arguments.insert(arguments.end(), order.options.begin(), order.options.end());
    return arguments;
}

PovrayPicture failed(std::string problem) { return {{}, std::move(problem), false}; }

}  // namespace

std::optional<fs::path> povrayProgram() {
    const char* const list = std::getenv("PATH");
    std::string_view rest = list ? list : "";
    while (!rest.empty()) {
        const std::size_t end = std::min(rest.find(':'), rest.size());
        const fs::path program = fs::path(rest.substr(0, end)) / "povray";
        if (end > 0 && ::access(program.c_str(), X_OK) == 0) return program;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return {};
}

std::string whyNotForPovray(const std::map<std::string, std::string>& writtenFiles) {
    for (const auto& [name, text] : writtenFiles) {
        const fs::path file = name;
        bool leaves = file.is_absolute();
        for (const fs::path& part : file) leaves = leaves || part == "..";
        if (leaves) return "the scene writes `" + name + "`, outside of its folder";
    }
    return {};
}

PovrayPicture drawWithPovray(const PovrayOrder& order, std::stop_token stop,
                             const std::function<void(double share)>& report) {
    const std::optional<fs::path> program = povrayProgram();
    if (!program) return failed("POV-Ray is not installed (no program `povray` in PATH)");
    const TemporaryFolder folder;
    const fs::path& own = folder.path();
    if (own.empty() || !writeText(own / "scene.pov", order.text) ||
        !writeText(own / ".povray/3.7/povray.conf", restrictions(order, own)))
        return failed("there is no room for its temporary files");
    Child child(*program, argumentsOf(order, own), own);
    if (!child.started()) return failed("POV-Ray could not be started");
    std::string output;
    Standstill standstill(child, order.patience);
    for (std::size_t before = 0; child.read(output); before = output.size()) {
        if (stop.stop_requested()) return {{}, "stopped", true};
        if (standstill.lasts(output.size() != before)) return failed("POV-Ray stands still and was ended");
        if (output.size() > 2 * keptOutput) output.erase(0, output.size() - keptOutput);
        if (const double share = shareTold(output); report && share >= 0) report(share);
    }
    const int status = child.finish();
    if (status == notStarted && output.empty()) return failed("POV-Ray could not be started");
    if (status != 0) return failed("POV-Ray: " + complaint(output, own));
    PovrayPicture picture{readPng(own / "picture.png"), {}, false};
    if (picture.image.pixels.empty()) picture.problem = "POV-Ray wrote no picture";
    return picture;
}

}  // namespace isoscope
