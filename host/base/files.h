// SPDX-License-Identifier: Apache-2.0
// Reading whole files, and writing them so that a reader sees the old or the new one, never half.
#pragma once

#include <string>

#include "base/error.h"

namespace lobe {

// All bytes of a file (or pipe). Throws Error (code) with the path and the system's reason.
std::string read_file(const std::string& path, ExitCode code = ExitCode::scene);

// Replaces a file's content at once: a new file in the same folder, flushed to disk, then renamed.
void write_file(const std::string& path, const std::string& bytes,
                ExitCode code = ExitCode::output);

// Throws Error (code) if write_file to this path could not begin: folder missing or read-only, path
// a directory. For use before a long render.
void check_writable(const std::string& path, ExitCode code = ExitCode::output);

// A new, empty file beside `path` for writers that take a file name. commit() flushes it and gives
// it the final name; without commit() it is removed. A link is followed. What is no regular file
// (/dev/stdout, a pipe) is never replaced: the bytes are copied into it instead.
class AtomicFile {
  public:
    explicit AtomicFile(const std::string& path, ExitCode code = ExitCode::output);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    const std::string& temporary() const { return temporary_; }
    void commit();

  private:
    [[noreturn]] void fail(const std::string& what, int reason) const;
    void copy_into_target() const;

    std::string path_, target_, temporary_;
    ExitCode code_;
    bool special_ = false;  // the target is a device or a pipe
};

}  // namespace lobe
