Problem:    theta1-min
Rows:       46
Columns:    2
Non-zeros:  92
Status:     OPTIMAL
Objective:  theta1_min = 0.001790892035 (MINimum)

   No.   Row name   St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 row14_upper  NU        0.0135                      0.0135    -0.0852806 
     2 row15_upper  B      0.0140518                      0.0145 
     3 row16_upper  B      0.0151953                      0.0155 
     4 row17_upper  B      0.0161819                      0.0165 
     5 row18_upper  B      0.0169677                      0.0175 
     6 row19_upper  B      0.0179905                      0.0185 
     7 row20_upper  B      0.0187491                      0.0195 
     8 row21_upper  B      0.0196884                      0.0205 
     9 row22_upper  B      0.0206577                      0.0215 
    10 row23_upper  B      0.0216264                      0.0225 
    11 row24_upper  B      0.0225974                      0.0235 
    12 row25_upper  B      0.0242368                      0.0245 
    13 row26_upper  B      0.0248041                      0.0255 
    14 row27_upper  B      0.0257977                      0.0265 
    15 row28_upper  B      0.0267374                      0.0275 
    16 row29_upper  B      0.0278171                      0.0285 
    17 row30_upper  B      0.0289063                      0.0295 
    18 row31_upper  B      0.0297835                      0.0305 
    19 row32_upper  B      0.0306603                      0.0315 
    20 row33_upper  B      0.0316582                      0.0325 
    21 row34_upper  B       0.033253                      0.0335 
    22 row35_upper  B      0.0339457                      0.0345 
    23 row36_upper  B         0.0345                      0.0355 
    24 row14_lower  B         0.0135        0.0125               
    25 row15_lower  B      0.0140518        0.0135               
    26 row16_lower  B      0.0151953        0.0145               
    27 row17_lower  B      0.0161819        0.0155               
    28 row18_lower  B      0.0169677        0.0165               
    29 row19_lower  B      0.0179905        0.0175               
    30 row20_lower  B      0.0187491        0.0185               
    31 row21_lower  B      0.0196884        0.0195               
    32 row22_lower  B      0.0206577        0.0205               
    33 row23_lower  B      0.0216264        0.0215               
    34 row24_lower  B      0.0225974        0.0225               
    35 row25_lower  B      0.0242368        0.0235               
    36 row26_lower  B      0.0248041        0.0245               
    37 row27_lower  B      0.0257977        0.0255               
    38 row28_lower  B      0.0267374        0.0265               
    39 row29_lower  B      0.0278171        0.0275               
    40 row30_lower  B      0.0289063        0.0285               
    41 row31_lower  B      0.0297835        0.0295               
    42 row32_lower  B      0.0306603        0.0305               
    43 row33_lower  B      0.0316582        0.0315               
    44 row34_lower  B       0.033253        0.0325               
    45 row35_lower  B      0.0339457        0.0335               
    46 row36_lower  NL        0.0345        0.0345                   0.0852806 

   No. Column name  St   Activity     Lower bound   Upper bound    Marginal
------ ------------ -- ------------- ------------- ------------- -------------
     1 theta1       B     0.00179089                             
     2 theta2       B      0.0226925                             

Karush-Kuhn-Tucker optimality conditions:

KKT.PE: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.PB: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

KKT.DE: max.abs.err = 5.55e-17 on column 2
        max.rel.err = 4.74e-17 on column 2
        High quality

KKT.DB: max.abs.err = 0.00e+00 on row 0
        max.rel.err = 0.00e+00 on row 0
        High quality

End of output
