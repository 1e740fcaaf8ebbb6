#include <fmt/format.h>

#include "base/text.h"
#include "store/store.h"

namespace marketgen {
namespace {

constexpr std::string_view style = R"(<style>
:root{color-scheme:light dark;--ink:#1c2321;--soft:#5c6663;--line:#d9dedc;--paper:#fbfcfb;--good:#2e7d32;--bad:#b3261e;--warn:#a66300}
@media(prefers-color-scheme:dark){:root{--ink:#e8ecea;--soft:#9aa5a1;--line:#333b39;--paper:#161a19;--good:#7cc47f;--bad:#f2938c;--warn:#e0a95a}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:1100px;margin:2.5rem auto;padding:0 1.25rem}
h1{font-size:1.6rem;margin:0 0 .25rem}h2{font-size:1.15rem;margin:2rem 0 .5rem}p.sub{color:var(--soft);margin:0 0 1rem}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}th,td{text-align:left;padding:.3rem .6rem;border-bottom:1px solid var(--line);vertical-align:top}
th{color:var(--soft);font-weight:600}.tiles{display:flex;flex-wrap:wrap;gap:.6rem}.tile{border:1px solid var(--line);border-radius:8px;padding:.5rem .9rem;min-width:7rem}
.tile b{display:block;font-size:1.25rem}.tile span{color:var(--soft);font-size:.85rem}.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}
section{border-top:2px solid var(--line);padding-top:1.2rem;margin-top:2rem}</style>)";

std::string tile(std::string_view name, std::string_view value) {
  return fmt::format("<div class=\"tile\"><b>{}</b><span>{}</span></div>", value, name);
}

std::string tiles(const Manifest& manifest, const StoreReport& report) {
  const Metrics& m = report.metrics;
  std::string out = "<div class=\"tiles\">";
  out += tile("products", with_thousands(static_cast<std::int64_t>(manifest.counts.products)));
  out += tile("SKUs", with_thousands(static_cast<std::int64_t>(manifest.counts.skus)));
  out += tile("fixtures", with_thousands(static_cast<std::int64_t>(manifest.counts.fixtures)));
  out += tile("items per m² sold on", fmt::format("{:.0f}", m.DENS));
  out += tile("shelf front stocked", fmt::format("{:.0f} %", 100 * m.fill));
  out += tile("COL", fmt::format("{:.2f} %", 100 * m.COL));
  out += tile("OOB", fmt::format("{}", m.OOB));
  out += tile("NAV", fmt::format("{:.3f}", m.NAV));
  out += tile("shelves in reach of a robot", fmt::format("{:.1f} %", 100 * m.reachable_shelves));
  if (m.STB)
    out += tile(fmt::format("STB of {} let go", m.stb_products.value_or(0)),
                fmt::format("{:.1f} %", 100 * *m.STB));
  return out + "</div>";
}

std::string requirement_rows(const StoreReport& report) {
  std::string out;
  for (const RequirementResult& r : report.requirements) {
    out += fmt::format("<tr><td class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>",
                       r.met ? "good" : "bad",
                       r.met ? "met" : "not met",
                       escaped_markup(r.text),
                       escaped_markup(r.why));
  }
  if (!report.understood) {
    out +=
        "<tr><td class=\"bad\">not understood</td><td>the whole prompt</td><td>this is the usual "
        "store</td></tr>";
  }
  for (const UnparsedWord& word : report.unparsed) {
    out += fmt::format("<tr><td class=\"warn\">not understood</td><td>{}</td><td></td></tr>",
                       escaped_markup(word.text));
  }
  for (const Conflict& c : report.conflicts) {
    out += fmt::format(
        "<tr><td class=\"warn\">conflict</td><td>{}</td><td>kept {}, dropped {}: {}</td></tr>",
        escaped_markup(c.what),
        escaped_markup(c.kept),
        escaped_markup(c.dropped),
        escaped_markup(c.why));
  }
  return out;
}

std::string rule_rows(const StoreReport& report) {
  std::string out;
  for (const Violation& v : report.rules) {
    out += fmt::format("<tr><td class=\"{}\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
                       v.severity == Severity::hard ? "bad" : "warn",
                       name_of(v.severity),
                       escaped_markup(v.code),
                       escaped_markup(v.where),
                       escaped_markup(v.message));
  }
  for (const std::string& change : report.repairs)
    out += fmt::format("<tr><td>repaired</td><td></td><td></td><td>{}</td></tr>",
                       escaped_markup(change));
  return out;
}

std::string timing_rows(const StoreReport& report) {
  std::string out;
  for (const StageTiming& t : report.timing_s)
    out += fmt::format("<tr><td>{}</td><td>{:.3f} s</td></tr>", escaped_markup(t.stage), t.seconds);
  return out;
}

std::string table(std::string_view title,
                  std::string_view head,
                  const std::string& rows,
                  std::string_view none) {
  if (rows.empty()) return fmt::format("<h2>{}</h2><p>{}</p>", title, none);
  return fmt::format("<h2>{}</h2><table><tr>{}</tr>{}</table>", title, head, rows);
}

std::string section(const Manifest& manifest, const StoreReport& report) {
  std::string out = fmt::format("<section><h1>{}</h1><p class=\"sub\">{}<br>seed {} · scene {}</p>",
                                escaped_markup(manifest.name),
                                escaped_markup(manifest.brief.prompt),
                                manifest.seed,
                                manifest.scene_hash);
  out += tiles(manifest, report);
  out += table("Requirements",
               "<th></th><th>asked for</th><th>measured</th>",
               requirement_rows(report),
               "None were asked for.");
  out += table("Rules",
               "<th></th><th>rule</th><th>where</th><th>what</th>",
               rule_rows(report),
               "No rule is broken and nothing was repaired.");
  out += table("Time", "<th>stage</th><th>wall time</th>", timing_rows(report), "Not measured.");
  return out + "</section>";
}

}  // namespace

std::string report_html(const std::vector<std::pair<Manifest, StoreReport>>& stores) {
  std::string out =
      "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\">"
      "<title>MarketGen report</title>";
  out += style;
  out += "</head><body>";
  for (const auto& [manifest, report] : stores)
    out += section(manifest, report);
  return out + "</body></html>\n";
}

}  // namespace marketgen
