//! How the page looks.

/// Colours follow the reader's choice of light or dark.
pub(super) const CSS: &str = "
:root{--bg:#fbfaf7;--ink:#22211d;--soft:#6d6a61;--line:#d9d5c9;--card:#ffffff;--a:#1f6f8b;--b:#c2571a;--c:#5b7f2b;--d:#8a4f9e;--e:#b08900;--bad:#b3261e;--good:#2e7d32}
@media(prefers-color-scheme:dark){:root{--bg:#161614;--ink:#ece8dd;--soft:#a29d90;--line:#3a3831;--card:#1f1e1b;--a:#6cc0dc;--b:#f0935c;--c:#a5cf6b;--d:#d19be4;--e:#e6c457;--bad:#ff8a80;--good:#81c784}}
*{box-sizing:border-box}
body{margin:0;background:var(--bg);color:var(--ink);font:15px/1.5 system-ui,'DejaVu Sans',sans-serif}
main{max-width:1180px;margin:0 auto;padding:28px 22px 60px}
h1{font-size:28px;margin:0 0 4px}h2{font-size:19px;margin:34px 0 6px}
.sub,.note{color:var(--soft);margin:2px 0 10px}.note{font-size:13px}
.plots{display:grid;grid-template-columns:repeat(auto-fit,minmax(520px,1fr));gap:18px}
figure{margin:0;background:var(--card);border:1px solid var(--line);border-radius:8px;padding:12px 14px}
figure.wide{grid-column:1/-1}
figcaption{font-size:13px;color:var(--soft);margin-top:6px}
figure h3{font-size:15px;margin:0 0 4px}
svg{width:100%;height:auto;display:block}
svg text{fill:var(--ink);font:14px system-ui,'DejaVu Sans',sans-serif}
svg .tick{fill:var(--soft);font-size:13px}svg .name{font-weight:700;font-size:15px}
svg .grid{stroke:var(--line);stroke-width:1}svg .front{fill:none;stroke:var(--ink);stroke-width:1.6;opacity:.75}
svg .halo{paint-order:stroke;stroke:var(--card);stroke-width:4px}
.k0{fill:var(--a);stroke:var(--a)}.k1{fill:var(--b);stroke:var(--b)}.k2{fill:var(--c);stroke:var(--c)}.k3{fill:var(--d);stroke:var(--d)}.k4{fill:var(--e);stroke:var(--e)}.k5{fill:var(--soft);stroke:var(--soft)}
.open{fill:var(--card)}.mark{stroke-width:1.5;fill-opacity:.75}.preset{fill:none;stroke:var(--ink);stroke-width:2}
table{border-collapse:collapse;font-size:13px;background:var(--card);width:100%}
th,td{border-bottom:1px solid var(--line);padding:4px 8px;text-align:right;white-space:nowrap}
th:first-child,td:first-child,td.l,th.l{text-align:left}td.w{white-space:normal}
.scroll{overflow-x:auto;border:1px solid var(--line);border-radius:8px}
.good{color:var(--good);font-weight:600}.bad{color:var(--bad);font-weight:600}
summary{cursor:pointer;margin:10px 0;font-weight:600}ul{margin:6px 0;padding-left:20px}
";
