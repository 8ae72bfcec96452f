// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <palpate/study/CompareRecordings.h>

namespace palpate::app {

/// Prints the tables of a comparison in columns.
void printCompared(const study::RecordingComparison& comparison);

} // namespace palpate::app
