#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_layers.sh ROOT   fails, naming file and line, on an include that modules/layers.txt does not allow, and when one of
# the engine's modules reaches for VTK, Qt's window modules or hidapi, in its sources or in what it links.
set -eu
root=$1
rules=$(dirname "${BASH_SOURCE[0]}")/../../modules/layers.txt

# Folder of each source, then its name: "geometry modules/geometry/src/TriangleMesh.cpp".
list() {
    cd "$root"
    local folder
    for folder in modules/*/; do
        [ -d "$folder" ] && find "$folder" -type f \( -name '*.h' -o -name '*.cpp' -o -name CMakeLists.txt \) | sed "s|^|$(basename "$folder") |"
    done
    for folder in app plugins data; do
        [ -d "$folder" ] && find "$folder" -type f \( -name '*.h' -o -name '*.cpp' \) | sed "s|^|$folder |"
    done
    true
}

list | LC_ALL=C sort | awk -v root="$root" '
    function complain(what) { printf "%s:%d: %s\n", file, line, what; bad = 1 }
    function reach(from, to,    i, n, parts) { # to is from, or named by it, or by what it names
        if (from == to) return 1
        n = split(uses[from], parts, " ")
        for (i = 1; i <= n; i++) if (reach(parts[i], to)) return 1
        return 0
    }
    FNR == NR {
        sub(/#.*/, "")
        if (split($0, half, ":") == 2) { name = half[1]; gsub(/ /, "", name); uses[name] = half[2]; known[name] = 1; if (split(name, path, "/") == 2) hasInner[path[1]] = 1 }
        next
    }
    {
        folder = $1; file = $2; line = 0; sources++
        if (!(folder in known)) { line = 1; complain("folder " folder " is not in layers.txt"); next }
        inner = ""
        if (split(file, path, "/") == 5 && path[3] == "src" && folder in hasInner) {
            inner = folder "/" path[4]
            if (!(inner in known)) { line = 1; complain("folder " inner " is not in layers.txt"); next }
        }
        engine = folder ~ /^(core|geometry|haptics|device|servo|session)$/
        while ((getline text < (root "/" file)) > 0) {
            line++
            if (file ~ /CMakeLists\.txt$/) {
                if (engine && text ~ /VTK::|Qt6::(Gui|Widgets|OpenGL)|hidapi/) complain("the engine links neither VTK, Qt Gui or Widgets, nor hidapi: " text)
                continue
            }
            if (text !~ /^[ \t]*#[ \t]*include/) continue
            header = text
            sub(/^[ \t]*#[ \t]*include[ \t]*[<"]/, "", header); sub(/[>"].*/, "", header)
            if (inner != "" && text ~ /"/ && split(header, path, "/") == 2 && (folder "/" path[1]) in known && !reach(inner, folder "/" path[1]))
                complain(inner " must not use " folder "/" path[1] ": " header)
            if (header ~ /^palpate\//) {
                split(header, path, "/")
                if (!(path[2] in known)) complain("no such module: " header)
                else if (!reach(folder, path[2])) complain(folder " must not use " path[2] ": " header)
            }
            if (engine && header ~ /^(vtk|QtGui|QtWidgets|QtOpenGL|QOpenGL|QApplication|QGuiApplication|QWidget|QImage|hidapi)/)
                complain("the engine uses neither VTK, Qt Gui or Widgets, nor hidapi: " header)
            if (folder ~ /^(core|geometry|haptics)$/ && header ~ /^(Q[A-Z]|Qt|sqlite3)/)
                complain(folder " uses Eigen and the standard library alone: " header)
            if (folder == "view" && header ~ /^(Q[A-Z]|Qt)/) complain("view uses no Qt: " header)
            if (file ~ /^modules\/meshio\/include\// && header ~ /^vtk/) complain("VTK is private to meshio: " header)
        }
        close(root "/" file)
    }
    END {
        if (!sources) { print "no sources below " root; exit 1 }
        if (!bad) printf "layers: %d files, every include allowed\n", sources
        exit bad
    }' "$rules" -
