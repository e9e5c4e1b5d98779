// SPDX-License-Identifier: MIT
// The files of the page and of the help as bytes in the program, so that it needs no installed data. Paths are relative to
// this folder, which the build puts on the include path. Files of one asset follow each other.

#define BEGIN(id) .global fde_asset_##id; fde_asset_##id:
#define END(id) .global fde_asset_##id##_end; fde_asset_##id##_end:
#define QUOTED(path) #path
#define TEXT(path) .incbin QUOTED(path); .ascii "\n"
#define LICENCE_IN(package, file) .ascii QUOTED(package), "\n\n"; TEXT(node_modules/package/file); .ascii "\n\n"
#define LICENCE(package) LICENCE_IN(package, LICENSE)

  .section .rodata

BEGIN(page)
  TEXT(page/page.html)
END(page)

BEGIN(style)
  TEXT(page/page.css)
END(style)

BEGIN(charts)
  TEXT(page/numbers.js)
  TEXT(page/say.js)
  TEXT(page/statements.js)
  TEXT(page/runs.js)
  .ascii "const placesOfSchemes = {"
#define FDE_SCHEME(id, mark) .ascii QUOTED(id), ": ", QUOTED(mark), ", "
#include "../schemes/list.def"
  .ascii "};\n"
  TEXT(page/scheme_marks.js)
  TEXT(page/charts.js)
  TEXT(page/line_labels.js)
  TEXT(page/section_charts.js)
  TEXT(page/region_charts.js)
  TEXT(page/drift_charts.js)
  TEXT(page/motion_charts.js)
  TEXT(page/solution_charts.js)
  TEXT(page/family_charts.js)
  TEXT(page/winner_map.js)
END(charts)

BEGIN(plot)
  TEXT(plot/residual_chart.js)
  TEXT(plot/figure_style.js)
  TEXT(plot/figure_width.js)
  TEXT(plot/plot.js)
END(plot)

BEGIN(regions)
  TEXT(page/regions.json)
END(regions)

BEGIN(script)
  TEXT(page/unpacked.js)
  TEXT(page/mathml.js)
  TEXT(page/section_texts.js)
  TEXT(page/section_tables.js)
  TEXT(page/fact_tables.js)
  TEXT(page/chart_table.js)
  TEXT(page/tables.js)
  TEXT(page/cell_dialog.js)
  TEXT(page/view.js)
  TEXT(page/page.js)
END(script)

// The topics of `fdebench help`.
#define FDE_TOPIC(id, name) BEGIN(topic_##id) TEXT(command/topics/id.txt); END(topic_##id)
#include "command/topics.def"

// The scripts with which shells complete `fdebench`.
#define FDE_SHELL(id) BEGIN(completion_##id) .incbin QUOTED(command/completions/id); END(completion_##id)
#include "command/shells.def"

// Without the packages of setup.sh these are empty, and `fdebench report` says so.
BEGIN(vega)
#ifndef FDEBENCH_NO_CHARTS
  TEXT(node_modules/vega/build/vega.min.js)
  TEXT(node_modules/vega-lite/build/vega-lite.min.js)
  TEXT(node_modules/vega-embed/build/vega-embed.min.js)
#endif
END(vega)

// Of the three builds, and of what is bundled in them.
BEGIN(licences)
#ifndef FDEBENCH_NO_CHARTS
  LICENCE(vega)
  LICENCE(vega-lite)
  LICENCE(vega-embed)
  LICENCE(d3-array)
  LICENCE(d3-color)
  LICENCE(d3-delaunay)
  LICENCE(d3-dispatch)
  LICENCE(d3-dsv)
  LICENCE(d3-ease)
  LICENCE(d3-force)
  LICENCE(d3-format)
  LICENCE(d3-geo)
  LICENCE(d3-geo-projection)
  LICENCE(d3-hierarchy)
  LICENCE(d3-interpolate)
  LICENCE(d3-path)
  LICENCE(d3-quadtree)
  LICENCE(d3-scale)
  LICENCE(d3-scale-chromatic)
  LICENCE(d3-shape)
  LICENCE(d3-time)
  LICENCE(d3-time-format)
  LICENCE(d3-timer)
  LICENCE(delaunator)
  LICENCE(internmap)
  LICENCE(robust-predicates)
  LICENCE(topojson-client)
  LICENCE_IN(fast-json-patch, LICENSE.txt)
  LICENCE(json-stringify-pretty-compact)
  LICENCE(semver)
  LICENCE_IN(tslib, LICENSE.txt)
#endif
END(licences)

#if defined(__ELF__)
  .section .note.GNU-stack, "", %progbits
#endif
