// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace palpate::study {

/// Styles needed by the charts, also in standalone SVG files.
inline constexpr const char* kChartStyle = R"(
svg text{font:12px "Inter","Segoe UI","Noto Sans","DejaVu Sans",sans-serif}
.grid{stroke:#e9edf0}.tick{fill:#5b6670}svg .axis{fill:#1d252c;font-size:12.5px}
.rule{stroke:#8c98a3;stroke-dasharray:2 4;stroke-width:1.2}svg .ruleText{fill:#5b6670;font-size:11.5px}
.label{paint-order:stroke;stroke:#fff;stroke-width:3px;stroke-linejoin:round}svg .strong{font-size:14px;font-weight:700}
)";

/// Style sheet of all reports, embedded so that a report is self-contained.
inline constexpr const char* kReportStyle = R"(
:root{--ink:#1d252c;--soft:#5b6670;--line:#dfe4e8;--ground:#f6f8f9;--card:#fff;--good:#0b7a75;--bad:#b3261e}
*{box-sizing:border-box}
body{margin:0;background:var(--ground);color:var(--ink);font:15px/1.5 "Inter","Segoe UI","Noto Sans","DejaVu Sans",sans-serif}
main{max-width:1240px;margin:0 auto;padding:22px 28px 60px}
h1{font-size:25px;margin:0 0 2px;letter-spacing:-.01em}h2{font-size:19px;margin:34px 0 8px}h3{font-size:15px;margin:0 0 4px}
p{margin:4px 0 10px}.soft{color:var(--soft)}.small{font-size:13px}
.cards{display:grid;grid-template-columns:repeat(auto-fit,minmax(340px,1fr));gap:14px;margin:14px 0}
.card{background:var(--card);border:1px solid var(--line);border-radius:10px;padding:14px 18px}
.advice{border-left:5px solid var(--good);margin:14px 0}.advice b{font-size:17px}.advice ul{margin:6px 0 0;padding-left:18px}
.warning{border-left:5px solid #c98a00;background:#fff8e6}.good{color:var(--good);font-weight:600}.missed{color:var(--bad);font-weight:600}
.pair{display:grid;grid-template-columns:1fr 1fr;gap:14px}@media(max-width:900px){.pair{grid-template-columns:1fr}}
svg{width:100%;height:auto;display:block}
table{border-collapse:collapse;width:100%;font-size:11.5px;background:var(--card)}
th,td{padding:5px 4px;border-bottom:1px solid var(--line);text-align:right;white-space:nowrap}
th{color:var(--soft);font-weight:600;border-bottom:2px solid var(--line);vertical-align:bottom}
th:first-child,td:first-child,td.left,th.left{text-align:left}td.left{white-space:normal}td.left:first-child{white-space:nowrap}td.case{white-space:normal!important}
.case{min-width:330px}tr.strong td{font-weight:700}.pass{color:var(--good);font-weight:600}.fail{color:#fff;background:var(--bad);border-radius:4px;padding:1px 7px;font-weight:600}
.legend span{margin-right:18px;display:inline-block}
details>summary{cursor:pointer;margin:8px 0;color:var(--soft)}code{font-size:12px;word-break:break-all}
@media print{body{background:#fff}.card{break-inside:avoid}}
)";

} // namespace palpate::study
