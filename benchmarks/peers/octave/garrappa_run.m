% SPDX-License-Identifier: MIT
% Codes of R. Garrappa: fde12, flmm2 (systems of one order), fde_pi* (one order for each row), mt_fde_pi*
% (multi-term equations). Options: mu (predictor-corrector), method (flmm2), tol (Newton's method).
function run = garrappa_run(code, task, options)
  T = task.end_time;
  mu = option(options, "mu", 1);
  tol = option(options, "tol", 1e-6); % the default of the codes
  run = struct("own_times", false, "columns", {{}}, "solve", []);
  if strncmp(code, "mt_", 3)
    of = multi_term_equation(task);
    run.columns = of.columns;
    if strcmp(code, "mt_fde_pi1_ex")
      run.solve = @(N) mt_fde_pi1_ex(of.orders, of.coefficients, of.f, 0, T, of.y0, T / N);
    elseif strcmp(code, "mt_fde_pi12_pc")
      run.solve = @(N) mt_fde_pi12_pc(of.orders, of.coefficients, of.f, 0, T, of.y0, T / N, [], mu);
    else
      run.solve = @(N) feval(code, of.orders, of.coefficients, of.f, of.J, 0, T, of.y0, T / N, [], tol);
    end
    return;
  end
  [f, J, shown, run.columns] = system_of(task, "y(%d)");
  orders = [task.rows.order]';
  y0 = initial_values(task.rows);
  if any(strcmp(code, {"fde12", "flmm2"}))
    orders = single_order(task);
  elseif any(orders == 0)
    refuse("takes no algebraic equations");
  end
  switch code
    case "fde12"
      run.solve = @(N) shown_rows(@() fde12(orders, f, 0, T, y0, T / N, [], mu), shown);
    case "flmm2"
      method = option(options, "method", 3);
      run.solve = @(N) shown_rows(@() flmm2(orders, f, J, 0, T, y0, T / N, [], method, tol), shown);
    case "fde_pi1_ex"
      run.solve = @(N) shown_rows(@() fde_pi1_ex(orders, f, 0, T, y0, T / N), shown);
    case "fde_pi12_pc"
      run.solve = @(N) shown_rows(@() fde_pi12_pc(orders, f, 0, T, y0, T / N, [], mu), shown);
    otherwise
      run.solve = @(N) shown_rows(@() feval(code, orders, f, J, 0, T, y0, T / N, [], tol), shown);
  end
end
