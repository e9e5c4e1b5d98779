% SPDX-License-Identifier: MIT
% fhbvm and fhbvm2 (systems of one order) and fhbvm2_2 (of two) of L. Brugnano, G. Gurioli, F. Iavernaro and
% M. Vikerpuur, on a mesh of their own. Other orders up to 1 become chains of rows (chain_orders). Options: n, nu
% (a graded mesh of nu points in [0, nT/N]).
function run = fhbvm_run(code, task, options)
  most = 1 + strcmp(code, "fhbvm2_2");
  if any([task.rows.order] == 0)
    refuse("takes no algebraic equations");
  end
  [orders, counts] = chain_orders([task.rows.order], most);
  if isempty(orders)
    refuse({"takes systems of one order", "takes systems of two orders between the same whole numbers"}{most});
  end
  [~, J, shown, run.columns] = system_of(task, "y(:,%d)");
  % All points at once: a row for each point, also where a formula is constant.
  f = handle_of({strcat("(", cellstr(task.system.rhs), ")+0*t")'}, "y(:,%d)");
  [f, J, heads, first_rows, size] = in_chains(f, J, counts);
  initial = initial_values(task.rows)';
  y0 = zeros(rows(initial), size);
  y0(:, heads) = initial;
  n = option(options, "n", 1);
  nu = max(option(options, "nu", 1), n);
  T = task.end_time;
  problem = @(varargin) right_hand_side(f, J, orders, first_rows, varargin{:});
  run.own_times = true;
  switch code
    case "fhbvm"
      solver = @(N) fhbvm(problem, y0, T, N);
    otherwise
      solver = @(N) feval(code, problem, y0, T, N, n, nu);
  end
  run.solve = @(N) columns_of(solver, N, heads(shown));
end

% The system with counts(i, k) rows of the k-th order for unknown i, those of the first order first: each row of a
% chain is the right-hand side of the one before. `heads` are the unknowns themselves.
function [f, J, heads, first_rows, size] = in_chains(f, J, counts)
  kinds = unknowns = [];
  for i = 1:rows(counts)
    kinds = [kinds, repelem(1:columns(counts), counts(i, :))];
    unknowns = [unknowns, repelem(i, sum(counts(i, :)))];
  end
  size = numel(kinds);
  first_rows = sum(kinds == 1);
  [~, sorted] = sort(kinds);
  place(sorted) = 1:size;
  starts = [true, diff(unknowns) > 0];
  ends = [starts(2:end), true];
  heads = place(starts);
  tails = place(ends);
  if isequal(heads, tails, 1:size)
    return;
  end
  next = zeros(size);
  next(sub2ind([size, size], place(! ends), place(! starts))) = 1;
  f = @(t, y) values_in_chains(f(t, y(:, heads)), y, next, tails);
  J = @(t, y) jacobian_in_chains(J(t, y(:, heads)), next, tails, heads);
end

function values = values_in_chains(last, y, next, tails)
  values = y * next';
  values(:, tails) = last;
end

function J = jacobian_in_chains(last, J, tails, heads)
  J(tails, heads) = last;
end

% As these codes call the problem: without arguments the orders, with three the Jacobian.
function [value, first_rows] = right_hand_side(f, J, orders, first_rows, t, y, ~)
  if nargin == 4
    value = orders;
  elseif nargin == 7
    value = J(t, y);
    value(! isfinite(value)) = 0; % of a root at the start
  else
    value = f(t, y);
  end
end

function [t, y] = columns_of(solver, N, shown)
  [t, y] = solver(N);
  y = y(:, shown)';
end
