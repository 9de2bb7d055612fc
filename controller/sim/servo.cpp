// SPDX-License-Identifier: Apache-2.0
#include "servo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace campanel::controller {
namespace {

constexpr double restPulses = 1e-6; // smaller distances count as standstill
constexpr double restPulsesPerS = 1e-3;

} // namespace

Servo::Servo(double bandwidthHz)
    : m_angularBandwidth(2.0 * std::numbers::pi * bandwidthHz)
    , m_lagS(2.0 / m_angularBandwidth)
{
}

void Servo::setDriveOn(bool on)
{
    if (on && !m_driveOn)
        m_commanded = std::llround(m_position);
    m_driveOn = on;
}

void Servo::turnByHand(double pulses)
{
    m_position += pulses;
    m_commanded = std::llround(m_position);
    m_target = static_cast<double>(m_commanded);
    m_before = m_position;
    m_speed = 0.0;
}

void Servo::setLoad(double acceleration, double limit)
{
    m_load = acceleration;
    m_limit = limit;
}

double Servo::acceleration() const
{
    const double w = m_angularBandwidth;
    const double wanted = w * w * (m_target - m_position) - 2.0 * w * m_speed;
    return m_driveOn ? std::clamp(wanted, -m_limit, m_limit) : 0.0;
}

void Servo::advance(double stepS)
{
    m_before = m_position;
    const double target = m_driveOn ? static_cast<double>(m_commanded) : m_position;
    const double from = m_driveOn ? m_target : m_position;
    m_target = target;
    if (m_driveOn && std::abs(acceleration()) >= m_limit) {
        const double change = (acceleration() + m_load) * stepS;
        m_position += (m_speed + change / 2.0) * stepS;
        m_speed += change;
        return;
    }
    if (m_load == 0.0 && std::abs(target - m_position) < restPulses && std::abs(target - from) < restPulses &&
        std::abs(m_speed) < restPulsesPerS) {
        m_speed = 0.0;
        return;
    }
    if (stepS != m_stepS) {
        m_stepS = stepS;
        m_stepsPerS = 1.0 / stepS;
        m_decay = std::exp(-m_angularBandwidth * stepS);
    }
    // x'' = w^2 (u - x) - 2 w x' with u' = r: z = x - u + 2 r / w decays as (z0 + (z0' + w z0) t) exp(-w t).
    // The load is the same as a target that lies so far behind.
    const double w = m_angularBandwidth;
    const double aside = m_driveOn ? m_load / (w * w) : 0.0;
    const double rise = (target - from) * m_stepsPerS;
    const double lag = rise * m_lagS - aside;
    const double z = m_position - from + lag;
    const double zSpeed = m_speed - rise;
    const double slope = zSpeed + w * z;
    m_position = target - lag + (z + slope * stepS) * m_decay;
    m_speed = rise + (zSpeed - w * slope * stepS) * m_decay;
}

} // namespace campanel::controller
