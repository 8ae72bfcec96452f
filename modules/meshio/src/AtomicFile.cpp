// SPDX-License-Identifier: BSD-3-Clause
#include "AtomicFile.h"

#include "Fault.h"

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <string>
#include <unistd.h>

namespace palpate::meshio::internal {

core::Status writeAtomically(const std::filesystem::path& path, std::string_view bytes)
{
    static std::atomic<unsigned> count{0};
    const std::string temporary =
        path.string() + ".tmp-" + std::to_string(::getpid()) + "-" + std::to_string(count.fetch_add(1));
    const auto failed = [&](std::string_view what, int error) {
        return fault(error == ENOENT ? core::StatusCode::NotFound : core::StatusCode::Unreadable,
                     path.filename().string(), "", std::string(what) + ": " + std::strerror(error),
                     "a place that can be written");
    };
    const int descriptor = ::open(temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0) {
        return failed("cannot be written", errno);
    }
    int error = 0;
    while (error == 0 && !bytes.empty()) {
        const ssize_t done = ::write(descriptor, bytes.data(), bytes.size());
        if (done >= 0) {
            bytes.remove_prefix(static_cast<std::size_t>(done));
        } else if (errno != EINTR) {
            error = errno;
        }
    }
    if (error == 0 && ::fsync(descriptor) != 0) {
        error = errno;
    }
    if (::close(descriptor) != 0 && error == 0) {
        error = errno;
    }
    if (error == 0 && ::rename(temporary.c_str(), path.c_str()) != 0) {
        error = errno;
    }
    if (error != 0) {
        ::unlink(temporary.c_str());
        return failed("cannot be written", error);
    }
    // The rename itself is on disk once its folder is.
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (const int parent = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC); parent >= 0) {
        (void)::fsync(parent);
        ::close(parent);
    }
    return {};
}

} // namespace palpate::meshio::internal
