// Scale of heat-map views: 1 / count of the hottest colour.
// Farol
uniform float farol_heatScale;
