// SPDX-License-Identifier: Apache-2.0
// Settings, Machine, Editor, Records, Alarms and Service on a fake link, a fake clock and a temporary folder.
#pragma once

#include "app/panel/alarms/alarms.h"
#include "app/panel/controller/controller.h"
#include "app/panel/editor/editor.h"
#include "app/panel/maintenance/maintenance.h"
#include "app/panel/records/database_service.h"
#include "app/panel/settings/settings.h"
#include "app/panel/trends/trends.h"
#include "fake_link.h"
#include "tests/support/stored_recipe.h"

#include <QTemporaryDir>

namespace campanel::test {

struct PanelRig {
    QTemporaryDir folder;
    FakeLink link;
    panel::Settings settings{folder.filePath(QStringLiteral("settings.ini")), nullptr};
    link::SteadyTime now{std::chrono::hours(1)};
    panel::Controller machine{link, settings, nullptr};
    panel::Editor editor{machine, withStoredRecipe(folder.path()), nullptr};
    panel::DatabaseService records{folder.path(), nullptr};
    panel::Alarms alarms{machine, editor, records, settings, nullptr};
    panel::Maintenance maintenance{machine, settings, folder.path(), nullptr};
    panel::Trends trends{machine, settings, records, folder.path(), nullptr};

    PanelRig()
    {
        machine.setClock([this] { return now; });
        maintenance.dryRun()->follow(editor);
        maintenance.measurement()->follow(editor);
    }

    void connectIdle()
    {
        link.becomeConnected();
        link.sendStatus(now);
        emit link.programRead({link.status.generation, 0, {}});
    }

    // Connects to a controller that runs the edited recipe.
    void connectRunning()
    {
        connectIdle();
        link.activate(image(), now);
        link.status.state = modbus::State::Running;
        link.status.masterSpeedPercent = 100;
        link.sendStatus(now);
    }

    [[nodiscard]] program::ProgramImage image() const
    {
        const auto image = program::buildProgram(editor.recipe());
        if (!image)
            qFatal("%s", program::describe(image.error()).c_str());
        return *image;
    }
};

} // namespace campanel::test
