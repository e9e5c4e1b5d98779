% SPDX-License-Identifier: MIT
% An explicit product rectangle rule, called like fde12: the tests of the adapter do not need the code of another.
function [t, y] = fde12(alpha, fdefun, t0, tfinal, y0, h, ~, ~)
  N = round((tfinal - t0) / h);
  t = t0 + h * (0:N);
  weights = h^alpha / gamma(alpha + 1) * diff((0:N) .^ alpha);
  y = repmat(y0, 1, N + 1);
  f = zeros(numel(y0), N);
  for n = 1:N
    f(:, n) = fdefun(t(n), y(:, n));
    y(:, n + 1) = y0 + f(:, 1:n) * weights(n:-1:1)';
  end
end
