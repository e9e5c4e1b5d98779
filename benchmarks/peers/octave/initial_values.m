% SPDX-License-Identifier: MIT
% The initial values: column k + 1 has the derivatives of order k, 0 where a row needs none.
function y0 = initial_values(rows)
  count = max(arrayfun(@(row) numel(row.initial), rows));
  y0 = zeros(numel(rows), count);
  for i = 1:numel(rows)
    y0(i, 1:numel(rows(i).initial)) = rows(i).initial;
  end
end
