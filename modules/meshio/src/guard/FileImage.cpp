// SPDX-License-Identifier: BSD-3-Clause
#include "guard/FileImage.h"

#include "text/Fault.h"

#include <algorithm>
#include <cerrno>
#include <sys/mman.h>
#include <unistd.h>
#include <utility>

namespace palpate::meshio::internal {

using core::StatusCode;

core::Result<FileImage> FileImage::allocate(std::size_t size, std::string_view file)
{
    FileImage image;
    image.m_descriptor = ::memfd_create("palpate-mesh", MFD_CLOEXEC);
    if (image.m_descriptor < 0 || ::ftruncate(image.m_descriptor, static_cast<off_t>(size)) != 0) {
        return systemFault(file, PALPATE_TEXT("not enough memory to read it: %1"));
    }
    if (size > 0) {
        void* data = ::mmap(nullptr, size, PROT_READ | PROT_WRITE, MAP_SHARED, image.m_descriptor, 0);
        if (data == MAP_FAILED) {
            return systemFault(file, PALPATE_TEXT("not enough memory to read it: %1"));
        }
        image.m_data = static_cast<char*>(data);
        image.m_size = size;
    }
    return image;
}

core::Result<FileImage> FileImage::load(const std::filesystem::path& path)
{
    const core::Result<OpenFile> source = openFile(path);
    return source.isOk() ? load(source.value(), path.filename().string()) : source.status();
}

core::Result<FileImage> FileImage::load(const OpenFile& source, std::string_view file)
{
    core::Result<FileImage> image = allocate(source.size, file);
    if (!image.isOk()) {
        return image;
    }
    const std::span<char> to = image.value().writable();
    for (std::size_t done = 0; done < to.size();) {
        constexpr std::size_t kPart = std::size_t{1} << 26;
        const ssize_t got = ::read(source.descriptor.value(), to.data() + done, std::min(kPart, to.size() - done));
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return systemFault(file, PALPATE_TEXT("cannot be read: %1"));
        }
        if (got == 0) {
            return fault(StatusCode::Unreadable, file, onByte(done),
                         {PALPATE_TEXT("the file became shorter while it was read")},
                         {PALPATE_TEXT("%1 bytes"), Count(to.size())});
        }
        done += static_cast<std::size_t>(got);
    }
    return image;
}

core::Result<FileImage> FileImage::copy(std::string_view bytes, std::string_view file)
{
    core::Result<FileImage> image = allocate(bytes.size(), file);
    if (image.isOk()) {
        std::copy(bytes.begin(), bytes.end(), image.value().writable().begin());
    }
    return image;
}

FileImage::FileImage(FileImage&& other) noexcept
    : m_descriptor(std::exchange(other.m_descriptor, -1))
    , m_data(std::exchange(other.m_data, nullptr))
    , m_size(std::exchange(other.m_size, 0))
{
}

FileImage& FileImage::operator=(FileImage&& other) noexcept
{
    std::swap(m_descriptor, other.m_descriptor);
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
    return *this;
}

FileImage::~FileImage()
{
    if (m_data != nullptr) {
        ::munmap(m_data, m_size);
    }
    if (m_descriptor >= 0) {
        ::close(m_descriptor);
    }
}

std::string FileImage::openPath() const
{
    return "/proc/self/fd/" + std::to_string(m_descriptor);
}

} // namespace palpate::meshio::internal
