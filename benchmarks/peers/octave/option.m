% SPDX-License-Identifier: MIT
% The number of this option, or a default.
function value = option(options, name, default)
  value = default;
  if isfield(options, name)
    value = str2double(strsplit(options.(name), ","));
  end
end
