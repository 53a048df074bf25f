Problem:    theta1-min
Rows:       6
Columns:    2
Non-zeros:  12
Status:     INFEASIBLE (FINAL)
Objective:  theta1_min = 0.7045700897 (MINimum)

   No.   Row name   St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 row1_upper   B       -5.72094                    -5.32094 
     2 row2_upper   NU       2.09732                     2.09732     0.0901185 
     3 row3_upper   B        3.07717                     3.86861 
     4 row1_lower   NL      -5.72094      -5.72094                  -0.0901185 
     5 row2_lower   B        2.09732       1.69732               
     6 row3_lower   B        3.07717       3.46861               

   No. Column name  St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 theta1       B        0.70457                             
     2 theta2       B        1.20703                             

Karush-Kuhn-Tucker optimality conditions:

KKT.PE: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.PB: max.abs.err = 3.91e-01 on row 6
        max.rel.err = 8.76e-02 on row 6
        PRIMAL SOLUTION IS INFEASIBLE

KKT.DE: max.abs.err = 0.00e+00 on column 0
        max.rel.err = 0.00e+00 on column 0
        High quality

KKT.DB: max.abs.err = 9.01e-02 on row 2
        max.rel.err = 9.01e-02 on row 2
        DUAL SOLUTION IS INFEASIBLE

End of output
