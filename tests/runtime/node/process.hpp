// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_RUNTIME_NODE_PROCESS_HPP
#define TESTS_RUNTIME_NODE_PROCESS_HPP

#include "tests/runtime/stepped_time/stepped_process.hpp"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace counterpoint::tools::test
{
/// @brief A bus that no other test uses, and one beside it.
[[nodiscard]] std::string OwnBus();
[[nodiscard]] std::string OtherBus();

/// One line that a node told, and when it was read.
struct NodeLine
{
    nlohmann::json event;
    std::uint64_t read_ns{0U};
};

/// `counterpoint node --json` as a process of its own in the time of the test, with typed orders.
class NodeProcess : public SteppedProcess
{
  public:
    using Wanted = std::function<bool(const nlohmann::json&)>;

    /// `arguments` behind --can and --json.
    explicit NodeProcess(const std::vector<std::string>& arguments, const std::string& bus = OwnBus());

    /// @brief The next line that is wanted, within a minute of the test's time; without one its event is null.
    NodeLine WaitFor(const Wanted& wanted);
    NodeLine WaitFor(const std::string& event);
    /// @brief Whether a wanted line comes within `ms`.
    bool Tells(const Wanted& wanted, int ms);
    /// @brief Exit status; 128 + signal; all further lines are in Lines.
    int End();
    [[nodiscard]] const std::vector<NodeLine>& Lines() const
    {
        return lines_;
    }

  private:
    bool ReadSome(std::uint64_t until_ns);
    NodeLine Next(const Wanted& wanted, int ms);

    std::string text_; ///< Begin of a line.
    std::vector<NodeLine> lines_;
    std::size_t seen_{0U};
};

/// @brief A node of this file of examples/ (or a path from there) with a slow cycle; its state is PRE-OPERATIONAL.
[[nodiscard]] std::unique_ptr<NodeProcess> StartNode(const std::string& dcf, const std::vector<std::string>& more,
                                                     const std::string& bus = OwnBus());
/// @brief The limit of its first consumer, as it told at its start.
[[nodiscard]] double LimitMsOf(const NodeProcess& consumer);
constexpr int kCycleUs = 10000;
/// @brief {"event": name, key: value}
[[nodiscard]] NodeProcess::Wanted Event(const std::string& name, const std::string& key, const nlohmann::json& value);
} // namespace counterpoint::tools::test

#endif // TESTS_RUNTIME_NODE_PROCESS_HPP
