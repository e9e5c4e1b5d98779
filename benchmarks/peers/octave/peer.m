% SPDX-License-Identifier: MIT
% Solves the equation of a task (docs/external_solvers.md) with a public code:
%   octave-cli --norc --quiet --no-history peer.m CODE [OPTION VALUE]... TASK
% The environment variable FDEBENCH_PEERS names the folder with the codes; docs/peers.md says what is in it.
addpath(fileparts(mfilename("fullpath")));
words = argv();
task = jsondecode(fileread(words{end}));
options = struct(words{2:end-1});
printf("# language: GNU Octave %s\n", OCTAVE_VERSION);
try
  [file, family] = find_code(words{1});
  printf("# code: %s\n", strtrim([words{1} " " version_of(file)]));
  run = peer_named(words{1}, family, task, options);
  start = tic;
  said = evalc("[t, y] = run.solve(task.steps);"); % some codes print
  first = toc(start);
  if t(end) < task.end_time * (1 - 1e-9)
    error("ends at t = %g%s", t(end), regexprep([": " strtrim(said)], '^: $', ""));
  end
  seconds = [];
  while task.timed && (isempty(seconds) || (numel(seconds) < 5 && sum(seconds) < 0.5))
    start = tic;
    evalc("run.solve(task.steps);");
    seconds(end + 1) = toc(start);
  end
catch failure
  warning("off", "all"); % fhbvm2_2 turns all on, and Octave warns while it ends: the last line is the reason
  fprintf(stderr, "%s\n", strtrim(strsplit(failure.message, "\n"){1}));
  if strcmp(failure.identifier, "peer:refused")
    exit(77);
  end
  exit(1);
end
if task.timed
  printf("# first: %.9g\n# seconds:%s\n", first, sprintf(" %.9g", seconds));
end
t = t(:)';
if run.own_times
  printf("# times: own\n");
else
  places = interp1(t, 1:numel(t), task.times', "nearest", "extrap");
  y = y(:, places);
  t = task.times';
end
printf("t,%s\n", strjoin(run.columns, ","));
printf([strjoin(repmat({"%.17g"}, 1, rows(y) + 1), ",") "\n"], [t; y]);
