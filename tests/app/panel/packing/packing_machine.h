// SPDX-License-Identifier: Apache-2.0
// The panel on a simulated packing machine, with its packing page open.
#pragma once

#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/packing/packing_setup.h"
#include "app/panel/settings/settings.h"
#include "tests/support/core_link.h"

#include <QTemporaryDir>

namespace campanel::test {

struct PackingMachine {
    QTemporaryDir folder;
    CoreLink link;
    panel::Settings settings{folder.filePath(QStringLiteral("settings.ini")), nullptr};
    panel::Controller machine{link, settings, nullptr};
    panel::Editor editor{machine, folder.path(), nullptr};
    panel::PackingSetup setup{machine, nullptr};

    // Downloads bags of this length, mm, and rate, bags/min, for a shaft with so many knives.
    PackingMachine(const controller::MachineOptions& options, double lengthMm, double rate, int knives = 1)
        : link(std::make_unique<Rig>(options))
    {
        machine.setClock([this] { return link.now(); });
        link.setFilmTimer(machine.packing()->findChild<QTimer*>());
        link.setConnected(true);
        pass(1);
        editor.field(QStringLiteral("knives"))->set(knives);
        editor.bagLength()->set(lengthMm);
        editor.rate()->set(rate);
        editor.download();
        pass(3);
        setup.open();
        pass(1);
    }

    panel::PackingFields& fields() { return *setup.fields(); }
    void pass(double seconds)
    {
        for (std::uint64_t us = 0; us < static_cast<std::uint64_t>(seconds * 1e6); us += CoreLink::stepUs) {
            link.step();
            QCoreApplication::processEvents();
        }
    }
    // Returns -1 without such a field.
    int row(const QString& label)
    {
        for (int row = 0; row < fields().rowCount(); ++row) {
            if (at(row, panel::PackingFields::NameRole) == label)
                return row;
        }
        return -1;
    }
    QString at(int row, int role) { return fields().data(fields().index(row), role).toString(); }
    std::uint16_t parameter(std::uint32_t address)
    {
        return ctl_parameter16(&link.rig().core().board, address);
    }
};

} // namespace campanel::test
