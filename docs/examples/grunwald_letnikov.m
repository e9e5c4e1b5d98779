% D^gamma y = lambda y by Gruenwald-Letnikov with Octave:
% fdebench run --external "octave=octave-cli --norc --quiet --no-history grunwald_letnikov.m" --scene relaxation ...
task = jsondecode(fileread(argv(){end}));
if (! strcmp(task.scene, "relaxation") || task.parameters.gamma >= 1 || ! strcmp(task.grid, "uniform"))
  fputs(stderr, "solves relaxation with gamma < 1 on the uniform grid\n");
  exit(77);
end
order = task.parameters.gamma;
rate = task.parameters.lambda;
start = task.parameters.y0;
steps = task.steps;
finish = task.end_time;
tic;
weights = cumprod([1, 1 - (order + 1) ./ (1:steps)]);
step = (finish / steps) ^ order;
z = zeros(1, steps + 1); % y - start
for k = 2:steps + 1
  past = weights(2:k) * z(k - 1:-1:1)';
  z(k) = (step * rate * start - past) / (1 - step * rate);
end
seconds = toc;
rows = round(task.times' / finish * steps) + 1;
printf("# seconds: %.9g\n", seconds);
printf("t,y\n");
printf("%.17g,%.17g\n", [task.times'; z(rows) + start]);
