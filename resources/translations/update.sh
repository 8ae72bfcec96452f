#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# resources/translations/update.sh [FOLDER]   brings the catalogues up to date with the sources: new texts come in
# untranslated, those that are gone go. With a FOLDER its catalogues are brought up to date instead.
set -eu -o pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
folder=$(cd "${1:-$root/resources/translations}" && pwd)
cd "$root"
for catalogue in "$folder"/palpate_*.ts; do
    "${LUPDATE:-/usr/lib/qt6/bin/lupdate}" -silent -no-obsolete -locations none -extensions cpp,h app/src modules -ts "$catalogue"
done
