// SPDX-License-Identifier: Apache-2.0
// Undo and redo as snapshots of whole values.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

namespace campanel::panel {

template <typename Value> class EditHistory {
public:
    // Records an edit; `before` is the value that it has replaced.
    void note(Value before)
    {
        m_redo.clear();
        m_undo.push_back(std::move(before));
        if (m_undo.size() > longest)
            m_undo.erase(m_undo.begin());
    }

    void clear()
    {
        m_undo.clear();
        m_redo.clear();
    }

    [[nodiscard]] bool canUndo() const { return !m_undo.empty(); }
    [[nodiscard]] bool canRedo() const { return !m_redo.empty(); }

    // Return the values that undo() and redo() restore.
    [[nodiscard]] const Value& previous() const { return m_undo.back(); }
    [[nodiscard]] const Value& next() const { return m_redo.back(); }

    // Returns the previous or next value; `present` is stored for the way back. Requires canUndo() or
    // canRedo().
    [[nodiscard]] Value undo(Value present) { return move(m_undo, m_redo, std::move(present)); }
    [[nodiscard]] Value redo(Value present) { return move(m_redo, m_undo, std::move(present)); }

private:
    static constexpr std::size_t longest = 200;

    static Value move(std::vector<Value>& from, std::vector<Value>& to, Value present)
    {
        to.push_back(std::move(present));
        Value value = std::move(from.back());
        from.pop_back();
        return value;
    }

    std::vector<Value> m_undo;
    std::vector<Value> m_redo;
};

} // namespace campanel::panel
