% SPDX-License-Identifier: MIT
% Ends the run as refused: the code does not take this equation.
function refuse(reason)
  error("peer:refused", "%s", reason);
end
