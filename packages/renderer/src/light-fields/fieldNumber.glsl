// Writes the index of the light for which a point is drawn.
// Farol
flat in highp float farol_fieldLight;
layout(location = 0) out highp vec4 farol_fieldNumber;
//# main
farol_fieldNumber = vec4(farol_fieldLight);
