// SPDX-License-Identifier: Apache-2.0
// The persistent data of the Editor: the stored recipe, the working copy, their versions, and the download.
#include "app/panel/editor/editor.h"

#include "app/panel/controller/controller.h"
#include "app/panel/recipe/recipe_edit.h"

#include <QFileInfo>

#include <algorithm>
#include <utility>

namespace campanel::panel {

Editor::~Editor()
{
    if (m_keepTimer.isActive())
        keepWorkingCopy();
    m_writer.waitForDone();
}

bool Editor::edited() const
{
    return m_stored.version == 0 || !sameRecipe(m_recipe, m_stored);
}

int Editor::recipeVersion() const
{
    return m_recipe.name == m_stored.name ? m_stored.version : m_newestVersion(m_recipe.name);
}

int Editor::nextVersion() const
{
    const int opened = m_recipe.name == m_stored.name ? m_stored.version : 0;
    return std::min(std::max(opened, m_newestVersion(m_recipe.name)) + 1, program::maxVersion);
}

void Editor::setNewestVersion(NewestVersion newest)
{
    m_newestVersion = std::move(newest);
    recompute();
}

program::Recipe Editor::newRecipe(profile::ProgramKind kind) const
{
    program::Recipe recipe = program::defaultRecipe(kind);
    if (const auto machine = m_machines.find(kind); machine != m_machines.end())
        recipe.machine = machine->second;
    if (const auto master = m_controller.masterSetting()->machine(); master && program::hasMaster(recipe))
        recipe.master =
            master->followsEncoder ? program::RecipeMaster::Encoder : program::RecipeMaster::Clock;
    return program::gentleRecipe(recipe);
}

void Editor::open(const program::Recipe& stored, const std::optional<program::Recipe>& edited)
{
    m_beforeDrag.reset();
    m_history.clear();
    m_trial.reset();
    m_comparedLaw.reset();
    m_recipe = edited.value_or(stored);
    takeStored(stored);
}

void Editor::takeStored(const program::Recipe& recipe, std::function<void()> done)
{
    m_stored = recipe;
    m_sources = {};
    if (m_stored.version > 0) {
        m_isNameProposed = false;
        write(m_storedFile, m_stored, std::move(done));
    }
    m_keepTimer.start();
    recompute();
}

void Editor::loadWorkingCopy()
{
    if (!QFileInfo::exists(m_workingFile.path())) {
        m_sources.working = m_sources.stored;
        return;
    }
    const auto working = m_workingFile.load();
    m_sources.working = working.source;
    if (working.source == store::LastRecipe::Source::Default) {
        if (m_notice.isEmpty())
            m_notice = tr("The unsaved edits were lost: their file is damaged. The saved recipe is open.");
        return;
    }
    m_recipe = working.recipe;
    if (m_notice.isEmpty())
        m_notice = working.notice;
    // An earlier state of the edits; its machine data may be out of date.
    if (working.source == store::LastRecipe::Source::Copy && m_recipe.kind() == m_stored.kind())
        m_recipe.machine = m_stored.machine;
}

void Editor::keepWorkingCopy()
{
    m_keepTimer.stop();
    write(m_workingFile, m_recipe, [] {});
}

// Writes in another thread: the medium may take seconds.
void Editor::write(const store::LastRecipe& file, const program::Recipe& recipe, std::function<void()> done)
{
    m_writer.start([this, file, recipe, done = std::move(done)] {
        QMetaObject::invokeMethod(this, [this, done, kept = file.save(recipe)] {
            if (!kept)
                showNotice(store::FileErrorText::describe(kept.error()));
            done();
        });
    });
}

void Editor::download()
{
    commitDrag();
    if (require(Level::Operator) && m_download.canDownload() && m_solution.image)
        m_download.download(*m_solution.image, m_recipe);
}

void Editor::cancelDownload()
{
    if (require(Level::Operator))
        m_download.cancel();
}

void Editor::saveToFlash()
{
    if (require(Level::Operator))
        m_download.save();
}

// Sends the controller's figures the machine data of the kind that is active.
void Editor::shareMachine()
{
    const auto& program = m_controller.program();
    const auto kind = program ? program->recipe.kind() : m_recipe.kind();
    const auto known = m_machines.find(kind);
    if (kind == m_recipe.kind())
        m_controller.torque()->setMachineData(m_recipe.machine);
    else
        m_controller.torque()->setMachineData(known == m_machines.end() ? std::nullopt
                                                                        : std::optional(known->second));
}

} // namespace campanel::panel
