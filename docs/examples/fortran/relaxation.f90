module fdebench
  use, intrinsic :: iso_c_binding
  implicit none
  interface
    function fdebench_problem_new(unknowns, orders, initial_count, initial, end, f, user, problem) &
        bind(c) result(status)
      import :: c_size_t, c_double, c_funptr, c_ptr, c_int
      integer(c_size_t), value :: unknowns, initial_count
      real(c_double), intent(in) :: orders(*), initial(*)
      real(c_double), value :: end
      type(c_funptr), value :: f
      type(c_ptr), value :: user
      type(c_ptr), intent(out) :: problem
      integer(c_int) :: status
    end function
    function fdebench_options_new(options) bind(c) result(status)
      import :: c_ptr, c_int
      type(c_ptr), intent(out) :: options
      integer(c_int) :: status
    end function
    function fdebench_options_set_integer(options, name, value) bind(c) result(status)
      import :: c_ptr, c_char, c_long_long, c_int
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: name(*)
      integer(c_long_long), value :: value
      integer(c_int) :: status
    end function
    function fdebench_options_set_text(options, name, value) bind(c) result(status)
      import :: c_ptr, c_char, c_int
      type(c_ptr), value :: options
      character(kind=c_char), intent(in) :: name(*), value(*)
      integer(c_int) :: status
    end function
    function fdebench_solve(problem, scheme, options, table) bind(c) result(status)
      import :: c_ptr, c_char, c_int
      type(c_ptr), value :: problem, options
      character(kind=c_char), intent(in) :: scheme(*)
      type(c_ptr), intent(out) :: table
      integer(c_int) :: status
    end function
    function fdebench_table_values(table, values, capacity) bind(c) result(status)
      import :: c_ptr, c_double, c_size_t, c_int
      type(c_ptr), value :: table
      real(c_double), intent(out) :: values(*)
      integer(c_size_t), value :: capacity
      integer(c_int) :: status
    end function
    function fdebench_last_error() bind(c) result(message)
      import :: c_ptr
      type(c_ptr) :: message
    end function
    subroutine fdebench_table_free(table) bind(c)
      import :: c_ptr
      type(c_ptr), value :: table
    end subroutine
    subroutine fdebench_options_free(options) bind(c)
      import :: c_ptr
      type(c_ptr), value :: options
    end subroutine
    subroutine fdebench_problem_free(problem) bind(c)
      import :: c_ptr
      type(c_ptr), value :: problem
    end subroutine
    function puts(text) bind(c) result(written)
      import :: c_ptr, c_int
      type(c_ptr), value :: text
      integer(c_int) :: written
    end function
  end interface
contains
  ! Stops with the message of a call that failed.
  subroutine check(status)
    integer(c_int), intent(in) :: status
    integer(c_int) :: written
    if (status == 0) return
    written = puts(fdebench_last_error())
    stop 1
  end subroutine
end module

module equation
  use, intrinsic :: iso_c_binding
  implicit none
contains
  ! D^0.5 y = -y, y(0) = 1, whose solution is e^t erfc(sqrt(t)).
  function f(t, y, dydt, user) bind(c) result(status)
    real(c_double), value :: t
    real(c_double), intent(in) :: y(*)
    real(c_double), intent(out) :: dydt(*)
    type(c_ptr), value :: user
    integer(c_int) :: status
    dydt(1) = -y(1)
    status = 0
  end function
end module

program relaxation
  use fdebench
  use equation
  implicit none
  integer(c_size_t), parameter :: one = 1
  type(c_ptr) :: problem, options, table
  real(c_double) :: y(2)
  call check(fdebench_problem_new(one, [0.5_c_double], one, [1.0_c_double], 1.0_c_double, &
      c_funloc(f), c_null_ptr, problem))
  call check(fdebench_options_new(options))
  call check(fdebench_options_set_integer(options, "steps"//c_null_char, 4096_c_long_long))
  call check(fdebench_options_set_text(options, "grid"//c_null_char, "graded:2"//c_null_char))
  call check(fdebench_options_set_integer(options, "points"//c_null_char, 2_c_long_long))
  call check(fdebench_solve(problem, "product_trapezoidal"//c_null_char, options, table))
  call check(fdebench_table_values(table, y, 2_c_size_t))
  print '(a, f11.9, a, es7.1)', "y(1) = ", y(2), ", error ", &
      abs(y(2) - exp(1.0_c_double) * erfc(1.0_c_double))
  call fdebench_table_free(table)
  call fdebench_options_free(options)
  call fdebench_problem_free(problem)
end program
