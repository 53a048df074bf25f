Problem:    theta1-min
Rows:       6
Columns:    2
Non-zeros:  12
Status:     UNBOUNDED
Objective:  theta1_min = 1.95 (MINimum)

   No.   Row name   St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 row1_upper   B            3.9                         4.2 
     2 row2_upper   B            3.9                         4.3 
     3 row3_upper   B            3.9                        4.15 
     4 row1_lower   B            3.9           3.8               
     5 row2_lower   NL           3.9           3.9                         0.5 
     6 row3_lower   B            3.9          3.75               

   No. Column name  St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 theta1       B           1.95                             
     2 theta2       NF             0                                      -0.5 

Karush-Kuhn-Tucker optimality conditions:

KKT.PE: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.PB: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.DE: max.abs.err = 0.00e+00 on column 0
        max.rel.err = 0.00e+00 on column 0
        High quality

KKT.DB: max.abs.err = 5.00e-01 on column 2
        max.rel.err = 5.00e-01 on column 2
        DUAL SOLUTION IS INFEASIBLE

End of output
