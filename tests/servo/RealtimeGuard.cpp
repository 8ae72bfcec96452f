// SPDX-License-Identifier: BSD-3-Clause
#include "RealtimeGuard.h"

#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <unistd.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define PALPATE_GUARD_AVAILABLE 0
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define PALPATE_GUARD_AVAILABLE 0
#endif
#endif
#ifndef PALPATE_GUARD_AVAILABLE
#define PALPATE_GUARD_AVAILABLE 1
#endif

namespace {

// Plain thread-local numbers in the executable: access needs no allocation.
constinit thread_local bool isArmed = false;
constinit thread_local std::uint64_t allocationCount = 0;
constinit thread_local std::uint64_t lockCount = 0;
constinit thread_local std::uint64_t fileCount = 0;

#if PALPATE_GUARD_AVAILABLE
void countAllocation() noexcept
{
    allocationCount += isArmed ? 1 : 0;
}

void countLock() noexcept
{
    lockCount += isArmed ? 1 : 0;
}

void countFile() noexcept
{
    fileCount += isArmed ? 1 : 0;
}

/// Returns the C library's function behind the interposed one.
template<class Function>
Function* next(const char* name) noexcept
{
    return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}
#endif

} // namespace

#if PALPATE_GUARD_AVAILABLE

extern "C" {

// glibc's names for its own allocator, provided for programs that replace malloc.
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* memory, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
void __libc_free(void* memory);

void* malloc(std::size_t size)
{
    countAllocation();
    return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size)
{
    countAllocation();
    return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size)
{
    countAllocation();
    return __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size)
{
    countAllocation();
    return __libc_memalign(alignment, size);
}

void* memalign(std::size_t alignment, std::size_t size)
{
    countAllocation();
    return __libc_memalign(alignment, size);
}

int posix_memalign(void** memory, std::size_t alignment, std::size_t size)
{
    countAllocation();
    *memory = __libc_memalign(alignment, size);
    return *memory == nullptr ? ENOMEM : 0;
}

void free(void* memory)
{
    countAllocation();
    __libc_free(memory);
}

int pthread_mutex_lock(pthread_mutex_t* mutex)
{
    static const auto original = next<int(pthread_mutex_t*)>("pthread_mutex_lock");
    countLock();
    return original(mutex);
}

int pthread_mutex_trylock(pthread_mutex_t* mutex)
{
    static const auto original = next<int(pthread_mutex_t*)>("pthread_mutex_trylock");
    countLock();
    return original(mutex);
}

int pthread_rwlock_rdlock(pthread_rwlock_t* lock)
{
    static const auto original = next<int(pthread_rwlock_t*)>("pthread_rwlock_rdlock");
    countLock();
    return original(lock);
}

int pthread_rwlock_wrlock(pthread_rwlock_t* lock)
{
    static const auto original = next<int(pthread_rwlock_t*)>("pthread_rwlock_wrlock");
    countLock();
    return original(lock);
}

int pthread_cond_wait(pthread_cond_t* condition, pthread_mutex_t* mutex)
{
    static const auto original = next<int(pthread_cond_t*, pthread_mutex_t*)>("pthread_cond_wait");
    countLock();
    return original(condition, mutex);
}

int open(const char* path, int flags, ...)
{
    static const auto original = next<int(const char*, int, ...)>("open");
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(more, mode_t) : 0;
    va_end(more);
    countFile();
    return original(path, flags, mode);
}

ssize_t read(int file, void* bytes, size_t count)
{
    static const auto original = next<ssize_t(int, void*, size_t)>("read");
    countFile();
    return original(file, bytes, count);
}

ssize_t write(int file, const void* bytes, size_t count)
{
    static const auto original = next<ssize_t(int, const void*, size_t)>("write");
    countFile();
    return original(file, bytes, count);
}

FILE* fopen(const char* path, const char* mode)
{
    static const auto original = next<FILE*(const char*, const char*)>("fopen");
    countFile();
    return original(path, mode);
}

size_t fwrite(const void* bytes, size_t size, size_t count, FILE* file)
{
    static const auto original = next<size_t(const void*, size_t, size_t, FILE*)>("fwrite");
    countFile();
    return original(bytes, size, count, file);
}

int fputs(const char* text, FILE* file)
{
    static const auto original = next<int(const char*, FILE*)>("fputs");
    countFile();
    return original(text, file);
}

int puts(const char* text)
{
    static const auto original = next<int(const char*)>("puts");
    countFile();
    return original(text);
}

int vfprintf(FILE* file, const char* format, va_list values)
{
    static const auto original = next<int(FILE*, const char*, va_list)>("vfprintf");
    countFile();
    return original(file, format, values);
}

int printf(const char* format, ...)
{
    va_list values;
    va_start(values, format);
    const int count = vfprintf(stdout, format, values);
    va_end(values);
    return count;
}

int fprintf(FILE* file, const char* format, ...)
{
    va_list values;
    va_start(values, format);
    const int count = vfprintf(file, format, values);
    va_end(values);
    return count;
}

} // extern "C"

#endif

namespace palpate::test {

RealtimeGuard::RealtimeGuard() noexcept
{
    allocationCount = 0;
    lockCount = 0;
    fileCount = 0;
    isArmed = true;
}

RealtimeGuard::~RealtimeGuard()
{
    isArmed = false;
}

std::uint64_t RealtimeGuard::allocations() const noexcept
{
    return allocationCount;
}

std::uint64_t RealtimeGuard::locks() const noexcept
{
    return lockCount;
}

std::uint64_t RealtimeGuard::files() const noexcept
{
    return fileCount;
}

bool RealtimeGuard::isAvailable() noexcept
{
    return PALPATE_GUARD_AVAILABLE != 0;
}

} // namespace palpate::test
