folder = "reference/data";
package = jsondecode(fileread([folder "/datapackage.json"]));
path = package.resources(strcmp({package.resources.name}, "trajectories.relaxation")).path;
header = strsplit(fgetl(fopen([folder "/" path])), ",");
rows = dlmread([folder "/" path], ",", 1, 0);
fprintf("%.15g\n", rows(rows(:, 1) == 1, strcmp(header, "y")));
