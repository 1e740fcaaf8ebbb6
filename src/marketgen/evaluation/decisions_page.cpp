#include "evaluation/decisions_page.h"

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "base/text.h"
#include "evaluation/decision_judge.h"
#include "store/html_page.h"

namespace marketgen::evaluation {
namespace {

constexpr std::string_view page_style = R"(<style>
.looks{display:flex;flex-wrap:wrap;gap:.8rem;margin:.4rem 0}.looks figure{flex:1 1 320px;max-width:480px}.looks .shot{position:relative}.looks img{width:100%;display:block;border-radius:6px}
.looks svg{position:absolute;inset:0;width:100%;height:100%}.looks rect{fill:none;stroke:#fff;stroke-opacity:.55;stroke-width:1;vector-effect:non-scaling-stroke}
.looks rect.goal{stroke:#ffd54a;stroke-opacity:1;stroke-width:2}details{border-bottom:1px solid var(--line);padding:.35rem 0}summary{cursor:pointer}summary .when{color:var(--soft);display:inline-block;min-width:4.5rem}
</style>)";

std::string mark_rect(const agent::PictureMark& mark) {
  const auto& [left, top, right, bottom] = mark.box;
  return fmt::format("<rect{} x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"/>",
                     mark.goal >= 0 ? " class=\"goal\"" : "",
                     100 * left,
                     100 * top,
                     100 * (right - left),
                     100 * (bottom - top));
}

std::string picture_figure(const PictureRecord& picture) {
  std::string rects;
  for (const agent::PictureMark& mark : picture.marks)
    rects += mark_rect(mark);
  const std::string camera = escaped_markup(picture.camera);
  const auto found =
      std::ranges::count_if(picture.marks, [](const auto& m) { return m.goal >= 0; });
  return fmt::format(
      "<figure><div class=\"shot\"><img alt=\"what {0} showed\" src=\"data:image/jpeg;base64,{1}\">"
      "<svg viewBox=\"0 0 100 100\" preserveAspectRatio=\"none\" "
      "aria-hidden=\"true\">{2}</svg></div>"
      "<figcaption>{0}: {3} found, {4} masks</figcaption></figure>",
      camera,
      picture.jpeg,
      rects,
      found,
      picture.marks.size() - static_cast<std::size_t>(found));
}

std::string goal_name(int goal) {
  return goal < 0 ? "in the way" : fmt::format("goal {}", goal + 1);
}

// What was true of a place, and whether that is what it was taken for.
std::string truth_words(const TruthThere& truth, const std::string& sku) {
  if (is_right(truth))
    return fmt::format("<span class=\"good\">right, {:.0f} mm off</span>", 1000 * *truth.own_m);
  const std::string there = truth.sku.empty() || truth.sku == sku
                                ? std::string("something else or nothing")
                                : escaped_markup(truth.sku);
  return fmt::format(
      "<span class=\"bad\">{}; the nearest is {}</span>",
      there,
      truth.own_m ? fmt::format("{:.0f} mm off", 1000 * *truth.own_m) : std::string("nowhere"));
}

std::string found_table(const std::vector<FoundRecord>& found) {
  if (found.empty()) return "";
  std::string rows;
  for (const FoundRecord& each : found)
    rows += fmt::format("<tr><td>{}</td><td>{}</td><td>{:.2f}</td><td>{}</td></tr>",
                        goal_name(each.goal),
                        escaped_markup(each.sku),
                        each.score,
                        truth_words(each.truth, each.sku));
  return "<table><tr><th>goal</th><th>taken for</th><th>score</th><th>truth</th></tr>" + rows +
         "</table>";
}

std::string tried_table(const std::vector<agent::TriedGrasp>& tried) {
  if (tried.empty()) return "";
  std::string rows;
  for (const agent::TriedGrasp& each : tried)
    rows += fmt::format(
        "<tr><td>{:.3f} {:.3f} {:.3f}</td><td>{:.0f} mm</td><td>{:.1f} mm</td><td>{}</td></tr>",
        each.tip_m[0],
        each.tip_m[1],
        each.tip_m[2],
        1000 * each.opening_m,
        1000 * each.intrusion_m,
        each.outcome == "None" ? "taken" : escaped_markup(each.outcome));
  return "<table><tr><th>grasp at</th><th>opened</th><th>into others</th><th>outcome</th></tr>" +
         rows + "</table>";
}

std::string what_of(const DecisionRecord& decision) {
  switch (decision.kind) {
    case agent::DecisionKind::read:
      return fmt::format(
          "{} means {}",
          goal_name(decision.goal),
          decision.readings.empty()
              ? "nothing that it knows"
              : escaped_markup(fmt::format("{}", fmt::join(decision.readings, ", "))));
    case agent::DecisionKind::look:
      return fmt::format("looks: {} found", decision.found.size());
    case agent::DecisionKind::stop:
      return "stops";
    default:
      return fmt::format("{}: {} {}",
                         name_of(decision.kind),
                         goal_name(decision.goal),
                         escaped_markup(decision.sku));
  }
}

std::string decision_section(const DecisionRecord& decision) {
  std::string body;
  if (!decision.pictures.empty()) {
    body += "<div class=\"looks\">";
    for (const PictureRecord& picture : decision.pictures)
      body += picture_figure(picture);
    body += "</div>";
  }
  if (decision.kind == agent::DecisionKind::reach && decision.truth)
    body += "<p>What is there: " + truth_words(*decision.truth, decision.sku) + "</p>";
  if (decision.kind == agent::DecisionKind::hold && decision.truth)
    body +=
        fmt::format("<p>In the hand: {}</p>",
                    decision.truth->sku.empty() ? "nothing" : escaped_markup(decision.truth->sku));
  body += found_table(decision.found) + tried_table(decision.tried);
  body += fmt::format("<p class=\"sub\">computed in {:.2f} s</p>", decision.computed_s);
  const bool fine = decision.outcome.empty() || decision.outcome == "None";
  return fmt::format(
      "<details><summary><span class=\"when\">{:.1f} s</span> {}{}</summary>{}</details>",
      decision.time_s,
      what_of(decision),
      fine ? "" : fmt::format(" <span class=\"bad\">{}</span>", escaped_markup(decision.outcome)),
      body);
}

std::string goals_table(const std::vector<JudgedGoal>& goals) {
  std::string rows;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    const JudgedGoal& goal = goals[i];
    const bool done = goal.module == PolicyModule::done;
    rows += fmt::format(
        "<tr><td>{}</td><td>{}</td><td>{} of {}</td><td "
        "class=\"{}\">{}</td><td>{}</td><td>{}</td></tr>",
        i + 1,
        escaped_markup(goal.sku),
        goal.reached,
        goal.count,
        done ? "good" : "bad",
        name_of(goal.module),
        escaped_markup(goal.why),
        done ? "" : fmt::format("{:.1f} s", goal.time_s));
  }
  return "<table><tr><th>goal</th><th>product</th><th>in place</th><th>first wrong</th><th>why</th>"
         "<th>when</th></tr>" +
         rows + "</table>";
}

}  // namespace

std::string decisions_html(const EpisodeDecisions& decisions) {
  std::string body = std::string(page_style) +
                     fmt::format("<h1>{}</h1><p class=\"sub\">{} · realism {}</p><p>{}</p>",
                                 escaped_markup(decisions.episode),
                                 escaped_markup(decisions.policy),
                                 escaped_markup(decisions.realism),
                                 escaped_markup(decisions.instruction));
  body += "<h2>Goals</h2>" + goals_table(decisions.goals) + "<h2>Decisions</h2>";
  if (decisions.decisions.empty()) body += "<p>The policy tells nothing of what it decides.</p>";
  for (const DecisionRecord& decision : decisions.decisions)
    body += decision_section(decision);
  return store::html_page(decisions.episode, body);
}

}  // namespace marketgen::evaluation
