% SPDX-License-Identifier: MIT
% The right-hand sides and their Jacobian as functions, and the rows that are columns of the scene.
function [f, J, shown, columns] = system_of(task, variable)
  f = handle_of(task.system.rhs, variable);
  J = handle_of(task.system.jacobian, variable);
  columns = cellstr(task.system.columns);
  shown = find(! cellfun(@isempty, columns))';
  columns = columns(shown);
end
