% SPDX-License-Identifier: MIT
% The only equation of a task in multi-term form, with the derivative of its right-hand side, and its column.
% The derivative is that of the last row of the chain, of which the right-hand side is a part.
function [equation, columns] = multi_term_equation(task)
  if ! isfield(task, "multi_term") || numel(task.multi_term) != 1
    refuse("the adapter takes one equation, linear in its derivatives");
  end
  equation = task.multi_term;
  rows = task.system.jacobian;
  last = cellstr(rows{end});
  leading = equation.coefficients(end);
  without_derivative = sum(equation.coefficients(equation.orders == 0));
  equation.derivative = sprintf("((%.17g*%s)+%.17g)", leading, last{1}, without_derivative);
  columns = cellstr(task.system.columns)(1);
end
