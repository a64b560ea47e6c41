// Copyright the Counterpoint authors. SPDX-License-Identifier: Apache-2.0
// The page with the boot-up sequence diagram.
#include "runtime/manager/report/diagram.hpp"
#include "runtime/manager/report/status.hpp"

#include "canopen/cia306/text/html_text.hpp"

#include <algorithm>
#include <cstdio>
#include <map>
#include <sstream>

namespace counterpoint::runtime
{
namespace
{
constexpr int kTimeWidth = 110;
constexpr int kFewLanes = 7;
constexpr int kWideLane = 280;   ///< Of few lanes.
constexpr int kNarrowLane = 120; ///< Of many.
constexpr int kLetterWidth = 7;
constexpr int kRowHeight = 22;
constexpr int kHeadHeight = 46;
constexpr int kRowsOfPage = 40; ///< Then the heads again: nobody has to go back to see whose lane it is.

constexpr const char* kStyle =
    ".sequence{color-scheme:light dark;--ink:#1c2430;--soft:#667085;--line:#c9d0da;--good:#1a7f4b;--bad:#c0362c;"
    "--paper:#fff;--head:#f3f5f8}@media(prefers-color-scheme:dark){.sequence{--ink:#e6e9ef;--soft:#98a2b3;--line:"
    "#3a4252;--good:#4cc38a;--bad:#ff7b72;--paper:#14181f;--head:#1d232d}}.sequence{font:14px/1.45 system-ui,"
    "sans-serif;color:var(--ink);background:var(--paper);margin:24px}.sequence h1{font-size:20px}.sequence table{"
    "border-collapse:collapse;margin:12px 0 24px}.sequence td,.sequence th{padding:4px 12px 4px 0;text-align:left;"
    "border-bottom:1px solid var(--line)}.sequence th{color:var(--soft);font-weight:500}.sequence .good{color:"
    "var(--good)}.sequence .bad{color:var(--bad)}.sequence svg text{font-size:12px;fill:var(--ink);paint-order:stroke;"
    "stroke:var(--paper);stroke-width:4px}.sequence svg .soft{fill:var(--soft)}.sequence svg .badtext{fill:var(--bad)}"
    ".sequence svg .lane{stroke:var(--line)}.sequence svg .arrow{stroke:var(--ink);fill:none}.sequence svg .badarrow{"
    "stroke:var(--bad);fill:none}.sequence svg .head{fill:var(--head)}.sequence figure,.sequence "
    ".wide{overflow-x:auto;margin:0}"
    // On a phone each slave is a block of named lines: what is wrong stands below the name, not beside it.
    "@media(max-width:600px){.sequence{margin:12px}.sequence .results tr{display:block;padding:6px 0;border-bottom:1px "
    "solid var(--line)}.sequence .results tr.titles,.sequence .results td:empty{display:none}.sequence .results td{"
    "display:block;border:0;padding:0}.sequence .results td::before{content:attr(data-of) \" \";color:var(--soft)}}"
    ".sequence figcaption{color:var(--soft);margin-bottom:8px}";

/// At most so many bytes, no character cut in two.
std::string Cut(std::string text, const std::size_t length)
{
    if (text.size() > length)
    {
        std::size_t end = length;
        while (end > 0U && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        {
            --end;
        }
        text.resize(end);
    }
    return text;
}

std::string Seconds(const std::uint64_t us)
{
    constexpr std::size_t kRoom = 32U;
    char text[kRoom];
    std::snprintf(text, sizeof(text), "%.4f s", static_cast<double>(us) / 1e6);
    return text;
}

std::string NameOf(const ManagerAssembly& assembly)
{
    return cia306::HtmlText(assembly.Net().Plan().name.empty() ? assembly.Net().Plan().file
                                                               : assembly.Net().Plan().name);
}

/// A cell that knows its title: where the table is no table any more, it is told before each value.
std::string Cell(const std::string& title, const std::string& html)
{
    return "<td data-of=\"" + title + "\">" + html + "</td>";
}

std::string ResultTable(const ManagerStation& station)
{
    std::ostringstream out;
    out << "<div "
           "class=\"wide\"><table class=\"results\"><tr "
           "class=\"titles\"><th>node</th><th>name</th><th>state</th><th>result</th><th>step</"
           "th><th>heartbeat</th><th>emergency</th><th>safety</th>"
           "<th>finding</th></tr>";
    for (const StatusRow& row : StatusRows(station, station.NowUs()))
    {
        out << "<tr>" << Cell("node", std::to_string(row.node)) << Cell("name", cia306::HtmlText(row.name))
            << "<td data-of=\"state\" class=\"" << (row.is_good ? "good" : "bad") << "\">" << row.state << "</td>"
            << Cell("result", row.result) << Cell("step", row.step) << Cell("heartbeat", row.age)
            << Cell("emergency", row.emergency) << Cell("safety", row.safety)
            << Cell("finding", cia306::HtmlText(row.finding)) << "</tr>";
    }
    const std::string unlisted = UnlistedText(station, station.NowUs());
    out << "</table></div>" << (unlisted.empty() ? "" : "<p>" + unlisted + "</p>");
    return out.str();
}

/// Lanes from left to right: manager, then each node that appears.
class Picture
{
  public:
    Picture(const ManagerAssembly& assembly, const ManagerDiagram& diagram) : rows_(diagram.Rows())
    {
        std::map<std::uint8_t, std::string> names;
        for (const auto& slave : assembly.Net().Slaves())
        {
            names[slave->plan.node] = slave->plan.name;
        }
        for (const DiagramRow& row : rows_)
        {
            if (row.node != 0U && row.node != assembly.Net().Setup().own.value)
            {
                names.emplace(row.node, "unknown");
            }
        }
        heads_.push_back({"manager", "node " + std::to_string(assembly.Net().Setup().own.value)});
        for (const auto& [node, name] : names)
        {
            lanes_[node] = static_cast<int>(heads_.size());
            heads_.push_back({std::to_string(node), name});
        }
        lane_width_ = (heads_.size() > static_cast<std::size_t>(kFewLanes)) ? kNarrowLane : kWideLane;
    }

    std::string Draw()
    {
        const int width = Width();
        const int count = static_cast<int>(rows_.size());
        const int height = kHeadHeight * (1 + count / kRowsOfPage) + (count + 1) * kRowHeight;
        out_ << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width << "\" height=\"" << height
             << "\" role=\"img\" aria-label=\"boot-up sequence\"><defs><marker id=\"tip\" markerWidth=\"8\" "
                "markerHeight=\"8\" refX=\"7\" refY=\"4\" orient=\"auto-start-reverse\"><path d=\"M0,0L8,4L0,8\" "
                "class=\"arrow\"/>"
                "</marker></defs>";
        for (std::size_t lane = 0U; lane < heads_.size(); ++lane)
        {
            const int x = X(static_cast<int>(lane));
            out_ << "<line class=\"lane\" x1=\"" << x << "\" y1=\"" << kHeadHeight - 12 << "\" x2=\"" << x << "\" y2=\""
                 << height << "\"/>";
        }
        int y = 0;
        for (std::size_t place = 0U; place < rows_.size(); ++place)
        {
            if (place % kRowsOfPage == 0U)
            {
                DrawHeads(y);
                y += kHeadHeight;
            }
            y += kRowHeight;
            DrawRow(rows_[place], y);
        }
        out_ << "</svg>";
        return out_.str();
    }

  private:
    struct Head
    {
        std::string node;
        std::string name;
    };

    /// Marks stand at the right of their lane, also of the last one, and none is cut.
    int Width() const
    {
        int width = X(static_cast<int>(heads_.size()) - 1) + kWideLane + kNarrowLane;
        for (const DiagramRow& row : rows_)
        {
            const int begin = row.is_mark ? X(LaneOf(row.node)) : X(0);
            constexpr int kAdded = 24; // Of an arrow: the time to its answer.
            width = std::max(width, begin + (static_cast<int>(row.label.size()) + kAdded) * kLetterWidth);
        }
        return width;
    }
    int X(const int lane) const
    {
        return kTimeWidth + kNarrowLane / 2 + lane * lane_width_;
    }
    void DrawHeads(const int y)
    {
        for (std::size_t lane = 0U; lane < heads_.size(); ++lane)
        {
            const std::string at =
                "<text x=\"" + std::to_string(X(static_cast<int>(lane))) + "\" text-anchor=\"middle\" y=\"";
            const std::string name = Cut(heads_[lane].name, static_cast<std::size_t>(lane_width_ / kLetterWidth));
            out_ << at << y + 16 << "\">" << heads_[lane].node << "</text>" << at << y + 31 << "\" class=\"soft\">"
                 << cia306::HtmlText(name) << "</text>";
        }
    }
    int LaneOf(const std::uint8_t node) const
    {
        const auto found = lanes_.find(node);
        return (found == lanes_.end()) ? 0 : found->second;
    }
    void DrawRow(const DiagramRow& row, const int y)
    {
        const int last = static_cast<int>(heads_.size()) - 1;
        const int lane = (row.node == 0U && !row.is_mark) ? last : LaneOf(row.node);
        const std::string time = Seconds(row.at_us);
        out_ << "<text class=\"soft\" x=\"4\" y=\"" << y << "\">" << time << "</text>";
        const char* const text = row.is_bad ? "badtext" : "";
        if (row.is_mark || lane == 0)
        {
            out_ << "<circle cx=\"" << X(lane) << "\" cy=\"" << y - 4 << "\" r=\"4\" class=\""
                 << (row.is_bad ? "badarrow" : "arrow") << "\"/><text class=\"" << text << "\" x=\"" << X(lane) + 9
                 << "\" y=\"" << y << "\">" << cia306::HtmlText(row.label) << "</text>";
            return;
        }
        const int from = row.is_from_manager ? X(0) : X(lane);
        const int to = row.is_from_manager ? X(lane) : X(0);
        const bool is_answered = row.until_us > row.at_us;
        const std::string took = is_answered ? " (" + std::to_string(row.until_us - row.at_us) + " us)" : "";
        const bool is_silent = row.is_request && row.until_us == 0U;
        const std::string label = cia306::HtmlText(row.label + (is_silent ? ": no answer" : "") + took);
        // By the lane of the node, where its messages stand below each other; what does not fit there begins at the
        // manager.
        const int room = X(lane) - X(0) - 24;
        const bool is_long = row.node == 0U || lane == 1 || static_cast<int>(label.size()) * kLetterWidth > room;
        const std::string at =
            is_long ? std::to_string(X(0) + 12) : std::to_string(X(lane) - 12) + "\" text-anchor=\"end";
        out_ << "<line class=\"" << (row.is_bad || is_silent ? "badarrow" : "arrow") << "\" marker-end=\"url(#tip)\""
             << (is_answered ? " marker-start=\"url(#tip)\"" : "") << " x1=\"" << from << "\" y1=\"" << y + 3
             << "\" x2=\"" << to << "\" y2=\"" << y + 3 << "\"/><text class=\"" << (is_silent ? "badtext" : text)
             << "\" x=\"" << at << "\" y=\"" << y << "\">" << label << "</text>";
    }

    const std::vector<DiagramRow>& rows_;
    std::vector<Head> heads_;
    int lane_width_{kWideLane};
    std::map<std::uint8_t, int> lanes_;
    std::ostringstream out_;
};
} // namespace

std::string DiagramSection(const ManagerStation& station)
{
    const ManagerAssembly& assembly = station.Assembly();
    const ManagerDiagram& diagram = station.Diagram();
    std::ostringstream out;
    out << "<section class=\"sequence\"><h1>Boot-up of " << NameOf(assembly) << "</h1><p>"
        << cia306::HtmlText(ManagerLine(assembly)) << "</p>" << ResultTable(station)
        << "<figure><figcaption>Time goes down, one row for each message; SDO transfers are one row, an arrow to and "
           "fro with the time to the answer.";
    if (diagram.LeftOut() > 0U)
    {
        out << " " << diagram.LeftOut() << " later rows are left out.";
    }
    out << "</figcaption>" << Picture(assembly, diagram).Draw() << "</figure></section>";
    return out.str();
}

std::string DiagramStyle()
{
    return std::string("<style>") + kStyle + "</style>";
}

std::string DiagramPage(const ManagerStation& station)
{
    return "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\"><title>Boot-up of " +
           NameOf(station.Assembly()) + "</title>" + DiagramStyle() + "</head><body>" + DiagramSection(station) +
           "</body></html>\n";
}
} // namespace counterpoint::runtime
