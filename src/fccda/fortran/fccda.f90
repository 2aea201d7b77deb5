!> The interface of fccda (fccda.h) for Fortran 2018: contact of points with rigid and deforming surfaces.
!>
!> This file is compiled with the program: modules of one compiler cannot be read by another. What has a name of fccda.h has its meaning, with these
!> differences: fccda_xyz, fccda_three and fccda_each take double and single precision, fccda_message() is the text of fccda_last_error(), fccda_text() that
!> of any pointer to text, and the types FCCDA_UNSET and FCCDA_ONE of views are FCCDA_TYPE_UNSET and FCCDA_TYPE_ONE, since Fortran does not tell them from
!> the functions. Points, panels and vertices are numbered from 0 on both sides: add 1 for an index into an array.
!>
!>   use fccda
!>   real(c_double), allocatable, target :: x_t0(:,:), x_t1(:,:), v(:,:)       ! (3, n)
!>   points = fccda_points(x_t0=fccda_xyz(x_t0), x_t1=fccda_xyz(x_t1), velocity=fccda_xyz(v), mass=fccda_one(1d0))
!>   if (fccda_detect(detector, motion, points, count) /= FCCDA_OK) error stop fccda_message()
!>
!> Views refer to the arrays. Only arrays with the attribute `target` are accepted, and pointers; they must not be reallocated while a view is used. An
!> array of another shape than (3, n), or three of different lengths or strides, give a view that every function refuses.
module fccda
  use, intrinsic :: iso_c_binding
  implicit none
  public

  integer(c_int), parameter :: FCCDA_ABI_VERSION_OF_MODULE = 1
  integer(c_int), parameter :: FCCDA_OK = 0, FCCDA_INPUT_ERROR = 1, FCCDA_RUN_ERROR = 2, FCCDA_INTERNAL_ERROR = 3
  integer(c_int32_t), parameter :: FCCDA_TYPE_UNSET = 0, FCCDA_DOUBLE = 1, FCCDA_FLOAT = 2, FCCDA_TYPE_ONE = 3
  integer(c_int32_t), parameter :: FCCDA_UNDECLARED = 0, FCCDA_NORMALS = 1, FCCDA_REVERSED = 2
  integer(c_int32_t), parameter :: FCCDA_REFUSE_BEYOND = 0, FCCDA_IGNORE_BEYOND = 1

  type, bind(C) :: fccda_vectors
    type(c_ptr) :: x = c_null_ptr, y = c_null_ptr, z = c_null_ptr
    integer(c_size_t) :: count = 0
    integer(c_intptr_t) :: stride = 0
    integer(c_int32_t) :: type = 0, reserved = 0
  end type

  type, bind(C) :: fccda_numbers
    type(c_ptr) :: first = c_null_ptr
    integer(c_size_t) :: count = 0
    integer(c_intptr_t) :: stride = 0
    real(c_double) :: value = 0
    integer(c_int32_t) :: type = 0, reserved = 0
  end type

  type, bind(C) :: fccda_points
    type(fccda_vectors) :: x_t0, x_t1, velocity
    type(fccda_numbers) :: mass, radius
  end type

  type, bind(C) :: fccda_surface_options
    real(c_double) :: weld_distance = 0
    type(c_ptr) :: name = c_null_ptr
    integer(c_int32_t) :: orientation = 0, reserved = 0
  end type

  type, bind(C) :: fccda_hull
    real(c_double) :: length = 0, breadth = 0, draft = 0, freeboard = 0, stem_angle = 0, waterline_angle = 0, fullness = 0
    real(c_double) :: stern_angle = 0, stern_waterline_angle = 0, bilge_radius = 0, stem_radius = 0, flare = 0, edge_length = 0
    real(c_double) :: bow_edge_length = 0
  end type

  type, bind(C) :: fccda_propeller
    real(c_double) :: diameter = 0, pitch_ratio = 0, area_ratio = 0, hub_ratio = 0, hub_length = 0, rake = 0, skew = 0
    real(c_double) :: thickness_factor = 0, edge_thickness = 0, edge_length = 0, blade_edge_length = 0
    integer(c_int32_t) :: blades = 0, axis = 0, is_left_handed = 0, reserved = 0
  end type

  type, bind(C) :: fccda_box
    real(c_double) :: size(3) = 0, centre(3) = 0
  end type

  type, bind(C) :: fccda_sectors
    real(c_double) :: axis(3) = [0, 0, 1], point(3) = 0, radius = 0, length = 0, hub_radius = 0, sector_angle = 0, start_angle = 0
    integer(c_int32_t) :: blades = 1, reserved = 0
  end type

  type, bind(C) :: fccda_surface_info
    integer(c_int64_t) :: panels = 0, panel_vertices = 0, triangles = 0, vertices = 0, repairs = 0, is_closed = 0
    real(c_double) :: area = 0, volume = 0, centroid(3) = 0, low(3) = 0, high(3) = 0
  end type

  type, bind(C) :: fccda_pose
    real(c_double) :: position(3) = 0, attitude(4) = [1, 0, 0, 0]
  end type

  type, bind(C) :: fccda_motion
    type(fccda_pose) :: t0, t1
    real(c_double) :: centre(3) = 0, dt = 0
  end type

  type, bind(C) :: fccda_body_properties
    real(c_double) :: mass = 0, centre_of_mass(3) = 0, inertia(9) = 0, added_mass(3) = 0
    type(fccda_pose) :: pose
    real(c_double) :: velocity(3) = 0, angular_velocity(3) = 0
    integer(c_int32_t) :: is_free(6) = 0
  end type

  type, bind(C) :: fccda_body_state
    real(c_double) :: centre_of_mass(3) = 0, velocity(3) = 0, angular_velocity(3) = 0, attitude(4) = [1, 0, 0, 0]
    real(c_double) :: constraint_work = 0
  end type

  type, bind(C) :: fccda_contact
    integer(c_int64_t) :: point = 0, panel = 0
    real(c_double) :: time_fraction = 0, hit(3) = 0, normal(3) = 0, relocation(3) = 0, depth = 0, radius = 0, normal_t0(3) = 0
  end type

  type, bind(C) :: fccda_contact_sum
    real(c_double) :: impulse(3) = 0, angular_impulse(3) = 0
    integer(c_int64_t) :: contacts = 0
  end type

  type, bind(C) :: fccda_deforming_contact
    type(fccda_contact) :: contact
    integer(c_int64_t) :: vertices(3) = 0
    real(c_double) :: weights(3) = 0, displacement(3) = 0
  end type

  !> A view of vectors (3, n) in double or single precision, also of a section such as x(:, 1::2).
  interface fccda_xyz
    module procedure xyz_of_doubles, xyz_of_floats
  end interface

  !> A view of three arrays (n) of x, y and z in double or single precision, of equal lengths and strides.
  interface fccda_three
    module procedure three_of_doubles, three_of_floats
  end interface

  !> A view of numbers (n), one for each point.
  interface fccda_each
    module procedure each_of_doubles, each_of_floats
  end interface

  interface
    integer(c_int) function fccda_abi_version() bind(C)
      import
    end function

    type(c_ptr) function fccda_version() bind(C)
      import
    end function

    type(c_ptr) function fccda_last_error() bind(C)
      import
    end function

    integer(c_int) function fccda_use_threads(count) bind(C)
      import
      integer(c_int32_t), value :: count
    end function

    integer(c_int) function fccda_surface_read(path, options, surface) bind(C)
      import
      character(kind=c_char), intent(in) :: path(*)
      type(fccda_surface_options), intent(in), optional :: options
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_create(vertices, panels, panel_count, corners, options, surface) bind(C)
      import
      type(fccda_vectors), intent(in) :: vertices
      integer(c_int32_t), intent(in) :: panels(*)
      integer(c_size_t), value :: panel_count
      integer(c_int32_t), value :: corners
      type(fccda_surface_options), intent(in), optional :: options
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_box(size, edge_length, surface) bind(C)
      import
      real(c_double), intent(in) :: size(3)
      real(c_double), value :: edge_length
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_sphere(diameter, edge_length, surface) bind(C)
      import
      real(c_double), value :: diameter, edge_length
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_cylinder(diameter, height, axis, edge_length, surface) bind(C)
      import
      real(c_double), value :: diameter, height, edge_length
      integer(c_int32_t), value :: axis
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_hull(hull, surface) bind(C)
      import
      type(fccda_hull), intent(in) :: hull
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_propeller(propeller, surface) bind(C)
      import
      type(fccda_propeller), intent(in) :: propeller
      type(c_ptr), intent(out) :: surface
    end function

    integer(c_int) function fccda_surface_measure(surface, info) bind(C)
      import
      type(c_ptr), value :: surface
      type(fccda_surface_info), intent(out) :: info
    end function

    type(c_ptr) function fccda_surface_report(surface) bind(C)
      import
      type(c_ptr), value :: surface
    end function

    integer(c_int) function fccda_surface_vertices(surface, vertices) bind(C)
      import
      type(c_ptr), value :: surface
      type(fccda_vectors), intent(in) :: vertices
    end function

    integer(c_int) function fccda_surface_panels(surface, panels, panel_count) bind(C)
      import
      type(c_ptr), value :: surface
      integer(c_int32_t), intent(out) :: panels(*)
      integer(c_size_t), value :: panel_count
    end function

    subroutine fccda_surface_destroy(surface) bind(C)
      import
      type(c_ptr), value :: surface
    end subroutine

    integer(c_int) function fccda_body_create(properties, body) bind(C)
      import
      type(fccda_body_properties), intent(in) :: properties
      type(c_ptr), intent(out) :: body
    end function

    integer(c_int) function fccda_body_advance(body, dt, motion) bind(C)
      import
      type(c_ptr), value :: body
      real(c_double), value :: dt
      type(fccda_motion), intent(out) :: motion
    end function

    integer(c_int) function fccda_body_add_impulse(body, impulse, angular_impulse) bind(C)
      import
      type(c_ptr), value :: body
      real(c_double), intent(in) :: impulse(3), angular_impulse(3)
    end function

    integer(c_int) function fccda_body_drive(body, degree, velocity) bind(C)
      import
      type(c_ptr), value :: body
      integer(c_int32_t), value :: degree
      real(c_double), value :: velocity
    end function

    integer(c_int) function fccda_body_pose(body, pose) bind(C)
      import
      type(c_ptr), value :: body
      type(fccda_pose), intent(out) :: pose
    end function

    integer(c_int) function fccda_body_kinetic_energy(body, energy) bind(C)
      import
      type(c_ptr), value :: body
      real(c_double), intent(out) :: energy
    end function

    integer(c_int) function fccda_body_state_of(body, state) bind(C)
      import
      type(c_ptr), value :: body
      type(fccda_body_state), intent(out) :: state
    end function

    integer(c_int) function fccda_body_resume(body, state) bind(C)
      import
      type(c_ptr), value :: body
      type(fccda_body_state), intent(in) :: state
    end function

    subroutine fccda_body_destroy(body) bind(C)
      import
      type(c_ptr), value :: body
    end subroutine

    integer(c_int) function fccda_detector_create(surface, radius, detector) bind(C)
      import
      type(c_ptr), value :: surface
      real(c_double), value :: radius
      type(c_ptr), intent(out) :: detector
    end function

    integer(c_int) function fccda_detector_create_in_boxes(surface, radius, boxes, box_count, beyond, detector) bind(C)
      import
      type(c_ptr), value :: surface
      real(c_double), value :: radius
      type(fccda_box), intent(in) :: boxes(*)
      integer(c_size_t), value :: box_count
      integer(c_int32_t), value :: beyond
      type(c_ptr), intent(out) :: detector
    end function

    integer(c_int) function fccda_detector_create_in_sectors(surface, radius, sectors, beyond, detector) bind(C)
      import
      type(c_ptr), value :: surface
      real(c_double), value :: radius
      type(fccda_sectors), intent(in) :: sectors
      integer(c_int32_t), value :: beyond
      type(c_ptr), intent(out) :: detector
    end function

    integer(c_int) function fccda_detector_create_in_fitted_bounds(surface, radius, detector) bind(C)
      import
      type(c_ptr), value :: surface
      real(c_double), value :: radius
      type(c_ptr), intent(out) :: detector
    end function

    type(c_ptr) function fccda_detector_bounds(detector) bind(C)
      import
      type(c_ptr), value :: detector
    end function

    integer(c_int) function fccda_detect(detector, motion, points, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(fccda_motion), intent(in) :: motion
      type(fccda_points), intent(in) :: points
      integer(c_size_t), intent(out), optional :: count
    end function

    integer(c_int) function fccda_detector_contacts(detector, contacts, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(c_ptr), intent(out) :: contacts
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_detector_keep(detector, which, count) bind(C)
      import
      type(c_ptr), value :: detector
      integer(c_int64_t), intent(in) :: which(*)
      integer(c_size_t), value :: count
    end function

    integer(c_int) function fccda_respond(detector, motion, points, friction, body, sum) bind(C)
      import
      type(c_ptr), value :: detector, body
      type(fccda_motion), intent(in) :: motion
      type(fccda_points), intent(in) :: points
      real(c_double), value :: friction
      type(fccda_contact_sum), intent(out), optional :: sum
    end function

    integer(c_int) function fccda_detector_moved(detector, point) bind(C)
      import
      type(c_ptr), value :: detector
      integer(c_int64_t), value :: point
    end function

    integer(c_int) function fccda_detector_points_changed(detector) bind(C)
      import
      type(c_ptr), value :: detector
    end function

    integer(c_int) function fccda_detector_points_inside(detector, pose, x, radius, points, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(fccda_pose), intent(in) :: pose
      type(fccda_vectors), intent(in) :: x
      type(fccda_numbers), intent(in), optional :: radius
      type(c_ptr), intent(out) :: points
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_detector_state(detector, numbers, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(c_ptr), intent(out) :: numbers
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_detector_resume(detector, numbers, count) bind(C)
      import
      type(c_ptr), value :: detector
      integer(c_int64_t), intent(in) :: numbers(*)
      integer(c_size_t), value :: count
    end function

    subroutine fccda_detector_destroy(detector) bind(C)
      import
      type(c_ptr), value :: detector
    end subroutine

    integer(c_int) function fccda_deforming_surface_create(surface, deforming) bind(C)
      import
      type(c_ptr), value :: surface
      type(c_ptr), intent(out) :: deforming
    end function

    integer(c_int) function fccda_deforming_surface_move(surface, vertices) bind(C)
      import
      type(c_ptr), value :: surface
      type(fccda_vectors), intent(in) :: vertices
    end function

    integer(c_int) function fccda_deforming_surface_place(surface, vertices) bind(C)
      import
      type(c_ptr), value :: surface
      type(fccda_vectors), intent(in) :: vertices
    end function

    integer(c_int) function fccda_deforming_surface_warnings(surface, text) bind(C)
      import
      type(c_ptr), value :: surface
      type(c_ptr), intent(out) :: text
    end function

    subroutine fccda_deforming_surface_destroy(surface) bind(C)
      import
      type(c_ptr), value :: surface
    end subroutine

    integer(c_int) function fccda_deforming_detector_create(surface, radius, detector) bind(C)
      import
      type(c_ptr), value :: surface
      real(c_double), value :: radius
      type(c_ptr), intent(out) :: detector
    end function

    integer(c_int) function fccda_deforming_detect(detector, points, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(fccda_points), intent(in) :: points
      integer(c_size_t), intent(out), optional :: count
    end function

    integer(c_int) function fccda_deforming_detector_contacts(detector, contacts, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(c_ptr), intent(out) :: contacts
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_deforming_detector_keep(detector, which, count) bind(C)
      import
      type(c_ptr), value :: detector
      integer(c_int64_t), intent(in) :: which(*)
      integer(c_size_t), value :: count
    end function

    integer(c_int) function fccda_deforming_respond(detector, dt, points, friction, vertex_mass, vertex_impulses, sum) bind(C)
      import
      type(c_ptr), value :: detector
      real(c_double), value :: dt, friction
      type(fccda_points), intent(in) :: points
      type(fccda_numbers), intent(in) :: vertex_mass
      type(fccda_vectors), intent(in) :: vertex_impulses
      type(fccda_contact_sum), intent(out), optional :: sum
    end function

    integer(c_int) function fccda_deforming_detector_moved(detector, point) bind(C)
      import
      type(c_ptr), value :: detector
      integer(c_int64_t), value :: point
    end function

    integer(c_int) function fccda_deforming_detector_points_changed(detector) bind(C)
      import
      type(c_ptr), value :: detector
    end function

    integer(c_int) function fccda_deforming_detector_points_inside(detector, x, points, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(fccda_vectors), intent(in) :: x
      type(c_ptr), intent(out) :: points
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_deforming_detector_balls_inside(detector, x, radius, points, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(fccda_vectors), intent(in) :: x
      type(fccda_numbers), intent(in) :: radius
      type(c_ptr), intent(out) :: points
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_deforming_detector_state(detector, numbers, count) bind(C)
      import
      type(c_ptr), value :: detector
      type(c_ptr), intent(out) :: numbers
      integer(c_size_t), intent(out) :: count
    end function

    integer(c_int) function fccda_deforming_detector_resume(detector, numbers, count) bind(C)
      import
      type(c_ptr), value :: detector
      integer(c_int64_t), intent(in) :: numbers(*)
      integer(c_size_t), value :: count
    end function

    subroutine fccda_deforming_detector_destroy(detector) bind(C)
      import
      type(c_ptr), value :: detector
    end subroutine

    pure integer(c_size_t) function fccda_text_length(text) bind(C, name="strlen")
      import
      type(c_ptr), value :: text
    end function
  end interface

  private :: xyz_of_doubles, xyz_of_floats, three_of_doubles, three_of_floats, three_of, each_of_doubles, each_of_floats, address

contains

  function xyz_of_doubles(xyz) result(view)
    real(c_double), intent(in), pointer :: xyz(:, :)
    type(fccda_vectors) :: view
    if (size(xyz, 1) /= 3) return
    view%type = FCCDA_DOUBLE
    view%stride = 3 * c_sizeof(0d0)
    view%count = size(xyz, 2, c_size_t)
    if (view%count == 0) return
    view%x = c_loc(xyz(1, 1)); view%y = c_loc(xyz(2, 1)); view%z = c_loc(xyz(3, 1))
    if (view%count > 1) view%stride = address(c_loc(xyz(1, 2))) - address(view%x)
  end function

  function xyz_of_floats(xyz) result(view)
    real(c_float), intent(in), pointer :: xyz(:, :)
    type(fccda_vectors) :: view
    if (size(xyz, 1) /= 3) return
    view%type = FCCDA_FLOAT
    view%stride = 3 * c_sizeof(0e0)
    view%count = size(xyz, 2, c_size_t)
    if (view%count == 0) return
    view%x = c_loc(xyz(1, 1)); view%y = c_loc(xyz(2, 1)); view%z = c_loc(xyz(3, 1))
    if (view%count > 1) view%stride = address(c_loc(xyz(1, 2))) - address(view%x)
  end function

  function three_of_doubles(x, y, z) result(view)
    real(c_double), intent(in), pointer :: x(:), y(:), z(:)
    type(fccda_vectors) :: view
    view = three_of(fccda_each(x), fccda_each(y), fccda_each(z))
  end function

  function three_of_floats(x, y, z) result(view)
    real(c_float), intent(in), pointer :: x(:), y(:), z(:)
    type(fccda_vectors) :: view
    view = three_of(fccda_each(x), fccda_each(y), fccda_each(z))
  end function

  pure function three_of(x, y, z) result(view)
    type(fccda_numbers), intent(in) :: x, y, z
    type(fccda_vectors) :: view
    if (x%count /= y%count .or. x%count /= z%count .or. x%stride /= y%stride .or. x%stride /= z%stride) return
    view%x = x%first; view%y = y%first; view%z = z%first
    view%count = x%count
    view%stride = x%stride
    view%type = x%type
  end function

  function each_of_doubles(numbers) result(view)
    real(c_double), intent(in), pointer :: numbers(:)
    type(fccda_numbers) :: view
    view%type = FCCDA_DOUBLE
    view%stride = c_sizeof(0d0)
    view%count = size(numbers, kind=c_size_t)
    if (view%count == 0) return
    view%first = c_loc(numbers(1))
    if (view%count > 1) view%stride = address(c_loc(numbers(2))) - address(view%first)
  end function

  function each_of_floats(numbers) result(view)
    real(c_float), intent(in), pointer :: numbers(:)
    type(fccda_numbers) :: view
    view%type = FCCDA_FLOAT
    view%stride = c_sizeof(0e0)
    view%count = size(numbers, kind=c_size_t)
    if (view%count == 0) return
    view%first = c_loc(numbers(1))
    if (view%count > 1) view%stride = address(c_loc(numbers(2))) - address(view%first)
  end function

  !> One number for all points.
  pure function fccda_one(value) result(view)
    real(c_double), intent(in) :: value
    type(fccda_numbers) :: view
    view%value = value
    view%type = FCCDA_TYPE_ONE
  end function

  !> No numbers, where they have a default.
  pure function fccda_unset() result(view)
    type(fccda_numbers) :: view
    view%type = FCCDA_TYPE_UNSET
  end function

  !> A body at rest at the origin without free degrees of freedom; change what differs.
  pure function fccda_fixed_body(mass) result(body)
    real(c_double), intent(in) :: mass
    type(fccda_body_properties) :: body
    body%mass = mass
  end function

  !> The sentence of the last call that failed (fccda_last_error).
  function fccda_message() result(text)
    character(len=:), allocatable :: text
    text = fccda_text(fccda_last_error())
  end function

  !> The text that a C function returned.
  function fccda_text(from) result(text)
    type(c_ptr), intent(in) :: from
    character(len=:), allocatable :: text
    character(kind=c_char), pointer :: letters(:)
    integer(c_size_t) :: k, length
    text = ""
    if (.not. c_associated(from)) return
    length = fccda_text_length(from)
    call c_f_pointer(from, letters, [length])
    text = repeat(" ", int(length))
    do k = 1, length
      text(k:k) = letters(k)
    end do
  end function

  pure function address(of) result(number)
    type(c_ptr), intent(in) :: of
    integer(c_intptr_t) :: number
    number = transfer(of, 0_c_intptr_t)
  end function
end module
