% SPDX-License-Identifier: MIT
% The rows of a solution that are columns of the scene.
function [t, y] = shown_rows(solve, shown)
  [t, y] = solve();
  y = y(shown, :);
end
