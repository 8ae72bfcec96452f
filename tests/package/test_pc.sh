#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_pc.sh PREFIX WORK   for each component installed in PREFIX: finds all that its headers include and links a program,
# by its .pc file alone. All objects of a static library are linked, so that no library that one of them uses may be missing.
set -eu
prefix=$1 work=$2
command -v pkg-config >/dev/null || { echo "no pkg-config here: the .pc files are not tried"; exit 0; }
libraries=$(dirname "$(find "$prefix" -name 'libpalpate*' -print -quit)")
export PKG_CONFIG_PATH=$libraries/pkgconfig
mkdir -p "$work"
echo 'int main() {}' | g++ -x c++ -c -o "$work/pc.o" -
tried=0
for file in "$PKG_CONFIG_PATH"/palpate-*.pc; do
    component=$(basename "$file" .pc)
    component=${component#palpate-}
    read -r -a compile < <(pkg-config --cflags "palpate-$component")
    read -r -a link < <(pkg-config --libs "palpate-$component")
    (cd "$prefix/include" && printf '#include <%s>\n' palpate/"$component"/*.h) |
        g++ -std=c++20 -E -o /dev/null "${compile[@]}" -x c++ - || { echo "$file: its flags do not find all headers"; exit 1; }
    archive=$libraries/libpalpate_$component.a
    [[ ! -e $archive ]] || link=(-Wl,--whole-archive "$archive" -Wl,--no-whole-archive "${link[@]}")
    g++ -o "$work/pc" "$work/pc.o" "${link[@]}" -Wl,--no-undefined -Wl,-rpath,"$libraries" || { echo "$file: does not link alone"; exit 1; }
    "$work/pc"
    tried=$((tried + 1))
done
[[ $tried -ge 3 ]] || { echo "found $tried .pc files in $PKG_CONFIG_PATH, expected one a component"; exit 1; }
