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
    /// Adds an error: line of the file, object (may be empty), what is wrong, what was expected.
    void Error(std::size_t line, const std::string& object, const std::string& wrong, const std::string& expected);
    /// Adds a warning of the same form.
    void Warning(std::size_t line, const std::string& object, const std::string& wrong, const std::string& expected);
    /// Adds findings that somebody else made.
    void Add(const std::vector<Finding>& findings);

    /// Whether there is any error.
    [[nodiscard]] bool HasError() const;
    /// Whether there is an error of this object at this line.
    [[nodiscard]] bool HasErrorAt(std::size_t line, const std::string& object) const;
    /// All findings, in the order of their lines.
    [[nodiscard]] std::vector<Finding> Sorted() const;

  private:
    void Add(Finding finding);

    std::vector<Finding> findings_;
    std::set<std::pair<std::size_t, std::string>> error_places_;
};
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_CHECK_FINDINGS_HPP
