// SPDX-License-Identifier: BSD-3-Clause
#include "Fuzz.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>

namespace palpate::fuzz {

const Target& target(std::string_view name)
{
    for (const Target* some : targets()) {
        if (some->name == name) {
            return *some;
        }
    }
    std::fprintf(stderr, "found the target \"%s\", expected one of:", std::string(name).c_str());
    for (const Target* some : targets()) {
        std::fprintf(stderr, " %s", std::string(some->name).c_str());
    }
    std::fputs("\n", stderr);
    std::exit(2);
}

void require(bool isTrue, const char* what)
{
    if (!isTrue) {
        std::fprintf(stderr, "broken promise: %s\n", what);
        std::abort();
    }
}

void requireOneLine(const core::Status& status, std::string_view name)
{
    require(!status.isOk(), "a refusal says so");
    require(status.message().starts_with(name), "a refusal names the file");
    require(status.message().find('\n') == std::string::npos, "a refusal is one line");
}

InputFile::InputFile(const char* name)
{
    std::error_code error;
    const std::filesystem::path memory = "/dev/shm";
    std::string made =
        ((std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path()) /
         "palpate-fuzz-XXXXXX")
            .string();
    require(::mkdtemp(made.data()) != nullptr, "a folder can be made");
    m_folder = made;
    m_path = m_folder / name;
}

InputFile::~InputFile()
{
    std::error_code ignored;
    std::filesystem::remove_all(m_folder, ignored);
}

void InputFile::set(std::string_view bytes) const
{
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator(m_folder, ignored)) { // including journals
        std::filesystem::remove(entry.path(), ignored);
    }
    std::ofstream(m_path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

} // namespace palpate::fuzz
