Optimal - objective value 0.00179089
      0 theta1          0.001790892                       0
      1 theta2           0.02269247                       0
