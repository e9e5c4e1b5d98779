% D^0.5 y = -y, y(0) = 1 by Gruenwald-Letnikov with Octave: octave-cli relaxation.m STEPS OUT.csv; prints the seconds it took.
arguments = argv();
steps = str2double(arguments{1});
order = 0.5;
finish = 1;
tic;
weights = cumprod([1, 1 - (order + 1) ./ (1:steps)]);
step = (finish / steps) ^ order;
z = zeros(1, steps + 1); % y - 1
for k = 2:steps + 1
  past = weights(2:k) * z(k - 1:-1:1)';
  z(k) = (-past - step) / (1 + step);
end
seconds = toc;
file = fopen(arguments{2}, "w");
fprintf(file, "t,y\n");
fprintf(file, "%.17g,%.17g\n", [linspace(0, finish, steps + 1); z + 1]);
fclose(file);
printf("%.6g\n", seconds);
