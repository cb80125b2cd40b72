// SPDX-License-Identifier: GPL-3.0-or-later
// The runtime of an AppImage of type 2: a static program in front of a squashfs image with an AppDir. It
// mounts the image by FUSE for as long as the program runs; where that is not possible it unpacks it once
// into the cache folder. Called by the name of a program in usr/bin, by a symbolic link, it runs that one,
// else AppRun.
//
//   --appimage-extract           unpacks into squashfs-root in the current folder
//   --appimage-extract-and-run   does not mount, nor with APPIMAGE_EXTRACT_AND_RUN in the environment
//   --appimage-offset            prints where the image begins
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <elf.h>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

extern "C" {
#include <squashfuse/ll.h>
#include <squashfuse/traverse.h>
}

namespace fs = std::filesystem;

namespace {

[[noreturn]] void fail(const std::string& what) {
    std::fprintf(stderr, "AppImage: %s\n", what.c_str());
    std::exit(127);
}

/// The image begins where the ELF file ends, with its table of sections.
std::size_t imageOffset(const fs::path& file) {
    Elf64_Ehdr header{};
    std::ifstream in(file, std::ios::binary);
    if (!in.read(reinterpret_cast<char*>(&header), sizeof header)) fail("cannot read " + file.string());
    return header.e_shoff + std::size_t(header.e_shnum) * header.e_shentsize;
}

/// Another number for other bytes, almost certainly (FNV-1a).
std::string digestOf(const fs::path& file) {
    std::uint64_t hash = 0xcbf29ce484222325;
    std::vector<char> block(1 << 20);
    for (std::ifstream in(file, std::ios::binary); in;) {
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        for (std::streamsize i = 0; i < in.gcount(); ++i)
            hash = (hash ^ static_cast<unsigned char>(block[static_cast<std::size_t>(i)])) * 0x100000001b3;
    }
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

bool unpackFile(sqfs& image, sqfs_inode& inode, const fs::path& to) {
    std::ofstream out(to, std::ios::binary);
    std::vector<char> block(1 << 20);
    const auto size = static_cast<sqfs_off_t>(inode.xtra.reg.file_size);
    for (sqfs_off_t at = 0; at < size;) {
        auto count = static_cast<sqfs_off_t>(block.size());
        if (sqfs_read_range(&image, &inode, at, &count, block.data()) != SQFS_OK || count <= 0) return false;
        out.write(block.data(), count);
        at += count;
    }
    out.close();
    return out && chmod(to.c_str(), inode.base.mode & 0777) == 0;
}

bool unpackLink(sqfs& image, sqfs_inode& inode, const fs::path& to) {
    std::vector<char> target(inode.xtra.symlink_size + std::size_t(1));
    std::size_t size = target.size();
    if (sqfs_readlink(&image, &inode, target.data(), &size) != SQFS_OK) return false;
    unlink(to.c_str());
    return symlink(target.data(), to.c_str()) == 0;
}

/// Unpacks folders, files and symbolic links into a folder, which is made.
void unpack(sqfs& image, const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    sqfs_traverse walk;
    sqfs_err state = sqfs_traverse_open(&walk, &image, sqfs_inode_root(&image));
    while (state == SQFS_OK && sqfs_traverse_next(&walk, &state)) {
        if (walk.dir_end) continue;
        sqfs_inode inode;
        bool good = sqfs_inode_get(&image, &inode, sqfs_dentry_inode(&walk.entry)) == SQFS_OK;
        const fs::path to = folder / walk.path;
        if (good && S_ISDIR(inode.base.mode)) good = fs::is_directory(to) || mkdir(to.c_str(), 0755) == 0;
        if (good && S_ISREG(inode.base.mode)) good = unpackFile(image, inode, to);
        if (good && S_ISLNK(inode.base.mode)) good = unpackLink(image, inode, to);
        if (!good) fail("cannot unpack to " + to.string());
    }
    if (state != SQFS_OK) fail("the image is damaged");
    sqfs_traverse_close(&walk);
}

/// The folder of the cache with this image; unpacked at the first time, and complete if it is there.
fs::path unpackedInCache(sqfs& image, const fs::path& file) {
    const char* cache = std::getenv("XDG_CACHE_HOME");
    const char* home = std::getenv("HOME");
    if ((cache == nullptr || *cache == 0) && home == nullptr)
        fail("there is no FUSE and no HOME to unpack to");
    const fs::path folder = (cache != nullptr && *cache != 0 ? fs::path(cache) : fs::path(home) / ".cache") /
                            "isoscope" / ("appimage-" + digestOf(file));
    std::error_code error;
    if (fs::is_directory(folder, error)) return folder;
    const fs::path growing = folder.string() + "." + std::to_string(getpid());
    unpack(image, growing);
    fs::rename(growing, folder, error);
    if (error) fs::remove_all(growing, error);  // another process was sooner
    return folder;
}

/// Answers for the mounted image until the last process that holds the other end of `alive` has ended.
void serve(fuse_session* session, int alive) {
    pollfd ends[] = {{fuse_session_fd(session), POLLIN, 0}, {alive, POLLIN, 0}};
    fuse_buf buffer{};
    while (fuse_session_exited(session) == 0) {
        if (poll(ends, 2, -1) < 0 && errno != EINTR) break;
        if (ends[1].revents != 0) break;
        if (ends[0].revents == 0) continue;
        const int got = fuse_session_receive_buf(session, &buffer);
        if (got == -EINTR) continue;
        if (got <= 0) break;
        fuse_session_process_buf(session, &buffer);
    }
}

/// Mounts the image on a folder, writes a byte to `ready`, serves, and takes both away again.
void mountAndServe(const fs::path& file, std::size_t offset, const std::string& folder, int ready,
                   int alive) {
    fuse_lowlevel_ops operations{};
    operations.getattr = sqfs_ll_op_getattr;
    operations.opendir = sqfs_ll_op_opendir;
    operations.releasedir = sqfs_ll_op_releasedir;
    operations.readdir = sqfs_ll_op_readdir;
    operations.lookup = sqfs_ll_op_lookup;
    operations.open = sqfs_ll_op_open;
    operations.release = sqfs_ll_op_release;
    operations.read = sqfs_ll_op_read;
    operations.readlink = sqfs_ll_op_readlink;
    operations.forget = sqfs_ll_op_forget;
    char name[] = "isoscope", option[] = "-oro,nosuid,nodev";
    char* words[] = {name, option, nullptr};
    fuse_args arguments = FUSE_ARGS_INIT(2, words);
    sqfs_ll* image = sqfs_ll_open(file.c_str(), offset);
    sqfs_ll_chan channel{};
    if (image == nullptr ||
        sqfs_ll_mount(&channel, folder.c_str(), &arguments, &operations, sizeof operations, image) != SQFS_OK)
        return;
    if (write(ready, "", 1) == 1) serve(channel.session, alive);
    sqfs_ll_unmount(&channel, folder.c_str());
    rmdir(folder.c_str());
}

/// Mounts the image in a process of its own. The folder, or nothing where that is not possible; it is
/// unmounted when this process, whatever program it becomes, and its children have ended.
fs::path mounted(const fs::path& file, std::size_t offset) {
    const char* temporary = std::getenv("TMPDIR");
    std::string folder = std::string(temporary != nullptr ? temporary : "/tmp") + "/.mount_isoscopeXXXXXX";
    int ready[2], alive[2];
    if (mkdtemp(folder.data()) == nullptr || pipe2(ready, O_CLOEXEC) != 0 || pipe(alive) != 0) return {};
    const pid_t child = fork();
    if (child == 0) {
        // What FUSE says of its troubles is of no use: there is another way.
        const int nowhere = open("/dev/null", O_RDWR);
        for (const int stream : {0, 1, 2}) dup2(nowhere, stream);
        close(alive[1]);
        setsid();
        if (fork() != 0) _exit(0);
        mountAndServe(file, offset, folder, ready[1], alive[0]);
        _exit(0);
    }
    close(ready[1]);
    close(alive[0]);
    char byte = 0;
    const bool good = child > 0 && read(ready[0], &byte, 1) == 1;
    if (child > 0) waitpid(child, nullptr, 0);
    close(ready[0]);
    if (good) return folder;
    close(alive[1]);
    rmdir(folder.c_str());
    return {};
}

[[noreturn]] void run(const fs::path& root, const fs::path& file, char** words) {
    setenv("APPIMAGE", file.c_str(), 1);
    setenv("APPDIR", root.c_str(), 1);
    setenv("ARGV0", words[0], 1);
    const fs::path named = root / "usr/bin" / fs::path(words[0]).filename();
    execv((access(named.c_str(), X_OK) == 0 ? named : root / "AppRun").c_str(), words);
    fail("cannot run what is in " + root.string());
}

}  // namespace

int main(int count, char** words) {
    std::error_code error;
    const fs::path file = fs::read_symlink("/proc/self/exe", error);
    const std::size_t offset = imageOffset(file);
    const std::string_view first = count > 1 ? words[1] : "";
    if (first == "--appimage-offset") return std::printf("%zu\n", offset) < 0 ? 1 : 0;
    bool mounts = std::getenv("APPIMAGE_EXTRACT_AND_RUN") == nullptr;
    if (first == "--appimage-extract-and-run") {
        mounts = false;
        words[1] = words[0];
        ++words;
    }
    if (mounts && first != "--appimage-extract")
        if (const fs::path root = mounted(file, offset); !root.empty()) run(root, file, words);
    sqfs_ll* image = sqfs_ll_open(file.c_str(), offset);
    if (image == nullptr) return 127;
    if (first == "--appimage-extract") {
        unpack(image->fs, "squashfs-root");
        return 0;
    }
    run(unpackedInCache(image->fs, file), file, words);
}
