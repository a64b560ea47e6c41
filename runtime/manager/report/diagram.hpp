// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_MANAGER_REPORT_DIAGRAM_HPP
#define RUNTIME_MANAGER_REPORT_DIAGRAM_HPP

#include "runtime/manager/assembly.hpp"
#include "runtime/manager/report/journal.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// One row of the diagram: a message between the manager and a node, or a mark at the lane of a node.
struct DiagramRow
{
    std::uint64_t at_us{0U};
    std::uint64_t until_us{0U}; ///< Of an SDO transfer: when its answer came.
    std::uint8_t node{0U};      ///< 0: all.
    bool is_from_manager{false};
    bool is_mark{false}; ///< No arrow: a result at the lane of the node.
    bool is_bad{false};
    std::string label;
    bool is_request{false}; ///< An SDO; without `until_us` nobody answered.
};

/// Collects the rows of the boot-up sequence diagram. [SRS_MGR_008]
class ManagerDiagram
{
  public:
    /// @brief A frame that the manager sent or received.
    void OnFrame(const CanFrame& frame, bool is_sent, std::uint64_t at_us);
    /// @brief An event of the manager: commands, results and losses become marks.
    void OnEvent(const ManagerEvent& event);
    /// @brief The rows, in the order of their times.
    [[nodiscard]] const std::vector<DiagramRow>& Rows() const noexcept
    {
        return rows_;
    }
    /// @brief Number of rows for which there was no room.
    [[nodiscard]] std::size_t LeftOut() const noexcept
    {
        return left_out_;
    }

  private:
    /// A request that waits for its answer.
    struct Pending
    {
        bool is_open{false};
        std::size_t row{0U};
    };

    void Add(const DiagramRow& row);
    void OnRequest(const CanFrame& frame, std::uint8_t node, std::uint64_t at_us);
    void GiveUp(std::uint8_t node);
    void OnAnswer(const CanFrame& frame, std::uint8_t node, std::uint64_t at_us);

    std::vector<DiagramRow> rows_;
    std::array<Pending, cia302::kNodeRoom> pending_{};
    std::size_t left_out_{0U};
};

class ManagerStation;

/// @brief Results and diagram as a part of a page; the page has DiagramStyle once. [SRS_MGR_139, SRS_MGR_142]
[[nodiscard]] std::string DiagramSection(const ManagerStation& station);
/// @brief The style sheet of such parts.
[[nodiscard]] std::string DiagramStyle();
/// @brief Results and diagram as a page of its own, which needs no other file.
[[nodiscard]] std::string DiagramPage(const ManagerStation& station);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_REPORT_DIAGRAM_HPP
