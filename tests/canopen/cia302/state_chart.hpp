// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_CIA302_STATE_CHART_HPP
#define TESTS_CANOPEN_CIA302_STATE_CHART_HPP

#include <gtest/gtest.h>

#include <cstddef>
#include <fstream>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace counterpoint::cia302
{

template <typename Value> struct Named
{
    Value value;
    const char* name;
};

/// A table of transitions as the documents show it, and what holds of each of them.
template <typename State, typename Event, typename Next> class StateChart
{
  public:
    StateChart(const std::vector<Named<State>>& states, const std::vector<Named<Event>>& events, Next next)
        : states_(states), events_(events), next_(next)
    {
    }

    /// @brief One line a state: its name, what `tell` says of it, and each event that leads to another one.
    [[nodiscard]] std::vector<std::string> Lines(const std::function<std::string(State)>& tell) const
    {
        std::vector<std::string> lines;
        for (const Named<State>& state : states_)
        {
            std::string exits;
            for (const Named<Event>& event : events_)
            {
                const State next = next_(state.value, event.value);
                if (next != state.value)
                {
                    exits += (exits.empty() ? "" : ", ") + std::string{event.name} + ": `" + NameOf(next) + "`";
                }
            }
            lines.push_back("| `" + std::string{state.name} + "` | " + tell(state.value) + " | " + exits + " |");
        }
        return lines;
    }

    /// @brief From the first state on every other one is reached and left.
    void ExpectConnected() const
    {
        std::set<State> reached{states_.front().value};
        for (std::size_t i = 0U; i < states_.size(); ++i)
        {
            const std::set<State> before = reached;
            for (const State state : before)
            {
                for (const Named<Event>& event : events_)
                {
                    reached.insert(next_(state, event.value));
                }
            }
        }
        for (const Named<State>& state : states_)
        {
            bool is_left = false;
            for (const Named<Event>& event : events_)
            {
                is_left = is_left || (next_(state.value, event.value) != state.value);
            }
            EXPECT_EQ(reached.count(state.value), 1U) << state.name << " is never reached";
            EXPECT_TRUE(is_left) << state.name << " is never left";
        }
        EXPECT_EQ(reached.size(), states_.size()) << "the table leads to a state without a name";
    }

  private:
    [[nodiscard]] std::string NameOf(const State state) const
    {
        std::string name = "no state";
        for (const Named<State>& row : states_)
        {
            name = (row.value == state) ? row.name : name;
        }
        return name;
    }

    std::vector<Named<State>> states_;
    std::vector<Named<Event>> events_;
    Next next_;
};

/// @brief The rows of the table in a document, which begin with the name of a state.
inline std::vector<std::string> RowsOf(const std::string& path)
{
    std::vector<std::string> rows;
    std::ifstream document{path};
    for (std::string line; std::getline(document, line);)
    {
        if (line.rfind("| `k", 0U) == 0U)
        {
            rows.push_back(line);
        }
    }
    return rows;
}

/// @brief The document shows these rows and no others; the failure prints what it would have to show.
inline void ExpectShown(const std::vector<std::string>& rows, const std::string& path)
{
    std::string whole;
    for (const std::string& row : rows)
    {
        whole += row + "\n";
    }
    EXPECT_EQ(RowsOf(path), rows) << path << " has to show:\n" << whole;
}

} // namespace counterpoint::cia302

#endif
