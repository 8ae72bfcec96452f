#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# test_python.sh PYTHON SOURCES PACKAGE PALPATE   runs test_palpate.py with the package in the folder PACKAGE.
# PYTHON is empty where the package was not built. Exit code 77: skipped.
set -eu
python=$1 sources=$2 package=$3 palpate=$4
if [[ -z $python ]]; then
    echo "skipped: the Python package was not built, which needs python3-dev and pybind11-dev"
    exit 77
fi
if ! "$python" -c 'import numpy' 2>/dev/null; then
    echo "skipped: $python has no numpy (Debian: python3-numpy)"
    exit 77
fi
export PYTHONPATH=$package PALPATE_SOURCES=$sources PALPATE_PROGRAM=$palpate PYTHONDONTWRITEBYTECODE=1 MPLBACKEND=Agg
export OPENBLAS_NUM_THREADS=1 # its threads would only wait
cd "$sources/tests/python" # unittest takes a path below the current folder only
exec "$python" -m unittest -v test_palpate
