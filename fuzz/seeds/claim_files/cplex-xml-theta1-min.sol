<?xml version = "1.0" encoding="UTF-8" standalone="yes"?>
<CPLEXSolution version="1.2">
 <header
   problemName="theta1-min.mps"
   solutionName="incumbent"
   solutionIndex="-1"
   objectiveValue="0.00179089203479447"
   solutionTypeValue="1"
   solutionTypeString="basic"
   solutionStatusValue="1"
   solutionStatusString="optimal"
   solutionMethodString="dual"
   primalFeasible="1"
   dualFeasible="1"/>
 <linearConstraints>
  <constraint name="row14_upper" index="0" status="LL" slack="0" dual="-0.0852805730854512"/>
  <constraint name="row15_upper" index="1" status="BS" slack="0" dual="0"/>
  <constraint name="row16_upper" index="2" status="BS" slack="0" dual="0"/>
  <constraint name="row17_upper" index="3" status="BS" slack="0" dual="0"/>
  <constraint name="row18_upper" index="4" status="BS" slack="0" dual="0"/>
  <constraint name="row19_upper" index="5" status="BS" slack="0" dual="0"/>
  <constraint name="row20_upper" index="6" status="BS" slack="0" dual="0"/>
  <constraint name="row21_upper" index="7" status="BS" slack="0" dual="0"/>
  <constraint name="row22_upper" index="8" status="BS" slack="0" dual="0"/>
  <constraint name="row23_upper" index="9" status="BS" slack="0" dual="0"/>
  <constraint name="row24_upper" index="10" status="BS" slack="0" dual="0"/>
  <constraint name="row25_upper" index="11" status="BS" slack="0" dual="0"/>
  <constraint name="row26_upper" index="12" status="BS" slack="0" dual="0"/>
  <constraint name="row27_upper" index="13" status="BS" slack="0" dual="0"/>
  <constraint name="row28_upper" index="14" status="BS" slack="0" dual="0"/>
  <constraint name="row29_upper" index="15" status="BS" slack="0" dual="0"/>
  <constraint name="row30_upper" index="16" status="BS" slack="0" dual="0"/>
  <constraint name="row31_upper" index="17" status="BS" slack="0" dual="0"/>
  <constraint name="row32_upper" index="18" status="BS" slack="0" dual="0"/>
  <constraint name="row33_upper" index="19" status="BS" slack="0" dual="0"/>
  <constraint name="row34_upper" index="20" status="BS" slack="0" dual="0"/>
  <constraint name="row35_upper" index="21" status="BS" slack="0" dual="0"/>
  <constraint name="row36_upper" index="22" status="BS" slack="0" dual="0"/>
  <constraint name="row14_lower" index="23" status="BS" slack="0" dual="0"/>
  <constraint name="row15_lower" index="24" status="BS" slack="0" dual="0"/>
  <constraint name="row16_lower" index="25" status="BS" slack="0" dual="0"/>
  <constraint name="row17_lower" index="26" status="BS" slack="0" dual="0"/>
  <constraint name="row18_lower" index="27" status="BS" slack="0" dual="0"/>
  <constraint name="row19_lower" index="28" status="BS" slack="0" dual="0"/>
  <constraint name="row20_lower" index="29" status="BS" slack="0" dual="0"/>
  <constraint name="row21_lower" index="30" status="BS" slack="0" dual="0"/>
  <constraint name="row22_lower" index="31" status="BS" slack="0" dual="0"/>
  <constraint name="row23_lower" index="32" status="BS" slack="0" dual="0"/>
  <constraint name="row24_lower" index="33" status="BS" slack="0" dual="0"/>
  <constraint name="row25_lower" index="34" status="BS" slack="0" dual="0"/>
  <constraint name="row26_lower" index="35" status="BS" slack="0" dual="0"/>
  <constraint name="row27_lower" index="36" status="BS" slack="0" dual="0"/>
  <constraint name="row28_lower" index="37" status="BS" slack="0" dual="0"/>
  <constraint name="row29_lower" index="38" status="BS" slack="0" dual="0"/>
  <constraint name="row30_lower" index="39" status="BS" slack="0" dual="0"/>
  <constraint name="row31_lower" index="40" status="BS" slack="0" dual="0"/>
  <constraint name="row32_lower" index="41" status="BS" slack="0" dual="0"/>
  <constraint name="row33_lower" index="42" status="BS" slack="0" dual="0"/>
  <constraint name="row34_lower" index="43" status="BS" slack="0" dual="0"/>
  <constraint name="row35_lower" index="44" status="BS" slack="0" dual="0"/>
  <constraint name="row36_lower" index="45" status="LL" slack="0" dual="0.0852805730854511"/>
 </linearConstraints>
 <variables>
  <variable name="theta1" index="0" status="BS" value="0.00179089203479447" reducedCost="0"/>
  <variable name="theta2" index="1" status="BS" value="0.0226924697253966" reducedCost="0"/>
 </variables>
</CPLEXSolution>
