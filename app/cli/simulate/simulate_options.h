// SPDX-License-Identifier: Apache-2.0
// Options of campanelctl simulate: disturbances of the simulated machine and parameters of its controller.
#pragma once

#include "app/cli/failure.h"
#include "app/program/dead_time_estimate.h"
#include "app/program/eye_dead_time.h"
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

// A technician who enters each dead time of the mark sensor that is offered.
class DeadTimeTaker {
public:
    // Returns what to write, by the group `sensor`.
    std::vector<controller::ParameterValue> take(std::span<const std::uint16_t> registers);
    [[nodiscard]] std::optional<program::DeadTime> found() const { return m_estimate.estimate(); }
    // Those of the product eye are only measured.
    void see(std::span<const std::uint16_t> registers);
    [[nodiscard]] const program::EyeDeadTime& eye() const { return m_eye; }

private:
    program::DeadTimeEstimate m_estimate;
    program::EyeDeadTime m_eye;
    std::uint32_t m_last = 0;
    double m_takenMs = 0.0;
};

// Returns the program of this recipe at another length and rate, its other values following the ratios.
[[nodiscard]] tl::expected<program::ProgramImage, Failure> imageAt(program::Recipe recipe, double lengthMm,
                                                                   double rate);

// The program of a run, and the one at half its rate where the run changes between them; otherwise empty.
struct Programs {
    program::ProgramImage given;
    program::ProgramImage half;
};
[[nodiscard]] tl::expected<Programs, Failure> programsOf(program::ProgramImage image,
                                                         const controller::PackingJob& job);

// Returns the job with these programs, which must outlive the job.
[[nodiscard]] controller::PackingJob withPrograms(controller::PackingJob job, const Programs& programs);

} // namespace campanel::cli
