// SPDX-License-Identifier: Apache-2.0
// The panel in a window on the demonstration link, operated by a TouchDriver, new for each test.
#pragma once

#include "app/shell/fonts.h"
#include "tests/looks/test_window.h"

#include <QTest>

#include <memory>

namespace campanel::test {

class PanelTest : public QObject {
    Q_OBJECT

protected:
    std::unique_ptr<looks::TestWindow> m_window;

    auto& editor() { return m_window->panel().editor(); }
    void tap(const char* name) { m_window->tap(QString::fromLatin1(name)); }
    // Holds a key for so long; a key that commands the machine acts after half a second.
    void holdFor(const char* name, int ms)
    {
        m_window->touch(QString::fromLatin1(name));
        QTest::qWait(ms);
        m_window->lift();
        m_window->settle();
    }
    // Without the marks that keep a number and its unit together.
    QString textOf(const char* name) { return plain(propertyOf(name, "text")); }
    QString propertyOf(const char* name, const char* property)
    {
        const QQuickItem* item = m_window->find(QString::fromLatin1(name));
        return item ? item->property(property).toString() : QString();
    }
    static QString plain(QString text) { return text.remove(QChar(0x2060)).replace(QChar(0xA0), u' '); }
    void show(looks::DemoLink::Kind kind)
    {
        m_window->link().show(looks::DemoLink::Situation::Running, kind);
        m_window->settle();
    }
    QPoint centerOf(const QString& name)
    {
        const QQuickItem* item = m_window->find(name);
        return item ? item->mapToScene(item->boundingRect().center()).toPoint() : QPoint();
    }

private slots:
    void initTestCase() { shell::applyFonts(); }
    void init()
    {
        m_window = std::make_unique<looks::TestWindow>(
            looks::Variant{QStringLiteral("en"), QStringLiteral("light"), QSize(1024, 600)});
        QVERIFY(m_window->isReady());
    }
    void cleanup()
    {
        const QStringList complaints = m_window->complaints();
        QVERIFY2(complaints.isEmpty(), qPrintable(complaints.join(u'\n')));
        m_window.reset();
    }
};

} // namespace campanel::test
