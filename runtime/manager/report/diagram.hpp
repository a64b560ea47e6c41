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
/// One row of the diagram: something that went between manager and a node, or a mark at a lane.
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

/// Collects what the boot-up sequence diagram shows. [SRS_MGR_008]
class ManagerDiagram
{
  public:
    /// @brief A frame that the manager sent or received.
    void OnFrame(const CanFrame& frame, bool is_sent, std::uint64_t at_us);
    /// @brief Something that the manager told: commands, results and losses are marks.
    void OnEvent(const ManagerEvent& event);
    [[nodiscard]] const std::vector<DiagramRow>& Rows() const noexcept
    {
        return rows_;
    }
    /// @brief Rows that found no room any more.
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

/// @brief A part of a page: results, then the diagram; its style once in the page.
[[nodiscard]] std::string DiagramSection(const ManagerAssembly& assembly, const ManagerDiagram& diagram, Instant now);
[[nodiscard]] std::string DiagramStyle();
/// @brief One page without references to elsewhere: results, then the diagram.
[[nodiscard]] std::string DiagramPage(const ManagerAssembly& assembly, const ManagerDiagram& diagram, Instant now);
} // namespace counterpoint::runtime

#endif // RUNTIME_MANAGER_REPORT_DIAGRAM_HPP
