// SPDX-License-Identifier: BSD-3-Clause
#include "palpate/session/AtomicFile.h"

#include <cerrno>
#include <cstring>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace palpate::session {

namespace {

constexpr std::size_t kBufferBytes = 1 << 16;

core::Status cannotWrite(const std::filesystem::path& path, int error)
{
    return {core::StatusCode::Unreadable, path.string() + ": cannot be written: " + std::strerror(error)};
}

} // namespace

core::Result<AtomicFile> AtomicFile::create(const std::filesystem::path& path)
{
    AtomicFile file;
    file.m_path = path;
    struct stat status
    {
    };
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (path.empty() || (exists && S_ISDIR(status.st_mode))) {
        return cannotWrite(path, path.empty() ? ENOENT : EISDIR);
    }
    if (exists && !S_ISREG(status.st_mode)) { // a pipe or terminal: renaming would replace it
        file.m_file = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
        return file.m_file >= 0 ? core::Result<AtomicFile>(std::move(file)) : cannotWrite(path, errno);
    }
    if (exists && ::access(path.c_str(), W_OK) != 0) {
        return cannotWrite(path, errno);
    }
    std::error_code ignored;
    if (const auto target = std::filesystem::canonical(path, ignored); exists && !target.empty()) {
        file.m_path = target; // write through a symbolic link
    }
    file.m_temporary = file.m_path;
    for (const std::string& part : {std::string("."), std::to_string(::getpid()), std::string(".part")}) {
        file.m_temporary += part;
    }
    file.m_file = ::open(file.m_temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file.m_file < 0) {
        const int error = errno;
        file.m_temporary.clear();
        return cannotWrite(path, error);
    }
    return file;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : m_path(std::move(other.m_path))
    , m_temporary(std::exchange(other.m_temporary, {}))
    , m_file(std::exchange(other.m_file, -1))
    , m_error(other.m_error)
    , m_buffer(std::move(other.m_buffer))
{
}

AtomicFile& AtomicFile::operator=(AtomicFile&& other) noexcept
{
    if (this != &other) {
        discard();
        m_path = std::move(other.m_path);
        m_temporary = std::exchange(other.m_temporary, {});
        m_file = std::exchange(other.m_file, -1);
        m_error = other.m_error;
        m_buffer = std::move(other.m_buffer);
    }
    return *this;
}

AtomicFile::~AtomicFile()
{
    discard();
}

void AtomicFile::discard() noexcept
{
    if (m_file >= 0) {
        ::close(std::exchange(m_file, -1));
    }
    if (!m_temporary.empty()) {
        ::unlink(m_temporary.c_str());
        m_temporary.clear();
    }
}

void AtomicFile::write(std::string_view text)
{
    m_buffer.append(text);
    if (m_buffer.size() >= kBufferBytes) {
        flush();
    }
}

void AtomicFile::flush()
{
    for (std::size_t done = 0; done < m_buffer.size() && m_error == 0;) {
        const auto n = ::write(m_file, m_buffer.data() + done, m_buffer.size() - done);
        if (n >= 0) {
            done += static_cast<std::size_t>(n);
        } else if (errno != EINTR) {
            m_error = errno;
        }
    }
    m_buffer.clear();
}

core::Status AtomicFile::finish()
{
    flush();
    if (m_error == 0 && !m_temporary.empty() && ::fsync(m_file) != 0) {
        m_error = errno;
    }
    if (::close(std::exchange(m_file, -1)) != 0 && m_error == 0) {
        m_error = errno;
    }
    if (m_error == 0 && !m_temporary.empty()) {
        if (::rename(m_temporary.c_str(), m_path.c_str()) == 0) {
            m_temporary.clear();
        } else {
            m_error = errno;
        }
    }
    discard();
    return m_error == 0 ? core::Status() : cannotWrite(m_path, m_error);
}

} // namespace palpate::session
