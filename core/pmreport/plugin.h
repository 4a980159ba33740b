/* The contract between pmreport and a mechanism plugin, in plain C (C11 and C++20).
 *
 * A plugin is a shared library that exports one constant data symbol, `pm_plugin`. Everything else is reached through it. The host and the
 * plugin may be built by other compilers, with other vector flags or under sanitizers: no C++ object and no exception crosses.
 *
 * Rules that hold for every function below
 *   - Units are SI and radians. Matrices are row-major. Axes are the base's unless said otherwise.
 *   - Arrays of numbers belong to the host; their sizes follow from the topology. Strings and lists belong to the plugin and live as long
 * as the instance they were asked of (the plugin's own tables: as long as the process).
 *   - No function throws, calls setlocale, prints, or keeps state: an instance is immutable after `create`, so threads may share it.
 *   - A function that does not return PM_OK may leave a sentence in `message`.
 *
 * Versions. `abi_major` of host and plugin must be equal. Structs only grow at their end: a reader looks at `struct_size`, or at `stride`
 * of the list, before it reads a later member.
 */
#ifndef PMREPORT_PLUGIN_H
#define PMREPORT_PLUGIN_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define PM_ABI_MAJOR 1u
#define PM_ABI_MINOR 4u

/* ---- Vocabulary ------------------------------------------------------------------------------------------------------------------- */

typedef int32_t pm_status;
enum {
  PM_OK = 0,
  PM_UNREACHABLE = 1,  /* the mechanism cannot be assembled at these coordinates */
  PM_SINGULAR = 2,     /* it can, but what was asked for has no unique answer there */
  PM_BAD_ARGUMENT = 3, /* the caller's mistake: a parameter out of range, a wrong size */
  PM_FAILED = 4        /* the plugin's mistake, an exception for one */
};

/* A sentence from plugin to host: the plugin writes at most `capacity` bytes, the closing zero included. May be NULL. */
typedef struct pm_text {
  char* data;
  size_t capacity;
} pm_text;

/* `count` items, each `stride` bytes after the one before. */
typedef struct pm_list {
  const void* items;
  size_t count;
  size_t stride;
} pm_list;

typedef struct pm_instance pm_instance; /* one mechanism with its parameters; opaque to the host */

/* ---- What can be set -------------------------------------------------------------------------------------------------------------- */

typedef int32_t pm_parameter_kind;
enum {
  PM_NUMBER = 0,  /* one number with a unit */
  PM_NUMBERS = 1, /* count_min to count_max numbers with a unit; points are given as x y z x y z ... */
  PM_CHOICE = 2   /* one of `choices`, passed as its index */
};

typedef struct pm_parameter {
  const char* name;    /* as written in a scenario: lower case, digits, underscores */
  const char* title;   /* a few words for a table */
  const char* unit;    /* SI, "m", "rad", "kg*m^2"; "" for a plain number */
  const char* display; /* the unit that a reader expects, "mm", "deg" */
  pm_parameter_kind kind;
  const double* defaults;
  size_t default_count;
  double min, max; /* of every number, inclusive */
  size_t count_min, count_max;
  const char* const* choices;
  size_t choice_count;
  int32_t working_mode; /* since 1.1. 1: a choice among the solutions of inverse displacement (elbow in or out, slider above or below).
                           Assembly modes are looked for with every word of it. */
  const char* unless;   /* since 1.2. Name of a parameter that, once given, stands in the place of this one: to give both is refused. NULL:
                           there is none */
} pm_parameter;

typedef struct pm_value { /* the value of one parameter; the host passes all of them, in the order of the list, defaults filled in */
  const double* numbers;
  size_t count;
} pm_value;

/* ---- What is connected to what ---------------------------------------------------------------------------------------------------- */

typedef struct pm_coordinate { /* an independent coordinate of the platform */
  const char* name;
  const char* title;
  const char* unit; /* "m" or "rad" */
  double home;      /* the home pose must be assemblable and regular */
  double min, max;  /* a sane box around home, in which random poses are tried */
} pm_coordinate;

/* Body 0 is the base and stands in the list too. */
typedef struct pm_body {
  const char* name;
  int32_t slender; /* 1: a leg that may spin freely about its own z axis. Its spin is taken as zero, its joints lie on that axis, its
                      inertia is axisymmetric. Placed by origin and axis alone. */
  int32_t limb;    /* 1, 2, ...; 0 for base and platform */
} pm_body;

typedef int32_t pm_joint_kind;
enum {
  PM_REVOLUTE = 0,   /* rotation about axis 1 */
  PM_PRISMATIC = 1,  /* translation along axis 1 */
  PM_UNIVERSAL = 2,  /* rotations about axis 1, fixed in body a, and axis 2, fixed in body b */
  PM_SPHERICAL = 3,  /* three rotations; no axis */
  PM_CYLINDRICAL = 4 /* rotation about and translation along axis 1 */
};

typedef struct pm_joint {
  const char* name; /* as in the paper's drawing: "A1", "B1" */
  pm_joint_kind kind;
  int32_t a, b; /* bodies; motion is that of b relative to a */
  /* Limits, each from min to max, of: the angle from home [rad] (revolute; universal, both axes; cylindrical), the travel from home [m]
     (prismatic), the angle [rad] between the z axis of body `stud` and a direction in the other body, the socket (spherical). */
  double min[2], max[2];
  int32_t stud;
  double from[3]; /* since 1.2, spherical: the direction that the limit counts from, in axes of the socket, of any length: the platform's
                     normal, say. Zero: the direction of the stud at home */
} pm_joint;

typedef struct pm_actuator {
  const char* name;
  const char* title;
  const char*
      unit; /* "m": displacement along axis 1 of the joint; "rad": rotation about axis 1. Positive: b moves along +axis relative to a */
  int32_t joint;
  double min, max; /* stroke */
} pm_actuator;

typedef struct pm_derived { /* a quantity that follows from the coordinates */
  const char* name;
  const char* title;
  const char* unit;
  int32_t dependent; /* 1: a dependent (parasitic) coordinate of the platform; 0: any other quantity of interest */
} pm_derived;

typedef struct pm_topology {
  size_t struct_size;
  pm_list coordinates; /* pm_coordinate, as many as degrees of freedom */
  pm_list bodies;      /* pm_body */
  pm_list joints;      /* pm_joint */
  pm_list actuators;   /* pm_actuator, as many as degrees of freedom */
  pm_list derived;     /* pm_derived */
  int32_t platform;    /* body that carries the load; its origin is the reference point */
  int32_t idle;        /* idle freedoms: spins of legs that move nothing else */
} pm_topology;

/* ---- KINEMATICS: where everything is ---------------------------------------------------------------------------------------------- */

/* A placement is a row of scalars: reach; then for each body but the base, origin (3) and rotation (9, row-major, body to base axes), or
   for a slender body origin (3) and axis (3); then for each joint centre (3) and its axes (3 each: revolute, prismatic, cylindrical 1,
   universal 2, spherical 0); then each actuator's value; then each derived quantity. `reach` is a margin: negative where the pose cannot be
   assembled, and what follows means nothing then.

   `order` tells what each scalar is made of; component c of scalar s of pose k stands at [(s * components + c) * count + k]. */
typedef int32_t pm_order;
enum {
  PM_VALUE = 0,    /* 1 component */
  PM_JET = 1,      /* 3: value, rate, acceleration in time; coordinates come with theirs */
  PM_PARTIALS = 2, /* 1 + dof: value and its derivatives by the independent coordinates; coordinates come as plain values */
  PM_EXTENDED = 3  /* 2: high and low part, whose sum is the value in extended precision; coordinates likewise. Not asked of a mechanism
                      that records (since 1.3): the host runs the recording in extended precision */
};

typedef struct pm_kinematics {
  size_t struct_size;
  pm_status (*topology)(const pm_instance*, pm_topology* out, pm_text* message);
  /* PM_SINGULAR, or numbers that are not finite, where the geometry has no pose to give, as of a limb without length. With count > 1 the
     status is PM_OK even when poses are out of reach: look at each one's `reach`. */
  pm_status (*place)(const pm_instance*, pm_order order, size_t count, const double* coordinates, double* placement, pm_text* message);
} pm_kinematics;

/* ---- STATICS: what carries the load ----------------------------------------------------------------------------------------------- */

typedef struct pm_constraint { /* a row of the overall Jacobian below the actuators: a constraint wrench of the limbs on the platform */
  const char* name;
  const char* title;
  const char* unit; /* of its magnitude: "N" or "N*m" */
} pm_constraint;

typedef struct pm_statics {
  size_t struct_size;
  pm_status (*constraints)(const pm_instance*, pm_list* out, pm_text* message); /* 6 - dof of pm_constraint */
  /* The overall Jacobian G (6 x 6) of a placement (same order and count, same layout rule): G * twist = (actuator rates, 0), twist =
     (velocity of the platform's reference point; angular velocity). Row i is also the unit wrench (force; moment about the reference point)
     that actuator i, or constraint i, applies to the platform of a massless mechanism. */
  pm_status (*jacobian)(const pm_instance*, pm_order order, size_t count, const double* placement, double* jacobian, pm_text* message);
} pm_statics;

/* ---- DYNAMICS: what has mass ------------------------------------------------------------------------------------------------------ */

typedef struct pm_inertia { /* of one body, in the order of the bodies */
  double mass;              /* [kg] */
  double centre[3];         /* centre of mass in body axes, from the body's origin [m] */
  double inertia[9];        /* about the centre of mass, body axes [kg m^2] */
} pm_inertia;

typedef struct pm_dynamics {
  size_t struct_size;
  pm_status (*inertias)(const pm_instance*, pm_list* out, pm_text* message);
} pm_dynamics;

/* ---- CLOSED FORMS: what the source itself writes (since 1.1, optional) --------------------------------------------------------------- */

typedef int32_t pm_rates;
enum {
  PM_COORDINATE_RATES = 0, /* of the independent coordinates, dof of them */
  PM_ACTUATOR_RATES = 1,   /* dof of them */
  PM_TWIST = 2,            /* of the platform, 6 */
  PM_NO_RATES = 3
};

/* A matrix that the source states, such as the A and B of A x' + B q' = 0, or a Jacobian in its own coordinates. The matrices of one
   `relation`, each times the rates that it acts on, sum to the rates that they give. The host shows the matrices and judges the relation by
   the rates it has from `place`. */
typedef struct pm_matrix {
  const char* name;  /* "A" */
  const char* title; /* "constraint equations by the pose" */
  size_t rows, columns;
  int32_t relation; /* any number; equal for the matrices of one relation */
  pm_rates acts_on; /* its columns */
  pm_rates gives;   /* PM_ACTUATOR_RATES, PM_TWIST, PM_COORDINATE_RATES, or PM_NO_RATES: they sum to zero. Equal within a relation */
} pm_matrix;

/* A number that the source shows at a pose: an angle in its own convention, a transmission index. A value only: it need not have rates
   everywhere, and is NaN where it is not defined. What has rates is a pm_derived instead. */
typedef struct pm_reading {
  const char* name;
  const char* title;
  const char* unit;
} pm_reading;

typedef struct pm_closed_forms {
  size_t struct_size;
  pm_status (*matrices)(const pm_instance*, pm_list* out, pm_text* message); /* pm_matrix */
  /* Fills the matrices one after the other, each row-major, at one pose: its coordinates, and its placement of order PM_VALUE. */
  pm_status (*evaluate)(const pm_instance*, const double* coordinates, const double* placement, double* out, pm_text* message);
  pm_status (*readings)(const pm_instance*, pm_list* out, pm_text* message); /* pm_reading */
  pm_status (*read)(const pm_instance*, const double* coordinates, const double* placement, double* out, pm_text* message);
} pm_closed_forms;

/* ---- RECORDED GEOMETRY: the same once more, as a list of operations (since 1.3, optional) ------------------------------------------ */

/* One operation on numbers that earlier steps gave. A mask, what a comparison gives, is a number too: one where it holds, else zero. */
typedef int32_t pm_operation;
enum {
  PM_OP_CONSTANT = 0, /* `constant`, finite */
  PM_OP_INPUT = 1,    /* independent coordinate `a` */
  PM_OP_ADD = 2,      /* a + b; likewise below: a, b, c are the numbers of steps */
  PM_OP_SUBTRACT = 3,
  PM_OP_MULTIPLY = 4,
  PM_OP_DIVIDE = 5,
  PM_OP_NEGATE = 6, /* -a; so of one operand are those to PM_OP_ABS */
  PM_OP_SQRT = 7,
  PM_OP_SIN = 8,
  PM_OP_COS = 9,
  PM_OP_TAN = 10,
  PM_OP_ASIN = 11,
  PM_OP_ACOS = 12,
  PM_OP_ABS = 13,
  PM_OP_ATAN2 = 14,  /* atan2(a, b) */
  PM_OP_HYPOT = 15,  /* hypot(a, b) */
  PM_OP_LESS = 16,   /* mask: a < b */
  PM_OP_AND = 17,    /* masks: a and b */
  PM_OP_OR = 18,     /* a or b */
  PM_OP_NOT = 19,    /* not a */
  PM_OP_CHOOSE = 20, /* b where the mask a holds, else c */
  PM_OP_COUNT = 21
};
typedef struct pm_step {
  pm_operation operation;
  int32_t a, b, c; /* earlier steps; of PM_OP_INPUT the coordinate */
  double constant;
} pm_step;

/* The host's list, which `record` fills. */
typedef struct pm_recording {
  size_t struct_size;
  pm_step* steps;
  size_t capacity;
  size_t count;     /* of the steps; those beyond `capacity` are counted, and not written */
  int32_t* outputs; /* the step that gives each number: the scalars of a placement of order PM_VALUE, then the 36 of the overall Jacobian */
} pm_recording;

/* ---- ELASTICITY: what gives way (since 1.4, optional) ---------------------------------------------------------------------------------
 */

typedef int32_t pm_element_kind;
enum {
  PM_BEAM = 0, /* a straight bar from the centre of joint `from` to that of joint `to`, at whatever distance these are at a pose, through
                  the bodies between them; it is loaded by what passes through them */
  PM_RAIL = 1, /* a screw or belt along the slide `from`, which has an actuator: loaded by what joint `to` passes along that slide. Its free
                  length is the size of the actuator's value, and `offset`: rigid where that is zero */
  PM_DRIVE = 2,  /* servo, gears and screw of an actuator, in series with its force */
  PM_BEARING = 3 /* joint `to` itself, about its centre */
};
typedef int32_t pm_bending;
enum {
  PM_BENDING_NONE = 0,    /* a bar that is stretched and twisted */
  PM_BENDING_COUPLES = 1, /* bent by the couple that acts at joint `to`, as if no force across it did */
  PM_BENDING_FULL = 2     /* by forces and couples (Euler and Bernoulli) */
};

/* What has no use for an element is not looked at. A stiffness, modulus, area or second moment above zero; infinite: it does not give. */
typedef struct pm_element {
  const char* name;  /* letters, digits, underscores: columns are called after it */
  const char* title; /* a few words for a table */
  pm_element_kind kind;
  int32_t from, to;              /* joints */
  int32_t beside;                /* beam: a further joint of the body at its end, which then lies halfway between both; -1: none */
  int32_t actuator;              /* of a drive */
  double modulus, shear_modulus; /* beams and rails: Young's and shear modulus [Pa] */
  double expansion;              /* by temperature [1/K] */
  double area;                   /* [m^2] */
  double bending[2]; /* second moments of area [m^4] about the x and y axes of the first body of the beam, as far as these lie across it */
  double torsion;    /* torsion constant [m^4] */
  pm_bending bends;
  double buckling_length; /* of a beam, by its length: 1 between hinges, 0.5 between clamps, 2 with a free end; 0: it is not slender */
  double offset;          /* of a rail [m], zero or more */
  /* Of a drive: the first [N/m], [N m/rad]. Of a bearing: along axis 1 of its joint, across it [N/m]; about axis 1, about the axes across
     it [N m/rad]. The axis of a ball is the z axis of its stud. What the joint leaves free is not looked at. */
  double stiffness[4];
} pm_element;

typedef struct pm_elasticity {
  size_t struct_size;
  pm_status (*elements)(const pm_instance*, pm_list* out, pm_text* message); /* pm_element */
} pm_elasticity;

/* ---- How it looks ----------------------------------------------------------------------------------------------------------------- */

typedef int32_t pm_shape_kind;
enum {
  PM_CYLINDER = 0, /* from a to b with `radius` */
  PM_BALL = 1,     /* at a with `radius` */
  PM_BOX = 2       /* centre a, half edge lengths b */
};

/* A solid fixed to a body, in body axes. A body without shapes is drawn from its joints: two joints a rod, more a plate. */
typedef struct pm_shape {
  int32_t body;
  pm_shape_kind kind;
  double a[3], b[3];
  double radius;
} pm_shape;

typedef struct pm_appearance {
  size_t struct_size;
  pm_status (*shapes)(const pm_instance*, pm_list* out, pm_text* message);
} pm_appearance;

/* ---- The exported table ----------------------------------------------------------------------------------------------------------- */

typedef struct pm_mechanism {
  size_t struct_size;
  const char* name;   /* as written in a scenario: "4sps-spr" */
  const char* title;  /* one line */
  const char* source; /* the paper */
  int32_t dof;
  pm_list parameters; /* pm_parameter */
  pm_status (*create)(const pm_value* values, size_t count, pm_instance** out, pm_text* message);
  void (*destroy)(pm_instance*);
  const pm_kinematics* kinematics;
  const pm_statics* statics;
  const pm_dynamics* dynamics;
  const pm_appearance* appearance;     /* may be NULL */
  const pm_closed_forms* closed_forms; /* may be NULL; since 1.1 */
  /* Since 1.3; may be NULL. Writes down what `place`, and `jacobian` of that placement, do with the coordinates: the same operations
     whatever these are, so that the host can run them on other kinds of numbers. The same list at every call. */
  pm_status (*record)(const pm_instance*, pm_recording*, pm_text* message);
  const pm_elasticity* elasticity; /* may be NULL; since 1.4 */
} pm_mechanism;

typedef struct pm_plugin_table {
  size_t struct_size;
  uint32_t abi_major, abi_minor;
  const char* build; /* compiler and flags, for the report's provenance */
  size_t mechanism_count;
  const pm_mechanism* const* mechanisms;
} pm_plugin_table;

#define PM_PLUGIN_SYMBOL "pm_plugin" /* the name of the exported `const pm_plugin_table` */

#ifdef __cplusplus
}
#endif
#endif
