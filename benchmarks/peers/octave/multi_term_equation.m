% SPDX-License-Identifier: MIT
% The multi-term equation of a task, sum of coefficients(k) D^orders(k) y = f(t, y), with the Jacobian of f, the
% initial values y0 (a row for each unknown) and the columns. Of several unknowns the left sides have to be the same.
% The Jacobian is that of the last row of each chain, of which the right-hand side is a part.
function equation = multi_term_equation(task)
  if ! isfield(task, "multi_term")
    refuse("the adapter takes equations that are linear in their derivatives");
  end
  terms = task.multi_term;
  equation.orders = terms(1).orders(:)';
  equation.coefficients = terms(1).coefficients(:)';
  for term = terms(:)'
    if ! isequal(term.orders(:)', equation.orders) || ! isequal(term.coefficients(:)', equation.coefficients)
      refuse("takes systems whose equations have the same derivatives on the left");
    end
  end
  unknowns = cellfun(@(name) str2double(name(2:end)), {terms.unknown});
  lasts = [unknowns(2:end) - 1, numel(task.rows)];
  rhs = {terms.rhs};
  derivatives = cell(numel(unknowns), 1);
  for i = 1:numel(unknowns)
    row = cellstr(task.system.jacobian{lasts(i)});
    derivatives{i} = strcat(sprintf("%.17g*", equation.coefficients(end)), row(unknowns))(:)';
  end
  for i = 1:numel(unknowns)
    replaced = sprintf('\\<y%d\\>', unknowns(i));
    rhs = regexprep(rhs, replaced, sprintf("y(%d)", i));
    derivatives = cellfun(@(row) regexprep(row, replaced, sprintf("y(%d)", i)), derivatives, "UniformOutput", false);
  end
  equation.f = handle_of(rhs, "y(%d)");
  last = handle_of(derivatives, "y(%d)");
  on_the_left = sum(equation.coefficients(equation.orders == 0)) * eye(numel(unknowns));
  equation.J = @(t, y) last(t, y) + on_the_left;
  equation.y0 = initial_values(terms);
  equation.columns = cellstr(task.system.columns)(unknowns);
end
