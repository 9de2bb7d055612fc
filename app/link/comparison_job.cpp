// SPDX-License-Identifier: Apache-2.0
#include "app/link/comparison_job.h"

#include "modbus/map/crc32.h"

#include <utility>

namespace campanel::link {

ComparisonJob::ComparisonJob(std::vector<std::uint16_t> expected)
    : m_expected(std::move(expected))
{
    if (m_expected.empty())
        m_header.emplace(modbus::activeBankBase, modbus::bankHeaderRegisters);
    else
        m_bank.emplace(modbus::activeBankBase, static_cast<std::uint16_t>(m_expected.size()));
}

void ComparisonJob::noteStatus(const modbus::StatusBlock& status)
{
    if (ended())
        return;
    const std::uint32_t crc = status.activeCrc.value_or(0);
    if (!m_isProgramKnown) {
        m_isProgramKnown = true;
        m_report.generation = status.generation;
        m_report.controllerCrc = crc;
        m_report.expectedCrc = m_expected.empty() ? crc : modbus::crc32OfRegisters(m_expected);
        if (!status.activeCrc)
            m_report.stage = ComparisonStage::NoProgram;
    } else if (status.generation != m_report.generation || crc != m_report.controllerCrc) {
        m_report.stage = ComparisonStage::ProgramChanged;
    } else if (m_bank && m_bank->complete()) {
        // This status has the same program as the one before the first piece: all pieces belong to it.
        compare();
    }
}

void ComparisonJob::advance(modbus::RtuClient& client)
{
    m_isPortLost = false;
    const auto step = m_bank ? m_bank->advance(client) : m_header->advance(client);
    if (!step) {
        noteFailure(step.error());
        return;
    }
    m_failuresInARow = 0;
    if (m_bank)
        m_report.fraction = m_bank->progress();
    else if (*step)
        beginRows();
}

bool ComparisonJob::hasWork() const
{
    const bool isRead = m_bank && m_bank->complete(); // the next status decides
    return m_isProgramKnown && !m_report.isInterrupted && !isRead && !ended();
}

void ComparisonJob::beginRows()
{
    const auto length = modbus::bankLength(m_header->registers());
    if (length)
        m_bank.emplace(modbus::activeBankBase, *length);
    else
        m_report.stage = ComparisonStage::Different; // the header is invalid
}

void ComparisonJob::noteFailure(const modbus::LinkError& error)
{
    m_isPortLost = modbus::portIsLost(error);
    if (m_isPortLost || ++m_failuresInARow < maxFailuresInARow)
        return;
    m_report.stage = ComparisonStage::Failed;
    m_report.error = error;
}

void ComparisonJob::compare()
{
    const std::vector<std::uint16_t>& read = m_bank->registers();
    m_report.readCrc = modbus::crc32OfRegisters(read);
    for (std::size_t i = 0; i < m_expected.size(); ++i) {
        if (read[i] == m_expected[i])
            continue;
        ++m_report.differingRegisters;
        if (!m_report.firstDifference)
            m_report.firstDifference = {static_cast<quint16>(i), m_expected[i], read[i]};
    }
    const bool isEqual = m_report.readCrc == m_report.expectedCrc &&
                         m_report.controllerCrc == m_report.expectedCrc && m_report.differingRegisters == 0;
    m_report.stage = isEqual ? ComparisonStage::Equal : ComparisonStage::Different;
}

void ComparisonJob::cancel()
{
    if (!ended())
        m_report.stage = ComparisonStage::Canceled;
}

void ComparisonJob::connectionLost()
{
    m_report.isInterrupted = true;
    m_isPortLost = false;
}

void ComparisonJob::connectionFound()
{
    m_report.isInterrupted = false;
    m_failuresInARow = 0;
}

} // namespace campanel::link
