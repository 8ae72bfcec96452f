// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/meshio/MeshFormats.h"

#include "formats/Gzip.h"
#include "read/ImportServer.h"
#include "read/MeshWire.h"
#include "text/Fault.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <functional>
#include <optional>
#include <poll.h>
#include <string>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

namespace palpate::meshio {

namespace internal {

namespace {

using core::Result;
using core::Status;
using core::StatusCode;
using Clock = std::chrono::steady_clock;

/// The program's connection to the import server. Set once, before the program starts a second thread.
struct Server
{
    Descriptor socket;
    ImportLimits limits;
};

Server& server()
{
    static Server instance;
    return instance;
}

struct Budget
{
    std::uint64_t memory_bytes;
    double cpu_s;
    double wall_s;
};

Budget budgetFor(const ImportLimits& limits, std::size_t fileSize, bool isLabelMap)
{
    const auto size = static_cast<double>(fileSize);
    const double more_s = limits.perMegabyte_s * size * 1e-6 + (isLabelMap ? limits.label_s : 0.0);
    return {limits.memory_bytes + static_cast<std::uint64_t>(limits.memoryPerByte * size) +
                (isLabelMap ? limits.labelMemory_bytes : 0),
            limits.cpu_s + more_s, limits.wall_s + more_s};
}

/// @return "SIGSEGV"
std::string nameOf(int signal)
{
    const char* const name = ::sigabbrev_np(signal);
    return "SIG" + (name != nullptr ? std::string(name) : std::to_string(signal));
}

/// Describes why a reader ended without a result.
Status death(int outcome, const std::string& file, const Budget& budget)
{
    const auto refused = [&file](StatusCode code, const core::Message& found, const core::Message& expected) {
        return fault(code, file, {}, found, expected);
    };
    const core::Message readable(PALPATE_TEXT("a file that can be read"));
    const core::Message proportion(PALPATE_TEXT("content in proportion to the size of the file"));
    if (outcome == -1) {
        return refused(StatusCode::Internal, {PALPATE_TEXT("the process to read it could not be started")},
                       {PALPATE_TEXT("room for one more process with some open files and memory (`ulimit -a` lists the "
                                     "limits)")});
    }
    if (WIFSIGNALED(outcome)) {
        switch (const int signal = WTERMSIG(outcome); signal) {
        case SIGXCPU:
            return refused(
                StatusCode::OutOfRange,
                {PALPATE_TEXT("reading it took more than %1 s of processor time"), core::Rounded{budget.cpu_s, 3}},
                {PALPATE_TEXT("a file that can be read in this time")});
        case SIGXFSZ:
            return refused(StatusCode::OutOfRange,
                           {PALPATE_TEXT("its content is larger than %1 MiB"), Count(budget.memory_bytes >> 20)},
                           proportion);
        case SIGKILL:
            return refused(StatusCode::OutOfRange,
                           {PALPATE_TEXT("the system ended the process that read it, perhaps because memory ran out")},
                           {PALPATE_TEXT("a smaller file, or more free memory")});
        default:
            return refused(StatusCode::BadFormat,
                           {PALPATE_TEXT("the process that read it crashed (%1)"), nameOf(signal)}, readable);
        }
    }
    switch (WEXITSTATUS(outcome)) {
    case kNotConfined:
        return refused(StatusCode::OutOfRange,
                       {PALPATE_TEXT("the process to read it could not limit its memory and time")},
                       {PALPATE_TEXT("limits of this program above its own limits (`ulimit -a` lists them)")});
    case kNotHandedBack:
        return refused(
            StatusCode::OutOfRange, {PALPATE_TEXT("the process that read it could not write the result")},
            {PALPATE_TEXT("enough memory and no lower limit on the size of files (`ulimit -v`, `ulimit -f`)")});
    default:
        return refused(StatusCode::BadFormat,
                       {PALPATE_TEXT("the process that read it ended with exit code %1"), WEXITSTATUS(outcome)},
                       readable);
    }
}

enum class End : std::uint8_t
{
    Done,
    Died,
    Damaged, ///< a structure; the outcome has the error
    Cancelled,
    TooLate
};

/// Waits for the reader's final byte; reports progress and takes announced structures meanwhile.
/// @param take  takes the next structure; false if it is damaged. May be empty
End follow(int progress, const std::function<bool(double)>& told, const std::function<bool()>& take,
           Clock::time_point deadline)
{
    constexpr int kLook_ms = 50;    // maximum delay of a cancel
    constexpr double kShare = 0.95; // share of the progress for reading; the rest is the transfer
    std::uint8_t newest = 0;
    std::uint64_t waiting = 0; // structures
    while (true) {
        pollfd event{progress, POLLIN, 0};
        if (::poll(&event, 1, waiting > 0 ? 0 : kLook_ms) > 0) {
            std::array<std::uint8_t, 256> bytes;
            const ssize_t got = ::read(progress, bytes.data(), bytes.size());
            if (got == 0) {
                return End::Died;
            }
            for (ssize_t i = 0; i < got; ++i) {
                const std::uint8_t byte = bytes[static_cast<std::size_t>(i)];
                if (byte == kDoneByte) {
                    return End::Done;
                }
                if (byte == kStructureByte) {
                    waiting += take ? 1 : 0;
                } else {
                    newest = byte;
                }
            }
        }
        if (told && !told(kShare * double(newest) / double(kStructureByte))) {
            return End::Cancelled;
        }
        if (waiting > 0) {
            --waiting;
            if (!take()) {
                return End::Damaged;
            }
        }
        if (Clock::now() > deadline) {
            return End::TooLate;
        }
    }
}

/// Sends the task and its file descriptors to the server. @return 0, or an errno
int ask(const ImportTask& task, const std::filesystem::path& path, const ImportEnds& ends)
{
    const std::string& name = path.native();
    if (sizeof(task) + name.size() > kMostTask) {
        return ENAMETOOLONG;
    }
    alignas(cmsghdr) char rights[CMSG_SPACE(sizeof(ends))] = {};
    iovec parts[2] = {{const_cast<ImportTask*>(&task), sizeof(task)}, {const_cast<char*>(name.data()), name.size()}};
    msghdr message = {};
    message.msg_iov = parts;
    message.msg_iovlen = 2;
    message.msg_control = rights;
    message.msg_controllen = sizeof(rights);
    cmsghdr* head = CMSG_FIRSTHDR(&message);
    head->cmsg_level = SOL_SOCKET;
    head->cmsg_type = SCM_RIGHTS;
    head->cmsg_len = CMSG_LEN(sizeof(ends));
    std::memcpy(CMSG_DATA(head), &ends, sizeof(ends));
    ssize_t sent = 0;
    do {
        sent = ::sendmsg(server().socket.value(), &message, MSG_NOSIGNAL);
    } while (sent < 0 && errno == EINTR);
    return sent < 0 ? errno : 0;
}

/// @return the reader's exit status as from waitpid; -1 if the reader could not be started
int exitStatus(int control)
{
    constexpr int kLongest_ms = 5000; // the keeper only waits for the reader
    int status = -1;
    pollfd event{control, POLLIN, 0};
    if (::poll(&event, 1, kLongest_ms) > 0 &&
        ::recv(control, &status, sizeof(status), 0) != static_cast<ssize_t>(sizeof(status))) {
        status = -1;
    }
    return status;
}

} // namespace

bool hasImportServer()
{
    return server().socket.value() >= 0;
}

Status startImportServer(const ImportLimits& limits, ReaderHook hook)
{
    std::array<int, 2> ends = {-1, -1};
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        return {StatusCode::Internal, PALPATE_TEXT("no socket for the import server: %1"), core::systemError(errno)};
    }
    Descriptor here(ends[0]);
    const Descriptor there(ends[1]);
    const pid_t child = ::fork();
    if (child == 0) {
        serveImports(there.value(), hook);
    }
    if (child < 0) {
        return {StatusCode::Internal, PALPATE_TEXT("no process for the import server: %1"), core::systemError(errno)};
    }
    server().socket = std::move(here);
    server().limits = limits;
    return {};
}

namespace {

/// Reads a file in a child process and waits until the result is in a memory file, or damaged.
/// @param task  without limits; @param size  of the file or files, from which the limits follow [bytes]
/// @param take  takes the next structure from the memory file before the result is complete; false if it is damaged.
///              May be empty
Result<Descriptor> outcomeOf(ImportTask task, const OpenFile& file, std::uint64_t size,
                             const std::filesystem::path& path, const std::function<bool(double)>& told,
                             const std::function<bool(int result)>& take)
{
    const std::string name = path.filename().string();
    const auto unstarted = [&name](int error) {
        return fault(StatusCode::Internal, name, {},
                     {PALPATE_TEXT("the process to read it could not be started: %1"), core::systemError(error)},
                     {PALPATE_TEXT("room for one more process with some open files and memory (`ulimit -a` lists the "
                                   "limits)")});
    };
    std::array<int, 2> pipe = {-1, -1};
    if (::pipe2(pipe.data(), O_CLOEXEC | O_NONBLOCK) != 0) {
        return unstarted(errno);
    }
    const Descriptor progress(pipe[0]);
    Descriptor toldEnd(pipe[1]);
    if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0, pipe.data()) != 0) {
        return unstarted(errno);
    }
    const Descriptor control(pipe[0]); // closed on any return, which ends the reader
    Descriptor keeper(pipe[1]);
    Descriptor result(::memfd_create("palpate-import", MFD_CLOEXEC));
    if (result.value() < 0) {
        return unstarted(errno);
    }
    const Budget budget =
        budgetFor(server().limits, size, task.kind != ImportKind::Volume && hasLabelMapExtension(path));
    const auto deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(budget.wall_s));
    task.memory_bytes = budget.memory_bytes;
    task.cpu_s = static_cast<std::uint64_t>(std::ceil(budget.cpu_s));
    task.files = server().limits.files;
    if (const int error = ask(task, path, {file.descriptor.value(), result.value(), toldEnd.value(), keeper.value()});
        error != 0) {
        return unstarted(error);
    }
    toldEnd = Descriptor(); // now open only in the reader, so that the end of the reader closes the pipe
    keeper = Descriptor();
    const std::function<bool()> takeNext =
        take ? std::function<bool()>([&take, &result] { return take(result.value()); }) : std::function<bool()>();
    switch (follow(progress.value(), told, takeNext, deadline)) {
    case End::Done:
    case End::Damaged:
        break;
    case End::Died:
        return death(exitStatus(control.value()), name, budget);
    case End::Cancelled:
        return Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), name);
    case End::TooLate:
        return fault(StatusCode::OutOfRange, name, {},
                     {PALPATE_TEXT("reading it took more than %1 s"), core::Rounded{budget.wall_s, 3}},
                     {PALPATE_TEXT("a file that can be read in this time")});
    }
    return result;
}

/// @return the result, or Cancelled if the user cancelled during the transfer
template<class T>
Result<T> unlessCancelled(Result<T> outcome, const std::filesystem::path& path, const std::function<bool(double)>& told)
{
    if (outcome.isOk() && told && !told(1.0)) {
        return Status(StatusCode::Cancelled, PALPATE_TEXT("%1: reading was cancelled"), path.filename());
    }
    return outcome;
}

/// @return the size from which the limits for reading a mesh follow: that of its content, if packed [bytes]
std::uint64_t contentBytes(const OpenFile& file)
{
    std::array<char, 4> begin = {}, last = {};
    const int descriptor = file.descriptor.value();
    const auto ends = static_cast<off_t>(file.size) - static_cast<off_t>(last.size());
    const bool isRead = ends > 0 && ::pread(descriptor, begin.data(), begin.size(), 0) == ssize_t{4} &&
                        ::pread(descriptor, last.data(), last.size(), ends) == ssize_t{4};
    return isRead && isGzip({begin.data(), begin.size()})
               ? std::max<std::uint64_t>(file.size, statedGzipSize(file.size, {last.data(), last.size()}))
               : file.size;
}

} // namespace

Result<MeshFile> readInChild(const OpenFile& file, const std::filesystem::path& path, const ReadOptions& options)
{
    ImportTask task;
    task.unit_mm = options.unit_mm;
    task.isPartial = options.isPartial;
    task.frame = options.frame;
    task.readsScale = options.readsScale;
    // A file may have others beside it; the server's working directory is the one in which the program was started.
    const std::filesystem::path whole = std::filesystem::absolute(path);
    std::optional<OutcomeReader> outcome;
    const auto take = [&](int result) {
        if (!outcome) {
            outcome.emplace(result, path);
        }
        const bool isTaken = outcome->readStructure();
        if (isTaken) {
            options.structureRead(outcome->file());
        }
        return isTaken;
    };
    const Result<Descriptor> result =
        outcomeOf(task, file, hasLabelMapExtension(path) ? volumeBytes(path) : contentBytes(file), whole,
                  options.progress, options.structureRead ? std::function<bool(int)>(take) : nullptr);
    if (!result.isOk()) {
        return result.status();
    }
    if (!outcome) {
        outcome.emplace(result.value().value(), path);
    }
    // The reader releases its memory in the meantime.
    return unlessCancelled(std::move(*outcome).finish(), path, options.progress);
}

Result<VoxelGrid> readVolumeInChild(const OpenFile& file, const std::filesystem::path& path, core::FileFrame frame,
                                    const std::function<bool(double)>& progress)
{
    ImportTask task;
    task.kind = ImportKind::Volume;
    task.frame = frame;
    // The server's working directory is the one in which the program was started.
    const std::filesystem::path whole = std::filesystem::absolute(path);
    const Result<Descriptor> result = outcomeOf(task, file, volumeBytes(path), whole, progress, {});
    return result.isOk() ? unlessCancelled(takeVolume(result.value().value(), path), path, progress) : result.status();
}

Result<FieldGrid> readFieldInChild(const OpenFile& file, const std::filesystem::path& path, core::FileFrame frame)
{
    ImportTask task;
    task.kind = ImportKind::Field;
    task.frame = frame;
    const std::filesystem::path whole = std::filesystem::absolute(path);
    const Result<Descriptor> result = outcomeOf(task, file, volumeBytes(path), whole, {}, {});
    return result.isOk() ? takeField(result.value().value(), path) : result.status();
}

} // namespace internal

core::Status startImportServer(const ImportLimits& limits)
{
    return internal::startImportServer(limits, nullptr);
}

} // namespace palpate::meshio
