// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef VERIFICATION_CAMPAIGN_JSON_PIECES_HPP
#define VERIFICATION_CAMPAIGN_JSON_PIECES_HPP

#include "canopen/cia306/text/text_file.hpp"

#include <cstddef>
#include <functional>
#include <nlohmann/json.hpp>

namespace counterpoint::campaign
{
/// @brief Writes a report with one more key, `survivors`, of which each is made when it is its turn: all of them at
/// once may be larger than memory. The bytes are those of the report as a whole. [SRS_CMG_804]
void WriteWithSurvivors(const nlohmann::ordered_json& report, std::size_t count,
                        const std::function<nlohmann::ordered_json(std::size_t)>& survivor,
                        const cia306::TextPiece& write);
} // namespace counterpoint::campaign

#endif // VERIFICATION_CAMPAIGN_JSON_PIECES_HPP
