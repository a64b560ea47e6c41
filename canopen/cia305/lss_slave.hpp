// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA305_LSS_SLAVE_HPP
#define CANOPEN_CIA305_LSS_SLAVE_HPP

#include "canopen/cia301/nmt/frame_sink.hpp"

namespace counterpoint::cia305
{

using cia301::FrameSink;
using cia301::Moment;
using cia301::NodeId;

constexpr std::uint8_t kNoNodeId = 0xFFU;

/// 1018h:01 to 04: the LSS address.
struct Identity
{
    std::uint32_t vendor;
    std::uint32_t product;
    std::uint32_t revision;
    std::uint32_t serial;
};

/// Index of the table of CiA 305: 0 1000, 1 800, 2 500, 3 250, 4 125, 6 50, 7 20, 8 10 kbit/s, 9 automatic.
struct BitTiming
{
    std::uint8_t index;
};

/// What LSS configures and stores.
struct LssSettings
{
    std::uint8_t node_id; ///< 1 to 127, or kNoNodeId.
    BitTiming timing;
};

/// How far a store is.
enum class LssStored : std::uint8_t
{
    kInvalid = 0U,
    kDone = 1U,
    kPending = 2U, ///< Ask again in the next cycle.
    kFailed = 3U,
    kUnsupported = 4U,
};

/// What an LSS slave asks of its device.
class LssDevice
{
  public:
    /// @brief Whether the controller can run at this bit rate.
    [[nodiscard]] virtual bool IsSupported(BitTiming timing) noexcept = 0;
    /// @brief Keeps the settings without power. It is called again in each cycle while it answers kPending.
    [[nodiscard]] virtual LssStored Store(const LssSettings& settings) noexcept = 0;
    /// @brief The controller changes its bit rate now; IsSilent holds before and after it.
    virtual void SwitchTo(BitTiming timing) noexcept = 0;

  protected:
    LssDevice() noexcept = default;
    ~LssDevice() noexcept = default;
    LssDevice(const LssDevice&) = default;
    LssDevice& operator=(const LssDevice&) = default;
};

/// What an LSS slave works with; sink and device are kept by reference.
struct LssParts
{
    FrameSink& sink;
    LssDevice& device;
    Identity identity;
    LssSettings settings; ///< As stored.
};

/// State of the LSS slave.
enum class LssState : std::uint8_t
{
    kInvalid = 0U,
    kWaiting = 1U,
    kConfiguration = 2U,
};

/// The LSS slave: 7E5h in, 7E4h out. The device takes its node-ID from here: in the sub-state RESET COMMUNICATION it
/// calls TakeNodeId; without one it stays there, sends no boot-up message and asks again when MayBoot. Not reentrant.
class LssSlave
{
  public:
    /// @brief Waiting; TakeNodeId gives the stored node-ID.
    explicit LssSlave(const LssParts& parts) noexcept;

    /// @brief A frame from the bus. [SRS_LSS_001, SRS_LSS_002, SRS_LSS_003, SRS_LSS_004, SRS_LSS_005, SRS_LSS_006,
    /// SRS_LSS_007, SRS_LSS_008, SRS_LSS_009, SRS_LSS_010]
    void OnFrame(const CanFrame& frame, const Moment& moment) noexcept;
    /// @brief Watches the delays of a change of bit rate and sends the answer to a store. Once a cycle. [SRS_LSS_005,
    /// SRS_LSS_006, SRS_LSS_013]
    void OnCycle(const Moment& moment) noexcept;

    /// @brief Reset communication: the configured node-ID becomes the active one, and is returned. [SRS_LSS_004]
    NodeId TakeNodeId() noexcept;
    /// @brief Whether a device that waited without a node-ID has got one. [SRS_LSS_009]
    [[nodiscard]] bool MayBoot() const noexcept;
    /// @brief Whether nothing may be sent, because the bit rate is being changed. [SRS_LSS_005]
    [[nodiscard]] bool IsSilent() const noexcept;
    /// @brief The present state.
    [[nodiscard]] LssState State() const noexcept;
    /// @brief Active node-ID, or kNoNodeId.
    [[nodiscard]] std::uint8_t ActiveNodeId() const noexcept;
    /// @brief What was configured, whether stored or not.
    [[nodiscard]] const LssSettings& Settings() const noexcept;

  private:
    enum class Switching : std::uint8_t
    {
        kNone = 0U,
        kBefore = 1U, ///< Silent, old rate.
        kAfter = 2U,  ///< Silent, new rate.
    };

    void Obey(const CanFrame& frame, const Moment& moment) noexcept;
    void Configure(const CanFrame& frame, const Moment& moment) noexcept;
    void Inquire(std::uint8_t command) noexcept;
    void SwitchGlobal(std::uint8_t mode) noexcept;
    void SwitchSelective(std::uint8_t part, std::uint32_t value) noexcept;
    void IdentifyRemote(std::uint8_t part, std::uint32_t value) noexcept;
    void FastScan(const CanFrame& frame) noexcept;
    void ConfigureNodeId(std::uint8_t node_id) noexcept;
    void ConfigureTiming(std::uint8_t table, std::uint8_t index) noexcept;
    void ActivateTiming(std::uint16_t delay_ms, const Moment& moment) noexcept;
    void FinishStore() noexcept;
    [[nodiscard]] std::uint32_t AddressPart(std::uint32_t part) const noexcept;
    void Answer(std::uint8_t command, std::uint32_t value) noexcept;
    void Flush() noexcept;

    LssParts parts_;
    LssSettings pending_;
    LssSettings storing_; ///< As they were when the last 17h came.
    LssState state_;
    Switching switching_;
    Instant switched_at_;
    std::uint32_t delay_us_;
    std::uint8_t active_node_id_;
    std::uint8_t selected_;   ///< Parts of the address that matched one after the other.
    std::uint8_t identified_; ///< The same for identify remote slave.
    std::uint8_t scanned_;    ///< Part of the address that a fastscan is at.
    bool is_storing_;
    bool is_sending_; ///< `waiting_` found no room in the sink.
    CanFrame waiting_;
};

} // namespace counterpoint::cia305

#endif
