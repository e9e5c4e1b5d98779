% SPDX-License-Identifier: MIT
% fcoll and tsfcoll, spline collocation of A. Cardone, D. Conte and B. Paternoster on t_n = T (n/N)^r: scalar
% equations. Options: eta (collocation parameters, 0.5,1 as in their tests), r.
function run = collocation_run(code, task, options)
  if numel(task.rows) != 1
    refuse("takes scalar equations");
  end
  order = single_order(task);
  warning("off", "Octave:shadowed-function");
  addpath(fullfile(fileparts(mfilename("fullpath")), "matlab"));
  f = handle_of(task.system.rhs, "y");
  eta = option(options, "eta", [0.5, 1])';
  r = option(options, "r", 1);
  initial = task.rows.initial(:);
  run = struct("own_times", true, "columns", {cellstr(task.system.columns)}, "solve", []);
  run.solve = @(N) spline(code, f, task.end_time, initial, order, eta, r, N);
end

function [t, y] = spline(code, f, T, initial, order, eta, r, N)
  [t, y] = feval(code, f, T, initial, order, eta, r, N);
  y = y(:)';
end
