// First pixel of the picture in the target.
// Farol
uniform vec2 farol_offset;
