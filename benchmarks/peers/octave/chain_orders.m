% SPDX-License-Identifier: MIT
% At most `most` (1 or 2) orders, such that each of the given is a sum of counts(i, :) of them, with as few rows as
% can be; empty if there are none. D^(a + b) y = f is the chain D^a y = z, D^b z = f with z(0) = 0, where a + b <= 1:
% then y has one initial value.
function [orders, counts] = chain_orders(given, most)
  orders = unique(given, "stable");
  fractional = orders(orders != fix(orders));
  if numel(orders) <= most && numel(fractional) == numel(orders) && all(ceil(orders) == ceil(orders(1)))
    counts = given' == orders;
    return;
  end
  candidates = num2cell(unique([fractional, fractional / 2]));
  if most == 2
    candidates = pairs_of(fractional, orders);
  end
  orders = counts = [];
  for k = 1:numel(candidates) * all(given <= 1)
    tried = counts_of(given, candidates{k});
    if ! isempty(tried) && (isempty(counts) || sum(tried(:)) < sum(counts(:)))
      used = any(tried, 1);
      [orders, counts] = deal(candidates{k}(used), tried(:, used));
    end
  end
end

% A fractional order a, and b such that one of the orders is the sum of some of both.
function pairs = pairs_of(fractional, orders)
  pairs = {};
  for a = fractional
    rests = (orders' - (0:2) * a)(:);
    for b = unique([rests; rests / 2])'
      if b > 1e-3 && b < 1
        pairs{end + 1} = [a, b];
      end
    end
  end
end

function counts = counts_of(given, orders)
  [first, second] = ndgrid(0:9, 0:9 * (numel(orders) - 1));
  sums = first * orders(1) + second * orders(end);
  counts = zeros(numel(given), numel(orders));
  for i = 1:numel(given)
    found = find(abs(sums(:) - given(i)) < 1e-12);
    if isempty(found)
      counts = [];
      return;
    end
    [~, least] = min(first(found) + second(found));
    counts(i, :) = [first(found(least)), second(found(least))](1:numel(orders));
  end
end
