% SPDX-License-Identifier: MIT
% How a code of this family solves the task: solve(N) returns times and values (a row for each of `columns`),
% own_times whether the times are its own.
function run = peer_named(code, family, task, options)
  if ! isfield(task, "system")
    refuse("the adapter needs the right-hand sides as formulas, which this scene does not have");
  end
  if any(strfind(jsonencode(task.system), "mittag_leffler"))
    refuse("the adapter has no Mittag-Leffler function");
  end
  given = cellfun(@numel, {task.rows.initial});
  if any(strcmp({task.rows.side}, "right")) || any(given < ceil([task.rows.order]))
    refuse("takes initial-value problems only");
  end
  run = feval([family "_run"], code, task, options);
end
