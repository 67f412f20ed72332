// Light loop without lights, for the G-buffer pass and the like.
// Farol
#define FAROL_FOR_EACH_LIGHT(positionVS)
