// SPDX-License-Identifier: Apache-2.0
#include "app/machine/editor.h"

#include "app/machine/engine_instances.h"

namespace campanel::machine {

Editor::Editor(QObject* parent)
    : QObject(parent)
{
}

Editor* Editor::create(QQmlEngine* qmlEngine, QJSEngine*)
{
    return attachedInstance<Editor>(qmlEngine);
}

void Editor::setRecipeName(const QString& name)
{
    m_recipeName = name;
    emit recipeChanged();
}

void Editor::setLaw(const QString&) {}
void Editor::applySuggestion() {}
void Editor::dragRatio(int, double) {}
void Editor::commitDrag() {}
void Editor::undo() {}
void Editor::redo() {}
void Editor::revert() {}
void Editor::download() {}
void Editor::cancelDownload() {}
void Editor::saveToFlash() {}

} // namespace campanel::machine
