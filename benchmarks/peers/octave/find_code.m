% SPDX-License-Identifier: MIT
% Makes a code known to Octave, and returns its file and the family of codes that its adapter is of.
function [file, family] = find_code(code)
  families = struct("fcoll", "collocation", "tsfcoll", "collocation", "fhbvm", "fhbvm", "fhbvm2", "fhbvm", ...
                    "fhbvm2_2", "fhbvm");
  family = "garrappa";
  folder = family;
  if isfield(families, code)
    family = families.(code);
    folder = family;
  end
  if strcmp(family, "collocation")
    folder = code;
  end
  peers = getenv("FDEBENCH_PEERS");
  if isempty(peers)
    error("the environment variable FDEBENCH_PEERS must name the folder with the codes");
  end
  addpath(fullfile(peers, folder));
  file = which(code);
  if isempty(file)
    error("%s is not in the folder %s", code, fullfile(peers, folder));
  end
end
