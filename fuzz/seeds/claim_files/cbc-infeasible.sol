Infeasible - objective value 0.70457009
      0 theta1          0.70457009                       0
      1 theta2           1.2070252                       0
