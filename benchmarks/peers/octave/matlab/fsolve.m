% SPDX-License-Identifier: MIT
% fsolve as MATLAB has it: further arguments are passed to the function. Octave's takes three only.
function varargout = fsolve(f, x0, options, varargin)
  persistent octave_fsolve
  if isempty(octave_fsolve)
    here = fileparts(mfilename("fullpath"));
    rmpath(here);
    octave_fsolve = @fsolve;
    octave_fsolve(@(x) x, 0); % binds the handle to Octave's function
    addpath(here);
  end
  [varargout{1:max(1, nargout)}] = octave_fsolve(@(x) f(x, varargin{:}), x0, options);
end
