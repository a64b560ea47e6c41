// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TESTS_CANOPEN_START_UP_BUS_SLAVE_HPP
#define TESTS_CANOPEN_START_UP_BUS_SLAVE_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace counterpoint::cia302
{

/// What a slave does when a certain object is asked for.
enum class Manner : std::uint8_t
{
    kGood = 0U,
    kAbort = 1U,      ///< 0602 0000h.
    kSilent = 2U,     ///< No answer.
    kShort = 3U,      ///< Reads: one byte too few.
    kLong = 4U,       ///< Reads: a segmented answer that is longer than anybody wants.
    kAbortWrite = 5U, ///< Writes are aborted, reads are good.
    kSegments = 6U,   ///< Reads are answered in a segment, as those of long values.
    kNoSegment = 7U,  ///< Reads: a segmented answer, with something else in place of the segment.
};

/// A TxPDO as the slave really sends it.
struct SentPdo
{
    std::uint32_t identifier;
    std::uint8_t length_bytes;
    std::uint8_t syncs;      ///< Every n-th SYNC; 0: by time.
    std::uint32_t delay_us;  ///< After SYNC.
    std::uint32_t period_us; ///< By time.
    int skip;                ///< So many are left out.
    std::uint8_t count;      ///< SYNCs since the last one.
    std::uint32_t next_us;
};

/// A slave made of bare frames, so that every single one of them can be wrong. Writes are logged as "w 1017:00 64 00",
/// reads as "r 1000:00", NMT commands as "nmt 82".
class BusSlave
{
  public:
    BusSlave(std::uint8_t node, cia301::FrameSink& bus);

    void Power(std::uint32_t now_us);
    void OnFrame(const CanFrame& frame, std::uint32_t now_us);
    void OnCycle(std::uint32_t now_us);
    void Set(std::uint16_t index, std::uint8_t sub, std::uint32_t value, std::uint8_t size = 4U);
    void Behave(std::uint16_t index, std::uint8_t sub, Manner manner);
    /// The slave changes its state by itself.
    void Turn(std::uint8_t state);
    void Beat();

    std::uint8_t node;
    bool is_on{false};
    bool has_boot_up{true};
    bool is_toggle_stuck{false};
    bool answers_guard{true};
    bool is_deaf_to_start{false}; ///< Ignores NMT start.
    bool answers_segments{true};  ///< False: the read of a value in segments stands still behind its first answer.
    bool keeps_requests{false};   ///< SDO requests that come while it boots wait in its controller.
    std::uint32_t kept_us{0U};    ///< From the boot-up message until it has time for what waits there.
    std::uint8_t state{0U};       ///< As in the heartbeat.
    std::uint32_t boot_us{2000U}; ///< From reset to boot-up message.
    std::uint32_t heartbeat_us{0U};
    std::vector<std::string> log{};
    std::vector<SentPdo> pdos{};
    int resets{0};

  private:
    struct Value
    {
        std::uint32_t value;
        std::uint8_t size;
    };
    struct Pending
    {
        std::uint32_t due_us;
        CanFrame frame;
    };

    void Restart(std::uint32_t now_us);
    void Obey(const CanFrame& frame, std::uint32_t now_us);
    void OnSync(std::uint32_t now_us);
    void OnSdo(const CanFrame& frame);
    void OnSegment();
    void Answer(std::uint8_t command, const CanFrame& frame, std::uint32_t value);
    void Put(std::uint32_t identifier, std::uint8_t length);

    cia301::FrameSink& bus_;
    std::map<std::uint32_t, Value> values_{};
    std::map<std::uint32_t, Manner> manners_{};
    std::vector<Pending> pending_{};
    std::vector<CanFrame> kept_{};
    std::uint32_t segment_{0U}; ///< Object that is read in a segment; 0: none.
    std::uint32_t boots_at_us_{0U};
    std::uint32_t beats_at_us_{0U};
    std::uint8_t toggle_{0U};
    bool has_no_segment_{false}; ///< What is being read; see kNoSegment.
};

} // namespace counterpoint::cia302

#endif
