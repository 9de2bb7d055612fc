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

// Returns the number of an option, or `otherwise`; refuses values outside the limits.
[[nodiscard]] tl::expected<double, Failure> numberOf(const Invocation& call, const QString& option,
                                                     double otherwise, double minimum, double maximum);

// Returns the job without the bank.
[[nodiscard]] tl::expected<controller::PackingJob, Failure> jobOf(const Invocation& call);

// Returns the registers of a parameter; the value must fit. `name` must be a parameter.
[[nodiscard]] tl::expected<controller::ParameterValue, Failure> parameterOf(const QString& name,
                                                                            double value);

// Returns the job with this program; the image must outlive the job.
[[nodiscard]] controller::PackingJob withProgram(controller::PackingJob job,
                                                 const program::ProgramImage& image);

} // namespace campanel::cli
