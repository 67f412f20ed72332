// Scale of the heat map views: one over the count that is drawn hottest.
// Farol
uniform float farol_heatScale;
