// SPDX-License-Identifier: BSD-3-Clause
#include "HostileMeshes.h"

#include <array>
#include <cstdint>
#include <limits>
#include <random>

namespace palpate::test {

namespace {

const std::string kVertices = "v 0 0 0\nv 2.5 0 0\nv 0 1.5 0\n";
const std::string kObj = kVertices + "f 1 2 3\n";

std::string header(const std::string& vertices, const std::string& faces, const std::string& format = "ascii",
                   const std::string& coordinate = "float", const std::string& list = "uchar int")
{
    return "ply\nformat " + format + " 1.0\nelement vertex " + vertices + "\nproperty " + coordinate + " x\nproperty " +
           coordinate + " y\nproperty " + coordinate + " z\nelement face " + faces + "\nproperty list " + list +
           " vertex_indices\nend_header\n";
}

const std::string kPly = header("3", "1") + "0 0 0\n2.5 0 0\n0 1.5 0\n3 0 1 2\n";

template<class T>
void put(std::string& out, T value)
{
    out.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

/// Three vertices and one face, little-endian.
std::string binaryBody(float x = 2.5F, std::int32_t corner = 2, std::uint8_t corners = 3)
{
    std::string out;
    for (const float value : {0.0F, 0.0F, 0.0F, x, 0.0F, 0.0F, 0.0F, 1.5F, 0.0F}) {
        put(out, value);
    }
    put(out, corners);
    for (const std::int32_t index : {0, 1, corner}) {
        put(out, index);
    }
    return out;
}

std::string repeated(const std::string& text, int count)
{
    std::string out;
    for (int i = 0; i < count; ++i) {
        out += text;
    }
    return out;
}

std::string noise(std::size_t size)
{
    std::mt19937 random(7);
    std::string out(size, '\0');
    for (char& c : out) {
        c = static_cast<char>(random() & 0xff);
    }
    return out;
}

void addObj(std::vector<HostileMesh>& out)
{
    const auto add = [&out](const char* name, const std::string& bytes, const char* complaint) {
        out.push_back({std::string(name) + ".obj", bytes, complaint});
    };
    add("o01_empty", "", "byte 0: the file is empty");
    add("o02_vertices_only", kVertices, "line 3: 0 faces");
    add("o03_index_huge", kVertices + "f 1 2 4294967295\n", "line 4: vertex index 4294967295");
    add("o04_index_beyond_int64", kVertices + "f 1 2 99999999999999999999\n", "line 4: \"99999999999999999999\"");
    add("o05_index_beyond", kVertices + "f 1 2 4\n", "line 4: vertex index 4");
    add("o06_index_zero", kVertices + "f 0 1 2\n", "line 4: vertex index 0");
    add("o07_index_negative", kVertices + "f -1 -2 -4\n", "line 4: vertex index -4");
    add("o08_nan", "v 0 nan 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: a coordinate is not a finite number");
    add("o09_inf", "v 0 1e999 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: a coordinate is not a finite number");
    add("o10_far", "v 0 2e7 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: a coordinate is farther than 10 km");
    add("o11_cut", "v 0 0 0\nv 2.5 0", "line 2: the vertex has fewer than three coordinates");
    add("o12_cut_face", kVertices + "f 1 2", "line 4: a face with 2 corners");
    add("o13_words", "v 0 zero 0\nf 1 1 1\n", "line 1: \"zero\" is not a number");
    add("o14_comma", "v 0,5 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1: \"0,5\" is not a number");
    add("o15_nul", std::string(kVertices).append("g a\0b\nf 1 2 3\n", 14), "line 4: found a zero byte");
    add("o16_degenerate", "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", "all triangles have zero area");
    add("o17_corners", std::string(kVertices).append("f").append(repeated(" 1 2 3", 700)).append("\n"),
        "line 4: a face with 2,100 corners");
    add("o18_noise", std::string("v ").append(noise(20000)), "line 1: ");
    add("o19_endless_line", kVertices + repeated("f 1 2 \\\n", 100000), "line 4: ");
    add("o20_html", "<!DOCTYPE html><html><body>404 Not Found</body></html>\n", "byte 0: a web page (HTML)");
    add("o21_lfs", "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n", "byte 0: a Git LFS pointer");
    add("o22_utf16", std::string("\xff\xfev\0 \0", 6) + noise(100), "");
    out.back().complaint = "line 1: "; // read as XML, by its byte order mark
    add("p01_plain", kObj, "");
    add("p02_crlf", "v 0 0 0\r\nv 2.5 0 0\r\nv 0 1.5 0\r\nf 1 2 3\r\n", "");
    add("p03_bom", "\xef\xbb\xbf" + kObj, "");
    add("p04_long_name", std::string("g ").append(5'000'000, 'a').append("\n") + kObj, "");
    add("p05_blanks", "\n \t\n" + kObj, "");
    add("p06_slicer", "# 3D Slicer output. SPACE=RAS\n" + kObj, "");
    add("p07_two_objects", kVertices + "o a\nf 1 2 3\no b\nf 3 2 1\n", "");
    add("p08_normals_missing", kVertices + "f 1/9/9 2/9/9 3/9/9\n", "");
    add("p09_no_last_newline", kObj.substr(0, kObj.size() - 1), "");
}

void addPly(std::vector<HostileMesh>& out)
{
    const auto add = [&out](const char* name, const std::string& bytes, const char* complaint) {
        out.push_back({std::string(name) + ".ply", bytes, complaint});
    };
    const std::string body = "0 0 0\n2.5 0 0\n0 1.5 0\n3 0 1 2\n";
    const std::string binary = header("3", "1", "binary_little_endian");
    add("q01_empty", "", "byte 0: the file is empty");
    add("q02_header_only", header("3", "1"), "line 3: number of elements \"vertex\": declared 3");
    add("q03_vertices_4e9", header("4294967295", "1") + body,
        "line 3: number of elements \"vertex\": declared 4,294,967,295");
    add("q04_vertices_1e19", header("99999999999999999999", "1") + body, "line 3: ");
    add("q05_vertices_negative", header("-3", "1") + body, "line 3: ");
    add("q06_faces_1e9", header("3", "1000000000") + body,
        "line 7: number of elements \"face\": declared 1,000,000,000");
    add("q07_one_face_too_many", header("3", "2") + body, "line 14: the file ends in element \"face\" 1 of 2");
    add("q08_one_vertex_too_few", header("2", "1") + body, "line ");
    add("q09_index_beyond", header("3", "1") + "0 0 0\n2.5 0 0\n0 1.5 0\n3 0 1 3\n", "line 13: face 0 uses vertex 3");
    add("q10_index_negative", header("3", "1") + "0 0 0\n2.5 0 0\n0 1.5 0\n3 0 1 -1\n",
        "line 13: face 0 uses vertex -1");
    add("q11_index_beyond_binary", binary + binaryBody(2.5F, 2147483647), "byte ");
    add("q12_nan", binary + binaryBody(std::numeric_limits<float>::quiet_NaN()), "byte ");
    add("q13_inf", binary + binaryBody(std::numeric_limits<float>::infinity()), "byte ");
    add("q14_far", binary + binaryBody(1e30F), "byte ");
    add("q15_cut", binary + binaryBody().substr(0, 45), "byte ");
    add("q16_more", binary + binaryBody() + "more", "byte ");
    add("q17_two_corners", header("3", "1") + "0 0 0\n1 0 0\n0 1 0\n2 0 1\n",
        "line 13: number of corners of face 0: 2");
    add("q18_255_corners_of_none", binary + binaryBody(2.5F, 2, 255), "byte ");
    add("q19_list_of_4e9",
        header("3", "1", "binary_little_endian", "float", "uint int") + binaryBody() + "\xff\xff\xff", "byte ");
    add("q20_list_of_nan", header("3", "1", "ascii", "float", "float int") + "0 0 0\n1 0 0\n0 1 0\nnan 0 1 2\n",
        "line 8: the property \"list float int vertex_indices\"");
    add("q21_type", header("3", "1", "ascii", "string") + body, "line 4: ");
    add("q22_format", header("3", "1", "binary_middle_endian") + body, "line 2: ");
    add("q23_no_x", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float y\nend_header\n1\n", "header: ");
    add("q24_no_face",
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
        "end_header\n0 0 0\n",
        "header: no faces");
    add("q25_cut_header", "ply\nformat ascii 1.0\nelement vertex 3\n", "line 3: the file ends in the header");
    add("q26_comma", header("3", "1") + "0,5 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "line 10: \"0,5\" is not a number");
    add("q27_words", header("3", "1") + "0 0 0\n1 one 0\n0 1 0\n3 0 1 2\n", "line 11: \"one\" is not a number");
    add("q28_degenerate", header("3", "1") + "0 0 0\n1 1 1\n2 2 2\n3 0 1 2\n", "all triangles have zero area");
    add("q29_noise", std::string("ply\n").append(noise(20000)), "line ");
    add("q30_noise_in_body", binary + noise(20000), "byte ");
    add("q31_many_elements",
        std::string("ply\nformat ascii 1.0\n").append(repeated("element thing 0\nproperty list uchar int x\n", 20000)),
        "line ");
    add("q32_html", "<html>502</html>", "byte 0: a web page (HTML)");
    add("q33_lfs", "version https://git-lfs.github.com/spec/v1\noid sha256:00\nsize 1\n", "byte 0: a Git LFS pointer");
    add("r01_plain", kPly, "");
    add("r02_binary", binary + binaryBody(), "");
    add("r03_long_comment", std::string("ply\nformat ascii 1.0\ncomment ").append(5'000'000, 'a') + kPly.substr(20),
        "");
    add("r04_slicer", std::string("ply\nformat ascii 1.0\ncomment SPACE=RAS").append(kPly.substr(20)), "");
    add(
        "r05_crlf",
        [] {
            std::string text;
            for (const char c : kPly) {
                text += c == '\n' ? "\r\n" : std::string(1, c);
            }
            return text;
        }(),
        "");
}

} // namespace

std::vector<HostileMesh> hostileMeshes()
{
    std::vector<HostileMesh> out;
    addObj(out);
    addPly(out);
    return out;
}

} // namespace palpate::test
