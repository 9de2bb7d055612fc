// SPDX-License-Identifier: Apache-2.0
// The texts of a table of any kind: its columns, rows and error figures.
#pragma once

#include "app/program/program_image.h"

#include <QCoreApplication>
#include <QStringList>

#include <vector>

namespace campanel::panel {

class TableText {
    Q_DECLARE_TR_FUNCTIONS(TableText)

public:
    // The image must outlive the object.
    explicit TableText(const program::ProgramImage& image)
        : m_image(image)
    {
    }

    [[nodiscard]] QString name() const;
    [[nodiscard]] QStringList columns() const;
    // Returns the start of each row on the time axis. All are 0 for a press, because its stages have no fixed
    // ends.
    [[nodiscard]] std::vector<double> startsS() const;
    [[nodiscard]] QStringList cells(std::size_t row, double startS) const;
    // Returns the errors of the table, one line each.
    [[nodiscard]] QStringList summary() const;

private:
    [[nodiscard]] QStringList summaryOf(const profile::StepTable& table) const;
    [[nodiscard]] QStringList summaryOf(const profile::CamTable& table) const;
    [[nodiscard]] QStringList summaryOf(const profile::IntervalTable& table) const;
    [[nodiscard]] QStringList summaryOf(const profile::PressTable& table) const;
    [[nodiscard]] QString stretchName(double timeS) const;

    const program::ProgramImage& m_image;
};

} // namespace campanel::panel
