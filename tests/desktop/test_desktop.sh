#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_desktop.sh entry|metainfo|types|texts|thumbnail|version SOURCES BUILD WORK PALPATE VERSION   checks what resources/desktop
# installs. Exit code 77 if a tool for the check is missing.
set -euo pipefail
what=$1 sources=$2 build=$3 work=$4 palpate=$5 version=$6
made=$build/resources/desktop
rm -rf "$work" && mkdir -p "$work" && cd "$work"

failed=0
wrong() { echo "$*"; failed=1; }
need() {
    local tool
    for tool in "$@"; do
        command -v "$tool" >/dev/null || { echo "not checked: $tool is not installed"; exit 77; }
    done
}

case $what in
entry)
    need desktop-file-validate
    desktop-file-validate "$sources/resources/desktop/palpate.desktop" || failed=1
    # Each type of the entry is known: to the shared database, or to the file beside it.
    for type in $(sed -n 's/^MimeType=//p' "$sources/resources/desktop/palpate.desktop" | tr ';' ' '); do
        case $type in
        model/stl | model/obj) ;;
        *) grep -q "<mime-type type=\"$type\">" "$sources/resources/desktop/palpate-mime.xml" || wrong "$type: not in palpate-mime.xml" ;;
        esac
    done
    ;;
metainfo)
    need appstreamcli
    # The project has no homepage; newer versions warn of that, and of the form of <developer_name> that older ones need.
    lenient=
    for tag in url-homepage-missing developer-name-tag-deprecated developer-id-missing; do
        said=$(appstreamcli validate --no-net --override=$tag=info "$made"/*.metainfo.xml 2>&1) || true
        [[ $said == *"not override"* ]] || lenient+=,$tag=info # versions that know the tag
    done
    appstreamcli validate --no-net ${lenient:+"--override=${lenient#,}"} "$made"/*.metainfo.xml || failed=1
    ;;
types)
    need update-mime-database gio
    mkdir -p share/mime/packages home
    cp "$sources/resources/desktop/palpate-mime.xml" share/mime/packages/palpate.xml
    XDG_DATA_HOME=$work/home update-mime-database share/mime
    # expect FILE TYPE
    expect() {
        local found
        found=$(env XDG_DATA_HOME="$work/share" HOME="$work/home" gio info -a standard::content-type "$1" |
            sed -n 's/ *standard::content-type: //p')
        [[ $found == "$2" ]] || wrong "$1: found $found, expected $2"
    }
    phantom=$sources/data/phantom
    cp "$phantom/palpation.palpate" recording # by its content
    cp "$phantom/liver.stl" "$phantom/phantom.vtp" "$phantom/phantom.palpate.json" .
    echo '{}' >other.json
    printf 'SQLite format 3\0' >other.palpated
    head -c 200 /dev/zero >>other.palpated
    printf 'ply\nformat ascii 1.0\n' >mesh.ply
    for name in labels.nii labels.seg.nrrd labels.nhdr labels.mha labels.nii.gz surface.gii surface.off; do
        printf 'text of no known kind\n' >"$name"
    done
    expect "$phantom/palpation.palpate" application/x-palpate-recording
    expect recording application/x-palpate-recording
    expect other.palpated application/vnd.sqlite3 # another database
    expect phantom.palpate.json application/x-palpate-scene+json
    expect other.json application/json
    expect liver.stl model/stl
    expect phantom.vtp application/vnd.vtk
    expect mesh.ply model/x-ply
    expect labels.nii application/x-nifti
    expect labels.nii.gz application/x-nifti
    expect labels.seg.nrrd application/x-nrrd
    expect labels.nhdr application/x-nrrd
    expect labels.mha application/x-metaimage
    expect surface.gii application/x-gifti+xml
    expect surface.off model/x-off
    # Each extension that the program reads has a type: the file dialog takes the same table (meshio/MeshFormats.h).
    ;;
texts)
    need zcat
    zcat "$made/palpate.1.gz" | sed -e 's/\\-/-/g' -e 's/\\f[A-Z]/ /g' >man.txt
    # holds FILE WORD WHERE: the word is in the file as a whole word.
    holds() {
        grep -q -E -- "(^|[^[:alnum:]_-])$2($|[^[:alnum:]_-])" "$1" || wrong "$1: found no $2 of \"$3\""
    }
    cp "$made/palpate.bash" bash.txt
    cp "$made/_palpate" zsh.txt
    # check COMMAND…: all that `palpate COMMAND… --help` lists, and the same for its subcommands.
    checked=0
    check() {
        local help word
        help=$("$palpate" "$@" --help)
        grep -q "^.SS \"palpate $*\"" man.txt || [[ $# -eq 0 ]] || wrong "man.txt: found no section \"palpate $*\""
        # The part of each file that is about this command.
        awk -v path="$*" '/^\.S[SH] /{ on = path == "" ? $2 == "OPTIONS" : $0 == ".SS \"palpate " path "\"" } on' man.txt >man.part
        awk -v path="        '$*')" 'index($0, path) == 1 { on = 1 } on; / ;;$/ { on = 0 }' bash.txt >bash.part
        awk -v name="_palpate$(printf '_%s' "$@" | sed 's/_$//')() {" '$0 == name { on = 1 } on; /^}/ { on = 0 }' zsh.txt >zsh.part
        for word in $(grep -o -E -- '^  (-[a-z],)?--[a-z-]+' <<<"$help" | tr ',' ' '); do
            for file in man.part bash.part zsh.part; do
                holds "$file" "$word" "$*"
            done
            checked=$((checked + 1))
        done
        local commands
        commands=$(sed -n -e '1,/^Subcommands:/d' -e 's/^  \([a-z]*\) .*/\1/p' <<<"$help")
        for word in $commands; do
            holds bash.part "$word" "$*"
            holds zsh.part "$word" "$*"
        done
        for word in $commands; do
            check "$@" "$word"
        done
    }
    check
    echo "$checked options"
    [[ $checked -gt 100 ]] || wrong "found $checked options, expected more than 100: is --help read rightly?"

    # The pages are shown without a warning, and the completions can be read.
    if command -v man >/dev/null; then
        LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l "$made/palpate.1.gz" 2>warnings.txt >/dev/null || failed=1
        [[ ! -s warnings.txt ]] || wrong "$(cat warnings.txt)"
    else
        echo "the manual page was not shown: man is not installed"
    fi
    # complete WORD …: what bash offers for the last word
    complete() {
        bash -c 'source "$0"; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _palpate; printf "%s " "${COMPREPLY[@]}"' "$made/palpate.bash" "$@" | tr '\n' ' '
    }
    touch a-file.stl
    [[ $(complete palpate sess) == "session " ]] || wrong "bash: found \"$(complete palpate sess)\", expected session"
    [[ $(complete palpate session me) == "measure " ]] || wrong "bash: found \"$(complete palpate session me)\", expected measure"
    [[ $(complete palpate session measure --dis) == "--distance " ]] || wrong "bash: no option of session measure"
    [[ $(complete palpate evaluate --see) == "--seed --seeds " ]] || wrong "bash: no options of evaluate"
    [[ $(complete palpate info a-f) == "a-file.stl " ]] || wrong "bash: no file"
    [[ -z $(complete palpate felt --radius '' | tr -d ' ') ]] || wrong "bash: offers something for a number"
    if command -v zsh >/dev/null; then
        zsh -n "$made/_palpate" || failed=1
    else
        echo "the completion of zsh was not read: zsh is not installed"
    fi
    ;;
thumbnail)
    # Without a display, as in the sandbox of a file manager.
    draw() { env -i HOME="$work" "$palpate" thumbnail "$@"; }
    phantom=$sources/data/phantom
    mkdir scene && cp "$phantom"/*.stl "$phantom/phantom.vtp" "$phantom"/*.palpate.json "$phantom/palpation.palpate" scene/
    draw scene/phantom.palpate.json --out scene.png --size 128
    draw scene/palpation.palpate --out recording.png
    draw scene/liver.stl --out "mesh 1.png" --size 48
    for pair in scene.png=128 recording.png=256 "mesh 1.png=48"; do
        # Width and height in the header of a PNG.
        size=$(od -A n -t u1 -j 16 -N 8 "${pair%=*}" | tr -s ' \n' ' ')
        expected=$((${pair#*=} / 256)) rest=$((${pair#*=} % 256))
        [[ $size == " 0 0 $expected $rest 0 0 $expected $rest"* ]] || wrong "${pair%=*}: found the size$size, expected ${pair#*=}"
    done
    # A hidden target of an exercise is not drawn: as if it were invisible.
    name="lump 20 mm"
    grep -q "\"name\": \"$name\"" scene/phantom.palpate.json || wrong "the phantom has no $name"
    sed "1a \"exercise\": {\"targets\": [\"$name\"]}," scene/phantom.palpate.json >scene/exercise.palpate.json
    awk -v name="\"$name\"" 'index($0, "\"name\": " name) { on = 1 } on && /"visible"/ { sub(/true/, "false"); on = 0 } 1' \
        scene/phantom.palpate.json >scene/invisible.palpate.json
    draw scene/exercise.palpate.json --out exercise.png --size 128
    draw scene/invisible.palpate.json --out invisible.png --size 128
    cmp exercise.png invisible.png || failed=1
    ! cmp -s exercise.png scene.png || wrong "the lump is not in the picture at all"
    # No picture for what cannot be opened, and none for what is its own output.
    echo nonsense >scene/bad.stl
    for file in scene/bad.stl scene/none.stl scene/liver.stl; do
        out=bad.png
        [[ $file != scene/liver.stl ]] || out=$file
        code=0
        draw "$file" --out "$out" 2>error.txt || code=$?
        [[ $code -eq 2 && -s error.txt && ! -e bad.png ]] || wrong "$file: exit code $code, expected 2 and no picture"
    done
    cmp "$phantom/liver.stl" scene/liver.stl || failed=1
    ;;
version)
    said=$("$palpate" --version)
    [[ $said =~ ^"palpate $version ("[^$'\n']+")"$'\n'"built with Qt "[0-9.]+", VTK "[0-9.]+", SQLite "[0-9.]+", Eigen "[0-9.]+$ ]] ||
        wrong "palpate --version: found \"$said\""
    [[ $("$(dirname "$palpate")/palpate-evaluation" --version) == "$said" ]] || wrong "palpate-evaluation has another version"
    grep -q "^version: $version\$" "$sources/CITATION.cff" || wrong "CITATION.cff: expected version $version, the one in CMakeLists.txt"
    newest=$(sed -n -e '/^## [0-9.]* - [0-9-]*$/{ s/^## \(.*\) - /\1 /p; q }' "$sources/CHANGELOG.md")
    [[ ${newest% *} == "$version" ]] || wrong "CHANGELOG.md: found $newest as the newest release, expected $version"
    grep -q "^date-released: ${newest#* }\$" "$sources/CITATION.cff" || wrong "CITATION.cff: expected date-released ${newest#* }, as in CHANGELOG.md"
    grep -q "<release version=\"$version\" date=\"${newest#* }\"/>" "$made"/*.metainfo.xml || wrong "metainfo: expected release $newest"
    zcat "$made/palpate.1.gz" | sed 's/\\-/-/g' >man.txt
    grep -q "^.TH PALPATE 1 \"${newest#* }\" \"Palpate $version\"" man.txt || wrong "manual page: expected $newest"
    ;;
esac
exit $failed
