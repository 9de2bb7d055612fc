// SPDX-License-Identifier: Apache-2.0
// An empty Qt Quick window on the whole screen. check_boot.py starts it in the panel's place: no panel can be
// there sooner.
#include <QGuiApplication>
#include <QQmlApplicationEngine>

int main(int count, char* arguments[])
{
    const QGuiApplication application(count, arguments);
    QQmlApplicationEngine engine;
    // With colors enough for a picture that is no text.
    engine.loadData("import QtQuick\n"
                    "Window {\n"
                    "    visibility: Window.FullScreen\n"
                    "    Rectangle {\n"
                    "        anchors.fill: parent\n"
                    "        gradient: Gradient {\n"
                    "            GradientStop { position: 0; color: \"white\" }\n"
                    "            GradientStop { position: 1; color: \"steelblue\" }\n"
                    "        }\n"
                    "    }\n"
                    "}\n");
    return engine.rootObjects().isEmpty() ? 1 : QGuiApplication::exec();
}
