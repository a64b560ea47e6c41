// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_POLL_HPP
#define HAL_HOST_LIVE_POLL_HPP

#include <cstdint>

namespace counterpoint::host
{

/// Owns a file descriptor; -1: none.
class LiveFile
{
  public:
    /// @brief Takes the descriptor over.
    explicit LiveFile(int descriptor) : descriptor_{descriptor}
    {
    }
    ~LiveFile();
    LiveFile(const LiveFile&) = delete;
    LiveFile(LiveFile&& other) noexcept;
    LiveFile& operator=(const LiveFile&) = delete;
    LiveFile& operator=(LiveFile&& other) noexcept;
    /// @brief The descriptor.
    [[nodiscard]] int Get() const
    {
        return descriptor_;
    }

  private:
    int descriptor_;
};

/// One descriptor for poll that stands for several descriptors and a time: it is readable when one of them is, or when
/// the time has come. Throws std::runtime_error when the system has no descriptor left.
class LivePoll
{
  public:
    LivePoll();
    /// @brief From now on it stands for this descriptor, too.
    void Add(int descriptor);
    /// @brief Readable from `time_ns` of CLOCK_MONOTONIC on, until WakeAt is called again; 0: at no time.
    void WakeAt(std::uint64_t time_ns);
    /// @brief The descriptor to poll.
    [[nodiscard]] int Descriptor() const
    {
        return set_.Get();
    }

  private:
    LiveFile set_;
    LiveFile timer_;
    std::uint64_t wake_ns_{0U}; ///< 0: never.
};

} // namespace counterpoint::host

#endif
