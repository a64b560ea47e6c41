// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_CONSOLE_TOLD_COUNT_HPP
#define RUNTIME_CONSOLE_TOLD_COUNT_HPP

#include <cstdint>
#include <string>

namespace counterpoint::runtime
{
/// A count that grows, and of which a person is told at once, then at most once a second. [SRS_MGR_581, SRS_NODE_581,
/// SRS_MON_581]
class ToldCount
{
  public:
    /// @brief What it is now. True: it is another than before.
    [[nodiscard]] bool Learn(std::uint32_t count) noexcept;
    /// @brief How many are to be told now, which they are then; 0: none.
    [[nodiscard]] std::uint32_t Due(std::uint64_t now_ns) noexcept;

  private:
    std::uint32_t count_{0U};
    std::uint32_t told_{0U};
    std::uint64_t told_ns_{0U}; ///< 0: nothing was told yet.
};

/// @brief "3 malformed elements of the bus were left out, the last: PROBLEM"; the end only where a problem is known.
[[nodiscard]] std::string MalformedText(std::uint32_t count, const std::string& problem);
} // namespace counterpoint::runtime

#endif // RUNTIME_CONSOLE_TOLD_COUNT_HPP
