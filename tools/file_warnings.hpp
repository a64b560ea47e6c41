// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
#ifndef TOOLS_FILE_WARNINGS_HPP
#define TOOLS_FILE_WARNINGS_HPP

#include <ostream>
#include <string>
#include <vector>

namespace counterpoint::tools
{

/// @brief Writes what the reader of EDS and DCF files finds strange in them, a line each, each file once. A file that
/// cannot be read is left to who uses it, and refuses it. [SRS_EDS_038]
void TellFileWarnings(const std::vector<std::string>& files, std::ostream& err);

} // namespace counterpoint::tools

#endif
