// SPDX-License-Identifier: Apache-2.0
#include "base/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>

namespace lobe {

namespace fs = std::filesystem;

namespace {

// A file descriptor that closes itself.
class Descriptor {
  public:
    Descriptor(const std::string& path, int flags, mode_t mode = 0)
        : number_(open(path.c_str(), flags | O_CLOEXEC, mode)) {}
    ~Descriptor() { close(); }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int get() const { return number_; }
    bool ok() const { return number_ >= 0; }
    bool close() {
        const int number = number_;
        number_ = -1;
        return number < 0 || ::close(number) == 0;
    }

  private:
    int number_;
};

bool write_all(int file, const char* bytes, std::size_t count) {
    while (count) {
        const ssize_t written = write(file, bytes, count);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return false;
        bytes += written;
        count -= static_cast<std::size_t>(written);
    }
    return true;
}

// A short name that nothing else uses: this process, and a count.
std::string fresh_name(const fs::path& folder) {
    static std::atomic<unsigned> count{0};
    return (folder / (".lobe-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".tmp"))
        .string();
}

}  // namespace

std::string read_file(const std::string& path, ExitCode code) {
    const auto fail = [&](int reason) {
        const char* hint = reason == ENOENT   ? "is its name spelt right?"
                           : reason == EISDIR ? "name a file in it"
                                              : "";
        throw Error(code, std::string("cannot read the file: ") + std::strerror(reason), path,
                    hint);
    };
    const Descriptor file(path, O_RDONLY);
    if (!file.ok()) fail(errno);
    struct stat status;
    if (fstat(file.get(), &status) != 0) fail(errno);
    if (S_ISDIR(status.st_mode)) fail(EISDIR);
    std::string bytes;
    std::size_t size = 0;
    bytes.resize(static_cast<std::size_t>(status.st_size) + 1);
    while (true) {
        if (size == bytes.size()) bytes.resize(2 * size + 65536);
        const ssize_t count = read(file.get(), &bytes[size], bytes.size() - size);
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(errno);
        if (count == 0) break;
        size += static_cast<std::size_t>(count);
    }
    bytes.resize(size);
    return bytes;
}

void AtomicFile::fail(const std::string& what, int reason) const {
    std::string hint;
    if (reason == ENOENT) hint = "make the folder first, or choose another";
    if (reason == EACCES || reason == EPERM || reason == EROFS)
        hint = "choose a folder that you may write to";
    if (reason == EISDIR) hint = "name a file in it";
    if (reason == ENOSPC || reason == EDQUOT || reason == EFBIG)
        hint = "make room, or write elsewhere";
    throw Error(code_, what + ": " + std::strerror(reason), path_, hint);
}

AtomicFile::AtomicFile(const std::string& path, ExitCode code)
    : path_(path), target_(path), code_(code) {
    if (path.empty()) throw Error(code, "the name of the file to write is empty");
    std::error_code error;
    if (fs::is_symlink(path, error)) {
        const fs::path end = fs::canonical(path, error);
        if (!error) target_ = end.string();
    }
    mode_t mode = 0666;
    struct stat status;
    const bool exists = stat(target_.c_str(), &status) == 0;
    if (exists && S_ISDIR(status.st_mode)) fail("cannot write the file", EISDIR);
    if (exists && access(target_.c_str(), W_OK) != 0) fail("cannot write the file", errno);
    special_ = exists && !S_ISREG(status.st_mode);
    fs::path folder = special_ ? fs::temp_directory_path() : fs::path(target_).parent_path();
    if (folder.empty()) folder = ".";
    int reason = 0;
    for (int attempt = 0; attempt < 100; ++attempt) {
        const std::string name = fresh_name(folder);
        Descriptor file(name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW, mode);
        if (file.ok()) {
            temporary_ = name;
            if (exists && !special_) (void)!fchmod(file.get(), status.st_mode & 07777);
            return;
        }
        reason = errno;
        if (reason != EEXIST) break;
    }
    fail("cannot write a file in the folder " + folder.string(), reason);
}

AtomicFile::~AtomicFile() {
    if (!temporary_.empty()) unlink(temporary_.c_str());
}

void AtomicFile::copy_into_target() const {
    const std::string bytes = read_file(temporary_, code_);
    Descriptor file(target_, O_WRONLY | O_NOCTTY);
    if (!file.ok() || !write_all(file.get(), bytes.data(), bytes.size()) || !file.close())
        fail("cannot write the file", errno);
}

void AtomicFile::commit() {
    if (special_) return copy_into_target();
    {
        Descriptor file(temporary_, O_RDONLY);
        if (!file.ok() || fsync(file.get()) != 0 || !file.close())
            fail("cannot write the file", errno);
    }
    if (rename(temporary_.c_str(), target_.c_str()) != 0) fail("cannot rename the file", errno);
    temporary_.clear();
    fs::path folder = fs::path(target_).parent_path();
    const Descriptor directory(folder.empty() ? "." : folder.string(), O_RDONLY | O_DIRECTORY);
    if (directory.ok()) fsync(directory.get());  // so that the name survives a crash; best effort
}

void write_file(const std::string& path, const std::string& bytes, ExitCode code) {
    AtomicFile file(path, code);
    Descriptor out(file.temporary(), O_WRONLY);
    if (!out.ok() || !write_all(out.get(), bytes.data(), bytes.size()) || !out.close())
        throw Error(code, std::string("cannot write the file: ") + std::strerror(errno), path);
    file.commit();
}

void check_writable(const std::string& path, ExitCode code) { AtomicFile(path, code); }

}  // namespace lobe
