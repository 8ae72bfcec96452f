// SPDX-License-Identifier: BSD-3-Clause
#include "read/ImportServer.h"

#include "read/MeshWire.h"
#include "read/ReadMesh.h"
#include "text/Fault.h"

#include <algorithm>
#include <cerrno>
#include <climits>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <malloc.h>
#include <new>
#include <poll.h>
#include <string>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace palpate::meshio::internal {

namespace {

using core::Result;
using core::StatusCode;

bool limit(__rlimit_resource resource, std::uint64_t soft, std::uint64_t hard)
{
    const rlimit both{soft, hard};
    return ::setrlimit(resource, &both) == 0;
}

/// Drops all rights that reading a mesh does not need, before the first byte of the file is read.
bool confine(const ImportTask& task)
{
    return limit(RLIMIT_CORE, 0, 0) && limit(RLIMIT_AS, task.memory_bytes, task.memory_bytes) &&
           limit(RLIMIT_FSIZE, task.memory_bytes, task.memory_bytes) && // size of the result
           limit(RLIMIT_CPU, task.cpu_s, task.cpu_s + 1) && limit(RLIMIT_NOFILE, task.files, task.files) &&
           ::prctl(PR_SET_PDEATHSIG, SIGKILL) == 0;
}

/// @return a callback that reports progress to the client
std::function<bool(double)> progressTo(int pipe)
{
    return [pipe, newest = -1](double share) mutable {
        const int step = static_cast<int>(share * (kStructureByte - 1));
        if (step > newest && step < kStructureByte) {
            newest = step;
            const auto byte = static_cast<std::uint8_t>(step);
            (void)!::write(pipe, &byte, 1); // a slow client misses a step
        }
        return true;
    };
}

core::Status tooLarge(const ImportTask& task, const std::string& name)
{
    return fault(StatusCode::OutOfRange, name, {},
                 {PALPATE_TEXT("reading it takes more than %1 MiB of memory"), Count(task.memory_bytes >> 20)},
                 {PALPATE_TEXT("content in proportion to the size of the file")});
}

Result<MeshFile> readMeshFor(const ImportTask& task, const std::filesystem::path& path, const ImportEnds& ends,
                             const std::function<void(MeshFile&)>& structureRead)
{
    const std::string name = path.filename().string();
    try {
        ReadOptions options;
        options.unit_mm = task.unit_mm;
        options.isPartial = task.isPartial;
        options.frame = task.frame;
        options.readsScale = task.readsScale;
        options.progress = progressTo(ends.progress);
        options.structureRead = structureRead;
        const Result<OpenFile> file = openFile(Descriptor(ends.source), name);
        if (!file.isOk()) {
            return file.status();
        }
        Result<FileImage> image = FileImage::load(file.value(), name);
        return image.isOk() ? decodeMesh(std::move(image).value(), path, options) : image.status();
    } catch (const std::bad_alloc&) {
        return tooLarge(task, name);
    }
}

/// Reads a mesh and hands it over, a label map structure by structure. @return false when writing fails
bool handOverMesh(const ImportTask& task, const std::filesystem::path& path, const ImportEnds& ends)
{
    std::size_t written = 0;
    bool isWritten = true;
    Result<MeshFile> outcome = readMeshFor(task, path, ends, [&](MeshFile& file) {
        isWritten = isWritten && writeStructure(ends.result, file);
        written += isWritten ? 1 : 0;
        if (isWritten) {
            (void)!::write(ends.progress, &kStructureByte, 1); // if missed, it is read with the others at the end
        }
    });
    return isWritten && writeOutcome(ends.result, std::move(outcome), written);
}

/// Reads a volume or a field. @param read  readVolumeHere or readFieldHere
template<class Read>
auto readFor(Read read, const ImportTask& task, const std::filesystem::path& path, const ImportEnds& ends)
    -> decltype(read(path, task.frame, progressTo(ends.progress)))
{
    try {
        return read(path, task.frame, progressTo(ends.progress));
    } catch (const std::bad_alloc&) {
        return tooLarge(task, path.filename().string());
    }
}

/// @return false when writing fails
bool handOver(const ImportTask& task, const std::filesystem::path& path, const ImportEnds& ends)
{
    switch (task.kind) {
    case ImportKind::Volume:
        return writeVolume(ends.result, readFor(readVolumeHere, task, path, ends));
    case ImportKind::Field:
        return writeField(ends.result, readFor(readFieldHere, task, path, ends));
    case ImportKind::Mesh:
        break;
    }
    return handOverMesh(task, path, ends);
}

/// Configures the reader's heap to grow in large steps, with huge pages where available, and to keep freed memory:
/// otherwise a short process with large arrays spends a fifth of the time on page faults.
void prepareHeap(const ImportTask& task)
{
    const auto step = static_cast<int>(std::min<std::uint64_t>(task.memory_bytes / 4, 1 << 29));
    ::mallopt(M_MMAP_THRESHOLD, 1 << 25); // maximum that glibc accepts
    ::mallopt(M_TRIM_THRESHOLD, INT_MAX);
    ::mallopt(M_TOP_PAD, step);
    auto* const begin = static_cast<char*>(::sbrk(0));
    // Larger than the free heap, so that the heap grows by one step.
    void* volatile block = std::malloc(std::size_t{1} << 22);
    std::free(block);
    const auto* const end = static_cast<char*>(::sbrk(0));
    if (end > begin) {
        ::madvise(begin, static_cast<std::size_t>(end - begin), MADV_HUGEPAGE);
    }
}

/// Main function of the reader process.
[[noreturn]] void beReader(const ImportTask& task, const char* path, const ImportEnds& ends, ReaderHook hook)
{
    if (!confine(task)) {
        ::_exit(kNotConfined);
    }
    prepareHeap(task);
    if (hook != nullptr) {
        hook(path);
    }
    if (!handOver(task, path, ends)) {
        ::_exit(kNotHandedBack);
    }
    (void)!::write(ends.progress, &kDoneByte, 1);
    ::_exit(0); // this process has nothing to clean up
}

/// Starts the reader, waits until the reader ends or the client disconnects, and reports the exit status.
[[noreturn]] void beKeeper(const ImportTask& task, const char* path, const ImportEnds& ends, ReaderHook hook)
{
    int life[2] = {-1, -1}; // only the reader keeps one end open, so that the other end detects the end of the reader
    int status = -1;
    if (::pipe2(life, O_CLOEXEC) == 0) {
        const pid_t reader = ::fork();
        if (reader == 0) {
            ::close(ends.control);
            ::close(life[0]);
            beReader(task, path, ends, hook);
        }
        ::close(life[1]);
        ::close(ends.source);
        ::close(ends.result);
        ::close(ends.progress);
        pollfd events[2] = {{life[0], POLLIN, 0}, {ends.control, POLLIN, 0}};
        while (reader > 0 && ::poll(events, 2, -1) < 0 && errno == EINTR) {
        }
        if (reader > 0) {
            if (events[0].revents == 0) {
                ::kill(reader, SIGKILL);
            }
            (void)::waitpid(reader, &status, 0);
        }
    }
    (void)!::send(ends.control, &status, sizeof(status), MSG_NOSIGNAL);
    ::_exit(0);
}

} // namespace

void serveImports(int socket, ReaderHook hook)
{
    for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) { // discards output of libraries
        const int nothing = ::open("/dev/null", O_RDWR);
        ::dup2(nothing, standard);
        ::close(nothing);
    }
    ::dup2(socket, STDERR_FILENO + 1);
    socket = STDERR_FILENO + 1;
    ::closefrom(socket + 1);
    ::prctl(PR_SET_NAME, "palpate-import");
    (void)std::signal(SIGINT, SIG_IGN); // Ctrl+C is meant for the program; this process ends when the program ends
    while (true) {
        alignas(ImportTask) char bytes[kMostTask + 1] = {};
        alignas(cmsghdr) char rights[CMSG_SPACE(sizeof(ImportEnds))] = {};
        iovec part = {bytes, kMostTask};
        msghdr message = {};
        message.msg_iov = &part;
        message.msg_iovlen = 1;
        message.msg_control = rights;
        message.msg_controllen = sizeof(rights);
        const ssize_t got = ::recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        while (::waitpid(-1, nullptr, WNOHANG) > 0) {
        }
        const cmsghdr* head = CMSG_FIRSTHDR(&message);
        if (got <= static_cast<ssize_t>(sizeof(ImportTask)) || head == nullptr ||
            head->cmsg_len != CMSG_LEN(sizeof(ImportEnds))) {
            while (::wait(nullptr) > 0) { // the client has ended, and the child processes detect this too
            }
            ::_exit(0);
        }
        ImportTask task;
        ImportEnds ends;
        std::memcpy(&task, bytes, sizeof(task));
        std::memcpy(&ends, CMSG_DATA(head), sizeof(ends));
        if (::fork() == 0) {
            ::close(socket);
            beKeeper(task, bytes + sizeof(task), ends, hook);
        }
        for (const int end : {ends.source, ends.result, ends.progress, ends.control}) {
            ::close(end);
        }
    }
}

} // namespace palpate::meshio::internal
