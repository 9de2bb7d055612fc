// SPDX-License-Identifier: Apache-2.0
// Options of campanelctl simulate: disturbances of the simulated machine and parameters of its controller.
#pragma once

#include "app/cli/failure.h"
#include "app/program/program_image.h"
#include "packing_run.h"

#include <QCommandLineOption>

namespace campanel::cli {

class Invocation;

[[nodiscard]] QList<QCommandLineOption> simulateOptions();

// A number given with an option, or `otherwise`; refused outside the limits.
[[nodiscard]] tl::expected<double, Failure> numberOf(const Invocation& call, const QString& option,
                                                     double otherwise, double least, double most);

// Everything but the bank.
[[nodiscard]] tl::expected<controller::PackingJob, Failure> jobOf(const Invocation& call);

// A parameter's registers; the value must fit. `name` is a parameter's.
[[nodiscard]] tl::expected<controller::ParameterValue, Failure> parameterOf(const QString& name,
                                                                            double value);

// The job with this program, which must outlive it.
[[nodiscard]] controller::PackingJob withProgram(controller::PackingJob job,
                                                 const program::ProgramImage& image);

} // namespace campanel::cli
