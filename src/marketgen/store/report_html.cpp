#include <fmt/format.h>

#include "base/text.h"
#include "net/http.h"
#include "store/html_page.h"
#include "store/report_page.h"

namespace marketgen::store {
namespace {

// One metric: what it is called, what was measured, and what that means.
struct MetricLine {
  std::string name, value, sentence;
};

std::string percent(double share, int decimals = 1) {
  return fmt::format("{:.{}f} %", 100 * share, decimals);
}

std::vector<MetricLine> metric_lines(const audit::Metrics& m) {
  std::vector<MetricLine> lines{
      {"wishes met",
       percent(m.prompt, 0),
       "Of the atomic wishes in the prompt, the share that holds in the finished store."},
      {"density",
       fmt::format("{:.0f} items/m²", m.DENS),
       fmt::format("Items for each of the {:.0f} m² that shoppers use; the room has {:.0f} m².",
                   m.selling_area_m2,
                   m.gross_area_m2)},
      {"fill",
       percent(m.fill),
       "Of the width of all shelves, the share with goods on it; the rest is gaps between blocks "
       "and blocks that are sold out."},
      {"facings per product",
       fmt::format("{:.1f}", m.facings_per_sku),
       "How many packs of one product stand side by side, on average."},
      {"COL",
       percent(m.COL, 2),
       fmt::format("Of the pairs of items that nearly touch, the share that is more than 1 mm "
                   "inside one another: {} pairs. A store that can exist has none.",
                   m.colliding_pairs)},
      {"OOB",
       fmt::format("{}", m.OOB),
       "Items that reach more than 1 mm out of their shelf or out of the room. There should be "
       "none."},
      {"NAV",
       fmt::format("{:.3f}", m.NAV),
       "Of the floor on which a round robot of 0.42 m radius can be, the share that it can reach "
       "from one place; 1 when no corner is cut off."},
      {"shelves in reach",
       percent(m.reachable_shelves),
       "Shelves before which such a robot can stand when it comes from the entrance."},
      {"REACH",
       percent(m.REACH),
       "Bays, that is sides of modules, of which it can stand before one shelf at least."}};
  if (m.STB)
    lines.push_back({"STB",
                     percent(*m.STB),
                     fmt::format("Of {} products that were let go in physics around the busiest "
                                 "aisle, the share that moved less than 5 cm in four seconds.",
                                 m.stb_products.value_or(0))});
  return lines;
}

std::string metric_rows(const audit::Metrics& metrics) {
  std::string out;
  for (const MetricLine& line : metric_lines(metrics))
    out += fmt::format("<tr><td>{}</td><td class=\"value\">{}</td><td>{}</td></tr>",
                       line.name,
                       line.value,
                       line.sentence);
  return out;
}

std::string figure(const PagePicture& picture) {
  const std::string title = escaped_markup(picture.title);
  return fmt::format(
      "<figure><img alt=\"{0}\" src=\"data:{1};base64,{2}\"><figcaption>{0}</figcaption></figure>",
      title,
      picture.media_type,
      net::base64_of(picture.bytes));
}

std::string pictures(const StorePage& page) {
  if (page.pictures.empty()) return {};
  std::string out =
      "<h2>Pictures</h2><div class=\"layout\">" + figure(page.pictures.front()) + "</div>";
  if (page.pictures.size() == 1)
    return out + "<p>The store has no previews: it was made with --no-previews.</p>";
  out += "<div class=\"views\">";
  for (std::size_t i = 1; i < page.pictures.size(); ++i)
    out += figure(page.pictures[i]);
  return out + "</div>";
}

std::string plot(std::string_view title, const std::string& svg) {
  if (svg.empty()) return {};
  return fmt::format("<figure>{}<figcaption>{}</figcaption></figure>", svg, title);
}

std::string plots(const StorePage& page) {
  const std::string all =
      plot("Shelf width with goods on it, by zone.", bar_plot(page.fill)) +
      plot("Items by category.", bar_plot(page.categories)) +
      plot("How many products cost how much.", histogram(page.prices_eur, "shelf price, euro")) +
      plot("How many products weigh how much.", histogram(page.masses_kg, "gross mass, kg"));
  return all.empty() ? "" : "<h2>What is on the shelves</h2><div class=\"plots\">" + all + "</div>";
}

std::string tile(std::string_view name, std::string_view value) {
  return fmt::format("<div class=\"tile\"><b>{}</b><span>{}</span></div>", value, name);
}

std::string tiles(const Manifest& manifest, const StoreReport& report) {
  std::size_t hard = 0, met = 0;
  for (const layout::Violation& v : report.rules)
    hard += v.severity == layout::Severity::hard ? 1 : 0;
  for (const audit::RequirementResult& r : report.requirements)
    met += r.met ? 1 : 0;
  std::string out = "<div class=\"tiles\">";
  out += tile("products", with_thousands(static_cast<std::int64_t>(manifest.counts.products)));
  out += tile("SKUs", with_thousands(static_cast<std::int64_t>(manifest.counts.skus)));
  out += tile("fixtures", with_thousands(static_cast<std::int64_t>(manifest.counts.fixtures)));
  out += tile("wishes met", fmt::format("{} of {}", met, report.requirements.size()));
  out += tile("hard rules broken", fmt::format("{}", hard));
  out += tile("soft rules broken", fmt::format("{}", report.rules.size() - hard));
  return out + "</div>";
}

std::string requirement_rows(const StoreReport& report) {
  std::string out;
  for (const audit::RequirementResult& r : report.requirements) {
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
  for (const intake::UnparsedWord& word : report.unparsed) {
    out += fmt::format("<tr><td class=\"warn\">not understood</td><td>{}</td><td></td></tr>",
                       escaped_markup(word.text));
  }
  for (const intake::Conflict& c : report.conflicts) {
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
  for (const layout::Violation& v : report.rules) {
    out += fmt::format("<tr><td class=\"{}\">{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
                       v.severity == layout::Severity::hard ? "bad" : "warn",
                       name_of(v.severity),
                       escaped_markup(v.code),
                       escaped_markup(v.where),
                       escaped_markup(v.message));
  }
  for (const std::string& change : report.repairs)
    out += fmt::format("<tr><td>repaired</td><td></td><td></td><td>{}</td></tr>",
                       escaped_markup(change));
  for (const scene::Unstocked& own : report.unstocked)
    out +=
        fmt::format("<tr><td class=\"warn\">not stocked</td><td></td><td>{}</td><td>{}</td></tr>",
                    escaped_markup(own.sku),
                    escaped_markup(own.why));
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

std::string section(const StorePage& page) {
  const Manifest& manifest = page.manifest;
  const StoreReport& report = page.report;
  std::string out = fmt::format("<section><h1>{}</h1><p class=\"sub\">{}<br>seed {} · scene {}</p>",
                                escaped_markup(manifest.name),
                                escaped_markup(manifest.brief.prompt),
                                manifest.seed,
                                escaped_markup(manifest.scene_hash));
  out += tiles(manifest, report);
  out += pictures(page);
  out += table("Metrics",
               "<th>metric</th><th>measured</th><th>what it says</th>",
               metric_rows(report.metrics),
               "");
  out += plots(page);
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

std::string report_html(const std::vector<StorePage>& stores) {
  std::string sections;
  for (const StorePage& page : stores)
    sections += section(page);
  return html_page("MarketGen report", sections);
}

}  // namespace marketgen::store
