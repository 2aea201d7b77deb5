! Fortran: grains of different radii fall into a tray that is shaken up and down:  grains [amplitude of the tray in metres]
!
! A discrete-element method: linear springs and dashpots between grains, symplectic Euler. All contact with the tray goes through fccda, by the
! module that is installed with it (fccda.f90). The tray is an open surface, five quads whose normals point to the grains.
program grains
  use fccda
  use, intrinsic :: iso_fortran_env, only: error_unit
  implicit none

  integer, parameter :: side = 5, n = side**3, steps_per_period = 400, periods = 10
  real(c_double), parameter :: pi = acos(-1d0), gravity = 9.81d0, half_width = 0.25d0, height = 1d0  ! [m/s2], [m]
  real(c_double), parameter :: stiffness = 2d4, damping = 5d0, friction = 0.4d0                      ! [N/m], [N s/m], [-]
  real(c_double), parameter :: period = 0.2d0, dt = period / steps_per_period                        ! [s]

  ! in the order of a solver: (3, n)
  real(c_double), target :: x_t0(3, n), x_t1(3, n), v(3, n), mass(n), radius(n)
  real(c_double) :: force(3, n), amplitude, momentum_error, impulse_z, weight, largest_force, mean_force
  type(c_ptr) :: surface, detector, tray
  type(fccda_points) :: points
  type(fccda_motion) :: motion
  type(fccda_contact_sum) :: on_tray
  integer(c_size_t) :: found, contacts
  integer :: step, outside

  if (fccda_abi_version() /= FCCDA_ABI_VERSION_OF_MODULE) error stop "fccda.f90 and the library have different binary interfaces"
  amplitude = argument(0.02d0)
  call place_grains
  call make_tray(surface, tray)
  call expect_ok(fccda_detector_create(surface, 0d0, detector))
  call fccda_surface_destroy(surface)  ! the detector keeps what it needs
  points = fccda_points(x_t0=fccda_xyz(x_t0), x_t1=fccda_xyz(x_t1), velocity=fccda_xyz(v), mass=fccda_each(mass), &
    radius=fccda_each(radius))

  weight = gravity * sum(mass)
  impulse_z = 0; momentum_error = 0; largest_force = 0; mean_force = 0
  contacts = 0; outside = 0
  do step = 1, periods * steps_per_period
    call add_pair_forces
    x_t0 = x_t1
    v = v + dt * force / spread(mass, 1, 3)
    x_t1 = x_t1 + dt * v
    call expect_ok(fccda_body_drive(tray, 2, mean_speed(step)))
    call expect_ok(fccda_body_advance(tray, dt, motion))
    call expect_ok(fccda_detect(detector, motion, points, found))
    call expect_ok(fccda_respond(detector, motion, points, friction, tray, on_tray))

    contacts = contacts + found
    outside = outside + grains_outside(motion%t1%position(3))
    impulse_z = impulse_z + on_tray%impulse(3)
    largest_force = max(largest_force, -on_tray%impulse(3) / dt)
    if (step > (periods - 2) * steps_per_period) mean_force = mean_force - on_tray%impulse(3) / (2 * period)
    momentum_error = max(momentum_error, abs(dot_product(mass, v(3, :)) + impulse_z + weight * dt * step))
  end do

  print '(i0, a, i0, a, i0, a)', n, " grains, ", contacts, " contacts with the tray, ", outside, " grains ever outside"
  print '(a, f7.4, a, f9.4)', "mean force on the tray in the last two periods / weight: ", mean_force / weight, "; largest: ", &
    largest_force / weight
  print '(a, es8.1, a)', "kinetic energy at the end: ", 0.5d0 * sum(mass * sum(v**2, 1)), " J"
  print '(a, es8.1, a)', "momentum of the grains + impulse on the tray - impulse of gravity: ", &
    momentum_error / (weight * periods * period), " of the latter at most"
  call fccda_detector_destroy(detector)
  call fccda_body_destroy(tray)

contains

  subroutine expect_ok(status)
    integer(c_int), intent(in) :: status
    if (status == FCCDA_OK) return
    write (error_unit, '(2a)') "error: ", fccda_message()
    stop 2, quiet=.true.
  end subroutine

  function argument(default) result(number)
    real(c_double), intent(in) :: default
    real(c_double) :: number
    character(len=32) :: text
    integer :: status
    number = default
    call get_command_argument(1, text, status=status)
    if (status == 0) read (text, *) number
  end function

  subroutine place_grains
    integer :: i, j, k, grain
    grain = 0
    do k = 0, side - 1
      do j = 0, side - 1
        do i = 0, side - 1
          grain = grain + 1
          radius(grain) = 0.02d0 + 0.005d0 * mod(7 * grain, 11) / 10d0
          x_t1(:, grain) = 0.06d0 * [i - 2, j - 2, k + 1] + [0.003d0 * mod(grain, 5), 0.002d0 * mod(grain, 7), 0d0]
        end do
      end do
    end do
    mass = 2500 * 4 / 3d0 * pi * radius**3
    v = 0
  end subroutine

  !> Vertices are numbered from 0.
  subroutine make_tray(surface, body)
    type(c_ptr), intent(out) :: surface, body
    real(c_double), target :: corners(3, 8)
    integer(c_int32_t) :: quads(4, 5)
    type(fccda_surface_options) :: options
    type(fccda_body_properties) :: properties
    integer :: c
    do c = 0, 7
      corners(:, c + 1) = [half_width * merge(1, -1, any(c == [1, 2, 5, 6])), half_width * merge(1, -1, mod(c, 4) > 1), &
                           merge(height, 0d0, c > 3)]
    end do
    quads = reshape([0, 1, 2, 3, 0, 4, 5, 1, 1, 5, 6, 2, 2, 6, 7, 3, 3, 7, 4, 0], [4, 5])
    options%orientation = FCCDA_NORMALS
    call expect_ok(fccda_surface_create(fccda_xyz(corners), quads, 5_c_size_t, 4, options, surface))
    properties = fccda_fixed_body(1d0)
    call expect_ok(fccda_body_create(properties, body))
  end subroutine

  !> Of the tray in a step: with it, it is at amplitude (1 - cos(2 pi t/T)) at the end of each.
  pure function mean_speed(step) result(speed)
    integer, intent(in) :: step
    real(c_double) :: speed
    speed = amplitude * (cos(2 * pi * (step - 1) / steps_per_period) - cos(2 * pi * step / steps_per_period)) / dt
  end function

  subroutine add_pair_forces
    real(c_double) :: apart(3), distance, overlap, along(3), push(3)
    integer :: i, j
    force = 0
    force(3, :) = -gravity * mass
    do j = 2, n
      do i = 1, j - 1
        apart = x_t1(:, j) - x_t1(:, i)
        distance = norm2(apart)
        overlap = radius(i) + radius(j) - distance
        if (overlap <= 0) cycle
        along = apart / distance
        push = max(0d0, stiffness * overlap - damping * dot_product(v(:, j) - v(:, i), along)) * along
        force(:, j) = force(:, j) + push
        force(:, i) = force(:, i) - push
      end do
    end do
  end subroutine

  !> By the planes of the tray, without fccda. Relocated grains are at their radius from the surface, to rounding.
  function grains_outside(floor) result(number)
    real(c_double), intent(in) :: floor
    integer :: number
    number = count(x_t1(3, :) < floor + radius - 1d-9 .or. maxval(abs(x_t1(1:2, :)), 1) > half_width - radius + 1d-9)
  end function
end program
