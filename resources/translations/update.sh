#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# resources/translations/update.sh [FOLDER]   brings the catalogues up to date with the sources: new texts come in
# untranslated, those that are gone go. With a FOLDER its catalogues are brought up to date instead. The English
# catalogue has only the texts with a number, whose singular and plural differ: "%n finding(s)".
set -eu -o pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(cd "${1:-$root/resources/translations}" && pwd)
cd "$root"

# The engine marks the texts of its messages with PALPATE_TEXT (core/Message.h), which lupdate does not know.
messages=$(mktemp -d)
trap 'rm -rf "$messages"' EXIT
git ls-files -co --exclude-standard '*.cpp' '*.h' | grep -v '^tests/' | LC_ALL=C sort | tr '\n' '\0' |
    xargs -0 perl -0777 -ne 's{^\s*//.*}{}mg; print qq(QT_TRANSLATE_NOOP("palpate::Message", $1);\n) while /\bPALPATE_TEXT\(\s*((?:"(?:\\.|[^"\\])*"\s*)+)\)/g' \
        >"$messages/messages.cpp"

for catalogue in "$folder"/palpate_*.ts; do
    plurals=()
    [[ $catalogue != */palpate_en.ts ]] || plurals=(-pluralonly)
    "${LUPDATE:-/usr/lib/qt6/bin/lupdate}" -silent "${plurals[@]}" -no-obsolete -locations none -extensions cpp,h app/src modules "$messages" -ts "$catalogue"
done
