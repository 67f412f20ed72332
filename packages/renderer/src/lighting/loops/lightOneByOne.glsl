// Every lit material is shaded light by light, by three's own functions: to count lights, or since the host changed
// those functions.
// Farol
#define FAROL_ONE_BY_ONE
