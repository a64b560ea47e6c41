// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef RUNTIME_NODE_LATENCY_HPP
#define RUNTIME_NODE_LATENCY_HPP

#include <nlohmann/json.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace counterpoint::runtime
{
/// Statistics of the times from the reception of a pair to its released output. It counts by microseconds up to a tenth
/// of a second, so its memory does not grow with time. [SRS_NODE_008]
class NodeLatency
{
  public:
    /// @brief Adds a time in ns.
    void Add(std::uint64_t ns);
    /// @brief Number of times.
    [[nodiscard]] std::uint64_t Count() const noexcept
    {
        return count_;
    }
    /// @brief The time in us that `percent` of all times do not exceed.
    [[nodiscard]] std::uint64_t Percentile(unsigned percent) const;
    /// @brief Summary and histogram, as lines.
    [[nodiscard]] std::string Text() const;
    /// @brief The same as JSON.
    [[nodiscard]] nlohmann::ordered_json Json() const;

  private:
    [[nodiscard]] std::vector<std::uint64_t> Doubling() const;

    std::vector<std::uint64_t> counts_; ///< By microsecond; the last one takes all above.
    std::uint64_t count_{0U};
    std::uint64_t least_us_{0U};
    std::uint64_t greatest_us_{0U};
};
} // namespace counterpoint::runtime

#endif // RUNTIME_NODE_LATENCY_HPP
