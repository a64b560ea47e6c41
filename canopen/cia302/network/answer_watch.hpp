// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA302_NETWORK_ANSWER_WATCH_HPP
#define CANOPEN_CIA302_NETWORK_ANSWER_WATCH_HPP

#include "canopen/cia302/network/setup.hpp"
#include "safety_core/contract/can_frame.hpp"

#include <cstdint>

namespace counterpoint::cia302
{

/// What one node was asked, and how often it answered. Zero-filled at first.
struct AskedNode
{
    ObjectAddress object;       ///< Of the last request that begins an SDO transfer; 0000h: none that counts.
    std::uint8_t open;          ///< Requests for this object without an answer.
    std::uint8_t twice;         ///< SDO requests and resets in a row that were answered twice.
    std::uint8_t guarded_twice; ///< Remote frames in a row that were.
    bool is_answered;           ///< The SDO request was,
    bool is_ended;              ///< by an answer that is the last one of its transfer,
    bool is_doubled;            ///< and by another one.
    bool is_short;              ///< The request carries its whole value.
    std::uint8_t resets;        ///< That no boot-up message has followed yet.
    bool has_booted;            ///< After the last reset.
    bool is_known;              ///< Has ever shown a boot-up message.
    bool is_remote_open;        ///< A remote frame without an answer.
    bool is_remote_doubled;     ///< The last one was answered twice.
    bool has_toggled;           ///< Answers remote frames: a heartbeat never has the toggle bit.
};

/// Finds two devices behind one node-ID by their answers: a question that both answer is answered twice. Answers that
/// are equal bit for bit and begin together are one frame on the wire; then nobody can tell them from the answer of one
/// device. Pure functions over one record. [SRS_MGR_015, SRS_MGR_223]
class AnswerWatch
{
  public:
    /// Questions in a row that are answered twice before anything is said.
    static constexpr std::uint8_t kInARow = 3U;

    /// @brief A frame to the node that was on the bus: SDO request, or remote frame of guarding. O(1)
    static void OnQuestion(AskedNode& node, const CanFrame& frame) noexcept;
    /// @brief A reset of the node was on the bus, whoever sent it. O(1)
    static void OnReset(AskedNode& node) noexcept;
    /// @brief A frame of the node: SDO answer, or error control message. True: it is the answer that shows a second
    /// device. O(1)
    [[nodiscard]] static bool OnAnswer(AskedNode& node, const CanFrame& frame) noexcept;

  private:
    static void OnRequest(AskedNode& node, const CanFrame& frame) noexcept;
    static void OnSdo(AskedNode& node, const CanFrame& frame) noexcept;
    static void OnSecond(AskedNode& node, bool is_abort) noexcept;
    static void OnBootUp(AskedNode& node) noexcept;
    static void OnSign(AskedNode& node, bool is_toggle_set) noexcept;
};

} // namespace counterpoint::cia302

#endif
