#include "planners/trace.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/text.h"
#include "io/json.h"
#include "io/png.h"
#include "layout/layout_picture.h"

namespace marketgen::planners {
namespace {

constexpr int picture_px = 1024;
constexpr const char* folder = "agents/";

// agents/trace.json
struct TraceDocument {
  std::string planner, kept, why;
  std::vector<TraceStep> steps;

  static constexpr auto fields =
      field_list(field("planner", &TraceDocument::planner, "which language model"),
                 field("kept", &TraceDocument::kept, "whose plan the store has"),
                 field("why", &TraceDocument::why, "why"),
                 field("steps", &TraceDocument::steps, "what was done, in order"));
};

constexpr std::string_view page_head =
    R"(<!doctype html><html lang="en"><meta charset="utf-8"><title>Agents</title><style>
body{font:15px/1.5 system-ui,sans-serif;max-width:1060px;margin:2rem auto;padding:0 1rem;color:#1c2321;background:#fbfcfb}
h2{font-size:1.1rem;margin:2rem 0 .3rem}img{max-width:100%;border:1px solid #d9dedc;border-radius:6px}li,figcaption{color:#5c6663}
figure{display:inline-block;max-width:320px;margin:.5rem 1rem .5rem 0;vertical-align:top}
@media(prefers-color-scheme:dark){body{color:#e8ecea;background:#161a19}img{background:#fff}li,figcaption{color:#9aa5a1}}</style>
)";

std::string figure_of(const TracedPicture& picture) {
  return fmt::format("<figure><img src=\"{}\" alt=\"{}\"><figcaption>{}{}{}</figcaption></figure>",
                     picture.file,
                     escaped_markup(picture.of),
                     escaped_markup(picture.of),
                     picture.read.empty() ? "" : ": ",
                     escaped_markup(picture.read));
}

std::string section_of(const TraceStep& step, std::size_t number) {
  std::string out = fmt::format("<section><h2>{}. {}</h2><p>{}</p>",
                                number,
                                escaped_markup(step.agent),
                                escaped_markup(step.what));
  if (step.score) out += fmt::format("<p>Not held: {}.</p>", words_of(*step.score));
  if (!step.rules.empty()) {
    out += "<ul>";
    for (const std::string& rule : step.rules)
      out += fmt::format("<li>{}</li>", escaped_markup(rule));
    out += "</ul>";
  }
  if (!step.picture.empty())
    out += fmt::format("<img src=\"{0}\" alt=\"the floor after step {1}\">", step.picture, number);
  for (const TracedPicture& picture : step.shown.value_or(std::vector<TracedPicture>{}))
    out += figure_of(picture);
  return out + "</section>\n";
}

std::string page_of(const TraceDocument& document) {
  std::string out(page_head);
  out += fmt::format("<h1>How {} planned</h1><p>The store has the plan of the {}: {}.</p>\n",
                     escaped_markup(document.planner),
                     escaped_markup(document.kept),
                     escaped_markup(document.why));
  for (std::size_t i = 0; i < document.steps.size(); ++i)
    out += section_of(document.steps[i], i + 1);
  return out + "</html>\n";
}

}  // namespace

void Trace::add(std::string agent, std::string what) {
  TraceStep& step = steps_.emplace_back();
  step.agent = std::move(agent);
  step.what = std::move(what);
}

Result<void> Trace::add(std::string agent,
                        std::string what,
                        const JudgedPlan& judged,
                        const catalog::Catalog& catalog) {
  MARKETGEN_TRY(std::string png,
                io::encode_png(layout::draw_layout(judged.layout, catalog, picture_px)));
  add(std::move(agent), std::move(what));
  TraceStep& step = steps_.back();
  step.score = judged.score;
  for (const layout::Violation& rule : judged.rules)
    step.rules.push_back(
        fmt::format("{} ({}): {}", rule.code, name_of(rule.severity), rule.message));
  step.picture = fmt::format("step-{}.png", steps_.size());
  pictures_.push_back({folder + step.picture, std::move(png)});
  return {};
}

void Trace::add(std::string agent,
                std::string what,
                const std::vector<ShownPicture>& pictures,
                const std::vector<std::string>& read) {
  add(std::move(agent), std::move(what));
  if (pictures.empty()) return;
  std::vector<TracedPicture>& shown = steps_.back().shown.emplace();
  for (std::size_t i = 0; i < pictures.size(); ++i)
    shown.push_back({file_of(pictures[i]), pictures[i].file, i < read.size() ? read[i] : ""});
}

// Its bytes are kept once, however often it is shown.
std::string Trace::file_of(const ShownPicture& picture) {
  const auto known = std::ranges::find(shown_, picture.file);
  std::string name = fmt::format("shown-{}.png", known - shown_.begin() + 1);
  if (known == shown_.end()) {
    shown_.push_back(picture.file);
    pictures_.push_back({folder + name, picture.png});
  }
  return name;
}

std::vector<intake::PlannerFile> Trace::files(const intake::PlannerRecord& record) const {
  const TraceDocument document{record.planner, record.kept, record.why, steps_};
  std::vector<intake::PlannerFile> files = pictures_;
  files.push_back({std::string(folder) + "trace.json", io::write_json(document)});
  files.push_back({std::string(folder) + "index.html", page_of(document)});
  return files;
}

}  // namespace marketgen::planners
