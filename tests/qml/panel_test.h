// SPDX-License-Identifier: Apache-2.0
// The panel in a window on the demonstration link, operated by a Finger, new for each test.
#pragma once

#include "app/shell/fonts.h"
#include "tests/looks/stage.h"

#include <QTest>

#include <memory>

namespace campanel::test {

class PanelTest : public QObject {
    Q_OBJECT

protected:
    std::unique_ptr<looks::Stage> m_stage;

    auto& editor() { return m_stage->panel().editor(); }
    void tap(const char* name) { m_stage->tap(QString::fromLatin1(name)); }
    QString textOf(const char* name)
    {
        const QQuickItem* item = m_stage->find(QString::fromLatin1(name));
        return item ? item->property("text").toString() : QString();
    }
    void show(looks::DemoLink::Kind kind)
    {
        m_stage->link().show(looks::DemoLink::Situation::Running, kind);
        m_stage->settle();
    }
    QPoint centerOf(const QString& name)
    {
        const QQuickItem* item = m_stage->find(name);
        return item ? item->mapToScene(item->boundingRect().center()).toPoint() : QPoint();
    }

private slots:
    void initTestCase() { shell::applyFonts(); }
    void init()
    {
        m_stage = std::make_unique<looks::Stage>(
            looks::Look{QStringLiteral("en"), QStringLiteral("light"), QSize(1024, 600)});
        QVERIFY(m_stage->isReady());
    }
    void cleanup()
    {
        QCOMPARE(m_stage->complaints(), QStringList());
        m_stage.reset();
    }
};

} // namespace campanel::test
