% SPDX-License-Identifier: MIT
% fhbvm and fhbvm2 (systems of one order) and fhbvm2_2 (of two, the rows of the first order first) of
% L. Brugnano, G. Gurioli, F. Iavernaro and M. Vikerpuur, on a mesh of their own. Options: n, nu (a graded mesh
% of nu points in [0, nT/N]).
function run = fhbvm_run(code, task, options)
  rows = [task.rows.order];
  orders = unique(rows, "stable");
  most = 1 + strcmp(code, "fhbvm2_2");
  if any(orders == 0)
    refuse("takes no algebraic equations");
  elseif numel(orders) > most
    refuse({"takes systems of one order", "takes systems of two orders"}{most});
  elseif any(orders == fix(orders))
    refuse("takes no whole orders");
  elseif any(diff(rows == orders(1)) > 0)
    refuse("takes the rows of one order after those of the other");
  end
  [~, J, shown, run.columns] = system_of(task, "y(:,%d)");
  % All points at once: a row for each point, also where a formula is constant.
  f = handle_of({strcat("(", cellstr(task.system.rhs), ")+0*t")'}, "y(:,%d)");
  y0 = initial_values(task.rows)';
  n = option(options, "n", 1);
  nu = max(option(options, "nu", 1), n);
  T = task.end_time;
  problem = @(varargin) right_hand_side(f, J, orders, sum(rows == orders(1)), varargin{:});
  run.own_times = true;
  switch code
    case "fhbvm"
      solver = @(N) fhbvm(problem, y0, T, N);
    otherwise
      solver = @(N) feval(code, problem, y0, T, N, n, nu);
  end
  run.solve = @(N) rows_of(solver, N, shown);
end

% As these codes call the problem: without arguments the orders, with three the Jacobian.
function [value, first_rows] = right_hand_side(f, J, orders, first_rows, t, y, ~)
  if nargin == 4
    value = orders;
  elseif nargin == 7
    value = J(t, y);
  else
    value = f(t, y);
  end
end

function [t, y] = rows_of(solver, N, shown)
  [t, y] = solver(N);
  y = y(:, shown)';
end
