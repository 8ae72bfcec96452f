// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "palpate/study/ExerciseScore.h"
#include "palpate/study/Report.h"

#include <palpate/core/Export.h>
#include <palpate/session/RecordingReader.h>

#include <string>

namespace palpate::study {

/// Facts of the result page of an exercise beside the score.
struct ExerciseFacts
{
    std::string recording;   ///< file name
    std::string startedUtc;  ///< of the recording
    std::string caseText;    ///< free text
    std::string examinee;    ///< free text
    bool isPictured = false; ///< `Report::views` gets one entry: a picture of the view with the targets
};

/// Composes the result page of an exercise: found and missed targets with times, false alarms, coverage and force. The
/// numbers are those of the score, and no grade is given.
[[nodiscard]] PALPATE_EXPORT Report composeExercise(const ExerciseScore& score, const ExerciseFacts& facts);

} // namespace palpate::study
