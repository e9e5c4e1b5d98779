% SPDX-License-Identifier: MIT
% The order of a system whose rows all have the same; otherwise the task is refused.
function order = single_order(task)
  order = task.rows(1).order;
  if any([task.rows.order] != order)
    refuse("takes systems of one order");
  end
  if order == 0
    refuse("takes no algebraic equations");
  end
end
