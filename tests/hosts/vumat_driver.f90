! SPDX-License-Identifier: BSD-3-Clause
! An explicit code in small: blocks of points through VUMAT, then one point through UMAT, by the names that Abaqus
! uses. Prints what test_vumat.py compares with the library.
program vumat_driver
  implicit none
  integer, parameter :: steps = 20
  integer :: nblock, states
  character(80) :: name, word
  call get_command_argument(1, name)
  call get_command_argument(2, word)
  read (word, *) nblock
  call get_command_argument(3, word)
  read (word, *) states
  call explicit(nblock, states)
  call implicit_point(states)

contains

  ! Strain increment of a component (1 to 6) of a point in a step; test_vumat.py has the same.
  real(8) function increment(point, component, step)
    integer, intent(in) :: point, component, step
    increment = 4d-4*sin(1.3d0*point + 0.7d0*component + 0.5d0*step)
    if (component <= 3) increment = increment - 3d-4
  end function

  subroutine explicit(n, ns)
    integer, intent(in) :: n, ns
    real(8) :: de(n, 6), old(n, 6), new(n, 6), state_old(n, ns), state_new(n, ns), none(n), density(n)
    real(8) :: internal_old(n), internal_new(n), plastic_old(n), plastic_new(n), props(1), spin(n, 3), grad(n, 9)
    real(8) :: dt
    integer :: k, c, step
    external :: vumat
    old = 0; state_old = 0; none = 0; density = 1; internal_old = 0; plastic_old = 0; spin = 0; grad = 0; props = 1
    dt = 1d-6
    do step = 0, steps
      do c = 1, 6
        do k = 1, n
          de(k, c) = increment(k, c, step)
        end do
      end do
      ! Step 0 is the data check: time 0, made-up strains, an elastic answer that is thrown away.
      call vumat(n, 3, 3, ns, 0, 1, 0, step*dt, step*dt, dt, name, none, none, props, density, de, spin, none, grad, &
        grad, none, old, state_old, internal_old, plastic_old, none, grad, grad, none, new, state_new, internal_new, &
        plastic_new)
      if (step == 0) then
        print '(a,6es25.16)', 'check', new(1, :)
        print '(a,es25.16)', 'virgin', maxval(abs(state_new))
      else
        old = new; state_old = state_new; internal_old = internal_new; plastic_old = plastic_new
      end if
    end do
    do k = 1, n
      print '(a,100es25.16)', 'point', old(k, :), state_old(k, :), internal_old(k), plastic_old(k)
    end do
  end subroutine

  ! Point 1 again, as an implicit code would: engineering shears, order 11 22 33 12 13 23.
  subroutine implicit_point(ns)
    integer, intent(in) :: ns
    integer, parameter :: order(6) = (/1, 2, 3, 4, 6, 5/)
    real(8) :: stress(6), state(ns), tangent(6, 6), sse, spd, scd, rpl, ddsddt(6), drplde(6), drpldt, stran(6), dstran(6)
    real(8) :: time(2), dt, temp, dtemp, predef(1), dpred(1), props(1), coords(3), drot(3, 3), pnewdt, celent, f0(3, 3), f1(3, 3)
    integer :: c, step
    external :: umat
    stress = 0; state = 0; tangent = 0; sse = 0; spd = 0; stran = 0; time = 0; dt = 1d-6; pnewdt = 1; props = 1
    drot = reshape([1d0, 0d0, 0d0, 0d0, 1d0, 0d0, 0d0, 0d0, 1d0], [3, 3])
    do step = 1, steps
      do c = 1, 6
        dstran(c) = increment(1, order(c), step)
        if (c > 3) dstran(c) = 2*dstran(c)
      end do
      call umat(stress, state, tangent, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dt, temp, dtemp, &
        predef, dpred, name, 3, 3, 6, ns, props, 1, coords, drot, pnewdt, celent, f0, f1, 1, 1, 1, 1, 1, step)
    end do
    print '(a,100es25.16)', 'umat', stress(order), state, sse, spd
    print '(a,36es25.16)', 'tangent', tangent
    print '(a,es25.16)', 'pnewdt', pnewdt
    ! A step that cannot be: nothing changes, and a quarter of it is asked for.
    dstran = 0; dstran(1) = -50
    call umat(stress, state, tangent, sse, spd, scd, rpl, ddsddt, drplde, drpldt, stran, dstran, time, dt, temp, dtemp, &
      predef, dpred, name, 3, 3, 6, ns, props, 1, coords, drot, pnewdt, celent, f0, f1, 1, 1, 1, 1, 1, steps)
    print '(a,100es25.16)', 'kept', stress(order), state, sse, spd
    print '(a,es25.16)', 'cut', pnewdt
  end subroutine
end program
