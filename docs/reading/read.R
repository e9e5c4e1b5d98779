folder <- "reference/data"
tables <- jsonlite::fromJSON(file.path(folder, "datapackage.json"))$resources
path <- tables$path[tables$name == "trajectories.relaxation"]
rows <- read.csv(file.path(folder, path))
cat(sprintf("%.15g\n", rows$y[rows$t == 1]))
