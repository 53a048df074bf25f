NAME          a model
OBJSENSE
    MAX
ROWS
 N  the cost
 L  row 1
 E  row 2
COLUMNS
    col 1     the cost  1              row 1     1
    col 1     row 2     -0.5           $ a comment
    c 2       the cost  2D0            row 2     1
RHS
    rhs 1     row 1     4              row 2     1
RANGES
    rng 1     row 2     -2
BOUNDS
 UP bnd a     col 1     -3
 FR bnd a     c 2
ENDATA
