// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_CHECK_FINDINGS_HPP
#define CANOPEN_CIA306_CHECK_FINDINGS_HPP

#include "canopen/cia306/text/finding.hpp"

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace counterpoint::cia306
{
/// Collects what the rules find.
class Findings
{
  public:
    void Error(std::size_t line, const std::string& object, const std::string& wrong, const std::string& expected);
    void Warning(std::size_t line, const std::string& object, const std::string& wrong, const std::string& expected);
    void Add(const std::vector<Finding>& findings);

    [[nodiscard]] bool HasError() const;
    [[nodiscard]] bool HasErrorAt(std::size_t line, const std::string& object) const;
    /// In the order of the lines.
    [[nodiscard]] std::vector<Finding> Sorted() const;

  private:
    void Add(Finding finding);

    std::vector<Finding> findings_;
    std::set<std::pair<std::size_t, std::string>> error_places_;
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_FINDINGS_HPP
