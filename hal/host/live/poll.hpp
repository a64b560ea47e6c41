// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef HAL_HOST_LIVE_POLL_HPP
#define HAL_HOST_LIVE_POLL_HPP

#include <cstdint>

namespace counterpoint::host
{

/// An owned descriptor; -1: none.
class LiveFile
{
  public:
    explicit LiveFile(int descriptor) : descriptor_{descriptor}
    {
    }
    ~LiveFile();
    LiveFile(const LiveFile&) = delete;
    LiveFile(LiveFile&& other) noexcept;
    LiveFile& operator=(const LiveFile&) = delete;
    LiveFile& operator=(LiveFile&& other) noexcept;
    [[nodiscard]] int Get() const
    {
        return descriptor_;
    }

  private:
    int descriptor_;
};

/// One descriptor for poll that stands for several and for a moment: readable when one of them is, or when the moment
/// has come. Throws std::runtime_error when the system has no descriptor left.
class LivePoll
{
  public:
    LivePoll();
    void Add(int descriptor);
    /// @brief Readable from `time_ns` of CLOCK_MONOTONIC on, until WakeAt or WakeNever is called again.
    void WakeAt(std::uint64_t time_ns);
    void WakeNever();
    [[nodiscard]] int Descriptor() const
    {
        return set_.Get();
    }

  private:
    void Set(std::uint64_t time_ns);

    LiveFile set_;
    LiveFile timer_;
    std::uint64_t wake_ns_{0U}; ///< 0: never.
};

} // namespace counterpoint::host

#endif
