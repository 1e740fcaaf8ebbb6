#include "store/html_page.h"

#include <fmt/format.h>

#include "base/text.h"

namespace marketgen::store {
namespace {

constexpr std::string_view page_style = R"(<style>
:root{color-scheme:light dark;--ink:#1c2321;--soft:#5c6663;--line:#d9dedc;--paper:#fbfcfb;--good:#2e7d32;--bad:#b3261e;--warn:#a66300}
@media(prefers-color-scheme:dark){:root{--ink:#e8ecea;--soft:#9aa5a1;--line:#333b39;--paper:#161a19;--good:#7cc47f;--bad:#f2938c;--warn:#e0a95a}}
body{font:15px/1.5 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:1100px;margin:2.5rem auto;padding:0 1.25rem}
h1{font-size:1.6rem;margin:0 0 .25rem}h2{font-size:1.15rem;margin:2rem 0 .5rem}p.sub{color:var(--soft);margin:0 0 1rem}
table{border-collapse:collapse;width:100%;font-variant-numeric:tabular-nums}th,td{text-align:left;padding:.3rem .6rem;border-bottom:1px solid var(--line);vertical-align:top}
th{color:var(--soft);font-weight:600}.tiles{display:flex;flex-wrap:wrap;gap:.6rem}.tile{border:1px solid var(--line);border-radius:8px;padding:.5rem .9rem;min-width:7rem}
.tile b{display:block;font-size:1.25rem}.tile span{color:var(--soft);font-size:.85rem}.good{color:var(--good)}.bad{color:var(--bad)}.warn{color:var(--warn)}
section{border-top:2px solid var(--line);padding-top:1.2rem;margin-top:2rem}
td.value{white-space:nowrap;font-weight:600}figure{margin:0}figcaption{color:var(--soft);font-size:.85rem;margin-top:.2rem}
.layout img{width:100%;background:#fff;border-radius:6px}.views{display:grid;grid-template-columns:repeat(auto-fit,minmax(320px,1fr));gap:.8rem;margin-top:.8rem}
.views img{width:100%;border-radius:6px}.strips{display:flex;flex-wrap:wrap;gap:1rem}.strips figure{flex:0 1 520px}.strips img{width:100%;border-radius:6px}
.plots{display:flex;flex-wrap:wrap;gap:1.2rem 2.5rem}.plots figure{flex:1 1 480px}
svg{max-width:100%;height:auto;font:12px system-ui,sans-serif}svg text{fill:var(--ink)}.bar{fill:#2f7f79}.back{fill:var(--line)}.mark{fill:var(--ink);stroke:var(--paper)}</style>)";

}  // namespace

std::string html_page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!doctype html><html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
      "content=\"width=device-width\"><title>{}</title>{}</head><body>{}</body></html>\n",
      escaped_markup(title),
      page_style,
      body);
}

}  // namespace marketgen::store
