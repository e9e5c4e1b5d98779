% SPDX-License-Identifier: MIT
% 0 for x < 0, 1/2 at 0, 1 for x > 0.
function s = step(x)
  s = (sign(x) + 1) / 2;
end
