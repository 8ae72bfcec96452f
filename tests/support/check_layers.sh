#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# check_layers.sh ROOT   fails, naming file and line, on an include that modules/layers.txt does not allow, and when one of
# the engine's modules reaches for VTK, Qt's window modules or hidapi, in its sources or in what it links.
#
# A line `module/folder: ...` of layers.txt names a folder of the module's src/. A public header belongs to the folder of the
# source with its name, and if there is none, every folder of the module may include it.
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
    function inSource(folder, file,    path) { # path below src/, e.g. "solver/GodObject.cpp"; empty elsewhere
        return match(file, "^(modules/)?" folder "/src/") ? substr(file, RLENGTH + 1) : ""
    }
    function innerOf(folder, file,    path) { # e.g. "haptics/solver"; empty outside the folders of src/
        return folder in hasInner && split(inSource(folder, file), path, "/") == 2 ? folder "/" path[1] : ""
    }
    function stem(file) { sub(/.*\//, "", file); sub(/\.[a-z]+$/, "", file); return file }
    function check(    inner, engine, text, header, path, home) {
        line = 0
        if (!(folder in known)) { line = 1; complain("folder " folder " is not in layers.txt"); return }
        inner = innerOf(folder, file)
        if (inner == "" && file ~ /\/include\//) inner = homeOf[folder "/" stem(file)]
        if (inner != "" && !(inner in known)) { line = 1; complain("folder " inner " is not in layers.txt"); return }
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
            if (inner != "") {
                home = ""
                if (split(header, path, "/") == 2 && (folder "/" path[1]) in known) home = folder "/" path[1]
                else if (header ~ ("^palpate/" folder "/")) home = homeOf[folder "/" stem(header)]
                if (home != "" && !reach(inner, home)) complain(inner " must not use " home ": " header)
            }
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
    FNR == NR {
        sub(/#.*/, "")
        if (split($0, half, ":") == 2) {
            name = half[1]; gsub(/ /, "", name); uses[name] = half[2]; known[name] = 1
            if (split(name, path, "/") == 2) hasInner[path[1]] = 1
        }
        next
    }
    {
        folders[++sources] = $1; files[sources] = $2
        inner = innerOf($1, $2)
        if (inner != "" && $2 ~ /\.cpp$/) homeOf[$1 "/" stem($2)] = inner
    }
    END {
        if (!sources) { print "no sources below " root; exit 1 }
        for (i = 1; i <= sources; i++) { folder = folders[i]; file = files[i]; check() }
        if (!bad) printf "layers: %d files, every include allowed\n", sources
        exit bad
    }' "$rules" -
