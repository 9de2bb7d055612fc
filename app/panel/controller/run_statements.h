// SPDX-License-Identifier: Apache-2.0
// `Controller.run` in QML: what Run says of the machine, by the table of RunSentences. An empty text:
// nothing.
#pragma once

#include "app/panel/words/run_sentences.h"
#include "app/program/change_film.h"

#include <QObject>
#include <QtQml/qqmlregistration.h>

namespace campanel::panel {

class Controller;

class RunStatements : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The statements belong to the Controller")
    Q_PROPERTY(QString program READ program NOTIFY changed FINAL) // why there is none
    Q_PROPERTY(QString bags READ bags NOTIFY changed FINAL)       // why none of the last bags counts
    Q_PROPERTY(QString marks READ marks NOTIFY changed FINAL)     // the state of the mark tracking
    Q_PROPERTY(QString film READ film NOTIFY changed FINAL)       // why film or knife do not simply run
    Q_PROPERTY(QString stroke READ stroke NOTIFY changed FINAL)   // why there is no stroke of a press
    Q_PROPERTY(QString trends READ trends NOTIFY changed FINAL)   // why there are no data of any time
    // The next bags that will not count, as far as that is known: those of a change, and the one that is in
    // the making while the cuts are not on the marks.
    Q_PROPERTY(int scrapAhead READ scrapAhead NOTIFY changed FINAL)
    // The next cuts as FilmPicture draws them, those of an announced change included from the moment at which
    // the controller has the program; and the length of its bags, empty: there is none, or it stays.
    Q_PROPERTY(QList<QPointF> cuts READ cuts NOTIFY cutsChanged FINAL)
    Q_PROPERTY(QString nextLength READ nextLength NOTIFY cutsChanged FINAL)

public:
    // The controller must outlive the object.
    explicit RunStatements(Controller& controller);

    [[nodiscard]] QString program() const { return text(RunPlace::Program); }
    [[nodiscard]] QString bags() const { return text(RunPlace::Bags); }
    [[nodiscard]] QString marks() const { return text(RunPlace::Marks); }
    [[nodiscard]] QString film() const;
    [[nodiscard]] int scrapAhead() const { return m_scrapAhead; }
    [[nodiscard]] QList<QPointF> cuts() const;
    [[nodiscard]] QString nextLength() const;
    [[nodiscard]] QString stroke() const { return text(RunPlace::Stroke); }
    [[nodiscard]] QString trends() const { return text(RunPlace::Trends); }
    // Returns what a download that has just ended means.
    [[nodiscard]] QString downloaded() const { return text(RunPlace::Downloaded); }
    [[nodiscard]] std::optional<RunRow> row(RunPlace place) const
    {
        return RunSentences::row(place, m_facts);
    }
    // Shows this price from the download that begins now to the first bag that counts.
    void announceChange(const program::ChangePrice& price, const program::ChangeFilm& film);
    // Collects the facts again; emits changed() when one of them is another.
    void update();
    // The same after a change of what Start may do; its refusal is a sentence, too much for each status.
    void updateStart();

signals:
    void changed();
    void cutsChanged();

private:
    [[nodiscard]] QString text(RunPlace place) const;
    [[nodiscard]] RunFacts facts() const;
    [[nodiscard]] int scrapOf(const RunFacts& facts) const;
    // Returns true while the controller waits for the boundary of the announced change.
    [[nodiscard]] bool isArmed() const;
    // Returns true while the announced change is under way.
    [[nodiscard]] bool isAnnounced(const RunFacts& facts) const;

    Controller& m_controller;
    RunFacts m_facts;
    int m_scrapAhead = 0;
    bool m_canStart = false;
    struct Change {
        program::ChangePrice price;
        program::ChangeFilm film;
        std::uint32_t generation = 0; // before it
    };
    std::optional<Change> m_change;
};

} // namespace campanel::panel
