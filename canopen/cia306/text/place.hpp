// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef CANOPEN_CIA306_TEXT_PLACE_HPP
#define CANOPEN_CIA306_TEXT_PLACE_HPP

#include <cstddef>
#include <string>

namespace counterpoint::cia306
{
/// A place in a text; both count from 1. Line 0: the file as a whole; column 0: the line as a whole. Columns are bytes,
/// of YAML characters; a byte order mark has none. Of a binary capture the line is the number of the packet.
struct Place
{
    std::size_t line{0U};
    std::size_t column{0U};

    /// Whether it is no more than the file.
    [[nodiscard]] bool IsWhole() const noexcept
    {
        return line == 0U;
    }
    /// The place, for the file as a whole its beginning.
    [[nodiscard]] Place OrBeginning() const noexcept
    {
        return IsWhole() ? Place{1U, 1U} : *this;
    }
    [[nodiscard]] bool operator==(const Place& other) const noexcept
    {
        return line == other.line && column == other.column;
    }
};

/// What every message about a file begins with: FILE:LINE:COLUMN, as much of it as there is. [SRS_EDS_036]
[[nodiscard]] std::string PlaceText(const std::string& file, Place place);
} // namespace counterpoint::cia306

#endif // CANOPEN_CIA306_TEXT_PLACE_HPP
