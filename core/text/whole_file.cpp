// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/whole_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <optional>
#include <system_error>
#include <utility>
#ifdef __linux__
#include <sys/xattr.h>
#endif

namespace isoscope {

namespace {

namespace fs = std::filesystem;

/// The error of the call that just failed; never 0.
int lastError() { return errno == 0 ? EIO : errno; }

std::string reasonOf(int error) {
    return error == 0 ? std::string() : std::generic_category().message(error);
}

class Descriptor {
  public:
    Descriptor(const fs::path& file, int flags, mode_t mode = 0)
        : number_(::open(file.c_str(), flags | O_CLOEXEC, mode)), error_(number_ < 0 ? lastError() : 0) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }
    int error() const { return error_; }
    /// Closing may be what tells of a full disk.
    int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : lastError(); }

  private:
    int number_;
    int error_;
};

/// Hands all of the content to `write`, which takes some and returns how much. 0, or the error.
template <class Write>
int writeAll(std::string_view content, Write write) {
    while (!content.empty()) {
        const ssize_t written = write(content);
        if (written < 0 && errno == EINTR) continue;
        if (written <= 0) return written < 0 ? lastError() : ENOSPC;
        content.remove_prefix(static_cast<std::size_t>(written));
    }
    return 0;
}

int writeAll(int file, std::string_view content) {
    return writeAll(content,
                    [file](std::string_view rest) { return ::write(file, rest.data(), rest.size()); });
}

/// File systems that know no such wish are no failure.
int synchronize(int file, bool wanted) {
    return !wanted || ::fsync(file) == 0 || errno == EINVAL || errno == ENOTSUP ? 0 : lastError();
}

/// Where a link leads in the end, even when nothing is there.
fs::path linkTarget(fs::path file) {
    constexpr int deepest = 40;
    std::error_code failed;
    for (int depth = 0; depth < deepest && fs::is_symlink(file, failed); ++depth) {
        const fs::path next = fs::read_symlink(file, failed);
        if (failed) break;
        file = file.parent_path() / next;
    }
    return file;
}

/// An access list or attributes that somebody gave to the file; a rename would drop them.
bool hasAttributes([[maybe_unused]] const fs::path& file) {
#ifdef __linux__
    const ssize_t size = ::listxattr(file.c_str(), nullptr, 0);
    if (size <= 0) return false;
    std::string names(static_cast<std::size_t>(size), '\0');
    if (::listxattr(file.c_str(), names.data(), names.size()) <= 0) return false;
    names.insert(0, 1, '\0');
    using namespace std::string_literals;
    return names.find("\0user."s) != std::string::npos ||
           names.find("\0system.posix_acl"s) != std::string::npos;
#else
    return false;
#endif
}

/// The content beside the file under a name of its own; goes with the object unless it was renamed.
class PartialFile {
  public:
    PartialFile(const fs::path& file, mode_t mode) {
        static std::atomic<unsigned> number = 0;
        constexpr int attempts = 100;
        for (int attempt = 0; attempt < attempts; ++attempt) {
            path_ = file.parent_path() /
                    (".isoscope-" + std::to_string(::getpid()) + '-' + std::to_string(number++) + ".part");
            descriptor_.emplace(path_, O_WRONLY | O_CREAT | O_EXCL, mode);
            if (descriptor_->error() != EEXIST) break;
        }
        exists_ = descriptor_->error() == 0;
    }
    ~PartialFile() {
        if (exists_) ::unlink(path_.c_str());
    }
    PartialFile(const PartialFile&) = delete;
    PartialFile& operator=(const PartialFile&) = delete;

    const fs::path& path() const { return path_; }
    int error() const { return descriptor_->error(); }
    int write(std::string_view content, bool durable) {
        if (const int error = writeAll(descriptor_->number(), content)) return error;
        return synchronize(descriptor_->number(), durable);
    }
    int writeAt(std::uint64_t position, std::string_view content) {
        const std::size_t size = content.size();
        return writeAll(content, [&](std::string_view rest) {
            return ::pwrite(descriptor_->number(), rest.data(), rest.size(),
                            static_cast<off_t>(position + (size - rest.size())));
        });
    }
    int settle() { return synchronize(descriptor_->number(), true); }
    /// False when the owner cannot be given.
    bool become(const struct stat& before) {
        const int file = descriptor_->number();
        struct stat now;
        if (::fstat(file, &now) != 0) return false;
        if ((now.st_uid != before.st_uid || now.st_gid != before.st_gid) &&
            ::fchown(file, before.st_uid, before.st_gid) != 0)
            return false;
        return ::fchmod(file, before.st_mode & 07777) == 0;
    }
    int renameTo(const fs::path& file, bool durable) {
        if (const int error = descriptor_->close()) return error;
        if (::rename(path_.c_str(), file.c_str()) != 0) return lastError();
        exists_ = false;
        const fs::path folder = file.parent_path().empty() ? fs::path(".") : file.parent_path();
        const Descriptor entry(folder, O_RDONLY);
        if (entry.error() == 0) synchronize(entry.number(), durable);
        return 0;
    }
    /// Not removed at the end.
    void leave() { exists_ = false; }

  private:
    fs::path path_;
    std::optional<Descriptor> descriptor_;
    bool exists_ = false;
};

int overwrite(int file, std::string_view content, bool durable) {
    if (::lseek(file, 0, SEEK_SET) != 0) return lastError();
    if (const int error = writeAll(file, content)) return error;
    if (::ftruncate(file, static_cast<off_t>(content.size())) != 0) return lastError();
    return synchronize(file, durable);
}

std::string writeInPlace(const fs::path& file, std::string_view content, PartialFile* copy, bool durable) {
    std::ifstream input(file, std::ios::binary);
    const std::string before{std::istreambuf_iterator<char>(input), {}};
    if (!input) return reasonOf(EACCES);
    Descriptor output(file, O_WRONLY);
    if (output.error()) return reasonOf(output.error());
    const int error = overwrite(output.number(), content, durable);
    if (error == 0) return reasonOf(output.close());
    // The room that the old content had is still the file's own.
    if (overwrite(output.number(), before, durable) == 0 || !copy) return reasonOf(error);
    copy->leave();
    return reasonOf(error) + "; the new content is in " + copy->path().string();
}

std::string writeToDevice(const fs::path& file, std::string_view content) {
    Descriptor output(file, O_WRONLY);
    if (output.error()) return reasonOf(output.error());
    if (const int error = writeAll(output.number(), content)) return reasonOf(error);
    return reasonOf(output.close());
}

bool takesNoNewFile(int error) { return error == EACCES || error == EPERM || error == EROFS; }

std::string replace(const fs::path& place, const struct stat& before, std::string_view content,
                    const WholeFileOptions& options) {
    if (::faccessat(AT_FDCWD, place.c_str(), W_OK, AT_EACCESS) != 0) return reasonOf(lastError());
    PartialFile partial(place, 0600);
    if (takesNoNewFile(partial.error())) return writeInPlace(place, content, nullptr, options.durable);
    if (partial.error()) return reasonOf(partial.error());
    if (const int error = partial.write(content, options.durable)) return reasonOf(error);
    struct stat wanted = before;
    if (options.ownerOnly) wanted.st_mode = 0600;
    if (before.st_nlink > 1 || hasAttributes(place) || !partial.become(wanted))
        return writeInPlace(place, content, &partial, options.durable);
    return reasonOf(partial.renameTo(place, options.durable));
}

/// Whether a file at `place` can be replaced by renaming another: there is none, or one that has nothing that
/// a rename would lose.
bool mayBeRenamedOver(const fs::path& place, bool exists, const struct stat& before) {
    if (!exists) return true;
    return S_ISREG(before.st_mode) && before.st_nlink <= 1 && !hasAttributes(place);
}

}  // namespace

std::string writeWhole(const fs::path& file, std::string_view content, const WholeFileOptions& options) {
    struct stat before;
    const bool exists = ::stat(file.c_str(), &before) == 0;
    if (exists && S_ISDIR(before.st_mode)) return reasonOf(EISDIR);
    if (exists && !S_ISREG(before.st_mode)) return writeToDevice(file, content);
    const fs::path place = linkTarget(file);
    if (exists) return replace(place, before, content, options);
    PartialFile partial(place, options.ownerOnly ? 0600 : 0666);
    if (partial.error()) return reasonOf(partial.error());
    if (const int error = partial.write(content, options.durable)) return reasonOf(error);
    return reasonOf(partial.renameTo(place, options.durable));
}

struct GrowingFile::Partial {
    fs::path place;
    PartialFile file;
};

GrowingFile::GrowingFile(fs::path file) : file_(std::move(file)) {
    struct stat before {};
    const bool exists = ::stat(file_.c_str(), &before) == 0;
    if (exists && ::faccessat(AT_FDCWD, file_.c_str(), W_OK, AT_EACCESS) != 0)
        problem_ = reasonOf(lastError());
    if (exists && S_ISDIR(before.st_mode)) problem_ = reasonOf(EISDIR);
    if (!problem_.empty()) return;
    const fs::path place = linkTarget(file_);
    if (!mayBeRenamedOver(place, exists, before)) return;
    partial_.reset(new Partial{place, {place, exists ? mode_t{0600} : mode_t{0666}}});
    const int error = partial_->file.error();
    if (error == 0 && (!exists || partial_->file.become(before))) return;
    // A folder that takes no new file may hold one that can be written in place.
    if (error != 0 && !(exists && takesNoNewFile(error))) problem_ = reasonOf(error);
    partial_.reset();
}

GrowingFile::~GrowingFile() = default;

bool GrowingFile::write(std::uint64_t position, std::string_view bytes) {
    if (!problem_.empty() || position > size_) return false;
    if (partial_) {
        problem_ = reasonOf(partial_->file.writeAt(position, bytes));
    } else {
        const auto begin = static_cast<std::size_t>(position);
        memory_.replace(begin, std::min(bytes.size(), memory_.size() - begin), bytes);
    }
    size_ = std::max<std::uint64_t>(size_, position + bytes.size());
    return problem_.empty();
}

std::string GrowingFile::finish() {
    if (problem_.empty() && !partial_) problem_ = writeWhole(file_, memory_);
    if (problem_.empty() && partial_) problem_ = reasonOf(partial_->file.settle());
    if (problem_.empty() && partial_) problem_ = reasonOf(partial_->file.renameTo(partial_->place, true));
    partial_.reset();
    return problem_;
}

}  // namespace isoscope
