header = strsplit(fgetl(fopen("reference/data/trajectories/relaxation.csv")), ",");
rows = dlmread("reference/data/trajectories/relaxation.csv", ",", 1, 0);
fprintf("%.15g\n", rows(rows(:, 1) == 1, strcmp(header, "y")));
