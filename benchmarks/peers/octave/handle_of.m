% SPDX-License-Identifier: MIT
% The function of t and y whose value is the matrix of these formulas (a cell row for each row of the matrix).
% `variable` is the text of the unknown y_i, "y(%d)" or another with the place of its number.
function f = handle_of(formulas, variable)
  rows = cellfun(@(row) strjoin(cellstr(row), ","), formulas, "UniformOutput", false);
  text = strrep(strrep(strjoin(rows(:)', ";"), "*", ".*"), "/", "./");
  text = regexprep(text, '\<y(\d+)\>', strrep(variable, "%d", "$1"));
  f = eval(["@(t, y) [" text "]"]);
end
