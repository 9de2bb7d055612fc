// SPDX-License-Identifier: Apache-2.0
// The last edges of the mark sensor as places on the film and in words: the reason why a mark was not taken.
#pragma once

#include "app/panel/kit/numbers.h"
#include "app/panel/kit/row_model.h"
#include "app/program/dead_time_estimate.h"

#include <QList>
#include <QObject>
#include <QPointF>
#include <QStringList>
#include <QtQml/qqmlregistration.h>

#include <deque>
#include <optional>
#include <vector>

namespace campanel::panel {

class Controller;
class MarkSensor;

// A verdict with the number of edges that have it.
struct MarkVerdictRow {
    Q_GADGET
    Q_PROPERTY(QString name MEMBER name)
    Q_PROPERTY(int look MEMBER look)
    Q_PROPERTY(int edges MEMBER edges)

public:
    QString name;
    int look = 0; // MarkEdgeList::Look
    int edges = 0;

    bool operator==(const MarkVerdictRow&) const = default;
};

class MarkEdgeList : public QObject {
    Q_OBJECT
    QML_ELEMENT
    QML_UNCREATABLE("The edges belong to the packing setup")
    // The edges in mm of film, oldest first: 0 is the newest one, earlier ones are negative.
    Q_PROPERTY(QList<double> places READ places NOTIFY changed FINAL)
    // The look of each edge.
    Q_PROPERTY(QList<int> looks READ looks NOTIFY changed FINAL)
    // The distance from the expected mark as text; empty for an edge that was taken.
    Q_PROPERTY(QStringList notes READ notes NOTIFY changed FINAL)
    // The expected marks: (place, half of the window).
    Q_PROPERTY(QList<QPointF> windows READ windows NOTIFY changed FINAL)
    Q_PROPERTY(campanel::panel::RowModelBase* verdicts READ verdicts CONSTANT FINAL)
    Q_PROPERTY(QString newestText READ newestText NOTIFY changed FINAL)
    // The last edge that was not taken, unless that is the newest one; empty when there is none.
    Q_PROPERTY(QString rejectedText READ rejectedText NOTIFY changed FINAL)
    // Its place, and the number of edges since then.
    Q_PROPERTY(double rejectedPlace READ rejectedPlace NOTIFY changed FINAL)
    Q_PROPERTY(int sinceRejected READ sinceRejected NOTIFY changed FINAL)
    Q_PROPERTY(bool newestRejected READ newestRejected NOTIFY changed FINAL)
    // The sentence while there are no edges, with what to do; else empty.
    Q_PROPERTY(QString emptyText READ emptyText NOTIFY changed FINAL)
    // The picture in words.
    Q_PROPERTY(QString summary READ summary NOTIFY changed FINAL)
    // True while the list stays as it is. Edges that come meanwhile are in it afterwards.
    Q_PROPERTY(bool paused READ paused WRITE setPaused NOTIFY changed FINAL)

public:
    static constexpr std::size_t maxEdges = 60;

    // The looks of an edge, as plot::EdgePicture draws them.
    enum Look { Solid, Dashed, Dotted, Rejected };
    Q_ENUM(Look)

    // Both must outlive the object.
    MarkEdgeList(Controller& controller, MarkSensor& sensor, QObject* parent);

    [[nodiscard]] QList<double> places() const;
    [[nodiscard]] QList<int> looks() const;
    [[nodiscard]] QStringList notes() const;
    [[nodiscard]] QList<QPointF> windows() const;
    [[nodiscard]] RowModelBase* verdicts() { return &m_verdicts; }
    [[nodiscard]] QString newestText() const;
    [[nodiscard]] QString rejectedText() const;
    [[nodiscard]] double rejectedPlace() const;
    [[nodiscard]] int sinceRejected() const;
    [[nodiscard]] bool newestRejected() const;
    [[nodiscard]] QString emptyText() const;
    [[nodiscard]] QString summary() const;
    [[nodiscard]] bool paused() const { return m_isPaused; }
    void setPaused(bool paused);

    // Returns the newest edge's distance from the expected mark in mm; NaN while it has none.
    [[nodiscard]] double newestOffMm() const;

signals:
    void changed();

private:
    struct Edge {
        modbus::MarkEdge record;
        // As they were when the edge was read.
        double windowMm = unknown;
        double pitchMm = unknown;

        // Returns the distance from the expected mark; empty without one.
        [[nodiscard]] std::optional<double> offMm() const;
        [[nodiscard]] double placeMm(const Edge& newest) const;
    };
    using Edges = std::deque<Edge>;

    void add(const std::vector<modbus::MarkEdge>& edges);
    void clear();
    // Displays the edges unless the list is paused.
    void update();
    void noteWindow();
    [[nodiscard]] static QString sentence(const Edge& edge);
    [[nodiscard]] static QString verdictSentence(const Edge& edge);
    [[nodiscard]] Edges::const_reverse_iterator rejected() const;

    Controller& m_controller;
    MarkSensor& m_sensor;
    Edges m_edges; // the newest is the last one
    Edges m_shown;
    RowModel<MarkVerdictRow, &MarkVerdictRow::name> m_verdicts;
    bool m_isPaused = false;
};

} // namespace campanel::panel
