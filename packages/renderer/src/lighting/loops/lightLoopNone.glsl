// Light loop of no lights: the base pass and the G-buffer pass.
// Farol
#define FAROL_FOR_EACH_LIGHT(positionVS)
