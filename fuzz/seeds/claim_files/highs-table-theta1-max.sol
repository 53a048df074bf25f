Columns
    Index Status        Lower        Upper       Primal         Dual  Name
        0     BS         -inf          inf   0.00184838            0  theta1
        1     BS         -inf          inf    0.0226005            0  theta2
Rows
    Index Status        Lower        Upper       Primal         Dual  Name
        0     BS         -inf       0.0135    0.0131129           -0  row14_upper
        1     BS         -inf       0.0145    0.0136824           -0  row15_upper
        2     BS         -inf       0.0155    0.0148626           -0  row16_upper
        3     BS         -inf       0.0165    0.0158809           -0  row17_upper
        4     BS         -inf       0.0175    0.0166919           -0  row18_upper
        5     BS         -inf       0.0185    0.0177476           -0  row19_upper
        6     BS         -inf       0.0195    0.0185305           -0  row20_upper
        7     BS         -inf       0.0205       0.0195           -0  row21_upper
        8     BS         -inf       0.0215    0.0205003           -0  row22_upper
        9     BS         -inf       0.0225    0.0215001           -0  row23_upper
       10     BS         -inf       0.0235    0.0225023           -0  row24_upper
       11     BS         -inf       0.0245    0.0241943           -0  row25_upper
       12     BS         -inf       0.0255    0.0247799           -0  row26_upper
       13     BS         -inf       0.0265    0.0258054           -0  row27_upper
       14     BS         -inf       0.0275    0.0267752           -0  row28_upper
       15     BS         -inf       0.0285    0.0278896           -0  row29_upper
       16     BS         -inf       0.0295    0.0290138           -0  row30_upper
       17     BS         -inf       0.0305    0.0299191           -0  row31_upper
       18     BS         -inf       0.0315    0.0308241           -0  row32_upper
       19     BS         -inf       0.0325     0.031854           -0  row33_upper
       20     UB         -inf       0.0335       0.0335    -0.132027  row34_upper
       21     BS         -inf       0.0345     0.034215           -0  row35_upper
       22     BS         -inf       0.0355     0.034787           -0  row36_upper
       23     BS       0.0125          inf    0.0131129           -0  row14_lower
       24     BS       0.0135          inf    0.0136824           -0  row15_lower
       25     BS       0.0145          inf    0.0148626           -0  row16_lower
       26     BS       0.0155          inf    0.0158809           -0  row17_lower
       27     BS       0.0165          inf    0.0166919           -0  row18_lower
       28     BS       0.0175          inf    0.0177476           -0  row19_lower
       29     BS       0.0185          inf    0.0185305           -0  row20_lower
       30     LB       0.0195          inf       0.0195     0.132027  row21_lower
       31     BS       0.0205          inf    0.0205003           -0  row22_lower
       32     BS       0.0215          inf    0.0215001           -0  row23_lower
       33     BS       0.0225          inf    0.0225023           -0  row24_lower
       34     BS       0.0235          inf    0.0241943           -0  row25_lower
       35     BS       0.0245          inf    0.0247799           -0  row26_lower
       36     BS       0.0255          inf    0.0258054           -0  row27_lower
       37     BS       0.0265          inf    0.0267752           -0  row28_lower
       38     BS       0.0275          inf    0.0278896           -0  row29_lower
       39     BS       0.0285          inf    0.0290138           -0  row30_lower
       40     BS       0.0295          inf    0.0299191           -0  row31_lower
       41     BS       0.0305          inf    0.0308241           -0  row32_lower
       42     BS       0.0315          inf     0.031854           -0  row33_lower
       43     BS       0.0325          inf       0.0335           -0  row34_lower
       44     BS       0.0335          inf     0.034215           -0  row35_lower
       45     BS       0.0345          inf     0.034787           -0  row36_lower

Model status: Optimal

Objective value: -0.0018483800269
