Problem:    theta1-max
Rows:       46
Columns:    2
Non-zeros:  92
Status:     OPTIMAL
Objective:  theta1_max = -0.001848380027 (MINimum)

   No.   Row name   St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 row14_upper  B      0.0131129                      0.0135 
     2 row15_upper  B      0.0136824                      0.0145 
     3 row16_upper  B      0.0148626                      0.0155 
     4 row17_upper  B      0.0158809                      0.0165 
     5 row18_upper  B      0.0166919                      0.0175 
     6 row19_upper  B      0.0177476                      0.0185 
     7 row20_upper  B      0.0185305                      0.0195 
     8 row21_upper  B         0.0195                      0.0205 
     9 row22_upper  B      0.0205003                      0.0215 
    10 row23_upper  B      0.0215001                      0.0225 
    11 row24_upper  B      0.0225023                      0.0235 
    12 row25_upper  B      0.0241943                      0.0245 
    13 row26_upper  B      0.0247799                      0.0255 
    14 row27_upper  B      0.0258054                      0.0265 
    15 row28_upper  B      0.0267752                      0.0275 
    16 row29_upper  B      0.0278896                      0.0285 
    17 row30_upper  B      0.0290138                      0.0295 
    18 row31_upper  B      0.0299191                      0.0305 
    19 row32_upper  B      0.0308241                      0.0315 
    20 row33_upper  B       0.031854                      0.0325 
    21 row34_upper  NU        0.0335                      0.0335     -0.132027 
    22 row35_upper  B       0.034215                      0.0345 
    23 row36_upper  B       0.034787                      0.0355 
    24 row14_lower  B      0.0131129        0.0125               
    25 row15_lower  B      0.0136824        0.0135               
    26 row16_lower  B      0.0148626        0.0145               
    27 row17_lower  B      0.0158809        0.0155               
    28 row18_lower  B      0.0166919        0.0165               
    29 row19_lower  B      0.0177476        0.0175               
    30 row20_lower  B      0.0185305        0.0185               
    31 row21_lower  NL        0.0195        0.0195                    0.132027 
    32 row22_lower  B      0.0205003        0.0205               
    33 row23_lower  B      0.0215001        0.0215               
    34 row24_lower  B      0.0225023        0.0225               
    35 row25_lower  B      0.0241943        0.0235               
    36 row26_lower  B      0.0247799        0.0245               
    37 row27_lower  B      0.0258054        0.0255               
    38 row28_lower  B      0.0267752        0.0265               
    39 row29_lower  B      0.0278896        0.0275               
    40 row30_lower  B      0.0290138        0.0285               
    41 row31_lower  B      0.0299191        0.0295               
    42 row32_lower  B      0.0308241        0.0305               
    43 row33_lower  B       0.031854        0.0315               
    44 row34_lower  B         0.0335        0.0325               
    45 row35_lower  B       0.034215        0.0335               
    46 row36_lower  B       0.034787        0.0345               

   No. Column name  St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 theta1       B     0.00184838                             
     2 theta2       B      0.0226005                             

Karush-Kuhn-Tucker optimality conditions:

KKT.PE: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.PB: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.DE: max.abs.err = 2.22e-16 on column 1
        max.rel.err = 1.54e-16 on column 2
        High quality

KKT.DB: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

End of output
